/* SPDX-License-Identifier: GPL-3.0-or-later */
/* libroughcontact: what a measured rough surface does when it is pressed on a flat, for other programs.
 *
 * From a scan (a file, or bytes in memory) to a surface made ready (levelled, gaps bridged, filtered), its roughness,
 * spectrum and power law, and to what a model says of it at a list of loads. The numbers are those of the program
 * `roughcontact`, to the bit (unless FFTW has been given wisdom, by which it may round differently).
 *
 * Everything is SI. What is not known, not computed, or does not exist is NaN.
 *
 * Handles are opaque and belong to the caller, who ends each with its ..._free(), which takes NULL too. What a handle
 * returns by pointer is the handle's and lives as long. Handles do not refer to each other: a scan may be freed as soon
 * as a surface is made of it.
 *
 * Errors: functions that can fail return a roughcontact_code and, where `status` is not NULL, write it there with a
 * message: one line, lower case, what is wrong and what to do. A handle that could not be made is set to NULL.
 *
 * Threads: any function may be called in any thread at any time, but for a handle that another thread changes or
 * frees: only ..._set() and ..._free() do, so that one surface can be asked by several threads at once.
 *
 * The host: the library prints nothing, ends nothing, starts no program, sets no signal handler and keeps no state that
 * shows. Locale, rounding mode and floating-point traps of the calling thread are put aside for the time of a call, so
 * they change no number and no message. GSL's error handler, one for the process, is replaced while any call lasts by
 * one that hands the errors of other threads on to the host's; do not set it at such a time. FFTW's planner is made
 * safe for threads (fftw_make_planner_thread_safe()) at the first call.
 *
 * Binary interface: structures that the library fills (info, roughness, ...) are its own and may grow at their end.
 * Options are the caller's; ..._init() is told their size and fills in the defaults, so that a program built with this
 * header works with later libraries of the same soname. */
#ifndef ROUGHCONTACT_H
#define ROUGHCONTACT_H

#include <stddef.h>

#if defined __GNUC__
#define ROUGHCONTACT_API __attribute__((visibility("default")))
#else
#define ROUGHCONTACT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** What came of a call. */
enum roughcontact_code {
    ROUGHCONTACT_OK = 0,
    ROUGHCONTACT_MEMORY = 1, /* out of memory */
    ROUGHCONTACT_IO = 2,     /* a file could not be read */
    ROUGHCONTACT_USAGE = 3,  /* an argument is out of its range, unknown or missing */
    ROUGHCONTACT_SCAN = 4,   /* the data are no usable scan */
    ROUGHCONTACT_MODEL = 5,  /* the model does not exist for this surface */
    ROUGHCONTACT_NUMBER = 6  /* numbers leave what can be computed with */
};

/** The same with words. The caller's; its size is fixed. */
struct roughcontact_status {
    int code;
    char message[1024];
};

/** "0.1.0". */
ROUGHCONTACT_API const char *roughcontact_version(void);

/* ---- scans ---- */

/** The numbers along z are heights, or slopes dz/dx, which are integrated. */
enum roughcontact_quantity { ROUGHCONTACT_HEIGHT = 0, ROUGHCONTACT_SLOPE = 1 };

/** What is known of a file besides its content. */
struct roughcontact_scan_options {
    size_t size;                     /* set by ..._init() */
    const char *x_unit, *z_unit;     /* where the file (and its sidecar) names none: "mm", "um", ...; NULL: not known */
    int quantity;                    /* roughcontact_quantity; slopes are read only where this says so */
    const char *x_column, *z_column; /* of a table of text: a number, from 1, or a title; NULL: its header decides */
    size_t entry; /* of an archive of several scans: 0 the first, then `next_entry` of the one before */
};
/** Fills in the defaults: heights, nothing else known. `size`: sizeof *options. */
ROUGHCONTACT_API void roughcontact_scan_options_init(struct roughcontact_scan_options *options, size_t size);

/** A scan as it was measured. */
struct roughcontact_scan;

/** Reads a scan file of any format that the program reads, found by its content. A unit is never guessed: it comes from
 * the file, else from a sidecar beside it, else from the options (NULL: defaults), else this is an error that says what
 * to add. Errors: IO, SCAN, USAGE, MEMORY. */
ROUGHCONTACT_API int roughcontact_scan_read_file(struct roughcontact_scan **out, const char *path,
                                                 const struct roughcontact_scan_options *options,
                                                 struct roughcontact_status *status);
