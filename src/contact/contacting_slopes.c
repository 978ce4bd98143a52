/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/contacting_slopes.h"

#include "base/rank.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>

const size_t contacting_slopes_least = 30;
const double contacting_slopes_separation_area = 0.15;

size_t contacting_slopes_of_profile(struct slope_point *out, const double *height_m, size_t points, double spacing_m)
{
    for (size_t j = 1; j + 1 < points; j++) {
        double slope = (height_m[j + 1] - height_m[j - 1]) / (2 * spacing_m);
        out[j - 1] = (struct slope_point){height_m[j], slope * slope};
    }
    return points - 2;
}

/** m2(k) and p_k. That p_k never falls is asked for but comes by itself, rounding apart: the sum of s² does not, and
 * erf^-1(A)/sqrt(A) rises. */
static void lay_areas(struct contacting_slopes *slopes, const struct slope_point *point, const size_t *order)
{
    double sum = 0, correction = 0, highest = 0; /* compensated: a map has millions of points */
    slopes->mean_square[0] = slopes->load[0] = 0;
    for (size_t k = 1; k <= slopes->points; k++) {
        double term = point[order[k - 1]].slope_square - correction, next = sum + term;
        correction = (next - sum) - term;
        sum = next;
        slopes->mean_square[k] = sum / (double)k;
        double area = (double)k / (double)slopes->points;
        if (k >= contacting_slopes_least && k < slopes->points)
            highest = fmax(highest, persson_load(area, slopes->mean_square[k], slopes->energy_factor));
        slopes->load[k] = highest;
    }
}

double contacting_slopes_score(size_t i, size_t points)
{
    return gsl_cdf_ugaussian_Qinv(((double)i + 0.5) / (double)points);
}

/** Running means and co-moments of heights and normal scores y_i = Phi^-1(1 - (i+1/2)/M) (Welford 1962). */
static void lay_lines(struct contacting_slopes *slopes)
{
    double mean_y = 0, mean_z = 0, square = 0, product = 0, highest_m = slopes->height_m[0];
    for (size_t k = 1; k <= slopes->lines; k++) {
        double y = contacting_slopes_score(k - 1, slopes->points), z = slopes->height_m[k - 1] - highest_m;
        double from_y = y - mean_y, from_z = z - mean_z;
        mean_y += from_y / (double)k;
        mean_z += from_z / (double)k;
        square += from_y * (y - mean_y);
        product += from_y * (z - mean_z);
        double scale = k > 1 ? product / square : 0;
        slopes->line[k].scale_m = scale;
        slopes->line[k].offset_m = highest_m + (mean_z - scale * mean_y);
    }
}

size_t contacting_slopes_of_map(struct slope_point *out, const double *height_m, size_t nx, size_t ny, double dx_m,
                                double dy_m)
{
    size_t count = 0;
    for (size_t j = 1; j + 1 < ny; j++)
        for (size_t i = 1; i + 1 < nx; i++) {
            const double *z = height_m + j * nx + i;
            double x_slope = (z[1] - z[-1]) / (2 * dx_m), y_slope = (z[nx] - *(z - nx)) / (2 * dy_m);
            double square = (x_slope * x_slope + y_slope * y_slope) / 2;
            if (!isnan(*z) && !isnan(square))
                out[count++] = (struct slope_point){*z, square};
        }
    return count;
}

/** Sorts the heights into out->height_m; *order, malloc'ed: where each was. */
static enum status_code sort_heights(struct contacting_slopes *out, size_t **order, const struct slope_point *point,
                                     size_t points, struct status *status)
{
    *out = (struct contacting_slopes){.points = points};
    if (points <= contacting_slopes_least)
        return status_fail(status, STATUS_MODEL,
                           "%zu inner points are too few for the slopes of the highest ones: at least %zu are needed",
                           points, contacting_slopes_least + 1);
    double most = 2 * contacting_slopes_separation_area * (double)points;
    out->lines = (size_t)fmin(fmax(most + 1, (double)contacting_slopes_least), (double)(points - 1));
    out->line = malloc((out->lines + 1) * sizeof *out->line);
    out->height_m = malloc(points * sizeof *out->height_m);
    double *height_m = malloc(points * sizeof *height_m);
    *order = malloc(points * sizeof **order);
    enum status_code rc = STATUS_OK;
    if (!out->line || !out->height_m || !height_m || !*order)
        rc = status_memory(status);
    if (rc == STATUS_OK) {
        for (size_t i = 0; i < points; i++)
            height_m[i] = point[i].height_m;
        rc = rank_descending(*order, height_m, points, status);
    }
    if (rc == STATUS_OK)
        for (size_t k = 0; k < points; k++)
            out->height_m[k] = height_m[(*order)[k]];
    free(height_m);
    return rc;
}

