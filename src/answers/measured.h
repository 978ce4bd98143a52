/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measured contact resistance, compared with the models (scene: `measured`). */
#ifndef ANSWERS_MEASURED_H
#define ANSWERS_MEASURED_H

#include "base/unit.h"
#include "contact/model.h"
#include "joint/joint.h"
#include "members/surface.h"

/** One file: points `first` to before `end`; `turn` has the largest load, and the points after it are unloading. */
struct measured_run {
    size_t first, turn, end;
};

/** Measured points of a surface in the models' units, run after run, each in the order of measurement. Owned:
 * measured_free(). */
struct measured {
    const struct scene_measured *given;
    size_t before;           /* points of the surfaces read before */
    size_t count, run_count; /* 0: none */
    struct measured_run *runs;
    double *load;                                              /* P/(A_n E') */
    double *resistance;                                        /* per nominal area: Ω m² or K m²/W */
    double *error;                                             /* of the resistance, in its unit; NaN: not given */
    bool thermal;                                              /* TCR, else ECR */
    char load_unit[UNIT_LENGTH], resistance_unit[UNIT_LENGTH]; /* of the file, as written there */
};

/** How the measured conductance grows with load, beside the leading model's. */
struct measured_exponent {
    double measured, sd, model; /* d ln G/d ln P; NaN: too few points (at least 3 more than runs) */
    bool not_flat; /* the measured exponent is lower by more than its error and 0.08, and a film or series resistance
                      does not explain that as well */
};

/** The models' answers at those measured loads that lie within the scene's. Owned: measured_answers_free(). */
struct measured_answers {
    double *resistance;  /* [model][measured point]; NaN: outside the loads, or none */
    struct estimate fit; /* measured over modelled conductance: measured_fit(); count 0: none */
    struct measured_exponent exponent;
};

/** A resistance as a value of the quantity that it is compared with, which may be a conductance; and back. */
double measured_as(enum quantity quantity, double resistance);
/** The models' quantity to compare with, for these EFFECT_BITs: that of the whole joint. */
enum quantity measured_quantity(const struct measured *measured, unsigned effects);
/** Runs the models of the plan at the measured loads, with the joint, averaged over scans like the surface's curve.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code measured_answer(struct measured_answers *out, const struct measured *measured,
                                            const struct surface_record *record, const struct surface_task *asked,
                                            struct status *status);
/** Fits the factor from the conductance of model `m` to the loading points, with the interval from their scatter (of
 * several runs from that of the runs' means), and compares the exponents. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code measured_fit(struct measured_answers *out, const struct measured *measured, size_t m,
                                         struct status *status);
void measured_answers_free(struct measured_answers *answers);

/** Distance of a model from the measurements, over the loads at which it has an answer. */
struct measured_distance {
    size_t points;       /* compared */
    double rms_decades;  /* of log10(model/measured); NaN when no point could be compared */
    double bias_decades; /* mean of the same */
};

/** Reads the files of out->given (see measured_file.h), measured on these bodies; the other fields, except `before`,
 * come zeroed. Units are the file's, else the scene's load_unit and resistance_unit. N are divided by the nominal area,
 * Ω and K/W multiplied by it; an error in 1 or % is relative, one without unit is in the resistance's. Errors:
 * STATUS_SCENE with file, line and remedy (as measured_file_read(); no unit, different units in file and scene, N, Ω or
 * K/W without nominal_area_m2, an effect that does not run); STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code measured_read(struct measured *out, const struct scene *scene, const struct plan *plan,
                                          const struct material_pair *pair, struct status *status);
void measured_free(struct measured *measured);

/** The distance of model `m`. */
struct measured_distance measured_compare(const struct measured *measured, const struct measured_answers *answers,
                                          size_t m);

/** The model of least rms distance among those that answer at least half as many points as the one that answers most;
 * model_count: none. */
size_t measured_nearest(const struct measured *measured, const struct measured_answers *answers);

#endif
