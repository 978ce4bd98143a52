/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "library/roughcontact.h"
#include <math.h>
#include <stdbool.h>

enum { PLACES = 2, LOADS = 8, CALLS_MOST = 48, STRIP_MOST = 256 };

/* What is read next of the input; behind its end all is 0. */
static struct {
    const uint8_t *bytes;
    size_t length;
} rest;

static unsigned next(unsigned limit)
{
    unsigned byte = rest.length > 0 ? *rest.bytes : 0;
    rest.bytes += rest.length > 0;
    rest.length -= rest.length > 0;
    return byte % limit;
}

/* One of the numbers at which something may end, a small one, or any. */
static double next_number(void)
{
    static const double ends[] = {0,    -1,   NAN,    INFINITY, -INFINITY, 1e-320, 1e308, 1e-3,
                                  1e-6, 1e-9, 2.5e-6, 8e-4,     1e11,      0.3,    1e8,   1e-12};
    unsigned kind = next(32);
    double any = 0;
    if (kind < sizeof ends / sizeof *ends)
        return ends[kind];
    for (unsigned char *at = (unsigned char *)&any; kind > 28 && at < (unsigned char *)(&any + 1); at++)
        *at = (unsigned char)next(256);
    return kind > 28 ? any : pow(10, -(double)kind / 2) * (1 + next(256));
}

/* A word of a list, now and then NULL or one of letters that is none. */
static const char *next_word(const char *const *words, unsigned count)
{
    static char none[8];
    unsigned i = next(count + 2);
    if (i < count)
        return words[i];
    for (size_t k = 0; k + 1 < sizeof none; k++)
        none[k] = (char)(next(256) % 95 + 32);
    return i == count ? NULL : none;
}

static struct roughcontact_scan *scans[PLACES];
static struct roughcontact_surface *surfaces[PLACES];
static struct roughcontact_material *materials[PLACES];
static struct roughcontact_curve *curves[PLACES];

static struct {
    const char *name;
    size_t calls, good;
} counts[] = {{"bytes", 0, 0},    {"file", 0, 0}, {"surface", 0, 0}, {"material", 0, 0},
              {"property", 0, 0}, {"run", 0, 0},  {"look", 0, 0},    {"free", 0, 0}};

void fuzz_library_counts(void)
{
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        fprintf(stderr, "calls of %-8s %9zu, good ones %9zu\n", counts[i].name, counts[i].calls, counts[i].good);
}

size_t fuzz_library_good(void)
{
    size_t least = SIZE_MAX;
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
        least = counts[i].good < least ? counts[i].good : least;
    return least;
}

/* What the header promises of a call that made `handle`, NULL where it makes none. */
static bool require_code(int code, const struct roughcontact_status *status, void *const *handle)
{
    FUZZ_REQUIRE(code >= ROUGHCONTACT_OK && code <= ROUGHCONTACT_NUMBER && code != ROUGHCONTACT_MEMORY);
    FUZZ_REQUIRE(!handle || (*handle != NULL) == (code == ROUGHCONTACT_OK));
    if (status) {
        FUZZ_REQUIRE(status->code == code && memchr(status->message, '\0', sizeof status->message));
        FUZZ_REQUIRE((*status->message != '\0') == (code != ROUGHCONTACT_OK) && !strchr(status->message, '\n'));
    }
    return code == ROUGHCONTACT_OK;
}

