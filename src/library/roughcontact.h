/* SPDX-License-Identifier: GPL-3.0-or-later */
/* libroughcontact: what a measured rough surface does when it is pressed on a flat, for other programs.
 *
 * From a scan (a file, or bytes in memory) to a surface made ready (levelled, gaps bridged, filtered), its roughness,
 * spectrum and power law, and to what a model says of it at a list of loads. The numbers are those of the program
 * `roughcontact`, to the bit.
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
 * they change no number and no message. GSL's error handler, one for the process, is off while any call lasts: GSL's
 * functions then return their errors, in all threads; do not set it at such a time. FFTW is one of its own, which the
 * host's never meets. An allocation that fails, in FFTW too, is the error MEMORY (or IO, of a file).
 *
 * Binary interface: structures that the library fills (roughness, ...) are its own and may grow at their end. Options
 * are the caller's, and stay as they are within a soname. */
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

/* ---- scans ---- */

/** What is known of a file besides its content. */
struct roughcontact_scan_options {
    const char *x_unit, *z_unit; /* where the file (and its sidecar) names none: "mm", "um", ...; NULL: not known */
};
/** Fills in the defaults: nothing is known. */
ROUGHCONTACT_API void roughcontact_scan_options_init(struct roughcontact_scan_options *options);

/** A scan as it was measured. */
struct roughcontact_scan;

/** Reads a scan file of any format that the program reads, found by its content; of an archive the first scan. A unit
 * is never guessed: it comes from the file, else from a sidecar beside it, else from the options (NULL: defaults), else
 * this is an error that says what to add. Errors: IO, SCAN, USAGE, MEMORY. */
ROUGHCONTACT_API int roughcontact_scan_read_file(struct roughcontact_scan **out, const char *path,
                                                 const struct roughcontact_scan_options *options,
                                                 struct roughcontact_status *status);
/** The same of `length` bytes in memory, which are copied; no file is looked at. `name` stands in messages. */
ROUGHCONTACT_API int roughcontact_scan_read_bytes(struct roughcontact_scan **out, const void *bytes, size_t length,
                                                  const char *name, const struct roughcontact_scan_options *options,
                                                  struct roughcontact_status *status);

/** Warning `i` from 0, one line; NULL behind the last. */
ROUGHCONTACT_API const char *roughcontact_scan_warning(const struct roughcontact_scan *scan, size_t i);
ROUGHCONTACT_API void roughcontact_scan_free(struct roughcontact_scan *scan);

/* ---- surfaces ---- */

#define ROUGHCONTACT_NO_ROW ((size_t)-1)

/** How a scan is made ready, besides what the program does unasked. */
struct roughcontact_surface_options {
    size_t row;                    /* of a map, which is read as a profile; ROUGHCONTACT_NO_ROW: it has to be one */
    double lambda_s_m, lambda_c_m; /* Gaussian low-pass and high-pass (ISO 16610-21); 0: none */
};
/** Fills in the defaults: a profile, no filter. */
ROUGHCONTACT_API void roughcontact_surface_options_init(struct roughcontact_surface_options *options);

/** A profile made ready, with its spectrum and power law. */
struct roughcontact_surface;

/** Makes a scan ready. Options NULL: the defaults. Errors: SCAN (too many points missing, flat, a filter longer than
 * the scan), USAGE, MEMORY. */
ROUGHCONTACT_API int roughcontact_surface_make(struct roughcontact_surface **out, const struct roughcontact_scan *scan,
                                               const struct roughcontact_surface_options *options,
                                               struct roughcontact_status *status);

/** What was done to the scan and what is doubtful, `i` from 0, one line each; NULL behind the last. */
ROUGHCONTACT_API const char *roughcontact_surface_note(const struct roughcontact_surface *surface, size_t i);

struct roughcontact_roughness {
    double rq_m, ra_m, pv_m;     /* root mean square, mean absolute height, highest minus lowest */
    double rsk, rku;             /* 0 and 3 for Gaussian heights */
    double m0_m2, m2, m4_per_m2; /* mean square height, slope, curvature, by differences */
};
ROUGHCONTACT_API const struct roughcontact_roughness *
roughcontact_surface_roughness(const struct roughcontact_surface *surface);

