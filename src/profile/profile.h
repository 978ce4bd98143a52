/* A scan made ready: heights at a uniform spacing, levelled (physics §1). */
#ifndef PROFILE_PROFILE_H
#define PROFILE_PROFILE_H

#include "scan/scan.h"
#include "scene/scene.h"

enum profile_spacing { PROFILE_UNIFORM, PROFILE_ROUNDED, PROFILE_RESAMPLED };

struct profile {
    double *height_m; /* `points` heights, spacing_m apart, levelled */
    size_t points;
    double spacing_m;
    enum profile_spacing grid; /* as printed; rounded x, nominal spacing used; uneven x, interpolated */
    double tilt;               /* slope the levelling took out (line, parabola), else 0 */
    double end_jump_m;         /* last minus first height after levelling: the record is not periodic */
};

/** Makes the profile of a scan's row `row` (0 for a profile). An x that is uniform up to the rounding of its digits
 * gets its mean spacing; a truly uneven one is interpolated monotonically (Steffen) to a uniform grid.
 * Owned: profile_free(). Errors: STATUS_SCAN: missing points, a flat profile; STATUS_MEMORY. */
MUST_CHECK enum status_code profile_make(struct profile *out, const struct scan *scan, size_t row,
                                         enum scene_level level, struct status *status);
void profile_free(struct profile *profile);

/** Takes the least-squares mean, line or parabola out of `points` heights. Returns the slope of the line taken out, as
 * height per point (0 for none and mean). */
double profile_level(double *height_m, size_t points, enum scene_level level);

#endif
