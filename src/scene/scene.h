/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the user asks for: DIR/scene.yaml, with defaults for everything (docs/scene.md). */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/text.h"
#include "joint/joint.h"
#include "profile/level.h"
#include "scan/scan.h"
#include "scene/scene_words.h"
#include "spectrum/power_law.h"

/** The bodies of a contact; scene_read() completes those of a surface with the scene's. */
struct scene_bodies {
    struct material material; /* E NaN: none is given, and loads are P/(A_n E') */
    bool material_given;
    enum material_counterface counterface_kind;
    struct material counterface;
    bool counterface_given, counterface_same; /* it is whatever the material is */
    size_t counterface_line;                  /* of the scene; 0: none */
    double hardness_Pa;                       /* of the softer body; NaN: what material_pair() has */
    double hardness_exponent;                 /* below 0: hardness_Pa is c1 and this c2 of Vickers's correlation */
};

enum scene_measured_quantity { SCENE_MEASURED_ECR, SCENE_MEASURED_TCR, SCENE_MEASURED_QUANTITY_COUNT };

/** Units of a measured resistance, by quantity: enum unit_quantity bits. A load may be any of UNIT_LOADS. */
extern const unsigned scene_measured_resistances[SCENE_MEASURED_QUANTITY_COUNT];

/** Files as named in a scene: scene_file_path() says where they are. */
struct scene_files {
    char **path;
    size_t count;
};

/** Measured contact resistance, to compare with the models. */
struct scene_measured {
    struct scene_files files; /* each a run of its own; none: nothing was measured */
    enum scene_measured_quantity quantity;
    char load_unit[UNIT_LENGTH];       /* "" when the scene gives none */
    char resistance_unit[UNIT_LENGTH]; /* the same: total, or times the nominal area */
    unsigned carry;                    /* measured values replace the model's in row, targets and limits */
};

/** One surface to report: one scan file, or repeated scans of it. */
struct scene_surface {
    struct scene_bodies bodies; /* once the scene is read completed with the scene's */
    char *name;                 /* as printed; hostile until escaped */
    struct scene_files files;
    struct scene_measured measured;
    struct scene_files along; /* scans in the other direction */
    bool lay_given;
    double lay;      /* rms slope along over across the lay; 0: a perfect one */
    char x_unit[16]; /* "" when the scene gives none */
    char z_unit[16];
    size_t x_column, z_column; /* from 1; 0: the file's header decides */
};

/** Loads as given, in SI; scene_loads() turns them into P/(A_n E'). */
struct scene_load {
    double from, to;             /* used when values is NULL */
    size_t points;               /* >= 1 */
    double *values;              /* count `points`, or NULL */
    enum unit_quantity kind;     /* UNIT_NUMBER: P/(A_n E'); UNIT_PRESSURE: P/A_n; UNIT_FORCE: P */
    struct unit unit;            /* as given; else operating_load's */
    char unit_text[UNIT_LENGTH]; /* the same, for charts and tables over load; "": P/(A_n E') */
    bool given;                  /* by the scene: kind and unit are those of its first load */
};

struct scene_convergence {
    double alpha, gamma; /* benchmark power law; alpha in m^(1-gamma) */
    double load;         /* P/(A_n E') */
    double scan_length_m;
    size_t scales;
    bool given, load_given; /* the scene has the key, and the load in it */
};

/** The mean free path for the scale dependence of TCR where a material does not give its own. */
enum scene_mean_free_path {
    SCENE_MEAN_FREE_PATH_THESIS,   /* 3k/(density v_s c_p), one of phonons (4.52) */
    SCENE_MEAN_FREE_PATH_ELECTRON, /* of the metal's free electrons */
    SCENE_MEAN_FREE_PATH_COUNT
};

enum {
    SCENE_DIRECT_GRID_LEAST = 16,
    SCENE_DIRECT_GRID_MOST = 16384,
    SCENE_DIRECT_SEEDS = 1000,
    SCENE_DIRECT_LOADS = 64
};

enum scene_direct_surfaces { SCENE_DIRECT_BASELINE, SCENE_DIRECT_ALL, SCENE_DIRECT_SURFACES_COUNT };

