/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What stands for a surface: its scans, subrecords of longer ones, rows of a map, or records simulated of one scan.
 * Every member goes through the models alone; the surface's curve is the geometric mean of theirs, and their scatter
 * says how sure it is. The curve of the mean spectrum is another quantity (every harmonic's scatter averaged away), two
 * to four standard deviations of a scan from it; the mean spectrum is there to be drawn and fitted. */
#ifndef MEMBERS_ENSEMBLE_H
#define MEMBERS_ENSEMBLE_H

#include "base/fft.h"
#include "contact/model.h"
#include "joint/joint.h"
#include "scene/scene.h"
#include "statistics/estimate.h"

/** Rows in one strip, solved, and their heights in order. Owned: solved_strip_free(). */
struct solved_strip {
    struct strip_rows rows;
    struct strip strip;
    struct bearing bearing;
};
void solved_strip_free(struct solved_strip *solved);

struct member {
    struct spectrum spectrum;
    struct roughness roughness;
    size_t first_piece, pieces; /* which of the surface's strip rows are of it; 0: none */
    struct solved_strip *strip; /* these solved; NULL: not */
    size_t scan;                /* index of the scan it is of */
    bool is_row;                /* of a map */
    double *height_m;           /* levelled, until the surface is described; NULL: not kept */
    size_t points;
    double spacing_m;
    bool periodic; /* it closes on itself */
    uint64_t seed; /* of the heights as they were measured, of its strip's surrogates */
};

/** A file. */
struct ensemble_scan {
    const char *file; /* of the scene, which holds it */
    double weight;    /* lengths of the shortest scan that it holds */
};

/** Members in the order of their scans. Owned: ensemble_free(). */
struct ensemble {
    struct member *members;
    size_t count, capacity; /* 0: a single scan, the surface itself */
    struct ensemble_scan *scans;
    size_t scan_count;  /* 1: a map, whose rows the members are */
    double sigma_m;     /* rms height of the surface */
    bool keeps_heights; /* also those of subrecords and of rows of a map */
    bool solved_alone;  /* a model that uses strips has no answer of a member that has none */
};
void ensemble_free(struct ensemble *set);

/** Room for one more member, zeroed and counted. NULL: out of memory. */
struct member *ensemble_room(struct ensemble *set);

/** The first member of `other` that is of the same place in it as member p is in `set`: of the scan of that number, of
 * a map the row of that number. other->count: none. */
size_t ensemble_partner(const struct ensemble *set, size_t p, const struct ensemble *other);

/** How a record that is no whole scan is made ready: as the scan that it is of. */
struct record_conditioning {
    enum level level;
    bool periodic_mean;          /* of a periodic record the mean is taken out instead */
    bool periodic;               /* the scan closes on itself, so that the record may */
    enum spectrum_window window; /* auto: by whether the record closes on itself */
    enum roughness_moments moments;
    bool keeps_heights; /* of the member */
};
struct record_conditioning record_conditioning_of(const struct scene *scene, bool periodic);

/** Levels the heights in room->record, which are used up, and takes their spectrum, roughness and, where they
 * are to be kept, a copy (owned: spectrum_free(), free()); how->periodic: they close on themselves. A form that does
 * not fit leaves them as they are. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code member_of_record(struct member *out, struct fft_room *room, size_t points, double spacing_m,
                                             const struct record_conditioning *how, struct status *status);
/** Heights, evenly spaced. */
struct record_heights {
    const double *height_m;
    size_t points;
    double spacing_m;
};
/** Adds a member made of a copy of the heights; of a periodic scan it is looked at whether they close too. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_add(struct ensemble *set, size_t scan, const struct record_heights *of,
                                         const struct record_conditioning *how, struct status *status);

/** Two rough bodies: adds to each member its partner's spectrum and roughness; members that have none are dropped.
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_pair(struct ensemble *set, const struct ensemble *other, struct status *status);

/** `task` on one member in place of the surface, whose strip and bearing curve it has where it has none of its own;
 * `asperities` is where its own go. */
struct model_task member_task(struct asperities *asperities, const struct member *member,
                              const struct model_task *task);

/** A number, of one member after another. */
struct ensemble_values {
    const double *value;
    const size_t *scan; /* of each, ascending */
    size_t count;
};
/** What is known of a number from values of members, the scan of each ascending: the mean over a scan's values counts
 * once, with the scan's weight; of a map, whose rows are not independent, the mean alone. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_estimate(struct estimate *out, const struct ensemble *set,
                                              const struct ensemble_values *of, bool logarithmic,
                                              struct status *status);

/** Curves of the members on which a model has a solution, each task->load_count + 1 points long. Owned:
 * ensemble_curves_free(). */
struct ensemble_curves {
    struct model_curve *curves;
    struct contact_point *points; /* of all */
    size_t *scan;
    double *value, *sigma_m; /* one a curve: to work with; its member's rms height */
    size_t count;
    size_t left_out;      /* members on which it has none, of those that it was asked about */
    uint64_t evaluations; /* of all members, as in struct model_curve; like `overflows` */
    bool overflows;
};
/** `joint`: what lies between each of them and the counterface; NULL: nothing. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_run(struct ensemble_curves *out, const struct ensemble *set,
                                         const struct model_row *model, const struct model_task *task,
                                         const struct joint_task *joint, struct status *status);
void ensemble_curves_free(struct ensemble_curves *curves);

/** Intervals at a load, low and high: of the separation that the model shows over sigma, member by member, and of the
 * others as they are. NaN where not known. */
struct ensemble_band {
    double load;
    double mean[QUANTITY_COUNT][2]; /* 95 %: where the surface's mean lies */
    double next[QUANTITY_COUNT][2]; /* 95 %: where another scan lies */
};
/** A band of nothing known at these loads: malloc'ed; NULL: out of memory. */
struct ensemble_band *ensemble_band_make(const double *loads, size_t count);

/** Numbers of a curve that scans run alone, or simulated records, say how far off may be: each quantity at the
 * operating load, as the model shows it, then these. */
enum { CURVE_FULL_LOAD = QUANTITY_COUNT, CURVE_BETA, CURVE_ESTIMATES };

/** Estimates at a point that a bond line holds (joint_hold()), else nothing: where no metal touches, only the filler's
 * heat, as sure as the scene; else the point's own numbers in the middle. */
void ensemble_hold(struct estimate estimates[QUANTITY_COUNT], const struct contact_point *point,
                   const struct joint_task *joint);
/** Completes estimates of all quantities at a point of a surface: the model's own error; the point's numbers in the
 * middle of those of the joint, which are not the mean of the members' but made of means; an area of load and hardness
 * alone has no interval. */
void ensemble_settle(struct estimate estimates[QUANTITY_COUNT], const struct contact_point *point,
                     const struct model_row *model, const struct joint_task *joint, struct scans_reach reach);

/** What the members say beside the surface's curve. */
struct ensemble_result {
    const struct joint_task *joint; /* whose numbers have estimates too; NULL: there is nothing in it */
    struct ensemble_band *band;     /* task->load_count, the caller's; NULL: not wanted */
    struct estimate estimates[CURVE_ESTIMATES];
    size_t scans, left_out; /* members that it is of, and as in struct ensemble_curves */
};

/** The curve of a surface (its points: the caller's) in one model, as wherever it is asked for. Of one scan that of
 * `task`. Of several members the mean of their curves: at every load at which all have an answer, the geometric mean
 * (of models that end before complete contact: while half of them do not, the others as at their end); so are the loads
 * of full contact. Separations are the means of each member's separation/sigma, times the surface's sigma; a
 * statistical model's own one, and beta, which may be negative, have the arithmetic mean. A resistance or separation
 * shown of which some members have none left is empty. A model that uses strips speaks of the members that were solved
 * alone, and has the geometric mean of that and of its curve of the joined rows; of a map the latter alone. One that
 * uses the map knows no members. result: NULL, or what the members say. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code ensemble_curve(struct model_curve *curve, struct ensemble_result *result,
                                           const struct ensemble *set, const struct model_row *model,
                                           const struct model_task *task, struct status *status);
#endif
