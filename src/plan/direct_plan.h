/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the contact of one surface will be solved directly: grid, surfaces and loads from counts and fixed constants,
 * before anything runs, so that the same input gives the same numbers on every machine. */
#ifndef PLAN_DIRECT_PLAN_H
#define PLAN_DIRECT_PLAN_H

#include "base/words.h"
#include "direct/direct_map.h"
#include "direct/direct_surface.h"
#include "scene/scene.h"
#include "spectrum/spectrum.h"

/** What it is decided from. */
struct direct_plan_task {
    const struct scene_direct *direct;
    double divisor;      /* of the loads that `direct` lists, to be P/(A_n E') */
    size_t operating;    /* which of `loads` the summary stands at */
    const double *loads; /* P/(A_n E'), ascending: the scene's */
    size_t load_count;
    struct direct_map_def map;       /* the square that a map offers; nx 0: a profile */
    double length_m;                 /* of a profile */
    double lambda_s_m;               /* shortest wavelength that the scan stands for */
    bool of_spacing;                 /* that is four spacings of it, as nothing says where its roughness ends */
    double slope;                    /* root mean square slope of the scan: sets the range of loads */
    const struct spectrum *spectrum; /* of the scan */
    double hardness;                 /* H/E'; INFINITY: elastic alone */
    bool resistance;                 /* constriction too */
    bool gaussian;                   /* surfaces have Gaussian heights, not the scan's */
};

struct direct_plan {
    bool possible;
    char problem[320]; /* where it is not; "": no load lies in `range` */
    double range[2];   /* of loads that the grid resolves, where the scene lists none for it */
    size_t side;       /* a map: points along the square taken; 0: a profile */
    size_t grid;       /* points a side */
    size_t seeds;      /* surfaces; 1 of a map */
    size_t fewer;      /* surfaces with a hardness */
    bool gaussian;     /* with Gaussian heights, not with the scan's */
    size_t fine_times; /* the first surface also on a grid so much finer; 0: not */
    double length_m;   /* L of the cell */
    double lambda_s_m; /* cut-off of the law: the scan's, or what the grid resolves; of a map's low-pass, 0: none */
    bool mirrored;     /* the grid holds a map's square and its mirror images */
    bool coarse;       /* the latter */
    bool of_spacing;   /* lambda_s is four spacings of the scan: nothing says where its roughness ends */
    struct direct_law law;
    double hardness; /* H/E' */
    bool resistance;
    double load[SCENE_DIRECT_LOADS]; /* P/(A_n E') */
    size_t loads, capped_loads;      /* those below the hardness come first */
    double seconds;                  /* likely, of one core */
    bool over_budget;                /* nothing fits into the budget; this is the least */
};

/** Chooses, and matches the law to a profile's spectrum: the power law with the cut-off lambda_s whose rows have the
 * spectrum's own m0, m1 and m2; where the grid is too coarse for the scan's cut-off, those of the spectrum low-passed
 * at the grid's. Never fails: see out->possible. */
void direct_plan_make(struct direct_plan *out, const struct direct_plan_task *task);

/** Why it is not possible. */
const char *direct_plan_problem(const struct direct_plan *plan, struct words *words);
/** Makes a plan impossible. */
void direct_plan_give_up(struct direct_plan *plan, const char *problem);

#endif