/** How the contact is solved directly; 0: the program chooses. */
struct scene_direct {
    bool called;             /* for, by the scene or the command line: it runs whatever `effects` says */
    size_t grid;             /* points a side */
    size_t seeds;            /* surfaces synthesised */
    size_t loads;            /* how many */
    double *values;          /* `loads` of them, SI, or NULL */
    enum unit_quantity kind; /* of `values`: P/(A_n E'), pressure or force */
    double hardness_Pa;      /* NaN: the scene's hardness */
    double budget_s;         /* time of one core for which grid and seeds are chosen; 0: none */
    enum scene_direct_surfaces surfaces;
};

/** The shape of the parts as the scene gives it; struct joint has the fields made of it. */
struct scene_shape {
    enum { SCENE_SHAPE_BULGE, SCENE_SHAPE_HEIGHT, SCENE_SHAPE_PRESSURE, SCENE_SHAPE_BOLTS } kind;
    bool given;
    double flatness_m, over_m, crown_m; /* 0: not given */
    struct scene_files files;           /* of height or pressure */
    unsigned scale;                     /* 1: the field is proportional to the load */
    struct shape_bolts bolts;
    double head_m; /* of each */
};

/** A target or a limit. */
struct scene_asked {
    enum quantity quantity;
    const struct quantity_asked *how; /* of its row */
    char symbol[UNIT_LENGTH];         /* in running text: "ECR with film" */
    double value;                     /* of the quantity, as the models have it */
    double factor;                    /* of the scene's unit: value = factor times the number, or its inverse */
    bool is_most;                     /* of a limit: the scene says `most` */
    bool is_upper;                    /* it bounds the quantity from above */
    enum unit_quantity kind;          /* of the number */
    struct unit unit;                 /* as given */
    char unit_text[UNIT_LENGTH];      /* the same as written, or SI */
    char text[UNIT_LENGTH + 16];      /* "1 mohm" */
    size_t line;
};

/** A value of the quantity in the unit of the scene. */
double scene_asked_shown(const struct scene_asked *asked, double value);

enum { SCENE_DATA_SURFACES = 100 /* with more, data/ has spectra in bins */, SCENE_EXPORTS_MOST = 64 };

enum { SCENE_BYTES_MOST = 1024 * 1024 }; /* of scene.yaml */

struct scene {
    char *directory; /* DIR as given */
    char *path;      /* of scene.yaml, NULL when there is none */
    char *title;
    uint64_t models;   /* MODEL_BITs asked for */
    bool models_named; /* by the scene: they run on any surface */
    bool effects_auto;
    unsigned effects;   /* EFFECT_BITs listed, and those they need */
    unsigned called;    /* EFFECT_BITs whose key the scene gives (effect_row.key): they run */
    struct joint joint; /* the values of those keys */
    struct scene_shape shape;
    struct scene_bodies bodies; /* of every surface that has none of its own */
    double nominal_area_m2;     /* NaN: resistances stay per area */
    enum scene_mean_free_path mean_free_path;
    struct scene_load load;
    struct scene_quantity operating; /* load of summary and tables; 0: that of a middling area */
    double tolerance;                /* relative */
    double accuracy;                 /* 95 % of answers are to lie within this factor less 1; NaN: not asked */
    double chosen_sd;                /* model_sd() of the model chosen for it; 0: none was */
    enum level level;
    bool level_given;    /* else only the mean of a periodic record is removed */
    double max_missing;  /* share of a profile's points that may be missing */
    double lambda_s_m;   /* cut-off of the Gaussian low-pass; 0: none */
    bool lambda_s_given; /* with 0: a map is solved as measured */
    double lambda_c_m;   /* cut-off of the Gaussian high-pass; 0: none */
    double tip_radius_m; /* of the stylus; 0: not known */
    enum spectrum_window window;
    enum power_law_method fit;
    bool fit_band_given;  /* else the band is found (auto) */
    double fit_band_m[2]; /* shortest, longest wavelength; 0, INFINITY: all. Not given: what the filters leave */
    enum roughness_moments moments;
    enum sinusoid_fit_id closure;
    char *template; /* a file of DIR that the report is filled from; NULL: the program's */
    char *baseline; /* surface name, NULL: the second smoothest */
    struct scene_convergence convergence;
    struct scene_direct direct;
    enum scan_direction direction; /* of the profiles taken from an areal map */
    bool lay_given;
    double lay;                               /* of surfaces without one of their own or scans along it */
    struct scene_surface counterface_surface; /* no files: the counterface is smooth */
    struct scene_measured measured;           /* on the baseline */
    struct scene_asked *targets, *limits;     /* NULL: none */
    size_t target_count, limit_count;
    struct scene_surface *surfaces;
    size_t surface_count;
    char *exports;           /* programs to write tables for, separated by commas or blanks; NULL: none */
    bool exports_overridden; /* by the command line */
    char *passed_over;       /* files of the directory that are no scans, one line a kind; NULL: none */
};

