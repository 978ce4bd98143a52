/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/figure_data.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void figure_hidden_begin(struct figure_lines *out, const char *style)
{
    if (out->count == FIGURE_LINES)
        return;
    struct figure_line *line = &out->line[out->count++];
    *line = (struct figure_line){.first = out->point_count, .end = out->point_count};
    snprintf(line->style, sizeof line->style, "%s", style);
}

void figure_hidden_keep(struct figure_lines *out, double x, double y)
{
    if (out->count == 0 || out->failed)
        return;
    if (out->point_count == out->capacity) {
        size_t more = out->capacity ? 2 * out->capacity : 256;
        double(*points)[2] = realloc(out->points, more * sizeof *points);
        out->failed = !points;
        if (!points)
            return;
        out->points = points;
        out->capacity = more;
    }
    out->points[out->point_count][0] = x;
    out->points[out->point_count][1] = y;
    out->line[out->count - 1].end = ++out->point_count;
}

/* A chart's size in points on the page, as in drawing_parts.h without its labels, and how near a line must be to be
 * covered. */
static const double wide = 570, tall = 340, covered = 1.5;

/** Place of a value along an axis. */
static double place(double value, struct figure_extent axis, bool logarithmic, double length)
{
    double low = logarithmic ? log10(axis.low) : axis.low, high = logarithmic ? log10(axis.high) : axis.high;
    return high > low ? length * ((logarithmic ? log10(value) : value) - low) / (high - low) : 0;
}

/** Does the stretch from a to b pass over a point, all on the page? */
static bool covers(const double *a, const double *b, const double *point)
{
    double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    double along = square > 0 ? ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / square : 0;
    along = fmin(fmax(along, 0), 1);
    return hypot(point[0] - a[0] - along * dx, point[1] - a[1] - along * dy) <= covered;
}

/** Adds 1 to count[i] of every point of a line that `other` passes over. Both go one way along x. */
static void count_covered(unsigned char *count, double (*page)[2], const struct figure_line *line,
                          const struct figure_line *other)
{
    if (line->end - line->first < 2 || other->end - other->first < 2)
        return;
    double way = page[line->end - 1][0] < page[line->first][0] ? -1 : 1;
    size_t s = other->first;
    for (size_t i = line->first; i < line->end; i++) {
        while (s + 2 < other->end && way * page[s + 1][0] < way * page[i][0] - covered)
            s++;
        bool found = false;
        for (size_t n = s; n + 1 < other->end && way * page[n][0] <= way * page[i][0] + covered && !found; n++)
            found = covers(page[n], page[n + 1], page[i]);
        count[i] += found;
    }
}

/** The end of the run of covered points that begins at `from`. */
static size_t run_end(const unsigned char *count, size_t from, size_t end)
{
    while (from < end && count[from] > 0)
        from++;
    return from;
}

/** The stretches of line `k` that later lines cover, as one block; nothing where none is worth a dash. */
static void put_stretches(struct figure_file *out, double (*page)[2], size_t k, const unsigned char *later,
                          const unsigned char *earlier)
{
    static const double least = 20; /* a shorter stretch is a crossing */
    const struct figure_line *line = &out->lines.line[k];
    bool begun = false;
    for (size_t from = line->first, to; from < line->end; from = to + 1) {
        to = run_end(later, from, line->end);
        if (to - from < 2 || hypot(page[to - 1][0] - page[from][0], page[to - 1][1] - page[from][1]) < least)
            continue;
        if (!begun) {
            size_t middle = (from + to) / 2;
            char style[40];
            snprintf(style, sizeof style, "%sh%d%d", line->style, later[middle], later[middle] + earlier[middle] + 1);
            drawing_begin(&out->drawing, style, "hidden");
        } else {
            drawing_add(&out->drawing, NULL, 0);
        }
        begun = true;
        for (size_t i = from; i < to; i++)
            drawing_add(&out->drawing, out->lines.points[i], 2);
    }
}

/** Leaves out of lines that are thinned the points that stand within a point of the page of the one before, but for its
 * last. */
static void thin_lines(struct figure_lines *lines, double (*page)[2])
{
    static const double apart = 1;
    size_t to = 0;
    for (size_t k = 0; k < lines->count; k++) {
        struct figure_line *line = &lines->line[k];
        size_t first = to;
        bool whole = line->end - line->first <= drawing_whole;
        for (size_t i = line->first; i < line->end; i++) {
            bool near = !whole && to > first && fabs(page[i][0] - page[to - 1][0]) < apart &&
                        fabs(page[i][1] - page[to - 1][1]) < apart;
            if (near && i + 1 < line->end)
                continue;
            memmove(page[to], page[i], sizeof *page);
            memmove(lines->points[to++], lines->points[i], sizeof *lines->points);
        }
        line->first = first;
        line->end = to;
    }
    lines->point_count = to;
}

void figure_hidden_put(struct figure_file *file, struct figure_extent x, struct figure_extent y, bool x_logarithmic,
                       bool y_logarithmic)
{
    size_t count = file->lines.point_count;
    double(*page)[2] = malloc((count + 1) * sizeof *page);
    unsigned char *later = malloc(2 * count + 1);
    file->lines.failed = file->lines.failed || !page || !later;
    for (size_t i = 0; !file->lines.failed && i < count; i++) {
        page[i][0] = place(file->lines.points[i][0], x, x_logarithmic, wide);
        page[i][1] = place(file->lines.points[i][1], y, y_logarithmic, tall);
    }
    if (!file->lines.failed) {
        thin_lines(&file->lines, page);
        count = file->lines.point_count;
    }
    unsigned char *earlier = later ? later + count : NULL;
    for (size_t k = 0; !file->lines.failed && k + 1 < file->lines.count; k++) {
        memset(later, 0, 2 * count);
        for (size_t j = 0; j < file->lines.count; j++)
            if (j != k)
                count_covered(j > k ? later : earlier, page, &file->lines.line[k], &file->lines.line[j]);
        put_stretches(file, page, k, later, earlier);
    }
    free(page);
    free(later);
}

void figure_hidden_free(struct figure_lines *lines)
{
    free(lines->points);
    *lines = (struct figure_lines){0};
}
