/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parameters of an areal map: of its heights over their plane, and of its rows as profiles. */
#ifndef SPECTRUM_AREAL_H
#define SPECTRUM_AREAL_H

#include "scan/scan.h"
#include "spectrum/power_law_scans.h"
#include "spectrum/roughness.h"
#include "spectrum/spectrum.h"

/** ISO 25178-2, heights over their least-squares plane; means over the points that are not missing. */
struct areal_parameters {
    double sq_m, sa_m, sz_m; /* root mean square, mean absolute, highest minus lowest */
    double ssk, sku;         /* mean third and fourth power over that of Sq: 0 and 3 of Gaussian heights */
    double sdq;              /* root mean square gradient by central differences, like m2 of the rows */
};

struct areal {
    struct areal_parameters surface;
    struct roughness rows;    /* each row over its own line; m0, Ra, m2, m4 averaged over the rows, PV the largest */
    struct spectrum spectrum; /* mean power of the rows, as grid_average() joins them */
    struct power_law_scans scans; /* the same rows, not flat and at most a tenth missing (ends cut off, gaps bridged) */
};

/** Missing points are left out; a slope or curvature counts where none of its points is missing. Owned: areal_free(),
 * also after an error. Errors: STATUS_SCAN: too few points, a flat map; STATUS_MEMORY. */
MUST_CHECK enum status_code areal_compute(struct areal *out, const struct scan *scan, struct status *status);
/** Heights over the least-squares plane: height_m (nx*ny, row after row, NaN where missing). Error: STATUS_SCAN: too
 * few points for a plane. */
MUST_CHECK enum status_code areal_flatten(double *height_m, const struct scan *scan, struct status *status);
/** Errors: the same; STATUS_MEMORY. */
MUST_CHECK enum status_code areal_parameters_of(struct areal_parameters *out, const struct scan *scan,
                                                struct status *status);
void areal_free(struct areal *areal);

#endif
