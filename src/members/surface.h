/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is known of one surface, from its scans to its curves. */
#ifndef MEMBERS_SURFACE_H
#define MEMBERS_SURFACE_H

#include "contact/strip.h"
#include "joint/joint.h"
#include "members/curve_summary.h"
#include "members/map_contact.h"
#include "members/note.h"
#include "members/repeats.h"
#include "members/scan_strips.h"
#include "members/tiles.h"
#include "members/variants.h"
#include "scene/plan.h"
#include "spectrum/areal.h"
#include "spectrum/power_law_scans.h"

enum { SURFACE_PREVIEW = 1000 /* points of a profile kept for the chart */ };

struct answer;      /* answers/answers.h */
struct limit_check; /* the same */
struct direct_plan; /* plan/direct_plan.h */

/** Time by stage [s]. */
struct surface_times {
    double read, prepare, spectrum, convergence, uncertainty, strips;
    double tiles[2]; /* elastic and with the hardness; what both need is shared out alike */
};

/** Which hardness the models use. */
enum surface_hardness { SURFACE_HARDNESS_BODIES, SURFACE_HARDNESS_SCENE, SURFACE_HARDNESS_PLATING };

struct surface_summary {
    const struct scene_surface *scene; /* name, files, bodies */
    struct material_pair pair;         /* the constants of the two bodies */
    enum surface_hardness hardness;
    bool usable;     /* false: refused, see `refusal` */
    char *refusal;   /* one line; owned */
    double carrying; /* share of the nominal area that carries 90 % of the load, with `shape`; 0: no shape; NaN: not
                        known */
    struct note_list notes;          /* warnings; owned */
    size_t all_scans, refused_scans; /* with each of an archive: that are there; not used, of several (the notes begin
                                        with them) */
    char hash[65];                   /* SHA-256 of the first file (of all of them one after another), hexadecimal */
    char format[32];
    char units[40];                 /* "x mm, z um" as read */
    size_t scans;                   /* that were averaged: files, or rows of a map */
    struct repeats repeats;         /* how they differ */
    size_t single_points;           /* of a single scan from which records can be simulated; else 0 */
    uint64_t simulated_evaluations; /* of the models on the simulated records */
    double strip_cost;              /* expected, joined and of each scan alone; 0: no model uses strips */
    uint64_t strip_transforms;      /* actual cost of its strips */
    bool has_strips;                /* strips are, or will be, solved */
    size_t strip_unsolved[2];       /* left out: loads that did not converge; scans without a solution */
    double tile_cost;               /* tiles_cost() of its map; 0: no map, or no model uses it */
    uint64_t tile_transforms[2];    /* actual cost of its map, elastic and with the hardness */
    bool has_tiles;                 /* its map is, or will be, solved */
    size_t points;                  /* of the longest scan */
    double spacing_m, length_m;
    struct roughness roughness;
    struct asperities asperities;
    bool has_asperities;              /* the statistical models can be used */
    struct areal_parameters measured; /* of its first map, before any low-pass */
    bool has_map;
    double between_m2; /* Sq² of maps less their rows' mean square height; 0: profiles */
    struct cmy rough;  /* for handbook formulas: Rq (of maps Sq) and the mean slope, with a lay over both directions */
    struct power_law power_law;
    struct power_law line;         /* the thesis's line through all harmonics of fit_band, whatever `fit` is */
    double independent;            /* effective number of scans: rows of a map count less */
    size_t periodic;               /* scans that are periodic */
    size_t windowed;               /* scans that had a Hann window */
    struct convergence_tail tail;  /* the spectrum extrapolated to shorter wavelengths */
    double longest_waves;          /* spectrum_longest_waves() */
    double pressure_over_hardness; /* this and scale_dependence: effects_bound(); 0: not asked for, or none */
    double scale_dependence;
    struct curve_summary **models; /* [model]: NULL where a model has not run; owned; read by surface_model() */
    size_t carried_model;          /* the model and quantity to whose targets the measured factor applies */
    enum quantity carried_quantity;
    double carried;             /* measured over modelled conductance; 0: none */
    struct answer *answers;     /* [target][model]; owned, NULL: the scene has no targets */
    struct limit_check *limits; /* one for each limit of the scene; the same */
    struct direct_map_def map;  /* the square of a map for the direct study; nx 0: profiles */
    double cutoff_m;            /* of the low-pass applied to a map; 0: none */
    bool has_lay;               /* `lay` is known */
    double lay;                 /* rms slope along the lay over that across it */
    struct direct_plan *direct; /* of the direct study; owned; NULL: not called for */
    struct surface_times times;
};

