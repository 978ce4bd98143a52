/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact models side by side: one row each, from name to evaluation. A new model is one file, which ends in its
 * row, and one word in model_table.c. Nothing outside src/contact names a model: ask the rows. */
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

/** Profiles solved as strips, the heights of these in order, and their spectrum. */
struct model_strips {
    const struct spectrum *spectrum;
    const struct strip *strip;
    const struct bearing *bearing;
};

/** What scans tell of their surface beside their numbers. */
struct scans_reach {
    double longest_waves; /* spectrum_longest_waves() of scans whose ends are open; 0: they close */
    bool two_directions;  /* they run across the lay, and how it is along it is known */
};

/** What a model is asked: one surface, one pair of bodies, a list of loads. */
struct model_task {
    const struct spectrum *spectrum;
    struct cmy rough;                    /* the surface's own sigma and mean slope; 0: those of its spectrum */
    const struct asperities *asperities; /* NULL: no statistical model exists for this surface */
    const struct material_pair *pair;
    const double *loads; /* P/(A_n E'), ascending */
    size_t load_count;
    size_t operating_place; /* 1 + the place of the load where the summary stands; 0: the middle */
    unsigned wanted;        /* QUANTITY_BITs */
    double tolerance;
    enum sinusoid_fit_id sinusoid_fit;
    double hardness_Pa;            /* H_d of the softer body; NaN: not known */
    bool levelled;                 /* a line was taken out of the scans, and a wave with it */
    bool carries_on;               /* beyond the area where a model ends it answers as there: one of several scans */
    const struct strip_rows *rows; /* its profiles; NULL: not there */
    const struct strip *strip;     /* these solved as a strip, for models that use_strip; NULL: not there */
    const struct bearing *bearing; /* their heights in order, for those that are plastic too; NULL: not there */
    struct model_strips flatter;   /* of the flatter of two directions, for models that use_strip; strip NULL: there is
                                      none, else it has a share of the answer */
    bool two_directions;           /* struct scans_reach */
    const struct transfer *transfer; /* a map's direct solution, for models that use_map; NULL: not there */
    uint64_t *evaluations; /* what running models takes is added here: visits of scales, laws at quadrature nodes, loads
                              solved for a separation; NULL: it is not counted */
};

#define MODEL_STIFFNESS_STEP 1e-3 /* in ln P, where a separation is a smooth function of it */

/** Where |d ln R/d ln P| of a curve falls, because a scale's contact becomes complete and its resistance is gone. */
struct model_kink {
    double load; /* P/(A_n E'), within 1e-4 */
    double wavelength_m;
};

/** What it answers. `points` is the caller's, load_count + 1 long. */
struct model_curve {
    bool exists;    /* false: the model was not run, or has no solution for this surface */
    bool overflows; /* it has none because its numbers leave the range of double; then no points */
    struct contact_point *points;
    size_t count;              /* statistical: ends with the point of full contact, when the loads reach it */
    double full_load;          /* P/(A_n E') at which A = A_n; NaN: the model does not say */
    double closed_load;        /* at which the (adjusted) separation is 0; NaN: the model does not say */
    double beta;               /* of the adjusted separation, else NaN */
    struct contact_point full; /* at full_load itself; all NaN where that is */
    uint64_t clamped;          /* stacked scales: visits in which the published area was limited: multiscale_solve() */
    struct model_kink kink;    /* the same: the first of them, by load; load 0: none, as a mean of curves */
    uint64_t evaluations;      /* that it took */
    size_t carried;            /* points at the end that are only carried on */
};

struct model_row {
    const char *name;                    /* as in contact.csv and scenes */
    const char *label;                   /* as in charts, tables and lists of names: no comma */
    const char *family;                  /* asked for together in scenes */
    bool plastic;                        /* needs the effect plasticity */
    const struct model_row *elastic;     /* of a plastic model: the one it adds yield to; NULL: none */
    const struct model_row *counterpart; /* multiscale model of the same material law, which the thesis holds this one
                                            against; NULL: none */
    const struct model_row *gaussian;    /* the same answer of Gaussian heights, over which this one's says what the
                                            heights do; NULL: none */
    bool stacks_scales;                  /* every harmonic is a scale: the convergence study speaks of it */
    const struct asperity_model *asperity_model; /* it sums this over model_task.asperities; NULL: it needs none */
    bool uses_strip;                             /* works on model_task.strip, and model_task.bearing where plastic */
    bool uses_map;                               /* is model_task.transfer: of the whole surface, not of its scans */
    unsigned quantities;                         /* QUANTITY_BITs it computes */
    unsigned may_be_empty; /* those of them that it leaves empty (NaN) where it should not be trusted */
    double largest_area;   /* A/A_n up to which it is valid; 0: any */
    bool ends;             /* it has no numbers beyond that */
    double stiffness_step; /* in ln P to either side, over which model_run() takes the slope of its separation; 0: it
                              computes its stiffness itself, or none */
    bool textbook;         /* handbooks print it: the first page sets it beside the leading one, where it is valid. It
                              follows from the surface's own sigma and slope; its scans alone say how these scatter */
    int precedence;        /* the summary speaks of the running model with the greatest */
    int thesis_place;      /* among the four charts of each quantity in chapter 6, 1...4; 0: not in the thesis */
    bool in_findings;      /* the findings of chapter 6 are checked on it */
    const char *colour;    /* of its line, "#rrggbb", for a light and a dark page */
    int marker;            /* gnuplot's point type: open (even) elastic, filled (odd) plastic */
    const char *does;      /* in a clause that "which" begins */
    const char *equations; /* the defining ones, and their numbers or section in docs/equations.md */
    const char *source;
    const char *assumes;
    const char *valid;
    const char *method; /* how its numbers come about */
    /** Fills the curve. Error: STATUS_MEMORY. */
    enum status_code (*run)(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status);
    /** Number and radius of the spots at the loads of the task, one of `spots` a load; nothing but what they need is
     * computed, and only when asked. NULL: the model has none (of stacked scales, every scale has its own). Error:
     * STATUS_MEMORY. */
    enum status_code (*spots)(struct contact_spots *spots, const struct model_row *row, const struct model_task *task,
                              struct status *status);
};

