/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plan of a direct solution: grid, surfaces and loads, chosen from counts and fixed constants before anything runs,
 * so that the same input gives the same numbers on every machine. */
#ifndef PLAN_DIRECT_PLAN_H
#define PLAN_DIRECT_PLAN_H

#include "base/words.h"
#include "direct/direct_map.h"
#include "direct/direct_surface.h"
#include "scene/scene.h"
#include "spectrum/spectrum.h"

/** What the plan is made from. */
struct direct_plan_task {
    const struct scene_direct *direct;
    double divisor;      /* from the loads that `direct` lists to P/(A_n E') */
    size_t operating;    /* index of the operating load */
    const double *loads; /* P/(A_n E') of the scene, ascending */
    size_t load_count;
    struct direct_map_def map;       /* the square of a map; nx 0: a profile */
    const double *height_m;          /* of its rows */
    double length_m;                 /* of a profile */
    double lambda_s_m;               /* shortest wavelength to be trusted */
    bool of_spacing;                 /* that is four spacings, as no cut-off is known */
    double slope;                    /* rms slope of the scan: sets the range of loads */
    const struct spectrum *spectrum; /* of the scan */
    double hardness;                 /* H/E'; INFINITY: elastic only */
    bool resistance;                 /* constriction too */
    bool gaussian;                   /* Gaussian heights, not the scan's */
};

struct direct_plan {
    bool possible;
    char problem[320]; /* why it is not possible; "": no load lies in `range` */
    double range[2];   /* of loads that the grid resolves; unused if the scene lists loads */
    size_t side;       /* a map: points a side of its square; 0: a profile */
    size_t grid;       /* points a side */
    size_t seeds;      /* number of surfaces; 1 for a map */
    size_t fewer;      /* number of surfaces solved with hardness */
    bool gaussian;     /* Gaussian heights, not the scan's */
    size_t fine_times; /* the first surface also on a grid finer by this; 0: not */
    double length_m;   /* L of the cell */
    double lambda_s_m; /* cut-off of the law: the scan's, or of the grid; for a map of its low-pass, 0: none */
    bool mirrored;     /* a map's square with its mirror images */
    bool coarse;       /* the cut-off is the grid's */
    bool of_spacing;   /* lambda_s is four spacings of the scan, as no cut-off is known */
    struct direct_law law;
    double hardness; /* H/E' */
    bool resistance;
    double load[SCENE_DIRECT_LOADS]; /* P/(A_n E') */
    size_t loads, capped_loads;      /* all loads; the first ones, below the hardness */
    double seconds;                  /* expected, on one core */
    bool over_budget;                /* even this cheapest choice exceeds the budget */
};

/** Makes the plan, and matches a law to a profile's spectrum: the power law with cut-off lambda_s whose rows have the
 * spectrum's m0, m1 and m2; on a grid too coarse for the scan's cut-off those of the spectrum low-passed at the grid's.
 * Never fails: see out->possible. */
void direct_plan_make(struct direct_plan *out, const struct direct_plan_task *task);

/** Why it is not possible, in words. */
const char *direct_plan_problem(const struct direct_plan *plan, struct words *words);
/** Makes a plan impossible. */
void direct_plan_give_up(struct direct_plan *plan, const char *problem);

#endif
