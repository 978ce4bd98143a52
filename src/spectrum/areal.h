/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Figures of an areal map: heights over its plane, and its rows as profiles. */
#ifndef SPECTRUM_AREAL_H
#define SPECTRUM_AREAL_H

#include "scan/scan.h"
#include "spectrum/power_law_scans.h"
#include "spectrum/roughness.h"
#include "spectrum/spectrum.h"

/** ISO 25178-2 of the heights over their least-squares plane, each a mean over the points that are there. */
struct areal_parameters {
    double sq_m, sa_m, sz_m; /* root mean square, mean absolute, highest minus lowest */
    double ssk, sku;         /* mean third and fourth power over that of Sq: 0 and 3 of Gaussian heights */
    double sdq;              /* root mean square gradient, by central differences, as m2 of the rows is */
};

struct areal {
    struct areal_parameters surface;
    struct roughness rows;    /* each row over its own line; m0, Ra, m2, m4 averaged over the rows, PV the largest */
    struct spectrum spectrum; /* mean power of the rows, as grid_average() joins them */
    struct power_law_scans scans; /* the same rows, for the power law */
    size_t spectrum_rows;         /* rows in it: not flat, at most a tenth missing (ends cut off, gaps bridged) */
};

/** Missing points are left out of every figure; a slope or curvature counts where all its points are there. Owned:
 * areal_free(), whatever comes back. Errors: STATUS_SCAN: too few points, a flat map; STATUS_MEMORY. */
MUST_CHECK enum status_code areal_compute(struct areal *out, const struct scan *scan, struct status *status);
/** The heights over the least-squares plane, in place of those of the scan: height_m (nx*ny, row after row, NaN where
 * missing). Error: STATUS_SCAN: too few points for a plane. */
MUST_CHECK enum status_code areal_flatten(double *height_m, const struct scan *scan, struct status *status);

/** Error: the same; STATUS_MEMORY. */
MUST_CHECK enum status_code areal_parameters_of(struct areal_parameters *out, const struct scan *scan,
                                                struct status *status);
void areal_free(struct areal *areal);

#endif
