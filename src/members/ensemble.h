/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The records of a surface: its scans, pieces of longer scans, rows of a map, or records simulated from one scan. The
 * models run on each member alone. The surface's curve is the geometric mean of the members' curves, and their scatter
 * gives its uncertainty. The curve of the mean spectrum differs from it by two to four standard deviations of a scan,
 * since averaging removes each harmonic's scatter; that spectrum is only drawn and fitted. */
#ifndef MEMBERS_ENSEMBLE_H
#define MEMBERS_ENSEMBLE_H

#include "base/fft.h"
#include "contact/model.h"
#include "joint/joint.h"
#include "scene/scene.h"
#include "statistics/estimate.h"

/** Rows solved as one strip, and their bearing curve. Owned: solved_strip_free(). */
struct solved_strip {
    struct strip strip;
    struct bearing bearing;
};
void solved_strip_free(struct solved_strip *solved);

struct member {
    struct spectrum spectrum;
    struct roughness roughness;
    size_t first_piece, pieces;     /* its rows among the surface's strip rows; 0: none */
    struct solved_strip *strip;     /* those rows, solved; NULL: not solved */
    struct prepared_strip prepared; /* that strip, or the surface's; by ensemble_prepare() */
    size_t scan;                    /* index of its scan */
    bool is_row;                    /* a row of a map */
    double *height_m;               /* levelled; kept until the surface is described, else NULL */
    size_t points;
    double spacing_m;
    bool periodic; /* its end joins its beginning */
    uint64_t seed; /* for its strip's surrogates, from the heights as measured */
};

/** Members in the order of their scans. Owned: ensemble_free(). */
struct ensemble {
    struct member *members;
    size_t count;        /* 0: a single scan, the surface itself */
    double *scan_weight; /* of each scan its length over that of the shortest */
    size_t scan_count;   /* 1: a map, whose rows the members are */
    double sigma_m;      /* rms height of the surface */
    bool keeps_heights;  /* also of pieces */
    bool solved_alone;   /* models that use strips answer only for members that have one */
};
void ensemble_free(struct ensemble *set);

/** Room for one more member, zeroed and counted. NULL: out of memory. */
struct member *ensemble_room(struct ensemble *set);

/** The first member of `other` from the scan (of a map: the row) with the same number as that of member p of `set`.
 * other->count: none. */
size_t ensemble_partner(const struct ensemble *set, size_t p, const struct ensemble *other);

/** How a piece of a scan is conditioned: like the whole scan. */
struct record_conditioning {
    enum level level;
    bool periodic_mean;          /* from a periodic record only the mean is removed */
    bool periodic;               /* the scan is periodic, so the piece may be */
    enum spectrum_window window; /* auto: none on periodic records */
    enum roughness_moments moments;
    bool keeps_heights; /* of the member */
};
struct record_conditioning record_conditioning_of(const struct scene *scene, bool periodic);

/** Levels the heights in room->record (which are used up), and finds their spectrum, roughness and, where wanted, a
 * copy (owned: spectrum_free(), free()); how->periodic says that this record is periodic. Where no form can be fitted
 * the heights stay as they are. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code member_of_record(struct member *out, struct fft_room *room, size_t points, double spacing_m,
                                             const struct record_conditioning *how, struct status *status);
/** Heights, evenly spaced. */
struct record_heights {
    const double *height_m;
    size_t points;
    double spacing_m;
};
/** Adds a member from a copy of the heights; in a periodic scan it is checked whether they are periodic too. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_add(struct ensemble *set, size_t scan, const struct record_heights *of,
                                         const struct record_conditioning *how, struct status *status);

/** Two rough bodies: adds to each member its partner's spectrum and roughness, and drops members without a partner.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_pair(struct ensemble *set, const struct ensemble *other, struct status *status);

/** `task` for one member in place of the surface; a member without a strip of its own takes the surface's.
 * `asperities` holds the member's. */
struct model_task member_task(struct asperities *asperities, const struct member *member,
                              const struct model_task *task);

