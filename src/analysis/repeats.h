/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Repeated scans of one surface. Each goes through the models alone, and the surface's curve is the geometric mean of
 * theirs: the curve of their mean spectrum is another quantity (every harmonic's scatter averaged away), two to four
 * standard deviations of a scan from it. The mean spectrum is there to be drawn and fitted. */
#ifndef ANALYSIS_REPEATS_H
#define ANALYSIS_REPEATS_H

#include "analysis/estimate.h"
#include "contact/model.h"
#include "spectrum/power_law.h"

enum {
    REPEATS_ROWS_MOST = 128, /* rows of a map that are run alone; of more, REPEATS_BLOCK_ROWS in each block */
    REPEATS_BLOCK_ROWS = REPEATS_ROWS_MOST / ESTIMATE_BLOCKS
};

/** What is run alone: a scan, a piece of one, or a row of a map. */
struct repeat {
    struct spectrum spectrum;
    struct roughness roughness;
    size_t scan;      /* index of the scan it is of */
    double *height_m; /* levelled; of a profile, until its scans are known to be of one length; else NULL */
    size_t points;
    double spacing_m;
    bool periodic; /* it closes on itself */
};

/** A file. */
struct repeats_scan {
    const char *file; /* of the scene, which holds it */
    double weight;    /* lengths of the shortest scan that it holds */
};

/** The scans of a surface, parts in their order. Owned by the record that holds it: repeats_free(). */
struct repeat_set {
    struct repeat *parts;
    size_t count, capacity; /* 0: a single scan, the surface itself */
    struct repeats_scan *scans;
    size_t scan_count;
    double sigma_m;    /* rms height of the surface */
    bool no_intervals; /* a rough counterface adds scatter of its own, which its scans do not tell */
};
void repeats_free(struct repeat_set *set);

/** What the scans of a surface say apart. */
struct repeats {
    size_t count; /* run alone: 0 or at least 2 */
    size_t scans; /* files; 1: a map, whose rows they are */
    size_t cut;   /* pieces that scans longer than the shortest were cut to; 0: all of one length */
    struct estimate rq_m, gamma, psd_m3; /* the latter two by a fit to each */
};

/** Does every part belong to the one map that the surface is? */
bool repeats_are_rows(const struct repeat_set *set);

/** What values are of: the scan of each, ascending. */
struct repeats_grouping {
    const struct repeat_set *set;
    const size_t *scan; /* of value i */
    size_t count;
};

/** What is known of a number from its value of every part: the mean over a scan's parts counts once, with the scan's
 * weight; rows of a map by estimate_rows(). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_estimate(struct estimate *out, const double *value, const struct repeat_set *set,
                                             bool logarithmic, struct status *status);
/** The same of values that are not one of each part. */
MUST_CHECK enum status_code repeats_estimate_grouped(struct estimate *out, const double *value,
                                                     const struct repeats_grouping *of, bool logarithmic,
                                                     struct status *status);

/** Rq, and gamma and C = Delta² L/2 (power spectral density at the middle of `law`, the mean spectrum's) of a fit to
 * each part in that law's band (law NULL: not, that is done elsewhere). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_laws(struct repeats *out, const struct repeat_set *set, const struct power_law *law,
                                         struct status *status);

/** Intervals at a load, low and high: of the separation that the model shows over sigma, record by record, and of the
 * others as they are. NaN where not known. */
struct repeats_band {
    double load;
    double mean[QUANTITY_COUNT][2]; /* 95 %: where the surface's mean lies */
    double next[QUANTITY_COUNT][2]; /* 95 %: where another scan lies */
};
/** A band of nothing known at these loads: malloc'ed; NULL: out of memory. */
struct repeats_band *repeats_band_make(const double *loads, size_t count);
/** Does a band hold this quantity? Area, separation, ECR and TCR. */
bool repeats_band_holds(enum quantity quantity);

/** `task` with one part in place of the mean of all; `asperities` is where its own go. */
struct model_task repeats_task(struct asperities *asperities, const struct repeat *part, const struct model_task *task);

/** What repeats_model() fills beside the curve. */
struct repeats_result {
    struct repeats_band *band;              /* task->load_count, the caller's, made by repeats_band_make() */
    struct estimate middle[QUANTITY_COUNT]; /* as in a band */
    struct estimate full_load, beta;
    size_t left_out; /* parts on which the model has no solution */
};

/** Runs a model on every part alone; for sets of several only. `curve` (its points: the caller's) is what the surface
 * has: at every load at which all have an answer, the geometric mean; so are the loads of full contact. Separations
 * are the means of each run's separation/sigma, times the surface's sigma; a statistical model's own one, and beta,
 * which may be negative, have the arithmetic mean. A resistance or separation shown of which some parts
 * have none left is empty. Error:
 * STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_model(struct model_curve *curve, struct repeats_result *result,
                                          const struct repeat_set *set, const struct model_row *model,
                                          const struct model_task *task, struct status *status);
#endif
