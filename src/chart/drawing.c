/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/drawing.h"

#include "chart/drawing_parts.h"
#include "chart/gnuplot.h"
#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

const size_t drawing_whole = 200;
const double drawing_tolerance = 0.05; /* a twentieth of a pixel; ten times enlarged, half of one */

void drawing_free(struct drawing *drawing)
{
    free(drawing->block);
    free(drawing->row);
    drawing->block = NULL;
    drawing->row = NULL;
    drawing->blocks = drawing->rows = drawing->block_capacity = drawing->row_capacity = 0;
}

void drawing_begin(struct drawing *drawing, const char *style, const char *legend)
{
    if (drawing->failed)
        return;
    if (drawing->blocks == drawing->block_capacity) {
        size_t more = drawing->block_capacity ? 2 * drawing->block_capacity : 16;
        struct drawing_block *block = reallocarray(drawing->block, more, sizeof *block);
        drawing->failed = !block;
        if (!block)
            return;
        drawing->block = block;
        drawing->block_capacity = more;
    }
    struct drawing_block *block = &drawing->block[drawing->blocks++];
    *block = (struct drawing_block){.first = drawing->rows, .end = drawing->rows};
    assert(strlen(style) < sizeof block->style);
    snprintf(block->style, sizeof block->style, "%s", style);
    snprintf(block->legend, sizeof block->legend, "%s", legend);
}

void drawing_add(struct drawing *drawing, const double *cell, size_t count)
{
    assert(drawing->failed || (drawing->blocks > 0 && count <= DRAWING_COLUMNS));
    if (drawing->failed)
        return;
    if (drawing->rows == drawing->row_capacity) {
        size_t more = drawing->row_capacity ? 2 * drawing->row_capacity : 512;
        double(*row)[DRAWING_COLUMNS] = reallocarray(drawing->row, more, sizeof *row);
        drawing->failed = !row;
        if (!row)
            return;
        drawing->row = row;
        drawing->row_capacity = more;
    }
    for (size_t c = 0; c < DRAWING_COLUMNS; c++)
        drawing->row[drawing->rows][c] = c < count ? cell[c] : NAN;
    drawing->block[drawing->blocks - 1].end = ++drawing->rows;
}

bool drawing_can_show(const struct drawing *drawing, double x, double y)
{
    return fabs(x) < 1e300 && fabs(y) < 1e300 && (!drawing->log_x || x > 0) && (!drawing->log_y || y > 0);
}

/** What each block holds that the axes can show. */
static void reckon(struct drawing *drawing)
{
    for (size_t b = 0; b < drawing->blocks; b++) {
        struct drawing_block *block = &drawing->block[b];
        block->look = look_of(block->style);
        block->rows = 0;
        block->x_low = block->y_low = INFINITY;
        block->x_high = block->y_high = -INFINITY;
        for (size_t i = block->first; i < block->end; i++) {
            double x = drawing->row[i][0], y = drawing->row[i][1];
            if (!drawing_can_show(drawing, x, y))
                continue;
            block->rows++;
            if (x >= block->x_high)
                block->y_end = y;
            block->x_low = fmin(block->x_low, x);
            block->x_high = fmax(block->x_high, x);
            block->y_low = fmin(block->y_low, y);
            block->y_high = fmax(block->y_high, y);
        }
    }
}

void drawing_extents(const struct drawing *drawing, struct figure_extent *x, struct figure_extent *y)
{
    *x = *y = (struct figure_extent){INFINITY, -INFINITY};
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct drawing_block *block = &drawing->block[b];
        if (block->look.scaled)
            continue;
        *x = (struct figure_extent){fmin(x->low, block->x_low), fmax(x->high, block->x_high)};
        *y = (struct figure_extent){fmin(y->low, block->y_low), fmax(y->high, block->y_high)};
    }
}

enum status_code drawing_script(struct text *out, struct drawing *drawing, const char *terminal_size,
                                struct status *status)
{
    if (drawing->failed)
        return status_memory(status);
    reckon(drawing);
    text_add(out, "# draws %s from %s.csv: gnuplot %s.gp\n# curves:", drawing->name, drawing->name, drawing->name);
    for (size_t b = 0; b < drawing->blocks; b++)
        text_add(out, " %s", drawing->block[b].style);
    text_add(out, "\n");
    if (drawing->axes_given) {
        text_add(out, "# axes: %.6e %.6e %.6e %.6e", drawing->x.low, drawing->x.high, drawing->y.low, drawing->y.high);
        if (drawing->ratio.low <= drawing->ratio.high)
            text_add(out, " %.6e %.6e", drawing->ratio.low, drawing->ratio.high);
        text_add(out, "\n");
    }
    switch (drawing->kind) {
    case DRAWING_CURVES:
        drawing_curves(out, drawing, terminal_size);
        break;
    case DRAWING_COST:
        drawing_cost(out, drawing);
        break;
    case DRAWING_PROFILES:
        drawing_profiles(out, drawing);
        break;
    case DRAWING_SPECTRA:
        drawing_spectra(out, drawing);
        break;
    case DRAWING_PATCHES:
        drawing_patches(out, drawing);
        break;
    }
    text_add(out, "set output\n");
    return out->failed ? status_memory(status) : STATUS_OK;
}

/* ---------------------------------------------------------------- thinning */

/** From values to places on the drawing. */
struct page {
    bool log_x, log_y;
    double x_low, x_scale, y_low, y_scale;
};