/** The same of `length` bytes in memory, which are copied; no file is looked at. `name` stands in messages. */
ROUGHCONTACT_API int roughcontact_scan_read_bytes(struct roughcontact_scan **out, const void *bytes, size_t length,
                                                  const char *name, const struct roughcontact_scan_options *options,
                                                  struct roughcontact_status *status);

struct roughcontact_scan_info {
    const char *format;          /* "text", "x3p", ... */
    size_t nx, ny;               /* points a row, rows; ny 1: a profile */
    double dx_m, dy_m;           /* spacing; dy_m 0 for a profile */
    const double *z_m;           /* ny rows of nx heights; NaN where a point is missing */
    const double *x_m;           /* nx positions, ascending; NULL: even, dx_m apart */
    size_t missing;              /* points */
    const char *x_unit, *z_unit; /* as they were taken */
    const char *part;            /* of an archive: the file in it; else "" */
    size_t next_entry;           /* where its next scan is; 0: there is none */
};
ROUGHCONTACT_API const struct roughcontact_scan_info *roughcontact_scan_info(const struct roughcontact_scan *scan);
/** Warning `i` from 0, one line; NULL behind the last. */
ROUGHCONTACT_API const char *roughcontact_scan_warning(const struct roughcontact_scan *scan, size_t i);
ROUGHCONTACT_API void roughcontact_scan_free(struct roughcontact_scan *scan);

/* ---- surfaces ---- */

/** What is taken out of the heights. */
enum roughcontact_level {
    ROUGHCONTACT_LEVEL_AUTO = 0, /* a line; of a record that closes on itself the mean */
    ROUGHCONTACT_LEVEL_NONE = 1,
    ROUGHCONTACT_LEVEL_MEAN = 2,
    ROUGHCONTACT_LEVEL_LINE = 3,
    ROUGHCONTACT_LEVEL_PARABOLA = 4,
    ROUGHCONTACT_LEVEL_CIRCLE = 5,
    ROUGHCONTACT_LEVEL_ROBUST = 6 /* a line that outliers do not move */
};
/** Auto: none for a record that closes on itself, else Hann. */
enum roughcontact_window { ROUGHCONTACT_WINDOW_AUTO = 0, ROUGHCONTACT_WINDOW_NONE = 1, ROUGHCONTACT_WINDOW_HANN = 2 };
/** Auto: of the multitaper spectrum, in the band where it is straight; thesis: a line through all harmonics. */
enum roughcontact_fit { ROUGHCONTACT_FIT_AUTO = 0, ROUGHCONTACT_FIT_THESIS = 1 };

#define ROUGHCONTACT_NO_ROW ((size_t)-1)

/** How a scan is made ready; the keys of the same names of the program's scene. */
struct roughcontact_surface_options {
    size_t size;                   /* set by ..._init() */
    int level;                     /* roughcontact_level */
    int window;                    /* roughcontact_window */
    int fit;                       /* roughcontact_fit */
    double max_missing;            /* share of the points that may be missing and are bridged, 0...1 */
    double lambda_s_m, lambda_c_m; /* Gaussian low-pass and high-pass (ISO 16610-21); 0: none */
    double tip_radius_m;           /* of the stylus, for a warning; 0: not known */
    double fit_low_m, fit_high_m;  /* shortest and longest wavelength of the fit; 0 and 0: found */
    size_t row;                    /* of a map, which is read as a profile; ROUGHCONTACT_NO_ROW: it has to be one */
};
/** Fills in the scene's defaults. `size`: sizeof *options. */
ROUGHCONTACT_API void roughcontact_surface_options_init(struct roughcontact_surface_options *options, size_t size);

/** A profile made ready, with its spectrum and power law. */
struct roughcontact_surface;

/** Makes a scan ready. Options NULL: the defaults. Errors: SCAN (too many points missing, flat, a filter longer than
 * the scan), USAGE, MEMORY. */
ROUGHCONTACT_API int roughcontact_surface_make(struct roughcontact_surface **out, const struct roughcontact_scan *scan,
                                               const struct roughcontact_surface_options *options,
                                               struct roughcontact_status *status);

