/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first page's table and sentences for a terminal. */
#include "base/mustache.h"
#include "chart/words.h"
#include "report/report.h"

#include <string.h>

enum { WIDTH = 80, COLUMNS = 8, NAME_LEAST = 10 };

/** Sets the lines with tabs that `rows` begins with in columns, the first to the left, and returns what follows. */
static const char *put_table(struct text *out, const char *rows)
{
    int widths[COLUMNS] = {0}, others = 0;
    const char *line = rows;
    for (int pass = 0; pass < 2; pass++) {
        for (line = rows; line[strcspn(line, "\t\n")] == '\t'; line++) {
            int c = 0;
            for (bool more = true; more && c < COLUMNS; c++) {
                size_t length = strcspn(line, "\t\n");
                int width = words_width(line, length);
                if (pass == 0)
                    widths[c] = width > widths[c] ? width : widths[c];
                else if (c == 0)
                    words_cut(out, line, length, widths[c]);
                else
                    text_add(out, "%*s%.*s", 2 + widths[c] - width, "", (int)length, line);
                if (pass == 1 && c == 0)
                    text_add(out, "%*s", width < widths[c] ? widths[c] - width : 0, "");
                line += length;
                more = *line == '\t';
                line += more;
            }
            if (pass == 1)
                text_add(out, "\n");
        }
        for (int c = 1; c < COLUMNS; c++)
            others += widths[c] > 0 ? 2 + widths[c] : 0;
        if (pass == 0 && widths[0] > WIDTH - others)
            widths[0] = WIDTH - others > NAME_LEAST ? WIDTH - others : NAME_LEAST;
    }
    return line;
}

enum status_code report_terminal(struct text *out, const json_t *view, const char *templates, struct status *status)
{
    struct mustache_folder folder = {templates, ".txt", NULL, status};
    struct text words = {0};
    enum status_code rc = mustache_file(&words, &folder, "terminal", view, NULL);
    text_add_wrapped(out, put_table(out, text_string(&words)), WIDTH, 0);
    text_free(&words);
    mustache_folder_free(&folder);
    return rc;
}
