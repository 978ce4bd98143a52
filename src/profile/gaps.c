/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "profile/gaps.h"

#include <math.h>
#include <string.h>

enum { GAPS_LEAST_POINTS = 3 };

static size_t count_missing(const double *height_m, size_t points)
{
    size_t missing = 0;
    for (size_t i = 0; i < points; i++)
        missing += isnan(height_m[i]) ? 1 : 0;
    return missing;
}

static enum status_code check_share(size_t missing, size_t points, double most, struct status *status)
{
    double share = (double)missing / (double)points;
    if (share <= most)
        return STATUS_OK;
    const char *remedy = share < 0.9 ? "allow more with `max_missing`, or export the scan with the gaps filled"
                                     : "export the scan with the gaps filled";
    return status_fail(status, STATUS_SCAN, "%zu of %zu heights are missing, %.3g %% where %.3g %% may be; %s", missing,
                       points, 100 * share, 100 * most, remedy);
}

/** Moves the profile to between its first and its last height that is there. */
static void trim(struct profile *profile, size_t *first)
{
    size_t start = 0, end = profile->points;
    while (start < end && isnan(profile->height_m[start]))
        start++;
    while (end > start && isnan(profile->height_m[end - 1]))
        end--;
    memmove(profile->height_m, profile->height_m + start, (end - start) * sizeof *profile->height_m);
    profile->trimmed = profile->points - (end - start);
    profile->points = end - start;
    *first = start;
}

/** Bridges the gap before point `end`, whose last point before is `start`. */
static void bridge(double *z, const double *x, size_t start, size_t end)
{
    for (size_t i = start + 1; i < end; i++) {
        double share = x ? (x[i] - x[start]) / (x[end] - x[start]) : (double)(i - start) / (double)(end - start);
        z[i] = z[start] + share * (z[end] - z[start]);
    }
}

enum status_code gaps_close(struct profile *profile, size_t *first, const double *x_m, double most,
                            struct status *status)
{
    size_t missing = count_missing(profile->height_m, profile->points);
    *first = 0;
    if (missing == 0)
        return STATUS_OK;
    if (check_share(missing, profile->points, most, status) != STATUS_OK)
        return status->code;
    trim(profile, first);
    if (profile->points < GAPS_LEAST_POINTS)
        return status_fail(status, STATUS_SCAN, "only %zu heights are there; a profile needs %d", profile->points,
                           GAPS_LEAST_POINTS);
    const double *x = x_m ? x_m + *first : NULL;
    size_t last = 0, gaps = 0, widest = 0;
    for (size_t i = 1; i < profile->points; i++) {
        if (isnan(profile->height_m[i]))
            continue;
        if (i > last + 1) {
            bridge(profile->height_m, x, last, i);
            gaps++;
            widest = i - last - 1 > widest ? i - last - 1 : widest;
        }
        last = i;
    }
    profile->bridged = missing - profile->trimmed;
    if (profile->trimmed > 0)
        profile_note(profile, "%zu missing points at the ends were cut off", profile->trimmed);
    if (profile->bridged > 0)
        profile_note(profile,
                     "%zu missing points in %zu gap%s were bridged by straight lines, the longest over %zu point%s",
                     profile->bridged, gaps, gaps == 1 ? "" : "s", widest, widest == 1 ? "" : "s");
    return STATUS_OK;
}
