/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Measured contact resistance, to be held against the models (scene: `measured`). */
#ifndef ANSWERS_MEASURED_H
#define ANSWERS_MEASURED_H

#include "base/unit.h"
#include "contact/model.h"
#include "joint/joint.h"
#include "members/surface.h"

/** One file: the points from `first` to before `end`, of which those behind `turn`, the one of the largest load, are of
 * the way down. */
struct measured_run {
    size_t first, turn, end;
};

/** Points of a surface in the models' units, in the order in which they were measured (loading, then unloading), run
 * after run. Owned: measured_free(). */
struct measured {
    const struct scene_measured *given;
    size_t before;           /* points of the surfaces that were read before it */
    size_t count, run_count; /* 0: none */
    struct measured_run *runs;
    double *load;       /* P/(A_n E') */
    double *resistance; /* per nominal area: Ω m² or K m²/W */
    double *error;      /* of the resistance, same unit; NaN where none is given */
    bool thermal;       /* TCR, else ECR */
    char load_unit[UNIT_LENGTH], resistance_unit[UNIT_LENGTH]; /* that they were given in, as written */
};

/** What the growth of conductance with load is a mark of. */
enum measured_mark {
    MEASURED_ROUGH,        /* as the model's own curve, about P^.95 */
    MEASURED_ELASTIC_SPOT, /* one spot, P^1/3 */
    MEASURED_PLASTIC_SPOT, /* P^1/2 */
    MEASURED_FILM,         /* that all heat or current goes through, P^1 */
    MEASURED_BULK,         /* P^0 */
    MEASURED_NOT_FLAT,     /* any between */
    MEASURED_MARKS
};
struct measured_exponent {
    double measured, sd, model; /* d ln G/d ln P; NaN: fewer than 3 points more than runs */
    enum measured_mark mark;    /* the likeliest, */
    double times;               /* times as likely as the next; NaN: it is beyond all */
};
extern const double measured_tells; /* times, from which it is said */

/** What the models say at the measured loads, as far as these lie within the run's. Owned: measured_answers_free(). */
struct measured_answers {
    double *resistance;  /* [model][measured point]; NaN: beyond the run's loads, or none */
    struct estimate fit; /* measured over predicted conductance, by measured_fit(); count 0: none */
    size_t fitted;       /* the model */
    struct measured_exponent exponent;
    bool carried; /* targets' loads are solved with that factor */
};

/** The models' quantity that measurements are held against with these EFFECT_BITs: the resistance with film and plating
 * where these are called for. */
enum quantity measured_quantity(const struct measured *measured, unsigned effects);
/** Runs the models of the plan at the measured loads themselves, on every scan as the surface's curve, with what lies
 * in the joint. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code measured_answer(struct measured_answers *out, const struct measured *measured,
                                            const struct surface_record *record, const struct surface_task *asked,
                                            struct status *status);
/** Fits the factor that the loading points carry of the conductance of model `m`, with the interval of their scatter;
 * of several runs that of the runs' means; and what the growth of their conductance is a mark of. Error: STATUS_MEMORY.
 */
MUST_CHECK enum status_code measured_fit(struct measured_answers *out, const struct measured *measured, size_t m,
                                         struct status *status);
void measured_answers_free(struct measured_answers *answers);

/** How far a model is from the measurements, over the loads that it answers. */
struct measured_distance {
    size_t points;       /* compared */
    double rms_decades;  /* of log10(model/measured); NaN when no point could be compared */
    double bias_decades; /* mean of the same */
};

/** Reads the files of out->given (see measured_file.h), measured on these bodies; all but that and `before` is zeroed.
 * Units are those that a file names, else the scene's load_unit and resistance_unit. N are divided by the nominal area,
 * Ω and K/W multiplied by it; an error in the unit 1 or % is relative, one without unit is in the resistance's. Errors:
 * STATUS_SCENE with file, line and remedy (as measured_file_read(); no unit anywhere, file and scene of two minds, N, Ω
 * or K/W without nominal_area_m2, nothing to compare with); STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code measured_read(struct measured *out, const struct scene *scene, const struct plan *plan,
                                          const struct material_pair *pair, struct status *status);
void measured_free(struct measured *measured);

/** Distance of model `m`. */
struct measured_distance measured_compare(const struct measured *measured, const struct measured_answers *answers,
                                          size_t m);

/** The model of least RMS distance among those that answer at least half as many points as the one that answers most;
 * model_count when none answers any. */
size_t measured_nearest(const struct measured *measured, const struct measured_answers *answers);

#endif