extern const struct model_row *const model_rows[];
extern const size_t model_count; /* below 64: sets of models are bits of a uint64_t */

/** Bit of a model in a set of models. */
#define MODEL_BIT(model) (UINT64_C(1) << (model))

/** Index of a row in the table; model_count when it is not in it (or NULL). */
size_t model_index(const struct model_row *row);
/** Models of that name or family, as bits; 0: no such name. */
uint64_t model_find(const char *name);
/** Those that run when a scene names none, all; the ones that use heights only where a surface is not Gaussian. */
uint64_t model_defaults(void);
/** Those whose flag at this offset of their row is set: model_flagged(offsetof(struct model_row, uses_map)). */
uint64_t model_flagged(size_t offset);
/** May model `m` of the set `models` run with these EFFECT_BITs: a plastic one needs plasticity. */
bool model_runs(size_t m, uint64_t models, unsigned effects);

/** The place among its loads of the one where the summary stands. */
size_t model_task_operating(const struct model_task *task);
/** `task` at other loads, which have no operating load of their own. */
struct model_task model_task_at(const struct model_task *task, const double *loads, size_t load_count);

/** Runs a model, on points of which nothing is known: it writes what it knows. A curve any of whose loads, areas or
 * wanted quantities is not finite does not exist: materials and heights may each be possible and still leave the range
 * of double together (JG's exponent 23 S_y/E' of 1e6). Error: STATUS_MEMORY. */
MUST_CHECK enum status_code model_run(struct model_curve *curve, const struct model_row *row,
                                      const struct model_task *task, struct status *status);

/** A contact in the quantities that are wanted: ECR A_n = (rho_1 + rho_2) l. */
struct contact_point model_point(const struct transfer_point *contact, const struct model_row *row,
                                 const struct model_task *task);

/** How far a model is from the contact of a surface of any heights: standard deviations of ln area, gap, resistance. */
struct model_error {
    const struct model_row *model;
    bool two_directions; /* of scans that know both; of a model that has no such row, the same as of one */
    double ln_sd[3];
};
extern const struct model_error model_errors[]; /* model_error.c; a model that is not in it says nothing of its error */
extern const size_t model_error_count;

/** A model's error of what the quantity follows; 0: not known. */
double model_sd(const struct model_row *row, enum quantity quantity, bool two_directions);
struct scans_reach model_task_reach(const struct model_task *task);
/** What scans of fewer than 2.5 longest waves cannot know of the surface, of ln a quantity: 1.3 ln(2.5/waves), measured
 * against direct solutions. waves 0: nothing. */
double model_few_waves_sd(double longest_waves);
/** model_sd() with that in quadrature; of a model of no known error nothing. */
double model_surface_sd(const struct model_row *row, enum quantity quantity, struct scans_reach reach);
/** The factor that 95 % of what has this standard deviation of its logarithm lie within: how errors are printed. */
double model_factor(double ln_sd);

/** 1 - (P/(H A))^4 at a point of a model with a hardness: d ln A/d ln A_e of bearing_area(), A_e the elastic area; 1 of
 * any other. `load_over_hardness`: P/H, NaN where no hardness is known. */
double model_elastic_share(const struct model_row *row, const struct contact_point *point, double load_over_hardness);
/** Is the area P/H there, load and hardness alone, to a thousandth? Then no surface differs in it from another, and
 * more scans change nothing. Not where contact is full. */
bool model_area_is_pressed(const struct model_row *row, const struct contact_point *point, double load_over_hardness);
/** Does an elastic model's contact bear more than the hardness? Then its error is not known: the model answers for a
 * contact that there is not. */
bool model_is_overloaded(const struct model_row *row, const struct contact_point *point, double load_over_hardness);

/** The separation to show: the adjusted one of models that have it. Other quantities are as they are. */
enum quantity model_shown(const struct model_row *row, enum quantity quantity);

#endif
