/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The compact table that `report` ends with on a terminal. */
#include "report/report.h"

#include "base/number_format.h"
#include "results/results.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TERMINAL_WIDTH = 80, TERMINAL_NAME = 10, FIRST_COLUMNS = 4, TERMINAL_ROWS = 100 };

/** A cell's text; one that does not fit is cut. */
struct terminal_cell {
    char text[128];
};

/** Cells row by row, the heads first. */
struct terminal_table {
    struct terminal_cell *cells;
    size_t rows, columns;
};

static struct terminal_cell *cell_at(const struct terminal_table *table, size_t row, size_t column)
{
    return &table->cells[row * table->columns + column];
}

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

/** "0.123×÷1.3": an amplitude of a law with the factor of its standard error. */
static void put_factor(struct terminal_cell *cell, const struct power_law *law, double wavelength_m)
{
    struct text text = {0};
    number_format(&text, power_law_amplitude(law, wavelength_m) * 1e6, 3);
    number_format_between(&text, "×÷", pow(10, power_law_error_decades(law, wavelength_m)), 3, "");
    snprintf(cell->text, sizeof cell->text, "%s", power_law_holds(law) ? text_string(&text) : "-");
    text_free(&text);
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
        number_format(&text, value, 3);
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
static bool has_beta(const struct plan *plan, size_t m)
{
    return plan_runs_model(plan, m) && (model_rows[m]->quantities & plan->wanted & QUANTITY_BIT(QUANTITY_ADJUSTED));
}

/** Has the model a column of loads? A line has room for the thesis's; others have theirs where none of those runs. */
static bool has_load(const struct plan *plan, size_t m)
{
    bool thesis = false;
    for (size_t other = 0; other < model_count; other++)
        thesis = thesis || (plan_runs_model(plan, other) && model_rows[other]->thesis_place > 0);
    return plan_runs_model(plan, m) && (model_rows[m]->thesis_place > 0 || !thesis);
}

static size_t column_count(const struct plan *plan)
{
    size_t columns = FIRST_COLUMNS;
    for (size_t m = 0; m < model_count; m++)
        columns += (size_t)has_beta(plan, m) + (size_t)has_load(plan, m);
    return columns;
}

static void put_heads(const struct terminal_table *table, const struct plan *plan)
{
    static const char *const first[FIRST_COLUMNS] = {"surface", "Rq/µm", "Δ/µm", "γ"};
    size_t column = 0;
    for (; column < FIRST_COLUMNS; column++)
        snprintf(cell_at(table, 0, column)->text, sizeof table->cells->text, "%s", first[column]);
    for (size_t m = 0; m < model_count; m++)
        if (has_beta(plan, m))
            snprintf(cell_at(table, 0, column++)->text, sizeof table->cells->text, "β %s", model_rows[m]->short_label);
    for (size_t m = 0; m < model_count; m++)
        if (has_load(plan, m))
            snprintf(cell_at(table, 0, column++)->text, sizeof table->cells->text, "%s", model_rows[m]->short_label);
}

static void put_surface(const struct terminal_table *table, size_t row, const struct results *results, size_t index)
{
    const struct surface_summary *s = &results->surfaces[index].summary;
    const struct plan *plan = results->plan;
    double load_scale = results_load_axis(results, index).scale;
    size_t column = FIRST_COLUMNS;
    put_number(cell_at(table, row, 1), s->roughness.rq_m * 1e6);
    put_factor(cell_at(table, row, 2), &s->power_law, results_law_wavelength_m(results));
    put_uncertain(cell_at(table, row, 3), power_law_holds(&s->power_law) ? s->power_law.gamma : NAN,
                  s->power_law.gamma_error);
    for (size_t m = 0; m < model_count; m++)
        if (has_beta(plan, m))
            put_beta(cell_at(table, row, column++), surface_model(s, m));
    for (size_t m = 0; m < model_count; m++)
        if (has_load(plan, m))
            put_load(cell_at(table, row, column++),
                     surface_model(s, m)->exists ? load_scale * surface_model(s, m)->full_load : NAN);
}

static void spaces(struct text *out, int count)
{
    for (; count > 0; count--)
        text_add_bytes(out, " ", 1);
}

/** Characters of a column's longest cell. */
static int widest(const struct terminal_table *table, size_t column)
{
    int width = 0;
    for (size_t r = 0; r < table->rows; r++) {
        int own = width_of(cell_at(table, r, column)->text);
        width = own > width ? own : width;
    }
    return width;
}

static void print_row(struct text *out, const struct terminal_table *table, size_t row, const int *widths)
{
    for (size_t c = 0; c < table->columns; c++) {
        int room = widths[c] - width_of(cell_at(table, row, c)->text);
        spaces(out, c > 0 ? 1 + room : 0);
        text_add(out, "%s", cell_at(table, row, c)->text);
        spaces(out, c > 0 ? 0 : room);
    }
    text_add(out, "\n");
}

void report_terminal_table(struct text *out, const struct results *results)
{
    const char *unit = results_load_axis(results, results->baseline).unit;
    struct text above = {0};
    text_add(&above, "load to full contact, %s", unit ? "" : "P/(An E')");
    text_add_shown(&above, unit ? unit : "");
    size_t listed = results->usable_count < TERMINAL_ROWS ? results->usable_count : TERMINAL_ROWS;
    struct terminal_table table = {.rows = listed + 1, .columns = column_count(results->plan)};
    int *widths = calloc(table.columns, sizeof *widths), numbers = 0;
    size_t row = 1;
    table.cells = calloc(table.rows * table.columns, sizeof *table.cells);
    if (!table.cells || !widths) {
        free(table.cells);
        free(widths);
        text_free(&above);
        out->failed = true;
        return;
    }
    put_heads(&table, results->plan);
    for (size_t i = 0; i < results->surface_count && row <= listed; i++)
        if (results->surfaces[i].summary.usable)
            put_surface(&table, row++, results, i);
    for (size_t c = 1; c < table.columns; c++)
        numbers += 1 + (widths[c] = widest(&table, c));
    int room = TERMINAL_WIDTH - numbers > TERMINAL_NAME ? TERMINAL_WIDTH - numbers : TERMINAL_NAME;
    row = 1;
    for (size_t i = 0; i < results->surface_count && row <= listed; i++)
        if (results->surfaces[i].summary.usable)
            put_name(cell_at(&table, row++, 0), results->surfaces[i].summary.scene->name, room);
    widths[0] = widest(&table, 0);
    if (!results_has_material(results))
        text_add(out, "%s\n", results_without_material);
    spaces(out, widths[0] + numbers - width_of(text_string(&above))); /* over the columns of loads, which come last */
    text_add(out, "%s\n", text_string(&above));
    text_free(&above);
    for (size_t r = 0; r < table.rows; r++)
        print_row(out, &table, r, widths);
    if (listed < results->usable_count)
        text_add(out, "… %zu more in data/surfaces.csv\n", results->usable_count - listed);
    if (isfinite(results_law_wavelength_m(results))) {
        number_format_between(out, "Δ: amplitude of the power law at ", results_law_wavelength_m(results) * 1e6, 3,
                              " µm\n");
    }
    free(table.cells);
    free(widths);
}