struct roughcontact_surface_info {
    size_t points;
    double spacing_m, length_m; /* length_m: points times spacing */
    const double *height_m;     /* levelled and filtered */
    int periodic;               /* it closes on itself */
    double tilt;                /* slope that was taken out */
    size_t bridged, trimmed;    /* missing points between others, and at the ends */
};
ROUGHCONTACT_API const struct roughcontact_surface_info *
roughcontact_surface_info(const struct roughcontact_surface *surface);
/** What was done to the scan and what is doubtful, `i` from 0, one line each; NULL behind the last. */
ROUGHCONTACT_API const char *roughcontact_surface_note(const struct roughcontact_surface *surface, size_t i);

struct roughcontact_roughness {
    double rq_m, ra_m, pv_m;        /* root mean square, mean absolute height, highest minus lowest */
    double rsk, rku;                /* 0 and 3 for Gaussian heights */
    double m0_m2, m2, m4_per_m2;    /* mean square height, slope, curvature, by differences */
    double nayak;                   /* m0 m4/m2² */
    double asperity_density_per_m2; /* these four: NaN where no statistical model exists */
    double asperity_radius_m;
    double asperity_sigma_m;  /* standard deviation of the summits' heights */
    double asperity_offset_m; /* mean plane of the summits above that of the heights */
};
ROUGHCONTACT_API const struct roughcontact_roughness *
roughcontact_surface_roughness(const struct roughcontact_surface *surface);

/** A profile parameter of ISO 21920-2. */
struct roughcontact_parameter {
    const char *name; /* "q": Pq, and Rq of a surface with lambda_c */
    const char *unit; /* "m", or "" for a pure number */
    const char *meaning, *clause;
};
ROUGHCONTACT_API size_t roughcontact_parameter_count(void);
/** Number `i` from 0; NULL behind the last. */
ROUGHCONTACT_API const struct roughcontact_parameter *roughcontact_parameter(size_t i);
/** Computes the first `count` of them: P, or R where the surface was made with lambda_c_m. Errors: SCAN (shorter than
 * one sampling length), USAGE, MEMORY. */
ROUGHCONTACT_API int roughcontact_surface_parameters(const struct roughcontact_surface *surface, double *values,
                                                     size_t count, struct roughcontact_status *status);

/** Harmonics n = 1 ... count of a record of length L, of wavelength L/n. */
struct roughcontact_spectrum {
    size_t count;
    double length_m;           /* L */
    const double *amplitude_m; /* of harmonic n at index n - 1 */
    int has_nyquist;           /* the last has the mean square amplitude², the others amplitude²/2 */
};
ROUGHCONTACT_API const struct roughcontact_spectrum *
roughcontact_surface_spectrum(const struct roughcontact_surface *surface);

enum roughcontact_law { ROUGHCONTACT_LAW_NONE = 0, ROUGHCONTACT_LAW_NARROW = 1, ROUGHCONTACT_LAW_FOUND = 2 };

/** amplitude = alpha wavelength^gamma. */
struct roughcontact_power_law {
    int law;      /* roughcontact_law; narrow: over less than a decade */
    double alpha; /* m^(1-gamma) */
    double gamma, gamma_error;
    double amplitude_m, amplitude_error_decades; /* at wavelength_m; with FIT_AUTO the rms amplitude */
    double wavelength_m;
    double low_m, high_m; /* shortest and longest wavelength of the band */
    double misfit_decades;
};
ROUGHCONTACT_API const struct roughcontact_power_law *
roughcontact_surface_power_law(const struct roughcontact_surface *surface);
ROUGHCONTACT_API void roughcontact_surface_free(struct roughcontact_surface *surface);

/* ---- materials ---- */

/** The properties of a body. */
struct roughcontact_material;

/** Number `i` from 0 of the built-in materials; NULL behind the last. */
ROUGHCONTACT_API const char *roughcontact_material_name(size_t i);
/** Number `i` from 0 of the properties, with its unit: "E_Pa", "nu", "Sy_Pa", ...; NULL behind the last. */
ROUGHCONTACT_API const char *roughcontact_material_key(size_t i);
/** A built-in material, or with NULL one of which nothing is known yet. Errors: USAGE (no such name), MEMORY. */
ROUGHCONTACT_API int roughcontact_material_new(struct roughcontact_material **out, const char *name,
                                               struct roughcontact_status *status);
/** Errors: USAGE: no such key, or out of its range. */
ROUGHCONTACT_API int roughcontact_material_set(struct roughcontact_material *material, const char *key, double value,
                                               struct roughcontact_status *status);
