/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact models: one row each. A new model is one file, which ends in its row, and one word in model_table.c.
 * Nothing outside src/contact names a model: ask the rows. */
#ifndef CONTACT_MODEL_H
#define CONTACT_MODEL_H

#include "contact/asperity.h"
#include "contact/bearing.h"
#include "contact/cmy.h"
#include "contact/quantity.h"
#include "contact/sinusoid.h"
#include "contact/transfer.h"
#include "spectrum/roughness.h"
#include "spectrum/spectrum.h"
#include <stdint.h>

/** What models need of a strip and a surface, whatever the loads: made once, since a target asks for dozens of single
 * loads. Owned: strip_nodes_free(&nodes). */
struct prepared_strip {
    const struct strip *strip; /* these three tell whether it is for a task */
    const struct spectrum *spectrum;
    double lost_m2;
    struct strip_nodes nodes;
};

/** Profiles solved as strips, their bearing curve and their spectrum. */
struct model_strips {
    const struct spectrum *spectrum;
    const struct strip *strip;
    const struct bearing *bearing;
    const struct prepared_strip *prepared;
};

/** How much of their surface scans show. */
struct scans_reach {
    double longest_waves; /* spectrum_longest_waves(); 0: periodic scans */
    bool two_directions;  /* scans both along and across the lay */
};

/** The input of a model: one surface, one pair of bodies, a list of loads. */
struct model_task {
    const struct spectrum *spectrum;
    struct cmy rough;                    /* sigma and mean slope of the surface; 0: those of its spectrum */
    const struct asperities *asperities; /* NULL: statistical models have no solution for this surface */
    const struct material_pair *pair;
    const double *loads; /* P/(A_n E'), ascending */
    size_t load_count;
    size_t operating_place; /* 1 + index of the operating load; 0: the middle */
    unsigned wanted;        /* QUANTITY_BITs */
    double tolerance;
    enum sinusoid_fit_id sinusoid_fit;
    double hardness_Pa;            /* of the softer body; NaN: not known */
    bool open;                     /* a scan does not close on itself */
    bool levelled;                 /* a line was subtracted from the scans, and with it their longest wave */
    bool carries_on;               /* beyond its largest area a model repeats its last answer: one of several scans */
    const struct strip *strip;     /* the profiles solved as a strip, for models that use_strip; NULL: none */
    const struct bearing *bearing; /* their bearing curve, for plastic models that use_strip; NULL: none */
    const struct prepared_strip *prepared; /* of that strip; where it is of another surface, or NULL, it is made anew */
    struct model_strips
        flatter; /* the flatter of two directions, a share of the answer of models that use_strip; strip NULL: none */
    bool two_directions;             /* struct scans_reach */
    const struct transfer *transfer; /* a map's direct solution, for models that use_map; NULL: none */
    uint64_t
        *evaluations; /* counts the work of all models run: scales, quadrature nodes, loads solved; NULL: no count */
};

#define MODEL_STIFFNESS_STEP 1e-3 /* in ln P, for models with a smooth separation */

/** Where |d ln R/d ln P| of a curve falls because a scale comes into complete contact and its resistance ends. */
struct model_kink {
    double load; /* P/(A_n E'), within 1e-4 */
    double wavelength_m;
};

/** The output of a model. `points` is the caller's, load_count + 1 long. */
struct model_curve {
    bool exists;    /* false: the model was not run, or has no solution for this surface */
    bool overflows; /* no solution, because its numbers leave the range of double */
    struct contact_point *points;
    size_t count;              /* statistical: the last is the point of full contact if the loads reach it */
    double full_load;          /* P/(A_n E') at which A = A_n; NaN: not known */
    double crushed_load;       /* at which P = H and a plastic model's answers end; 0, NaN: none */
    double beta;               /* of the adjusted separation, else NaN */
    struct contact_point full; /* at full_load; NaN where that is not known */
    uint64_t clamped;          /* stacked scales: how often the published area was limited (multiscale_solve()) */
    struct model_kink kink;    /* stacked scales: the first, by load; load 0: none */
    uint64_t evaluations;      /* the work it took */
    size_t carried;            /* points at the end that repeat the last answer (carries_on) */
};

