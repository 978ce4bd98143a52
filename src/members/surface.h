/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One surface from its scans to its curves: the pipeline scan -> profile -> spectrum + roughness -> contact. */
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

enum {
    SURFACE_PREVIEW = 1000,   /* points of a profile kept for the chart */
    SURFACE_LONGEST_WAVES = 4 /* of which direct solutions of Gaussian surfaces scatter by no more than 10 % */
};

struct answer;      /* answers/answers.h */
struct limit_check; /* the same */
struct direct_plan; /* plan/direct_plan.h */

/** Where a run's time goes, by stage [s]. */
struct surface_times {
    double read, prepare, spectrum, convergence, uncertainty, strips, tiles;
};

/** Whose hardness the models have. */
enum surface_hardness { SURFACE_HARDNESS_BODIES, SURFACE_HARDNESS_SCENE, SURFACE_HARDNESS_PLATING };

struct surface_summary {
    const struct scene_surface *scene; /* name, files, bodies */
    struct material_pair pair;         /* what the models need of the bodies */
    enum surface_hardness hardness;
    bool usable;   /* false: refused, see `refusal` */
    char *refusal; /* one line; owned */
    double
        carrying; /* share of the nominal area that carries 90 % of the load, with the shape; 0: flat, NaN: not known */
    struct note_list notes;          /* warnings; owned */
    size_t refused_scans;            /* of several; the notes begin with them */
    size_t copies;                   /* scans that are the same as one before and were left out, */
    const char *copy_file, *copy_of; /* of which the first is this file, and which it repeats; the scene's */
    char hash[65];                   /* SHA-256 of the first file (of all of them one after another), hexadecimal */
    char format[32];
    char units[40];                 /* "x mm, z um" as read */
    size_t scans;                   /* averaged: files, or rows of a map */
    struct repeats repeats;         /* what they say apart */
    size_t single_points;           /* of the one scan, where records can be simulated of it; else 0 */
    uint64_t simulated_evaluations; /* of the models, on those */
    double strip_cost;              /* of its rows, joined and of each scan alone; 0: no model uses strips */
    uint64_t strip_transforms;      /* that solving its strips took */
    bool has_strips;                /* they are, or will be, solved */
    size_t strip_unsolved[2];       /* loads of them that did not converge, scans that have no answer: left out */
    double tile_cost;               /* tiles_cost() of its map, 0: there is none, or no model uses it */
    uint64_t tile_transforms;       /* that solving it took */
    bool has_tiles;                 /* it is, or will be, solved */
    size_t squares, all_squares;    /* of it that are solved; that it holds */
    size_t points;                  /* of the first */
    double spacing_m, length_m;
    struct roughness roughness;
    struct asperities asperities;
    bool has_asperities;              /* a statistical model exists */
    struct areal_parameters measured; /* of its first map, before any low-pass */
    bool has_map;
    double between_m2; /* what Sq² of maps has over their rows' mean square height; 0: profiles */
    struct cmy rough;  /* what handbooks ask: Rq (of maps Sq), and the surface's mean slope, of a lay as across it and
                          along it together */
    struct power_law power_law;
    struct power_law line;        /* the thesis's, through all harmonics of fit_band, whatever `fit` */
    double independent;           /* scans averaged; rows of a map count less */
    size_t periodic;              /* of the scans: those that close on themselves */
    size_t windowed;              /* of the scans: those whose spectrum was taken under a Hann window */
    struct convergence_tail tail; /* the spectrum's own short end, carried on below what is known */
    double longest_waves; /* spectrum_longest_waves(); fewer than SURFACE_LONGEST_WAVES: a longer scan may differ */
    double pressure_over_hardness; /* and scale_dependence: effects_bound(); 0: not asked, or none */
    double scale_dependence;
    struct curve_summary *
        *models;          /* [model]: of those that have run, NULL of others; owned like the texts: surface_model() */
    size_t carried_model; /* the factor of conductance that was measured, in that model's answers to such targets */
    enum quantity carried_quantity;
    double carried;             /* 0: none */
    struct answer *answers;     /* [target][model]; owned, NULL: the scene has no targets */
    struct limit_check *limits; /* one a limit of the scene; the same */
    struct direct_map_def map;  /* the square that a map offers to a direct solution; nx 0: profiles */
    double cutoff_m;            /* of the low-pass that a map has had; 0: none */
    bool has_lay;               /* it is known */
    double lay;                 /* rms slope along over across it: surface_kappa() */
    struct direct_plan *direct; /* how its contact is solved directly; owned, NULL: it is not called for */
    struct surface_times times;
};