/** Prepares the members' strips for them (model_strips_prepare()). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_prepare(struct ensemble *set, const struct model_task *task,
                                             struct status *status);

/** A number of a member, and its scan. */
struct ensemble_value {
    double value;
    size_t scan;
};
/** Mean and uncertainty of `count` numbers, in the order of their scans. Those of one scan are averaged first, and that
 * mean counts with the scan's weight. A map, whose rows are not independent, gives a mean without an interval. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_estimate(struct estimate *out, const struct ensemble *set,
                                              const struct ensemble_value *of, size_t count, bool logarithmic,
                                              struct status *status);

/** Curves of those members for which a model has a solution, with room for task->load_count + 1 points each. Owned:
 * ensemble_curves_free(). */
struct ensemble_curves {
    struct model_curve *curves;
    struct contact_point *points; /* of all */
    struct ensemble_value *of;    /* one a curve: its member's scan, and room for a value */
    double *sigma_m;              /* its member's rms height */
    size_t count;
    size_t left_out;      /* members without a solution */
    uint64_t evaluations; /* and `overflows`: over all members, as in struct model_curve */
    bool overflows;
};
/** Runs a model on every member. `joint`: film, plating or filler in each contact; NULL: none. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_run(struct ensemble_curves *out, const struct ensemble *set,
                                         const struct model_row *model, const struct model_task *task,
                                         const struct joint_task *joint, struct status *status);
void ensemble_curves_free(struct ensemble_curves *curves);

/** Intervals at a load, low and high: separation over each member's sigma, the other quantities as they are. NaN: not
 * known. */
struct ensemble_band {
    double load;
    double mean[QUANTITY_COUNT][2]; /* 95 %: of the surface's mean */
    double next[QUANTITY_COUNT][2]; /* 95 %: of one more scan */
};
/** A band at these loads, all NaN, malloc'ed; NULL: out of memory. */
struct ensemble_band *ensemble_band_make(const double *loads, size_t count);

/** The numbers of a curve that have an uncertainty: each quantity at the operating load, as the model shows it, then
 * these. */
enum { CURVE_FULL_LOAD = QUANTITY_COUNT, CURVE_BETA, CURVE_ESTIMATES };

/** Bounds the estimates at a point by physics (joint_bounds()), and adjusts them where a filler's bond line keeps the
 * gap open (joint_hold()): without metal contact only the filler's conductance remains, and has no scatter; else
 * intervals are centred on the point's own numbers. */
void ensemble_hold(struct estimate estimates[QUANTITY_COUNT], const struct contact_point *point,
                   const struct model_row *model, const struct joint_task *joint);
/** Completes the estimates of all quantities at a point: adds the model's own error, and centres the joint's quantities
 * on the point, since they are computed from means and are not means themselves. An area that is load over hardness has
 * no interval. */
void ensemble_settle(struct estimate estimates[QUANTITY_COUNT], const struct contact_point *point,
                     const struct model_row *model, const struct joint_task *joint, struct scans_reach reach);

/** The uncertainty of the surface's curve. */
struct ensemble_result {
    const struct joint_task *joint; /* the joint, whose quantities get estimates too; NULL: bare contact */
    struct ensemble_band *band;     /* task->load_count of them, the caller's; NULL: not wanted */
    struct estimate estimates[CURVE_ESTIMATES];
    size_t scans, left_out; /* members used, and members without a solution */
};

/** The curve of a surface by one model (its points: the caller's).
 * One scan: the curve of `task`. Several members: at every load that all of them reach, the geometric mean of their
 * answers, and of their loads of full contact. (Where a model ends before full contact, a member that has ended keeps
 * its last value as long as at least half go on.) Separation is the mean of separation/sigma times the surface's sigma.
 * Beta and a statistical model's own separation may be negative and have the arithmetic mean. A resistance or
 * separation that has reached 0 on some members is empty. Strips: the geometric mean of that curve and of the curve of
 * all rows joined; of a map the latter alone. A model that solves the map itself has no members. result: NULL, or where
 * the uncertainty goes. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_curve(struct model_curve *curve, struct ensemble_result *result,
                                           const struct ensemble *set, const struct model_row *model,
                                           const struct model_task *task, struct status *status);
#endif