struct model_row {
    const char *name;                    /* as in contact.csv and scenes */
    const char *label;                   /* as in charts, tables and lists: no comma */
    const char *family;                  /* scene name of several models */
    bool plastic;                        /* needs the effect plasticity */
    const struct model_row *elastic;     /* the same model without yield; NULL: none */
    const struct model_row *counterpart; /* multiscale model of the same material law, as compared in the thesis; NULL:
                                            none */
    const struct model_row *gaussian;    /* the same for Gaussian heights, for comparison; NULL: none */
    bool stacks_scales;                  /* every harmonic is a scale, so the convergence study applies */
    bool sums_asperities;                /* those of model_task.asperities */
    bool uses_strip;                     /* needs model_task.strip, and model_task.bearing if plastic */
    bool uses_map;                       /* needs model_task.transfer: solves the map, not its scans */
    unsigned quantities;                 /* QUANTITY_BITs it computes */
    unsigned may_be_empty;               /* QUANTITY_BITs of those that it leaves NaN where they are not valid */
    double largest_area;                 /* A/A_n up to which it is valid; 0: any */
    bool ends;                           /* it has no numbers beyond that */
    double stiffness_step; /* model_run() differentiates the separation over ln P -+ this; 0: the model computes its own
                              stiffness, or none */
    bool textbook;         /* printed beside the leading model on the first page, where valid */
    int precedence;        /* the running model with the greatest leads */
    int thesis_place;      /* among the four charts of each quantity in chapter 6, 1...4; 0: not in the thesis */
    bool in_findings;      /* the findings of chapter 6 are checked on it */
    const char *colour;    /* of its line, "#rrggbb", for a light and a dark page */
    int marker;            /* gnuplot's point type: open (even) elastic, filled (odd) plastic */
    const char *does;      /* a clause that follows "which" */
    const char *equations; /* with numbers, or the section in docs/equations.md */
    const char *source;
    const char *assumes;
    const char *valid;
    const char *method; /* of computation */
    /** Fills the curve. Error: STATUS_MEMORY. */
    enum status_code (*run)(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status);
    /** Number and radius of the spots at each load of the task, and nothing else. NULL: not known (with stacked scales
     * each scale has its own spots). Error: STATUS_MEMORY. */
    enum status_code (*spots)(struct contact_spots *spots, const struct model_row *row, const struct model_task *task,
                              struct status *status);
};

/** Of the models that give corrected Persson's answers, or these times a ratio: what they compute, and how far. */
#define MODEL_OF_CORRECTED_PERSSON                                                                                     \
    .quantities = QUANTITY_USUAL, .largest_area = CORRECTED_PERSSON_LARGEST_AREA, .ends = true

extern const struct model_row *const model_rows[];
extern const size_t model_count; /* below 64: sets of models are bits of a uint64_t */

/** Bit of a model in a set of models. */
#define MODEL_BIT(model) (UINT64_C(1) << (model))

/** Index of a row in the table; model_count when it is not in it (or NULL). */
size_t model_index(const struct model_row *row);
/** Models of that name or family, as bits; 0: no such name. */
uint64_t model_find(const char *name);
/** The models that run when a scene names none: all. */
uint64_t model_defaults(void);
/** Models with the flag at this offset of the row: model_flagged(offsetof(struct model_row, uses_map)). */
uint64_t model_flagged(size_t offset);
/** Is model `m` in the set and may it run with these EFFECT_BITs? A plastic one needs plasticity. */
bool model_runs(size_t m, uint64_t models, unsigned effects);

/** Prepares the task's strip for its surface. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code model_strips_prepare(struct prepared_strip *out, const struct model_task *task,
                                                 struct status *status);

/** Index of the operating load. */
size_t model_task_operating(const struct model_task *task);
/** `task` at other loads, with the middle one as operating load. */
struct model_task model_task_at(const struct model_task *task, const double *loads, size_t load_count);

/** Runs a model; unknown quantities are NaN. A curve with a load, area or wanted quantity that is not finite does not
 * exist: a possible material and possible heights may together leave the range of double (JG's exponent 23 S_y/E' of
 * 1e6). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code model_run(struct model_curve *curve, const struct model_row *row,
                                      const struct model_task *task, struct status *status);

/** The wanted quantities of a contact: ECR A_n = (rho_1 + rho_2) l. */
struct contact_point model_point(const struct transfer_point *contact, const struct model_row *row,
                                 const struct model_task *task);

/** Error of a model on surfaces of any heights: standard deviations of ln area, gap and resistance. */
struct model_error {
    const struct model_row *model;
    bool two_directions; /* for scans in both directions; a model without such a row has the same error for both */
    double ln_sd[3];
};
extern const struct model_error model_errors[]; /* a model without a row has no known error */
extern const size_t model_error_count;

/** Error of a model in ln of a quantity; 0: not known. */
double model_sd(const struct model_row *row, enum quantity quantity, bool two_directions);
struct scans_reach model_task_reach(const struct model_task *task);
/** Error in ln of any quantity from scans of fewer than 2.5 longest waves: 1.3 ln(2.5/waves), measured against direct
 * solutions. waves 0: none. */
double model_few_waves_sd(double longest_waves);
/** Both errors in quadrature; 0 where model_sd() is not known. */
double model_surface_sd(const struct model_row *row, enum quantity quantity, struct scans_reach reach);
/** The 95 % factor exp(1.96 sd): how errors are printed. */
double model_factor(double ln_sd);

/** d ln A/d ln A_e = 1 - (P/(H A))^4 of a plastic model (bearing_area()), A_e the elastic area; 1 for an elastic one.
 * `load_over_hardness`: P/H, NaN where no hardness is known. */
double model_elastic_share(const struct model_row *row, const struct contact_point *point, double load_over_hardness);
/** Is the area P/H to within a thousandth? Then it is the same for every surface, and more scans change nothing. Not at
 * full contact. */
bool model_area_is_pressed(const struct model_row *row, const struct contact_point *point,
                           const struct material_pair *pair);
/** Does an elastic model's contact bear more than the hardness? It cannot exist, and its error is not known. */
bool model_is_overloaded(const struct model_row *row, const struct contact_point *point,
                         const struct material_pair *pair);

/** Is the mean pressure below what the softer body bears, as far as it ends a model's answers? */
bool model_curve_bears(const struct model_curve *curve, double load);

/** The quantity to show: for separation the adjusted one, of models that have it. */
enum quantity model_shown(const struct model_row *row, enum quantity quantity);

#endif