/** Everything of one surface. Owned: surface_record_free(). */
struct surface_record {
    struct surface_summary summary;
    struct spectrum spectrum;       /* its length over surface_kappa(), as those of the ensemble and the strips are */
    struct spectrum typical;        /* geometric means of the scans' amplitudes: what the thesis's line goes through */
    struct spectrum tapered;        /* rms amplitudes the law is fitted to; count 0: fit: thesis */
    struct power_law_band *band;    /* the same law with its bins, knees and lines; NULL: fit: thesis, or dropped */
    struct ensemble ensemble;       /* scans to be run alone, until they have been; count 0: there is one */
    struct strips strips;           /* of its scans, where a model uses them; rows 0: none */
    struct surface_record *flatter; /* of scans in two directions those of the flatter one, whose strips take part;
                                       NULL: none. Owned */
    struct tiles tiles;             /* of its one map, where a model uses it */
    struct map_contact contact;     /* of that at the operating load; cells 0: not looked at */
    double *height_m; /* of the one scan, summary.single_points long, until the models have run; NULL: not kept */
    const struct surface_record *counterface; /* the rough one; NULL: smooth. Not owned */
    struct model_curve *curves;               /* model_count of them, NULL before any model ran */
    struct joint_shape *shapes;               /* the same, where the scene has a shape; NULL: none */
    struct ensemble_band **bands;             /* the same, each band_count long; NULL: none */
    size_t band_count;
    struct variants variants; /* scans 0 where there is a rough counterface */
    double *direct_m;         /* where a direct solution is called for: heights of the profiles, or the square of
                                 a map row after row, conditioned; else NULL */
    size_t direct_count;
    size_t preview_points;
    double *preview_x_m, *preview_z_m; /* the first scan's profile, thinned */
};

/** What model `m` said of a surface; where it did not run, a curve that does not exist. */
const struct curve_summary *surface_model(const struct surface_summary *summary, size_t m);
/** The same, to be filled: zeroed where there was none. NULL: out of memory. */
struct curve_summary *surface_model_room(struct surface_summary *summary, size_t m);

/** gamma at short wavelengths, where convergence is decided. */
double surface_short_gamma(const struct power_law *law);
/** Is there a law whose slope at short wavelengths is the surface's? Not where that side of a knee reaches below what
 * is known, to what rounding has left. */
bool surface_tells_gamma(const struct surface_summary *summary);
/** The one criterion of divergence (4.55): gamma is below 1 by more than its standard error; where two slopes fit
 * better than one law, the one at short wavelengths. False where nothing tells. */
bool surface_diverges(const struct surface_summary *summary);

/** What is asked of a surface. */
struct surface_task {
    const struct scene *scene;
    const struct plan *plan;
    const double *loads; /* P/(A_n E') of its own bodies */
    size_t load_count;
    struct threads threads; /* of this surface alone; answers do not depend on how many */
};

/** What the models are asked of a described surface. */
struct model_task surface_model_task(const struct surface_record *record, const struct surface_task *asked);

/** What lies in the joint of a surface whose models are asked `task`. */
struct joint_task surface_joint(const struct surface_record *record, const struct scene *scene, const struct plan *plan,
                                const struct model_task *task);

/** The same at the middle load alone. */
struct model_task surface_middle_task(const struct model_task *task);

/** Sets r of a surface (not finite: not known), `from` scans "along" the lay, a "map", or the scene ("given"); what
 * makes it doubtful is noted, with what to do. */
void surface_set_lay(struct surface_summary *summary, double lay, const char *from);

/** Do its scans run across a lay of which it is known how strong it is: are they, in effect, of both directions? */
bool surface_knows_both(const struct surface_summary *summary);

/** What the frequencies of the scans, taken across a lay, are multiplied by in the models, which know no direction:
 * sqrt((1 + r²)/2), r the rms slope along over across (equations: lay). */
double surface_kappa(const struct surface_summary *summary);

/** Frees the scans that only the models need: those run alone, the heights of a single one. */
void surface_drop_scans(struct surface_record *record);
/** Frees all arrays; the summary stays. */
void surface_drop_arrays(struct surface_record *record);
void surface_record_free(struct surface_record *record);
/** Of a surface that memory was short for, of which `status` tells: it goes aside like one that is refused, and the
 * others go on. The error stays where it is the only one, or the counterface. */
MUST_CHECK enum status_code surface_put_aside(struct surface_record *record, const struct scene *scene,
                                              struct status *status);

#endif
