/* Repeated scans of one surface: every scan run alone beside the mean spectrum, so that each curve carries a band and
 * each number a spread. */
#ifndef ANALYSIS_REPEATS_H
#define ANALYSIS_REPEATS_H

#include "contact/model.h"
#include "spectrum/power_law.h"

enum {
    REPEATS_MOST = 24,      /* scans (or rows of a map) of a surface that are also run alone; more are thinned evenly */
    REPEATS_BOOTSTRAP = 200 /* resamples */
};

/** Mean and standard deviation of a number over scans. */
struct repeats_number {
    size_t count;
    double mean, square; /* square: sum of squared deviations */
};

void repeats_add(struct repeats_number *number, double value);
/** Standard deviation of a single scan (n - 1); NaN below two. */
double repeats_deviation(const struct repeats_number *number);

/** One scan of a surface. Owned by the record that holds it. */
struct repeat {
    struct spectrum spectrum;
    struct roughness roughness;
};

/** What the scans of a surface say apart. */
struct repeats {
    size_t count; /* run alone: 0 or at least 2 */
    struct repeats_number rq_m, gamma, log_alpha;
    double gamma_interval[2]; /* bootstrap over scans, 95 %; NaN below three scans */
    double alpha_interval[2];
};

/** One standard deviation to either side of the scans' mean at a load; logarithmic for all but the separation, which
 * is the one the model shows. A quantity that not all scans have there (beyond a full contact) is NaN. */
struct repeats_band {
    double load;
    double limits[QUANTITY_COUNT][2]; /* area, separation, ECR and TCR; the others are not kept */
};
/** Does a band hold this quantity? */
bool repeats_band_holds(enum quantity quantity);

/** Fits each part's law and bootstraps gamma and alpha over the parts (fixed seed: the same input, the same numbers).
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_laws(struct repeats *out, const struct repeat *parts, size_t count,
                                         const double band_m[2], struct status *status);

/** `task` with one scan in place of the mean of all; `asperities` is where its own go. */
struct model_task repeats_task(struct asperities *asperities, const struct repeat *scan, const struct model_task *task);

/** Runs one model on every part alone: `band` (task->load_count entries, the caller's), and the model's `beta` and
 * logarithm of the load of full contact over the parts; adds what that took to *work. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code repeats_model(struct repeats_number *beta, struct repeats_number *log_full_load,
                                          struct repeats_band *band, const struct repeat *parts, size_t count,
                                          const struct model_row *model, const struct model_task *task,
                                          struct model_work *work, struct status *status);
/** What repeats_model() will take for this task. */
struct model_work repeats_work(const struct repeat *parts, size_t count, const struct model_row *model,
                               const struct model_task *task);

#endif