static bool read_scan(bool file, struct roughcontact_status *status)
{
    static const char *const units[] = {"mm", "um", "", "m", "kg"};
    static const char *const paths[] = {"/dev/null", "/", "", PROJECT_SOURCE "/tests/fuzz/corpus/report/text",
                                        "no/such file"};
    struct roughcontact_scan_options options;
    struct roughcontact_scan **out = &scans[next(PLACES)];
    roughcontact_scan_options_init(&options);
    unsigned how = next(4);
    if (how > 1) {
        options.x_unit = next_word(units, sizeof units / sizeof *units);
        options.z_unit = next_word(units, sizeof units / sizeof *units);
    }
    const char *name = next_word(paths, sizeof paths / sizeof *paths);
    roughcontact_scan_free(*out);
    *out = (struct roughcontact_scan *)(uintptr_t)1; /* whatever was there */
    if (file)
        return require_code(roughcontact_scan_read_file(out, name, how > 0 ? &options : NULL, status), status,
                            (void **)out);
    bool none = next(16) == 15;
    size_t length = 4 * next(256);
    length = length < rest.length ? length : rest.length;
    char *copy = malloc(length ? length : 1); /* no NUL behind the last */
    FUZZ_REQUIRE(copy);
    memcpy(copy, rest.bytes, length);
    int code = roughcontact_scan_read_bytes(out, none ? NULL : copy, length, name, how > 0 ? &options : NULL, status);
    free(copy);
    rest.bytes += length;
    rest.length -= length;
    return require_code(code, status, (void **)out);
}

static bool make_surface(struct roughcontact_status *status)
{
    struct roughcontact_surface_options options;
    const struct roughcontact_scan *scan = scans[next(PLACES)];
    struct roughcontact_surface **out = &surfaces[next(PLACES)];
    roughcontact_surface_options_init(&options);
    unsigned how = next(6);
    if (how > 1)
        options.row = how == 2 ? SIZE_MAX - 1 : next(4);
    if (how > 3)
        options.lambda_s_m = next_number();
    if (how > 4)
        options.lambda_c_m = next_number();
    roughcontact_surface_free(*out);
    return require_code(roughcontact_surface_make(out, scan, how > 0 ? &options : NULL, status), status, (void **)out);
}

static bool new_material(struct roughcontact_status *status)
{
    static const char *const names[] = {"tin", "copper", "steel", "bronze", ""};
    struct roughcontact_material **out = &materials[next(PLACES)];
    const char *name = next_word(names, sizeof names / sizeof *names);
    roughcontact_material_free(*out);
    return require_code(roughcontact_material_new(out, name, status), status, (void **)out);
}

static bool set_property(struct roughcontact_status *status)
{
    static const char *const keys[] = {"E_Pa",       "nu", "Sy_Pa", "resistivity_ohm_m", "conductivity_W_per_mK",
                                       "hardness_Pa"};
    struct roughcontact_material *material = materials[next(PLACES)];
    const char *key = next_word(keys, sizeof keys / sizeof *keys);
    return require_code(roughcontact_material_set(material, key, next_number(), status), status, NULL);
}

/* What the header promises of a curve. */
static void require_curve(const struct roughcontact_curve *curve, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct roughcontact_point *p = roughcontact_curve_point(curve, i);
        FUZZ_REQUIRE(p && p->load > 0 && isfinite(p->load) && (p->exists || !p->valid));
        const double values[] = {p->separation_m, p->ecr_ohm_m2, p->tcr_K_m2_per_W, p->tcr_sd_K_m2_per_W};
        FUZZ_REQUIRE(isnan(p->area_ratio) ? !p->exists : p->exists && p->area_ratio >= 0 && p->area_ratio <= 1);
        for (size_t k = 0; k < sizeof values / sizeof *values; k++)
            FUZZ_REQUIRE(!isinf(values[k]) && (p->exists || isnan(values[k])));
        for (size_t k = 1; k < sizeof values / sizeof *values; k++)
            FUZZ_REQUIRE(isnan(values[k]) || values[k] >= 0);
    }
    FUZZ_REQUIRE(!roughcontact_curve_point(curve, count) && !roughcontact_curve_point(curve, SIZE_MAX));
}

