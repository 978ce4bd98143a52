/* One surface from its scans to its curves: the pipeline scan -> profile -> spectrum + roughness -> contact. */
#ifndef RESULTS_SURFACE_H
#define RESULTS_SURFACE_H

#include "base/text.h"
#include "contact/convergence.h"
#include "contact/model.h"
#include "profile/profile.h"
#include "results/plan.h"
#include "results/spread.h"
#include "spectrum/powerlaw.h"

enum { SURFACE_PREVIEW = 1000 }; /* points of a profile kept for the chart */

/** Where a run's time goes, by stage [s]. */
struct surface_times {
    double read, prepare, spectrum, models[MODEL_COUNT], convergence;
};

/** What is kept of a model for every surface: small, so that ten thousand surfaces fit. */
struct surface_model {
    bool exists;
    double full_load, closed_load, beta, beta_multiscale;
    double area_slope;        /* d ln A/d ln P, least squares over A/A_n < 0.1 */
    double area_slope_rms;    /* decades */
    double elbow_load;        /* where |d ln ECR/d ln P| first exceeds 2; NaN: nowhere */
    double sd_least, sd_most; /* TCR_sd/TCR - 1 over the curve */
    double invalid_area_load; /* statistical: first load with A/A_n > 0.1; NaN: none */
    double invalid_fit_load;  /* JG: first load with over 10 % of it beyond a/R = 0.41; NaN: none */
    double most_outside;      /* largest share of the load beyond a/R = 0.41 */
    double gap_at_full;       /* separation/sigma at the load of A = A_n (adjusted for the statistical models) */
    double area_low;          /* A/A_n at the lowest load */
    size_t yielding_scales;
    uint64_t clamped;      /* multiscale plastic: visits in which the published area was cut off at 1 */
    double most_saturated; /* JG: largest share of the load on asperities whose a/R is clamped to 1 */
    struct model_work work;
    bool extended; /* multiscale: the fitted law was carried on below the sampling limit */
    struct convergence_extension extension;
};

/** How far the surface could call for an effect, from bounds that cost next to nothing (bound.h). */
struct surface_bound {
    double yield;           /* least p_c/p* of a scale; at least 1: no scale yields before it is complete */
    double jg_excess;       /* bound on JG's relative difference from GW up to full contact */
    double scale_dependent; /* over the tolerance: TCR_sd/TCR - 1 at some load; else its bound over loads and models */
    uint64_t visits;        /* of scales, to bound that */
    bool settled;           /* no scale below the sampling limit can take any area at the convergence study's load */
};

struct surface_summary {
    const struct scene_surface *scene; /* name and files */
    bool usable;                       /* false: refused, see `refusal` */
    char *refusal;                     /* one line; owned */
    char *notes;                       /* one line a warning; owned, NULL: none */
    char hash[65];                     /* SHA-256 of the first file (of all of them one after another), hexadecimal */
    char format[32];
    char units[40];       /* "x mm, z um" as read */
    size_t scans;         /* averaged: files, or rows of a map */
    struct spread spread; /* what they say apart */
    size_t points;        /* of the first */
    double spacing_m, length_m;
    enum profile_spacing grid;
    double tilt;
    double jump_m;     /* end-to-end jump, root mean square over the scans */
    double jump_share; /* amplitude that jump leaks at the short end of the fit band / fitted amplitude there */
    struct roughness roughness;
    struct asperities asperities;
    bool has_asperities; /* a statistical model exists */
    struct powerlaw law;
    size_t harmonics;
    struct surface_bound bound;
    size_t part_asperities;   /* scans run alone for which the statistical models exist */
    uint64_t part_laws[2][2]; /* asperity laws these take: [plastic][scale-dependent] */
    struct surface_model models[MODEL_COUNT];
    struct surface_times times;
};

/** Everything of one surface; `points`, `spectrum` and the preview live as long as the record. */
struct surface_record {
    struct surface_summary summary;
    struct spectrum spectrum;
    struct spread_part parts[SPREAD_PARTS]; /* scans to be run alone too */
    size_t part_count, part_stride;         /* every part_stride-th scan is one */
    struct model_curve curves[MODEL_COUNT];
    struct spread_band *bands[MODEL_COUNT]; /* band_count each, NULL: none */
    size_t band_count;
    double preview_x_m[SURFACE_PREVIEW], preview_z_m[SURFACE_PREVIEW];
    size_t preview_points;
};

/** Reads and describes one surface: everything but the models. What is wrong with its files is no error: then
 * summary.usable is false and summary.refusal says why in one line. `counterface` is the described rough
 * counterface, NULL for a smooth one. Error: STATUS_MEMORY. Owned: surface_record_free().
 */
MUST_CHECK enum status_code surface_describe(struct surface_record *out, const struct scene *scene,
                                             const struct scene_surface *surface,
                                             const struct surface_record *counterface, struct status *status);

/** What the models are asked of a described surface. */
struct model_task surface_task(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                               const double *loads, size_t load_count);

/** Runs the models that `plan` calls for on a described surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code surface_run_models(struct surface_record *record, const struct scene *scene,
                                               const struct plan *plan, const double *loads, size_t load_count,
                                               struct status *status);
/** Will the fitted law of a described surface be carried on below its sampling limit, if the effect convergence runs?
 */
bool surface_extends(const struct surface_summary *summary, const struct scene *scene);

/** Frees the arrays of a record; the summary's texts too when `with_texts`. */
void surface_record_free(struct surface_record *record, bool with_texts);

#endif
