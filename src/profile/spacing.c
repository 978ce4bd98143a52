/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/spacing.h"

#include "base/extremes.h"
#include <gsl/gsl_errno.h>
#include <gsl/gsl_spline.h>
#include <math.h>

static const double spacing_uniform = 1e-3; /* steps that differ by less, of their mean, are the same */
static const double spacing_same = 1e-4;    /* steps of one kind */
static const double spacing_nominal = 5e-3; /* how far the header's may be off: it has few digits too */
enum { SPACING_KINDS = 5 };

static enum profile_spacing judge(const double *x_m, size_t points, double spacing_m)
{
    double shortest = INFINITY, longest = 0, deviation = 0;
    double kinds[SPACING_KINDS];
    size_t kind_count = 0; /* distinct steps, up to SPACING_KINDS */
    for (size_t i = 1; i < points; i++) {
        double step = x_m[i] - x_m[i - 1];
        shortest = extremes_smaller(shortest, step);
        longest = extremes_larger(longest, step);
        deviation = extremes_larger(deviation, fabs(x_m[i] - x_m[0] - (double)i * spacing_m));
        size_t k = 0;
        while (k < kind_count && fabs(step - kinds[k]) > spacing_same * spacing_m)
            k++;
        if (k == kind_count && kind_count < SPACING_KINDS)
            kinds[kind_count++] = step;
    }
    if (longest - shortest <= spacing_uniform * spacing_m)
        return PROFILE_UNIFORM;
    if (kind_count < SPACING_KINDS && deviation <= 1.05 * (longest - shortest))
        return PROFILE_ROUNDED;
    return PROFILE_RESAMPLED;
}

struct spacing spacing_judge(const struct scan *scan)
{
    struct spacing spacing = {PROFILE_UNIFORM, scan->dx_m, false};
    if (!scan->x_m)
        return spacing;
    spacing.step_m = (scan->x_m[scan->nx - 1] - scan->x_m[0]) / (double)(scan->nx - 1);
    spacing.grid = judge(scan->x_m, scan->nx, spacing.step_m);
    if (spacing.grid == PROFILE_ROUNDED && fabs(scan->nominal_dx_m / spacing.step_m - 1) <= spacing_nominal) {
        spacing.step_m = scan->nominal_dx_m;
        spacing.nominal = true;
    }
    return spacing;
}

enum status_code spacing_resample(double *out_m, const double *x_m, const double *z_m, size_t points, double spacing_m,
                                  struct status *status)
{
    gsl_interp *spline = gsl_interp_alloc(gsl_interp_steffen, points);
    gsl_interp_accel *accel = gsl_interp_accel_alloc();
    enum status_code rc = STATUS_OK;
    if (!spline || !accel || gsl_interp_init(spline, x_m, z_m, points) != GSL_SUCCESS) {
        rc = status_memory(status);
    } else {
        for (size_t i = 0; i < points; i++) {
            double x = fmin(x_m[0] + (double)i * spacing_m, x_m[points - 1]);
            out_m[i] = gsl_interp_eval(spline, x_m, z_m, x, accel);
        }
    }
    gsl_interp_accel_free(accel);
    gsl_interp_free(spline);
    return rc;
}