/** NaN: not known, or no such key. */
ROUGHCONTACT_API double roughcontact_material_get(const struct roughcontact_material *material, const char *key);
ROUGHCONTACT_API void roughcontact_material_free(struct roughcontact_material *material);

/* ---- models ---- */

struct roughcontact_model {
    const char *name;           /* to ask for it: "multiscale-elastic" */
    const char *label, *family; /* as in charts; those that belong together */
    int plastic;                /* needs Sy_Pa */
    int uses_asperities;        /* needs a surface for which a statistical model exists */
    int gaussian;               /* takes the heights as Gaussian: look at rsk and rku */
    double largest_area;        /* A/A_n up to which it is valid; 0: any */
    const char *equations;
    const char *source;
    const char *assumes, *valid;
};
/** Number `i` from 0; NULL behind the last. */
ROUGHCONTACT_API const struct roughcontact_model *roughcontact_model(size_t i);
/** That of the name; NULL: there is none. */
ROUGHCONTACT_API const struct roughcontact_model *roughcontact_model_find(const char *name);

/** What loads are given in: P/(A_n E'), or the nominal pressure P/A_n in Pa, which needs a material. */
enum roughcontact_load { ROUGHCONTACT_LOAD_OVER_MODULUS = 0, ROUGHCONTACT_LOAD_PRESSURE_PA = 1 };

struct roughcontact_run_options {
    size_t size;                                     /* set by ..._init() */
    const struct roughcontact_material *material;    /* NULL: none; then area and separation alone, elastic */
    const struct roughcontact_material *counterface; /* NULL: a rigid flat that conducts like the material */
    double hardness_Pa;                              /* of the softer body; NaN: the material's, else 2.84 S_y */
    double tolerance;                                /* relative, 1e-14 ... 0.1 */
    int load;                                        /* roughcontact_load */
};
/** Fills in the defaults: no material, tolerance 1e-6, loads over the modulus. `size`: sizeof *options. */
ROUGHCONTACT_API void roughcontact_run_options_init(struct roughcontact_run_options *options, size_t size);

/** What a model says of a surface at a list of loads. */
struct roughcontact_curve;

/** Runs a model at `count` loads, above 0 and ascending. Everything is computed that the materials give properties for:
 * separation always, ECR with resistivity_ohm_m, TCR with conductivity_W_per_mK, its scale-dependent form with what it
 * needs besides. Options NULL: the defaults. Errors: USAGE (no such model, a load out of order, a property that it
 * needs is missing), MODEL (the surface has no asperities in the model's sense), NUMBER, MEMORY. */
ROUGHCONTACT_API int roughcontact_run(struct roughcontact_curve **out, const struct roughcontact_surface *surface,
                                      const char *model, const double *loads, size_t count,
                                      const struct roughcontact_run_options *options,
                                      struct roughcontact_status *status);

/** Contact at one load. */
struct roughcontact_point {
    int exists;               /* 0: the model says nothing at this load, and all but the load is NaN */
    int valid;                /* within the range in which the model was tested or its law fitted */
    double load;              /* P/(A_n E') */
    double pressure_Pa;       /* P/A_n; NaN without a material */
    double area_ratio;        /* A/A_n */
    double separation_m;      /* mean gap, or distance of the mean planes */
    double adjusted_m;        /* of statistical models: the same adjusted, as charts show it */
    double ecr_ohm_m2;        /* electrical contact resistance times A_n */
    double tcr_K_m2_per_W;    /* thermal contact resistance times A_n */
    double tcr_sd_K_m2_per_W; /* the same, scale-dependent */
    double beyond_fit;        /* share of the load on asperities beyond the law's fitted range, 0...1 */
};

struct roughcontact_curve_info {
    const char *model;
    size_t count;                /* loads */
    double effective_modulus_Pa; /* E'; NaN without a material */
    double full_load;            /* P/(A_n E') at which A = A_n; NaN: the model does not say */
    double beta;                 /* of the adjusted separation */
};
ROUGHCONTACT_API const struct roughcontact_curve_info *roughcontact_curve_info(const struct roughcontact_curve *curve);
/** At load `i` from 0, in the order they were given; NULL behind the last. */
ROUGHCONTACT_API const struct roughcontact_point *roughcontact_curve_point(const struct roughcontact_curve *curve,
                                                                           size_t i);
ROUGHCONTACT_API void roughcontact_curve_free(struct roughcontact_curve *curve);

#ifdef __cplusplus
}
#endif

#endif
