/* Measured contact resistance, to be held against the models (scene: `measured`). */
#ifndef ANALYSIS_MEASURED_H
#define ANALYSIS_MEASURED_H

#include "analysis/plan.h"
#include "contact/model.h"

/** Points in the models' units, ascending in load. Owned: measured_free(). */
struct measured {
    size_t count;
    double *load;       /* P/(A_n E') */
    double *resistance; /* per nominal area: Ω m² or K m²/W */
    double *error;      /* of the resistance, same unit; NaN where none is given */
    bool thermal;       /* TCR, else ECR */
};

/** How far a model is from the measurements, over the loads that its curve covers. */
struct measured_distance {
    size_t points;       /* compared */
    double rms_decades;  /* of log10(model/measured); NaN when no point could be compared */
    double bias_decades; /* mean of the same */
    double load[2];      /* range compared */
};

/** Reads the scene's file: rows of load, resistance and perhaps error, in any delimiter; lines that do not begin with a
 * number are headings or comments. Errors: STATUS_SCENE with file, line and remedy (a row of another form, a load or
 * resistance that is not positive, newtons without nominal_area_m2, nothing to compare with); STATUS_IO, STATUS_MEMORY.
 */
MUST_CHECK enum status_code measured_read(struct measured *out, const struct scene *scene, const struct plan *plan,
                                          struct status *status);
void measured_free(struct measured *measured);

/** Distance of one curve, interpolated in log-log between its loads. */
struct measured_distance measured_compare(const struct measured *measured, const struct model_curve *curve);

#endif