static bool run_model(struct roughcontact_status *status)
{
    struct roughcontact_run_options options;
    const struct roughcontact_surface *surface = surfaces[next(PLACES)];
    struct roughcontact_curve **out = &curves[next(PLACES)];
    const char *model = roughcontact_model_name(next(16));
    double loads[LOADS], sum = 0;
    size_t count = next(LOADS + 1);
    bool ascending = next(8) > 0, none = next(16) == 15;
    roughcontact_run_options_init(&options);
    unsigned how = next(6);
    options.load = how > 0 && next(4) > 1 ? (int)next(4) - 1 : 0;
    options.material = how > 1 ? materials[next(PLACES)] : NULL;
    options.counterface = how > 3 ? materials[next(PLACES)] : NULL;
    options.hardness_Pa = how > 4 ? next_number() : NAN;
    for (size_t i = 0; i < count; i++)
        loads[i] = sum = ascending ? sum + 1e-6 + 1e-5 * pow(next(64), 3) : next_number();
    if (model && strncmp(model, "strip", 5) == 0 && surface &&
        roughcontact_surface_spectrum(surface)->count > STRIP_MOST)
        return true; /* it would take too long */
    roughcontact_curve_free(*out);
    int code = roughcontact_run(out, surface, model, none ? NULL : loads, count, how > 0 ? &options : NULL, status);
    if (require_code(code, status, (void **)out))
        require_curve(*out, count);
    return code == ROUGHCONTACT_OK;
}

/* All that a surface says. */
static bool look(void)
{
    const struct roughcontact_surface *surface = surfaces[next(PLACES)];
    const struct roughcontact_scan *scan = scans[next(PLACES)];
    size_t notes = 0;
    while (scan && roughcontact_scan_warning(scan, notes))
        notes++;
    FUZZ_REQUIRE(!scan || !roughcontact_scan_warning(scan, SIZE_MAX));
    if (!surface)
        return false;
    const struct roughcontact_roughness *r = roughcontact_surface_roughness(surface);
    const struct roughcontact_spectrum *spectrum = roughcontact_surface_spectrum(surface);
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    const double numbers[] = {r->rq_m, r->ra_m, r->pv_m, r->m0_m2, r->m2, r->m4_per_m2};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        FUZZ_REQUIRE(isnan(numbers[i]) || (numbers[i] >= 0 && isfinite(numbers[i])));
    FUZZ_REQUIRE(spectrum->count > 0 && spectrum->length_m > 0 && isfinite(spectrum->length_m));
    for (size_t n = 0; n < spectrum->count; n++)
        FUZZ_REQUIRE(spectrum->amplitude_m[n] >= 0 && isfinite(spectrum->amplitude_m[n]));
    FUZZ_REQUIRE(law->law >= ROUGHCONTACT_LAW_NONE && law->law <= ROUGHCONTACT_LAW_FOUND);
    FUZZ_REQUIRE(!isinf(law->alpha) && !isinf(law->gamma));
    for (notes = 0; roughcontact_surface_note(surface, notes); notes++)
        FUZZ_REQUIRE(!strchr(roughcontact_surface_note(surface, notes), '\n'));
    return true;
}

static bool free_one(unsigned what, unsigned place)
{
    if (what == 0) {
        roughcontact_scan_free(scans[place]);
        scans[place] = NULL;
    } else if (what == 1) {
        roughcontact_surface_free(surfaces[place]);
        surfaces[place] = NULL;
    } else if (what == 2) {
        roughcontact_material_free(materials[place]);
        materials[place] = NULL;
    } else {
        roughcontact_curve_free(curves[place]);
        curves[place] = NULL;
    }
    return true;
}

void fuzz_library(const uint8_t *bytes, size_t length)
{
    rest.bytes = bytes;
    rest.length = length;
    for (size_t i = 0; i < CALLS_MOST && rest.length > 0; i++) {
        struct roughcontact_status status, *said = next(8) > 0 ? &status : NULL;
        memset(&status, 0x55, sizeof status);
        unsigned call = next(sizeof counts / sizeof *counts);
        bool good = call == 0   ? read_scan(false, said)
                    : call == 1 ? read_scan(true, said)
                    : call == 2 ? make_surface(said)
                    : call == 3 ? new_material(said)
                    : call == 4 ? set_property(said)
                    : call == 5 ? run_model(said)
                    : call == 6 ? look()
                                : free_one(next(4), next(PLACES));
        counts[call].calls++;
        counts[call].good += good;
    }
    for (unsigned i = 0; i < 4 * PLACES; i++)
        free_one(i / PLACES, i % PLACES);
}
