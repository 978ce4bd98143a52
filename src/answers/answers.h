/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers to a scene's questions on one surface: the load that each target takes, by every model, and whether the
 * limits hold at the operating load. */
#ifndef ANSWERS_ANSWERS_H
#define ANSWERS_ANSWERS_H

#include "base/text.h"
#include "scene/plan.h"

struct surface_record; /* members/surface.h */

enum answer_kind {
    ANSWER_NONE,       /* the model has no such number */
    ANSWER_LOAD,       /* the target is met at `load` */
    ANSWER_LIGHTEST,   /* it is met at the first load already, which is `load` */
    ANSWER_NOT_REACHED /* it is not met up to `load`, the last at which the model has the number */
};

/** What a model says of a target. Loads are P/(A_n E'). */
struct answer {
    enum answer_kind kind;
    double load;
    double low, high;    /* 95 % interval of the surface's load; NaN: not known */
    double spots_per_m2; /* at that load; NaN: not known */
    bool invalid;        /* beyond the model's range of validity there */
    bool full;           /* the load is that of full contact, where it is met at the latest: numbers end before */
    bool wider;          /* an end of the interval lies beyond the loads, and wider ones could tell it */
    bool held; /* a filler's bond line holds the metals apart there, or from there on, and no load changes that */
    bool above_hardness; /* an elastic model whose contact bears more than that there */
    size_t counted_by;   /* the model whose spots they are, where they are known */
};

enum limit_verdict { LIMIT_NO_VALUE, LIMIT_MET, LIMIT_MISSED, LIMIT_UNDECIDED };

/** The one word for each: "no value", "met", "missed", "undecided". */
extern const char *const limit_verdict_words[];

/** A limit at the operating load, by the leading model; numbers of its row's quantity. */
struct limit_check {
    double value;     /* NaN: the model has none there */
    double low, high; /* 95 % interval; NaN: not known, and the value alone decides */
    enum limit_verdict verdict;
};

/** Fills record->summary.answers and .limits, once all models and intervals are there, and adds a search a target to
 * each model's work; once more after summary.carried has become known. Each target is solved on the surface's curve, to
 * the tolerance of `task`. The interval is where the ends of the quantity's band pass the target: the model times the
 * band's factor, which goes straight in ln P between the loads. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code answers_find(struct surface_record *record, const struct scene *scene,
                                         const struct plan *plan, const struct model_task *task, struct status *status);

/** Fills record->summary.limits by the model that leads the plan. */
void answers_check_limits(struct surface_record *record, const struct scene *scene, const struct plan *plan,
                          const struct model_task *task);

/** Spots below which a contact is no matter for statistics. */
extern const double answers_least_spots;
/** "not reached up to 0.1 N; beyond the model's validity; too few spots for statistics (9.1)": nothing, or what goes
 * with the answer's load, which stands in `load_unit` ("": P/(A_n E')), `load_scale` of them one P/(A_n E'). */
void answers_note(struct text *out, const struct answer *answer, double nominal_area_m2, double load_scale,
                  const char *load_unit);

/** Does an interval (or the value, where none is known) keep within a limit? */
enum limit_verdict answers_judge(const struct limit_check *check, const struct scene_asked *limit);

#endif
