#include "scan/text_grid.h"

#include <math.h>
#include <string.h>

enum { LIST_COLUMNS = 3 };

/* How far a point may be off its place, in steps: instruments jitter and round. */
static const double grid_jitter = 0.01;

/* One of the two directions of a list: the fast one steps from point to point, the slow one from run to run. */
struct direction {
    size_t column; /* 0 x, 1 y */
    size_t n;
    double first, step; /* in the unit of the file; the step may be negative */
};

static double at(const struct text_table *table, size_t row, size_t column)
{
    return table->cell[row * table->columns + column];
}

static void find_directions(const struct text_table *table, struct direction *fast, struct direction *slow)
{
    fast->column = at(table, 0, 0) == at(table, 1, 0) ? 1 : 0;
    slow->column = 1 - fast->column;
    fast->first = at(table, 0, fast->column);
    slow->first = at(table, 0, slow->column);
    for (fast->n = 1; fast->n < table->rows && at(table, fast->n, slow->column) == slow->first;)
        fast->n++;
    slow->n = table->rows / fast->n;
    fast->step = (at(table, fast->n - 1, fast->column) - fast->first) / (double)(fast->n - 1);
    slow->step =
        slow->n > 1 ? (at(table, (slow->n - 1) * fast->n, slow->column) - slow->first) / (double)(slow->n - 1) : 0.0;
}

bool text_grid_is_list(const struct text_table *table)
{
    if (table->columns != LIST_COLUMNS || table->rows < 4)
        return false;
    bool x_stays = at(table, 0, 0) == at(table, 1, 0), y_stays = at(table, 0, 1) == at(table, 1, 1);
    if (x_stays == y_stays)
        return false;
    struct direction fast, slow;
    find_directions(table, &fast, &slow);
    /* the second run starts where the first did; two equal heights in a row do not make a list */
    return slow.n < 2 || fabs(at(table, fast.n, fast.column) - fast.first) <= grid_jitter * fabs(fast.step);
}

static bool on_grid(const struct text_table *table, size_t row, const struct direction *direction, size_t index)
{
    double off = at(table, row, direction->column) - (direction->first + (double)index * direction->step);
    return fabs(off) <= grid_jitter * fabs(direction->step) * (1 + grid_jitter) + 1e-12 * fabs(direction->first);
}

/* Where a point goes along a direction of the map: forwards, whichever way the instrument went. */
static size_t place(const struct direction *direction, size_t index)
{
    return direction->step < 0 ? direction->n - 1 - index : index;
}

enum status_code text_grid_read_list(struct scan *out, const struct text_table *table, const struct text_header *header,
                                     const struct scan_bytes *file, const struct scan_options *options,
                                     struct status *status)
{
    double x_m, z_m;
    struct direction fast, slow;
    find_directions(table, &fast, &slow);
    if (table->rows % fast.n != 0)
        return scan_fail(status, file, table->last_line, "the last row of points is not complete: %zu of %zu",
                         table->rows % fast.n, fast.n);
    out->x_column = 1;
    out->z_column = LIST_COLUMNS;
    if (text_header_units(out, header, NULL, &x_m, &z_m, file, options, status) != STATUS_OK)
        return status->code;
    const char *y_unit = header->unit[1] ? header->unit[1] : header->y_unit;
    double y_m = y_unit ? scan_unit_m(y_unit, strlen(y_unit)) : x_m;
    bool along_x = fast.column == 0 || slow.n == 1; /* one run is a profile, wherever it goes */
    const struct direction *x = along_x ? &fast : &slow, *y = along_x ? &slow : &fast;
    if (scan_reserve(out, x->n, y->n, table->rows, file, status) != STATUS_OK)
        return status->code;
    for (size_t row = 0; row < table->rows; row++) {
        size_t f = row % fast.n, s = row / fast.n;
        if (!on_grid(table, row, &fast, f) || !on_grid(table, row, &slow, s))
            return scan_fail(status, file, text_table_line(table, row),
                             "this point is not on the grid of the points before; only maps on a grid can be read");
        size_t ix = place(x, along_x ? f : s), iy = place(y, along_x ? s : f);
        out->z_m[iy * x->n + ix] = at(table, row, 2) * z_m;
    }
    out->dx_m = fabs(x->step) * (x->column == 0 ? x_m : y_m); /* one run may go along y */
    out->dy_m = out->kind == SCAN_AREAL ? fabs(y->step) * y_m : 0.0;
    return STATUS_OK;
}

static bool sizes_fit(const struct text_table *table, const struct text_header *header)
{
    double columns = (double)table->columns, rows = (double)table->rows;
    if (header->columns == 0 || header->rows == 0)
        return true;
    /* width and height are taken for one another often enough */
    return (header->columns == columns && header->rows == rows) || (header->columns == rows && header->rows == columns);
}

enum status_code text_grid_read_matrix(struct scan *out, const struct text_table *table,
                                       const struct text_header *header, const struct scan_bytes *file,
                                       const struct scan_options *options, struct status *status)
{
    double x_m, z_m;
    struct text_quantity width = header->width, height = header->height;
    struct text_quantity step = header->pixel.value > 0 ? header->pixel : header->spacing;
    if (step.value > 0) {
        width = (struct text_quantity){step.value * (double)table->columns, step.unit};
        height = (struct text_quantity){step.value * (double)table->rows, step.unit};
    }
    if (!(width.value > 0 && height.value > 0))
        return scan_fail(status, file, table->first_line,
                         "a matrix of %zu x %zu heights without its pixel size; add a line `pixel size = 0.5 um` above "
                         "the numbers, or keep two columns, x and z",
                         table->columns, table->rows);
    if (!sizes_fit(table, header))
        return scan_fail(status, file, table->first_line, "%zu x %zu heights where the header says %g x %g",
                         table->columns, table->rows, header->columns, header->rows);
    if (text_header_units(out, header, width.unit, &x_m, &z_m, file, options, status) != STATUS_OK ||
        scan_reserve(out, table->columns, table->rows, table->columns * table->rows, file, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < table->columns * table->rows; i++)
        out->z_m[i] = table->cell[i] * header->z_factor * z_m;
    double y_m = height.unit ? scan_unit_m(height.unit, strlen(height.unit)) : x_m;
    out->dx_m = width.value / (double)table->columns * x_m;
    out->dy_m = out->kind == SCAN_AREAL ? height.value / (double)table->rows * y_m : 0.0;
    return STATUS_OK;
}
