/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What templates say, for a terminal: lines with tabs as tables in columns, sentences in lines, those of the report
 * without the marks of Markdown. */
#include "base/mustache.h"
#include "base/words.h"
#include "report/report.h"

#include <limits.h>
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
                int width = text_width(line, length);
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
            while (pass == 1 && out->length > 0 && out->data[out->length - 1] == ' ')
                out->data[--out->length] = '\0';
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

/** The same as Markdown; the first line is the head. */
static const char *put_markdown(struct text *out, const char *line)
{
    for (bool head = true; line[strcspn(line, "\t\n")] == '\t'; head = false, line += *line == '\n') {
        size_t cells = 1;
        text_add(out, "| ");
        for (; *line && *line != '\n'; line++) {
            cells += *line == '\t';
            text_add_bytes(out, *line == '\t' ? " | " : line, *line == '\t' ? 3 : 1);
        }
        text_add(out, " |\n%s", head ? "|---|" : "");
        for (; head && cells > 1; cells--)
            text_add(out, "---:|%s", cells == 2 ? "\n" : "");
    }
    return line;
}

enum status_code report_terminal(struct text *out, const char *name, const json_t *view, const char *templates,
                                 bool markdown, struct status *status)
{
    OWNED(mustache_folder_free) struct mustache_folder folder = {templates, ".md", NULL, status};
    const struct mustache how = {view, markdown ? text_add_markdown_shown : text_add_unmarked, mustache_folder_partial,
                                 &folder};
    OWNED(text_free) struct text path = {0}, source = {0}, words = {0};
    text_add(&path, "%s/%s.txt", templates, name);
    if (text_read_file(&source, text_string(&path), status) != STATUS_OK ||
        mustache_render(&words, text_string(&source), name, &how, status) != STATUS_OK)
        return status->code;
    text_squeeze(&words);
    if (!markdown)
        text_strip_marks(&words);
    for (const char *line = text_string(&words); *line;) {
        if (line[strcspn(line, "\t\n")] == '\t') {
            line = markdown ? put_markdown(out, line) : put_table(out, line);
            continue;
        }
        OWNED(text_free) struct text sentence = {0};
        size_t length = strcspn(line, "\n");
        text_add_bytes(&sentence, line, length + (line[length] == '\n'));
        text_add_wrapped(out, text_string(&sentence), markdown ? INT_MAX : WIDTH, 0);
        line += sentence.length;
    }
    return status->code;
}
