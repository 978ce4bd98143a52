/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the models on one surface, and answers a scene's questions: the load that each target needs, by every model, and
 * whether the limits are kept at the operating load. */
#ifndef ANSWERS_ANSWERS_H
#define ANSWERS_ANSWERS_H

#include "base/text.h"
#include "scene/plan.h"

struct surface_record; /* members/surface.h */
struct surface_task;   /* the same */

enum answer_kind {
    ANSWER_NONE,       /* the model does not compute the quantity */
    ANSWER_LOAD,       /* the target is met at `load` */
    ANSWER_LIGHTEST,   /* it is met at the first load already, `load` */
    ANSWER_NOT_REACHED /* it is not met up to `load`, the last at which the model has a value */
};

/** A model's answer to a target. Loads are P/(A_n E'). */
struct answer {
    enum answer_kind kind;
    double load;
    double low, high;    /* 95 % interval of the load; NaN: not known */
    double spots_per_m2; /* at that load; NaN: not known */
    bool invalid;        /* the model is outside its range there */
    bool most;  /* `load` is an end: at full contact, before which values end, or by physics the target is met there */
    bool wider; /* an end of the interval lies outside the loads; wider loads could give it */
    bool held;  /* there, or from there on, a filler's bond line fixes the gap, and more load changes nothing */
    bool above_hardness; /* an elastic model whose mean contact pressure exceeds the hardness there */
    size_t counted_by;   /* the model that counted the spots, if they are known */
};

enum limit_verdict { LIMIT_NO_VALUE, LIMIT_MET, LIMIT_MISSED, LIMIT_UNDECIDED };

/** The one word for each: "no value", "met", "missed", "undecided". */
extern const char *const limit_verdict_words[];

/** A limit at the operating load, by the leading model; values of the limit's quantity. */
struct limit_check {
    double value;     /* NaN: the model has no value there */
    double low, high; /* 95 % interval; NaN: not known, then the value decides */
    enum limit_verdict verdict;
};

/** Runs those models of the plan that can answer for a surface that has been read, and plans its direct study where
 * called for. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code surface_answers_find(struct surface_record *record, const struct surface_task *task,
                                                 struct status *status);

/** Fills record->summary.answers and .limits after all models have run; once more after summary.carried is known. Each
 * target is solved on the surface's curve to the tolerance of `task`. Its interval ends where the ends of the
 * quantity's band meet the target; the factor from curve to band is linear in ln P between the loads. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code answers_find(struct surface_record *record, const struct scene *scene,
                                         const struct plan *plan, const struct model_task *task, struct status *status);

/** Fills record->summary.limits by the plan's leading model. */
void answers_check_limits(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                          const struct model_task *task);

/** Fewer spots than these are too few for statistics. */
extern const double answers_least_spots;
/** Adds remarks on the answer's load, or nothing: "not reached up to P/(A_n E') = 0.1; beyond the model's validity; too
 * few spots for statistics (9.1)". */
void answers_note(struct text *out, const struct answer *answer, double nominal_area_m2);

/** Does the interval (or the value, without one) keep the limit? */
enum limit_verdict answers_judge(const struct limit_check *check, const struct scene_asked *limit);

#endif
