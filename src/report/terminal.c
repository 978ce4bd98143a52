/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first page's table for a terminal. */
#include "base/mustache.h"
#include "report/report.h"

#include <stdio.h>
#include <string.h>

enum { WIDTH = 80, COLUMNS = 5, NAME_LEAST = 10 };

/** A cell of a row of the view, by a path of two names at most; "-" where it is not there. */
static const char *cell(const json_t *row, const char *name, const char *part)
{
    const json_t *value = json_object_get(row, name);
    if (part)
        value = json_object_get(value, part);
    return json_is_string(value) ? json_string_value(value) : "-";
}

/** A text in `most` characters: of a longer one the middle is cut, as names often differ at their end. */
static void put_cut(struct text *out, const char *string, int most)
{
    int width = text_characters(string), at = 0;
    for (size_t bytes; *string; string += bytes, at++) {
        for (bytes = 1; ((unsigned char)string[bytes] & 0xC0) == 0x80; bytes++)
            ;
        if (width > most && at == most / 2)
            text_add(out, "…");
        if (width <= most || at < most / 2 || at > most / 2 + width - most)
            text_add_bytes(out, string, bytes);
    }
}

static void fill(struct text *out, int count)
{
    for (; count > 0; count--)
        text_add(out, " ");
}

/** The texts of a row; of the heads (row NULL). */
static void texts_of(const char *out[COLUMNS], const json_t *row, const json_t *view, char heads[COLUMNS][160])
{
    bool target = json_object_get(view, "target") != NULL;
    if (!row) {
        snprintf(heads[0], sizeof heads[0], "surface");
        snprintf(heads[1], sizeof heads[1], "Rq/µm");
        if (target)
            snprintf(heads[2], sizeof heads[2], "%s takes", cell(view, "target", NULL));
        else
            snprintf(heads[2], sizeof heads[2], "%s", cell(view, "asked", "symbol"));
        snprintf(heads[3], sizeof heads[3], "95 %%");
        snprintf(heads[4], sizeof heads[4], "area/%%");
        for (int c = 0; c < COLUMNS; c++)
            out[c] = heads[c];
        return;
    }
    out[0] = cell(row, "surface", NULL);
    out[1] = cell(row, "rq_um", NULL);
    out[2] = target ? cell(row, "answer", "load") : cell(row, "value", "value");
    out[3] = cell(row, target ? "answer" : "value", "interval");
    out[4] = cell(row, "area_percent", NULL);
}

static void put_table(struct text *out, const json_t *view)
{
    const json_t *rows = json_object_get(view, "rows");
    size_t count = json_array_size(rows);
    int widths[COLUMNS] = {0}, others = 0;
    char heads[COLUMNS][160];
    for (int pass = 0; pass < 2; pass++) {
        for (int c = 1; c < COLUMNS && pass == 1; c++)
            others += 2 + widths[c];
        if (pass == 1 && widths[0] > WIDTH - others)
            widths[0] = WIDTH - others > NAME_LEAST ? WIDTH - others : NAME_LEAST;
        for (size_t r = 0; r <= count; r++) {
            const char *texts[COLUMNS];
            texts_of(texts, r > 0 ? json_array_get(rows, r - 1) : NULL, view, heads);
            for (int c = 0; c < COLUMNS && pass == 0; c++)
                widths[c] = text_characters(texts[c]) > widths[c] ? text_characters(texts[c]) : widths[c];
            if (pass == 0)
                continue;
            put_cut(out, texts[0], widths[0]);
            fill(out, widths[0] - text_characters(texts[0]));
            for (int c = 1; c < COLUMNS; c++) {
                fill(out, 2 + widths[c] - text_characters(texts[c]));
                text_add(out, "%s", texts[c]);
            }
            text_add(out, "\n");
            if (r < count)
                continue;
            json_int_t more = json_integer_value(json_object_get(view, "rows_left_out"));
            if (more > 0)
                text_add(out, "… %lld more in data/surfaces.csv\n", (long long)more);
        }
    }
}

static void as_it_is(struct text *out, const char *string)
{
    text_add(out, "%s", string);
}

enum status_code report_terminal(struct text *out, const json_t *view, const char *templates, struct status *status)
{
    struct mustache_folder folder = {templates, ".txt", NULL, status};
    put_table(out, view);
    text_add(out, "\n");
    struct text words = {0};
    enum status_code rc = mustache_file(&words, &folder, "terminal", view, as_it_is);
    text_add_wrapped(out, text_string(&words), WIDTH, 0);
    text_free(&words);
    mustache_folder_free(&folder);
    return rc;
}