static double place(double value, bool logarithmic, double low, double scale)
{
    return ((logarithmic ? log10(value) : value) - low) * scale;
}

static struct page page_of(const struct drawing *drawing, struct figure_extent x, struct figure_extent y, bool log_y)
{
    struct page page = {.log_x = drawing->log_x, .log_y = log_y};
    double x_high = drawing->log_x ? log10(x.high) : x.high, y_high = log_y ? log10(y.high) : y.high;
    page.x_low = drawing->log_x ? log10(x.low) : x.low;
    page.y_low = log_y ? log10(y.low) : y.low;
    page.x_scale = x_high > page.x_low ? DRAWING_WIDTH / (x_high - page.x_low) : 0;
    page.y_scale = y_high > page.y_low ? DRAWING_TALL / (y_high - page.y_low) : 0;
    return page;
}

/** Slopes that a straight line from the last point kept may have, in each of two columns. */
struct cone {
    double low[2], high[2];
};

/** Does the straight line to this point pass all points since the last kept closely enough? Then it narrows the cone.
 */
static bool goes_on(struct cone *cone, const double *from, const double *to, int lines)
{
    double dx = to[0] - from[0];
    if (!(dx > 0))
        return false;
    for (int c = 0; c < lines; c++) {
        double slope = (to[c + 1] - from[c + 1]) / dx;
        if (!(slope >= cone->low[c] && slope <= cone->high[c]))
            return false;
    }
    for (int c = 0; c < lines; c++) {
        double dy = to[c + 1] - from[c + 1];
        cone->low[c] = fmax(cone->low[c], (dy - drawing_tolerance) / dx);
        cone->high[c] = fmin(cone->high[c], (dy + drawing_tolerance) / dx);
    }
    return true;
}

/** Moves the rows worth keeping of `block` to `to`; returns the end of them. */
static size_t thin_block(struct drawing *drawing, const struct drawing_block *block, const struct page *page, size_t to)
{
    static const struct cone open = {{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
    int lines = block->look.band ? 2 : 1;
    double from[3] = {NAN, NAN, NAN};
    struct cone cone = open;
    bool whole = block->end - block->first <= drawing_whole || look_in_bars(&block->look);
    size_t waiting = SIZE_MAX; /* the last row seen, when it was not kept */
    for (size_t i = block->first; i < block->end; i++) {
        const double *row = drawing->row[i];
        double at[3] = {NAN, NAN, NAN};
        if (drawing_can_show(drawing, row[0], 1) && (!page->log_y || (row[1] > 0 && (lines < 2 || row[2] > 0)))) {
            at[0] = place(row[0], page->log_x, page->x_low, page->x_scale);
            for (int c = 0; c < lines; c++)
                at[c + 1] = place(row[c + 1], page->log_y, page->y_low, page->y_scale);
        }
        if (!whole && goes_on(&cone, from, at, lines)) {
            waiting = i;
            continue;
        }
        if (waiting != SIZE_MAX) { /* the line ends there, and another begins */
            memmove(drawing->row[to++], drawing->row[waiting], sizeof *drawing->row);
            from[0] = place(drawing->row[waiting][0], page->log_x, page->x_low, page->x_scale);
            for (int c = 0; c < lines; c++)
                from[c + 1] = place(drawing->row[waiting][c + 1], page->log_y, page->y_low, page->y_scale);
            waiting = SIZE_MAX;
            cone = open;
            if (goes_on(&cone, from, at, lines)) {
                waiting = i;
                continue;
            }
        }
        memmove(drawing->row[to++], row, sizeof *drawing->row);
        memcpy(from, at, sizeof from);
        cone = open;
    }
    if (waiting != SIZE_MAX)
        memmove(drawing->row[to++], drawing->row[waiting], sizeof *drawing->row);
    return to;
}

void drawing_thin(struct drawing *drawing)
{
    struct figure_extent x, y;
    if (drawing->failed || drawing->kind != DRAWING_CURVES)
        return;
    drawing_extents(drawing, &x, &y);
    if (drawing->axes_given) {
        x = (struct figure_extent){fmin(x.low, drawing->x.low), fmax(x.high, drawing->x.high)};
        y = (struct figure_extent){drawing->y.low, fmax(y.high, drawing->y.high)};
    }
    size_t end = 0;
    for (size_t b = 0; b < drawing->blocks; b++) {
        struct drawing_block *block = &drawing->block[b];
        struct figure_extent own = {block->y_low, block->y_high}; /* a panel below has an axis of its own */
        struct page page = page_of(drawing, x, block->look.scaled ? own : y, drawing->log_y && !block->look.scaled);
        size_t first = end;
        end = thin_block(drawing, block, &page, end);
        block->first = first;
        block->end = end;
    }
    drawing->rows = end;
}

/* ---------------------------------------------------------------- data */

void drawing_data(struct text *out, const struct drawing *drawing)
{
    char field[sizeof drawing->block->legend + 16];
    for (size_t b = 0; b < drawing->blocks; b++) {
        const struct drawing_block *block = &drawing->block[b];
        gnuplot_field(field, sizeof field, block->legend);
        text_add(out, "%s%s\n", b > 0 ? "\n\n" : "", field);
        for (size_t i = block->first; i < block->end; i++) {
            const double *row = drawing->row[i];
            for (size_t c = 0; c < DRAWING_COLUMNS && !isnan(row[c]); c++)
                text_add(out, "%s%.9g", c > 0 ? "," : "", row[c]);
            text_add(out, "\n");
        }
    }
}