/** Options of the command line, each as its key of the scene; NULL: not given. */
struct scene_overrides {
    const struct text *text; /* in place of scene.yaml */
    const char *material, *effects, *tolerance, *accuracy, *exports;
    const char *x_unit, *z_unit; /* for every surface */
    const char *budget;          /* calls for the direct solution */
    bool direct;                 /* calls for it, too */
};

/** Reads `directory`/scene.yaml if there is one, applies the overrides and lists the surfaces: the scene's, else every
 * regular file of the directory that is not hidden, scene.yaml or a sidecar and may be a scan (scan_is_other();
 * passed_over names the rest). Each is a surface named by its file without the ending (with it, where two would be
 * alike), in natural order (2 before 10). Free `out` with scene_free() in any case. An empty directory gives
 * surface_count = 0. Errors: STATUS_SCENE with file, line, key and remedy: not YAML, unknown or doubled key, wrong
 * type, value out of range, missing material property, unknown material, missing file, two surfaces of one name,
 * baseline that is no surface; STATUS_USAGE: a wrong override; STATUS_IO: no such directory. */
MUST_CHECK enum status_code scene_read(struct scene *out, const char *directory,
                                       const struct scene_overrides *overrides, struct status *status);
void scene_free(struct scene *scene);

/** The value of a key of scene.yaml, or its default. */
struct scene_said {
    const char *key; /* with the unit of its number: "nominal_area_m2" */
    enum {
        SCENE_SAID_APART, /* a mapping, a list, or the key of an effect: written elsewhere */
        SCENE_SAID_NUMBER,
        SCENE_SAID_COUNT,
        SCENE_SAID_TEXT
    } kind;
    const void *at; /* a double in SI, a size_t, a const char * (NULL: none) */
};
/** The value of key `k`, valid as long as the scene; false beyond the last. */
bool scene_said(struct scene_said *out, const struct scene *scene, size_t k);

/** Joins surfaces of one file each whose names differ only in a number at the end, or in a letter behind a mark, into
 * one surface of repeated scans; not behind surface, sample, specimen or part, where the number counts surfaces. Then
 * joins names that end in x and y, 0 and 90, across and along, q and l, perp and par into a surface of two directions.
 * Ordered by name. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code scene_join_repeats(struct scene *scene, struct status *status);

/** Does data/ have the spectra in bins instead of every harmonic? */
bool scene_bins_spectra(const struct scene *scene);

/** The path of a scene's file: `file` if absolute, else below the scene's directory. malloc'ed; NULL: out of memory. */
char *scene_file_path(const struct scene *scene, const char *file);

/** The pair of bodies of a surface, or of the scene; material_pair_unknown() without a material. */
struct material_pair scene_pair(const struct scene_bodies *bodies);
/** The body that yields first, whose metal softens first. */
const struct material *scene_softer(const struct scene_bodies *bodies);

/** The bodies of surface `i`; the scene's where it has no such. */
const struct scene_bodies *scene_bodies_of(const struct scene *scene, size_t i);

/** A property that the effect needs and a body lacks, and which body; NULL: none. */
const struct material_property *scene_lack(const char **body, const struct scene_bodies *bodies,
                                           const struct effect_row *effect);

/** The divisor that makes a load of `kind` P/(A_n E'); NaN where the nominal area or E' is not known. */
double scene_load_divisor(const struct scene *scene, enum unit_quantity kind, const struct material_pair *pair);

/** A load as P/(A_n E') of a pair of bodies; 0: none. */
double scene_load_of(const struct scene_quantity *one, const struct scene *scene, const struct material_pair *pair);

/** The same in the kind of the scene's loads. */
double scene_load_as(const struct scene_quantity *one, const struct scene *scene, const struct material_pair *pair);

/** Have all surfaces the same E', hardness, resistivity and conductivity, or the same E'? */
bool scene_has_one_pair(const struct scene *scene, bool modulus_alone);

/** The scene's loads on a pair of bodies as P/(A_n E'), ascending, without duplicates, into an array with room for
 * load.points + 1. Returns their count, the same for every pair; *operating is the index of the summary's load. */
size_t scene_loads(double *all, size_t *operating, const struct scene *scene, const struct material_pair *pair);

#endif
