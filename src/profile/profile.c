#include "profile/profile.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_spline.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Projects the heights on orthogonal polynomials of u = -1...1 and takes them out, lowest first. */
double profile_level(double *height_m, size_t points, enum scene_level level)
{
    if (level == SCENE_LEVEL_NONE)
        return 0;
    double count = (double)points, half = (count - 1) / 2;
    double mean = 0;
    for (size_t i = 0; i < points; i++)
        mean += height_m[i] / count;
    double slope = 0, slope_norm = 0, u_square = 0;
    for (size_t i = 0; i < points; i++) {
        height_m[i] -= mean;
        double u = ((double)i - half) / half;
        slope += u * height_m[i];
        slope_norm += u * u;
    }
    if (level == SCENE_LEVEL_MEAN)
        return 0;
    slope /= slope_norm;
    u_square = slope_norm / count;
    double bend = 0, bend_norm = 0;
    for (size_t i = 0; i < points; i++) {
        double u = ((double)i - half) / half, form = u * u - u_square;
        height_m[i] -= slope * u;
        bend += form * height_m[i];
        bend_norm += form * form;
    }
    if (level == SCENE_LEVEL_PARABOLA && bend_norm > 0)
        for (size_t i = 0; i < points; i++) {
            double u = ((double)i - half) / half;
            height_m[i] -= bend / bend_norm * (u * u - u_square);
        }
    return slope / half;
}

/** How x deviates from a uniform grid. */
static enum profile_spacing judge_spacing(const double *x_m, size_t points)
{
    if (!x_m)
        return PROFILE_UNIFORM;
    double spacing = (x_m[points - 1] - x_m[0]) / (double)(points - 1);
    double shortest = INFINITY, longest = 0, deviation = 0;
    double kinds[5];
    size_t kind_count = 0; /* distinct steps, up to 5 */
    for (size_t i = 1; i < points; i++) {
        double step = x_m[i] - x_m[i - 1];
        shortest = fmin(shortest, step);
        longest = fmax(longest, step);
        deviation = fmax(deviation, fabs(x_m[i] - x_m[0] - (double)i * spacing));
        size_t k = 0;
        while (k < kind_count && fabs(step - kinds[k]) > 1e-4 * spacing)
            k++;
        if (k == kind_count && kind_count < 5)
            kinds[kind_count++] = step;
    }
    if (longest - shortest <= 1e-3 * spacing)
        return PROFILE_UNIFORM;
    /* positions printed with too few digits: few kinds of step, and no point further off than that digit */
    if (kind_count < 5 && deviation <= 1.05 * (longest - shortest))
        return PROFILE_ROUNDED;
    return PROFILE_RESAMPLED;
}

static enum status_code resample(struct profile *profile, const struct scan *scan, const double *z_m,
                                 struct status *status)
{
    gsl_interp *spline = gsl_interp_alloc(gsl_interp_steffen, profile->points);
    gsl_interp_accel *accel = gsl_interp_accel_alloc();
    enum status_code rc = STATUS_OK;
    if (!spline || !accel || gsl_interp_init(spline, scan->x_m, z_m, profile->points) != GSL_SUCCESS) {
        rc = status_memory(status);
    } else {
        for (size_t i = 0; i < profile->points; i++) {
            double x = fmin(scan->x_m[0] + (double)i * profile->spacing_m, scan->x_m[profile->points - 1]);
            profile->height_m[i] = gsl_interp_eval(spline, scan->x_m, z_m, x, accel);
        }
    }
    gsl_interp_accel_free(accel);
    gsl_interp_free(spline);
    return rc;
}

static double peak_to_valley(const double *height_m, size_t points)
{
    double highest = -INFINITY, lowest = INFINITY;
    for (size_t i = 0; i < points; i++) {
        highest = fmax(highest, height_m[i]);
        lowest = fmin(lowest, height_m[i]);
    }
    return highest - lowest;
}

enum status_code profile_make(struct profile *out, const struct scan *scan, size_t row, enum scene_level level,
                              struct status *status)
{
    *out = (struct profile){.points = scan->nx, .grid = judge_spacing(scan->x_m, scan->nx), .spacing_m = scan->dx_m};
    const double *z_m = scan->z_m + row * scan->nx;
    if (scan->missing > 0)
        return status_fail(status, STATUS_SCAN, "%zu heights are missing; export the scan with the gaps filled",
                           scan->missing);
    out->height_m = malloc(out->points * sizeof *out->height_m);
    if (!out->height_m)
        return status_memory(status);
    if (out->grid != PROFILE_RESAMPLED)
        memcpy(out->height_m, z_m, out->points * sizeof *z_m);
    else if (resample(out, scan, z_m, status) != STATUS_OK)
        return status->code;

    double first_m = out->height_m[0], before_m = peak_to_valley(out->height_m, out->points);
    if (before_m == 0)
        return status_fail(status, STATUS_SCAN, "the scan is flat: every height is %.9g m; check the column", first_m);
    out->tilt = profile_level(out->height_m, out->points, level) / out->spacing_m;
    /* a straight scan leaves what the subtraction rounds, in units of the last place of the heights */
    if (peak_to_valley(out->height_m, out->points) <= 32 * DBL_EPSILON * (fabs(first_m) + before_m))
        return status_fail(status, STATUS_SCAN,
                           "the scan is flat: no roughness is left after level: %s; check the "
                           "column",
                           scene_level_names[level]);
    out->end_jump_m = out->height_m[out->points - 1] - out->height_m[0];
    return STATUS_OK;
}

void profile_free(struct profile *profile)
{
    free(profile->height_m);
    *profile = (struct profile){0};
}