/** Everything of one surface. Owned: surface_record_free(). */
struct surface_record {
    struct surface_summary summary;
    struct spectrum spectrum;       /* lengths are divided by surface_kappa(), as in ensemble and strips */
    struct spectrum typical;        /* geometric mean of the scans' amplitudes, for the thesis's line */
    struct spectrum tapered;        /* rms amplitudes to which the law is fitted; count 0: fit: thesis */
    struct power_law_band *band;    /* details of that fit; NULL: fit: thesis, or freed */
    struct ensemble ensemble;       /* scans that are run one by one; count 0: a single scan */
    struct strips strips;           /* where a model uses them; rows 0: none */
    struct surface_record *flatter; /* of scans in two directions the flatter one, whose strips are used too; NULL:
                                       none. Owned */
    struct tiles tiles;             /* of its map, where a model uses it */
    struct map_contact contact;     /* of the map at the operating load; cells 0: not solved */
    double *height_m;               /* of the single scan, summary.single_points long, until the models have run */
    const struct surface_record *counterface; /* a rough counterface; NULL: smooth. Not owned */
    struct model_curve *curves;               /* model_count of them; NULL before any model ran */
    struct joint_shape *shapes;               /* model_count of them; NULL: no `shape` */
    struct ensemble_band **bands;             /* model_count of them, each NULL or band_count long */
    size_t band_count;
    struct variants variants; /* scans 0 with a rough counterface */
    double *direct_m;         /* for the direct study: conditioned heights of the profiles, or the square of a
                                 map row after row; else NULL */
    size_t direct_count;
    size_t preview_points;
    double *preview_x_m, *preview_z_m; /* the first scan's profile, thinned */
};

/** The summary of model `m`; `exists` is false where it has not run. */
const struct curve_summary *surface_model(const struct surface_summary *summary, size_t m);
/** The same, to be filled: zeroed if new. NULL: out of memory. */
struct curve_summary *surface_model_room(struct surface_summary *summary, size_t m);

/** gamma at short wavelengths, which decides on convergence. */
double surface_short_gamma(const struct power_law *law);
/** Is gamma at short wavelengths known? Not where a knee's short side lies below the resolved wavelengths, in the
 * rounding noise. */
bool surface_tells_gamma(const struct surface_summary *summary);
/** The criterion of divergence (4.55): gamma, with a knee that at short wavelengths, is below 1 by more than its
 * standard error. False where it is not known. */
bool surface_diverges(const struct surface_summary *summary);

/** What is to be computed for a surface. */
struct surface_task {
    const struct scene *scene;
    const struct plan *plan;
    const double *loads; /* P/(A_n E') with its own bodies */
    size_t load_count;
    struct threads threads; /* for this surface alone; results do not depend on their number */
};

/** The models' task for a surface that has been read. */
struct model_task surface_model_task(const struct surface_record *record, const struct surface_task *asked);

/** Film, plating, filler and shape of a surface whose models have `task`. */
struct joint_task surface_joint(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                const struct model_task *task);

/** Sets r, the slope along the lay over that across it (not finite: not known), `from` scans "along", a "map", or the
 * scene ("given"). A note says so if the scans seem to run along the lay. */
void surface_set_lay(struct surface_summary *summary, double lay, const char *from);

/** Is the lay known, with two scans across it or more, so that both directions are known? On 16 pieces of five measured
 * maps 1 + 1 scans err by .66 .79 .77 (rms ln of area, gap, resistance), as two in one direction do: with the error of
 * two directions .89 of the intervals hold, with 2 + 2 scans .93 .96 .96. */
bool surface_knows_both(const struct surface_summary *summary);

/** Factor on the spatial frequencies of scans across a lay, for models of isotropic surfaces: sqrt((1 + r²)/2), r the
 * rms slope along over across (equations: lay). */
double surface_kappa(const struct surface_summary *summary);

/** Frees the scans that only the models need. */
void surface_drop_scans(struct surface_record *record);
/** Frees everything but the summary. */
void surface_drop_arrays(struct surface_record *record);
void surface_record_free(struct surface_record *record);
/** Out of memory on one surface, as `status` says: it is refused, and the others go on. The error stays if it is the
 * only surface, or the counterface. */
MUST_CHECK enum status_code surface_put_aside(struct surface_record *record, const struct scene *scene,
                                              struct status *status);

#endif
