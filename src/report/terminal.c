/* The compact table that `report` ends with on a terminal. */
#include "report/report.h"

#include "base/number_format.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TERMINAL_COLUMNS = 10, TERMINAL_WIDTH = 80, TERMINAL_NAME = 10 };

/** A cell's text; one that does not fit is cut. */
struct terminal_cell {
    char text[128];
};

struct terminal_row {
    struct terminal_cell cells[TERMINAL_COLUMNS];
};

/** Characters, not bytes: texts are UTF-8. */
static int width_of(const char *string)
{
    int width = 0;
    for (; *string; string++)
        width += ((unsigned char)*string & 0xC0) != 0x80;
    return width;
}

/** A name from outside, in at most `most` characters: a longer one is cut in its middle, as names often differ at their
 * end. */
static void put_name(struct terminal_cell *cell, const char *name, int most)
{
    struct text shown = {0};
    text_add_shown(&shown, name);
    int width = width_of(text_string(&shown)), at = 0;
    size_t length = 0, bytes;
    for (const char *p = text_string(&shown); *p && length + 8 < sizeof cell->text; p += bytes, at++) {
        bytes = text_character(p);
        if (width > most && at == most / 2)
            length += (size_t)snprintf(cell->text + length, 4, "…");
        if (width > most && at >= most / 2 && at <= most / 2 + width - most)
            continue;
        memcpy(cell->text + length, p, bytes);
        length += bytes;
    }
    cell->text[length] = '\0';
    text_free(&shown);
}

static void put_uncertain(struct terminal_cell *cell, double value, double error)
{
    struct text text = {0};
    number_format_uncertain(&text, value, error);
    snprintf(cell->text, sizeof cell->text, "%s", text_string(&text));
    char *sign = strstr(cell->text, " ± "); /* no room for the blanks */
    if (sign) {
        memmove(sign, sign + 1, strlen(sign));
        sign += strlen("±");
        memmove(sign, sign + 1, strlen(sign));
    }
    text_free(&text);
}

/** Plain with three significant digits. */
static void put_number(struct terminal_cell *cell, double value)
{
    struct text text = {0};
    if (isfinite(value))
        number_format_number(&text, value, 3);
    snprintf(cell->text, sizeof cell->text, "%s", text.length > 0 ? text_string(&text) : "-");
    text_free(&text);
}

/** As 1.2e-4. */
static void put_load(struct terminal_cell *cell, double load)
{
    if (!(load > 0) || !isfinite(load)) {
        snprintf(cell->text, sizeof cell->text, "-");
        return;
    }
    char mantissa[32];
    snprintf(mantissa, sizeof mantissa, "%.1e", load);
    char *exponent = strchr(mantissa, 'e');
    *exponent++ = '\0';
    snprintf(cell->text, sizeof cell->text, "%se%ld", mantissa, strtol(exponent, NULL, 10));
}

static void put_beta(struct terminal_cell *cell, const struct curve_summary *model)
{
    if (model->exists && isfinite(model->beta))
        snprintf(cell->text, sizeof cell->text, "%.2f", model->beta);
    else
        snprintf(cell->text, sizeof cell->text, "-");
}

/** Has beta a meaning in this run? It belongs to the adjusted separation. */
static bool has_beta(const struct plan *plan, enum model_id model)
{
    return model_rows[model].family == SCENE_MODEL_STATISTICAL && plan_runs(plan, EFFECT_SEPARATION) &&
           model_called_for(model, plan->families, plan->running);
}

/** The heads; returns how many columns there are. */
static int put_heads(struct terminal_row *row, const struct plan *plan)
{
    static const char *const heads[MODEL_COUNT] = {"MS el.", "MS pl.", "GW", "JG"};
    static const char *const first[] = {"surface", "Rq/µm", "α (SI)", "γ"};
    int column = 0;
    for (; column < 4; column++)
        snprintf(row->cells[column].text, sizeof row->cells[column].text, "%s", first[column]);
    for (int m = 0; m < MODEL_COUNT; m++)
        if (has_beta(plan, (enum model_id)m))
            snprintf(row->cells[column++].text, sizeof row->cells[0].text, "β %s", heads[m]);
    for (int m = 0; m < MODEL_COUNT; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running))
            snprintf(row->cells[column++].text, sizeof row->cells[0].text, "%s", heads[m]);
    return column;
}

static void put_surface(struct terminal_row *row, const struct surface_summary *s, const struct plan *plan)
{
    int column = 4;
    put_number(&row->cells[1], s->roughness.rq_m * 1e6);
    put_uncertain(&row->cells[2], s->power_law.alpha, s->power_law.alpha_error);
    put_uncertain(&row->cells[3], s->power_law.gamma, s->power_law.gamma_error);
    for (int m = 0; m < MODEL_COUNT; m++)
        if (has_beta(plan, (enum model_id)m))
            put_beta(&row->cells[column++], &s->models[m]);
    for (int m = 0; m < MODEL_COUNT; m++)
        if (model_called_for((enum model_id)m, plan->families, plan->running))
            put_load(&row->cells[column++], s->models[m].exists ? s->models[m].full_load : NAN);
}

static void spaces(struct text *out, int count)
{
    for (; count > 0; count--)
        text_add_bytes(out, " ", 1);
}

static void print_row(struct text *out, const struct terminal_row *row, const int *widths, int columns)
{
    for (int c = 0; c < columns; c++) {
        int room = widths[c] - width_of(row->cells[c].text);
        spaces(out, c > 0 ? 1 + room : 0);
        text_add(out, "%s", row->cells[c].text);
        spaces(out, c > 0 ? 0 : room);
    }
    text_add(out, "\n");
}

/** Characters of a column's longest cell. */
static int widest(const struct terminal_row *table, size_t rows, int column)
{
    int width = 0;
    for (size_t r = 0; r < rows; r++)
        width = width_of(table[r].cells[column].text) > width ? width_of(table[r].cells[column].text) : width;
    return width;
}

void report_terminal_table(struct text *out, const struct results *results)
{
    static const char above[] = "load to full contact, P/(An E')";
    size_t rows = 1, row = 1;
    int widths[TERMINAL_COLUMNS] = {0}, numbers = 0;
    struct terminal_row *table = calloc(results->usable_count + 1, sizeof *table);
    if (!table) {
        out->failed = true;
        return;
    }
    int columns = put_heads(&table[0], results->plan);
    for (size_t i = 0; i < results->store->count; i++)
        if (results->store->summaries[i].usable)
            put_surface(&table[rows++], &results->store->summaries[i], results->plan);
    for (int c = 1; c < columns; c++)
        numbers += 1 + (widths[c] = widest(table, rows, c));
    int room = TERMINAL_WIDTH - numbers > TERMINAL_NAME ? TERMINAL_WIDTH - numbers : TERMINAL_NAME;
    for (size_t i = 0; i < results->store->count; i++)
        if (results->store->summaries[i].usable)
            put_name(&table[row++].cells[0], results->store->summaries[i].scene->name, room);
    widths[0] = widest(table, rows, 0);
    spaces(out, widths[0] + numbers - (int)strlen(above)); /* it stands over the columns of loads, which come last */
    text_add(out, "%s\n", above);
    for (size_t r = 0; r < rows; r++)
        print_row(out, &table[r], widths, columns);
    free(table);
}