enum status_code contacting_slopes_make(struct contacting_slopes *out, const struct slope_point *point, size_t points,
                                        double energy_factor, struct status *status)
{
    size_t *order = NULL;
    enum status_code rc = sort_heights(out, &order, point, points, status);
    out->energy_factor = energy_factor;
    if (rc == STATUS_OK) {
        out->mean_square = malloc((points + 1) * sizeof *out->mean_square);
        out->load = malloc((points + 1) * sizeof *out->load);
        rc = out->mean_square && out->load ? STATUS_OK : status_memory(status);
    }
    if (rc == STATUS_OK) {
        lay_areas(out, point, order);
        lay_lines(out);
    }
    if (rc == STATUS_OK && !(out->load[points - 1] > 0))
        rc = status_fail(status, STATUS_MODEL, "the surface has no slope; measure a rough one");
    free(order);
    if (rc != STATUS_OK)
        contacting_slopes_free(out);
    return rc;
}

enum status_code contacting_slopes_lines(struct contacting_slopes *out, const struct slope_point *point, size_t points,
                                         struct status *status)
{
    size_t *order = NULL;
    enum status_code rc = sort_heights(out, &order, point, points, status);
    if (rc == STATUS_OK)
        lay_lines(out);
    else
        contacting_slopes_free(out);
    free(order);
    return rc;
}

void contacting_slopes_free(struct contacting_slopes *slopes)
{
    free(slopes->mean_square);
    free(slopes->load);
    free(slopes->line);
    free(slopes->height_m);
    *slopes = (struct contacting_slopes){0};
}

struct contacting_slopes_area contacting_slopes_area(const struct contacting_slopes *slopes, double load)
{
    size_t low = contacting_slopes_least, high = slopes->points - 1;
    double points = (double)slopes->points;
    if (load < slopes->load[low])
        return (struct contacting_slopes_area){(double)low / points * (load / slopes->load[low]),
                                               CONTACTING_SLOPES_FEW};
    if (load >= slopes->load[high])
        return (struct contacting_slopes_area){(double)high / points, CONTACTING_SLOPES_BEYOND};
    while (high - low > 1) { /* p_low <= p < p_high */
        size_t middle = low + (high - low) / 2;
        if (slopes->load[middle] <= load)
            low = middle;
        else
            high = middle;
    }
    double share = 1; /* as p_low goes to 0 */
    if (slopes->load[low] > 0)
        share = log(load / slopes->load[low]) / log(slopes->load[high] / slopes->load[low]);
    double area = (double)low / points * exp(share * log((double)high / (double)low));
    return (struct contacting_slopes_area){area, CONTACTING_SLOPES_INSIDE};
}

/** floor(count), between 30 and `most`. */
static size_t counted(double count, size_t most)
{
    return (size_t)fmin(fmax(floor(count), (double)contacting_slopes_least), (double)most);
}

size_t contacting_slopes_fitted(const struct contacting_slopes *slopes, double area_ratio)
{
    return counted(2 * area_ratio * (double)slopes->points, slopes->lines);
}

bool contacting_slopes_gap(struct contacting_slopes_gap *out, const struct contacting_slopes *slopes,
                           const struct persson *persson, double load, double area_ratio)
{
    if (!(area_ratio <= contacting_slopes_separation_area))
        return false;
    size_t fitted = contacting_slopes_fitted(slopes, area_ratio);
    size_t k = counted(area_ratio * (double)slopes->points, slopes->points - 1);
    double offset_m = slopes->line[fitted].offset_m, scale_m = slopes->line[fitted].scale_m;
    *out = (struct contacting_slopes_gap){offset_m, scale_m, offset_m, 0};
    if (!(scale_m > 0 && slopes->mean_square[k] > 0 && persson->m2 > 0))
        return true;                                             /* a level top, or no wave: it touches as one */
    double steeper = sqrt(slopes->mean_square[k] / persson->m2); /* than the spectrum's waves */
    double sigma_m = sqrt(persson->m0_m2);
    struct persson_separation at = persson_separation(persson, load / steeper);
    out->separation_m += scale_m / sigma_m * at.separation_m;
    out->constriction_m = at.constriction_m * scale_m / (sigma_m * steeper) / 2; /* kappa = sigma_D steeper/b */
    return true;
}
