/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Results made up to order, without a run: every curve is a power law, so that what a report says of it can be worked
 * out by hand. */
#ifndef TEST_MADE_UP_RESULTS_H
#define TEST_MADE_UP_RESULTS_H

#include "report/view.h"

enum { MADE_UP_SURFACES = 4, MADE_UP_USABLE = 3, MADE_UP_LOADS = 9, MADE_UP_SCALES = 8, MADE_UP_MEASURED = 3 };

/* Loads 1e-6 ... 1e-2, two a decade; the middle one is 1e-4, E' is 1e11 Pa, so that it is 10 MPa.
 *
 *   index  name   rank    Rq     area/load  ECR load/1e-14
 *     0    beta    1    0.2 um      500          3             the baseline
 *     1    alpha   0    0.1 um     1000          1             the smoothest
 *     2    gamma   2    0.4 um      200          7.5
 *     3    broken                                              refused
 *
 * of multiscale elastic. Multiscale plastic has 2, GW 0.5 and JG 0.8 times the area and the inverse of that times the
 * resistance; TCR is 2e5 ECR, the scale-dependent one 1.02 TCR; separation/sigma is 1 - A/A_n.
 *
 * Every answer at the middle load has a standard deviation of 5 %: of beta by two scans, of the others, with the effect
 * uncertainty, by records simulated from one. That tells all of them apart. */
struct made_up {
    struct scene scene;
    struct plan plan;
    struct scene_bodies bodies[MADE_UP_SURFACES];
    struct scene_surface names[MADE_UP_SURFACES];
    char *files[1];
    double loads[MADE_UP_LOADS];
    struct surface_record surfaces[MADE_UP_SURFACES];
    size_t order[MADE_UP_USABLE], shown[MADE_UP_USABLE];
    struct measured measured[MADE_UP_SURFACES];
    struct measured_run run;
    double measured_values[3 * MADE_UP_MEASURED];
    struct measured_answers answers[MADE_UP_SURFACES];
    struct benchmark benchmark;
    double *sweeps;
    struct results results;
    struct comparison comparison;
    json_t *view;
};

/** With everything a report can have: all effects, repeats, measured file, cost. `change`, unless NULL, may alter each
 * surface's curves and summary before they are stored. End it with made_up_free(). */
void made_up_make(struct made_up *out, void (*change)(struct surface_record *record, size_t index));
/** The same with these effects only, in these of the four models (MODEL_BITs). */
void made_up_make_of(struct made_up *out, uint64_t models, unsigned effects,
                     void (*change)(struct surface_record *record, size_t index));
/** The four models that results are made up of. */
uint64_t made_up_models(void);
void made_up_free(struct made_up *made);
/** Makes comparison, figures and view anew, after a change to the plan, the scene, or what is in memory. */
void made_up_again(struct made_up *made);

/** Summary of surface `index`, to be changed. */
struct surface_summary *made_up_surface(struct made_up *made, size_t index);
/** Sets the second half of one curve of the convergence study to `last`; the first is 0.5. */
void made_up_sweep(struct made_up *made, enum convergence_sweep sweep, const char *model, size_t value, double last);

#endif