/** Harmonics n = 1 ... count of a record of length L, of wavelength L/n. */
struct roughcontact_spectrum {
    size_t count;
    double length_m;           /* L */
    const double *amplitude_m; /* of harmonic n at index n - 1 */
    int has_nyquist;           /* the last has the mean square amplitude², the others amplitude²/2 */
};
ROUGHCONTACT_API const struct roughcontact_spectrum *
roughcontact_surface_spectrum(const struct roughcontact_surface *surface);

enum roughcontact_law {
    ROUGHCONTACT_LAW_NONE = 0,
    ROUGHCONTACT_LAW_NARROW = 1,
    ROUGHCONTACT_LAW_FOUND = 2,
    ROUGHCONTACT_LAW_SCATTERED = 3
};

/** amplitude = alpha wavelength^gamma. */
struct roughcontact_power_law {
    int law;      /* roughcontact_law; narrow: over less than a decade; scattered: a line, no law */
    double alpha; /* m^(1-gamma) */
    double gamma, gamma_error;
    double amplitude_m, amplitude_error_decades; /* the rms amplitude, at wavelength_m */
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

/** A built-in material (`roughcontact materials` lists them), or with NULL one of which nothing is known yet. Errors:
 * USAGE (no such name), MEMORY. */
ROUGHCONTACT_API int roughcontact_material_new(struct roughcontact_material **out, const char *name,
                                               struct roughcontact_status *status);
/** `key`: a property with its unit: "E_Pa", "nu", "Sy_Pa", "resistivity_ohm_m", "conductivity_W_per_mK", ...
 * (`roughcontact materials --json` has all). Errors: USAGE: no such key, or out of its range. */
ROUGHCONTACT_API int roughcontact_material_set(struct roughcontact_material *material, const char *key, double value,
                                               struct roughcontact_status *status);
ROUGHCONTACT_API void roughcontact_material_free(struct roughcontact_material *material);

/* ---- models ---- */

/** Name of model `i` from 0, such as "multiscale-elastic"; NULL behind the last. `roughcontact models` says what each
 * assumes and where it holds. */
ROUGHCONTACT_API const char *roughcontact_model_name(size_t i);

/** What loads are given in: P/(A_n E'), or the nominal pressure P/A_n in Pa, which needs a material. */
enum roughcontact_load { ROUGHCONTACT_LOAD_OVER_MODULUS = 0, ROUGHCONTACT_LOAD_PRESSURE_PA = 1 };

struct roughcontact_run_options {
    const struct roughcontact_material *material;    /* NULL: none; then area and separation alone, elastic */
    const struct roughcontact_material *counterface; /* NULL: a rigid flat that conducts like the material */
    double hardness_Pa;                              /* of the softer body; NaN: the material's, else 2.84 S_y */
    int load;                                        /* roughcontact_load */
};
/** Fills in the defaults: no material, loads over the modulus. */
ROUGHCONTACT_API void roughcontact_run_options_init(struct roughcontact_run_options *options);

/** What a model says of a surface at a list of loads. */
struct roughcontact_curve;

/** Runs a model at `count` loads, above 0 and ascending. Everything is computed that the materials give properties for:
 * separation always, ECR with resistivity_ohm_m, TCR with conductivity_W_per_mK, its scale-dependent form with what it
 * needs besides. Options NULL: the defaults. Errors: USAGE (no such model, a load out of order, a property that it
 * needs is missing), MODEL (the surface has no asperities in the model's sense, or too little of it touches
 * as a strip), NUMBER, MEMORY. `strip` and `strip-plastic` solve the profile anew in every call. */
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
    double ecr_ohm_m2;        /* electrical contact resistance times A_n */
    double tcr_K_m2_per_W;    /* thermal contact resistance times A_n */
    double tcr_sd_K_m2_per_W; /* the same, scale-dependent */
};

/** At load `i` from 0, in the order they were given; NULL behind the last. */
ROUGHCONTACT_API const struct roughcontact_point *roughcontact_curve_point(const struct roughcontact_curve *curve,
                                                                           size_t i);
ROUGHCONTACT_API void roughcontact_curve_free(struct roughcontact_curve *curve);

#ifdef __cplusplus
}
#endif

#endif
