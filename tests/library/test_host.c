/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a host program may have set, and gets back; and several threads at once. */
#include "cli/process.h"
#include "hard_case.h"
#include "library/host.h"
#include "library/roughcontact.h"

#include <gsl/gsl_errno.h>
#include <pthread.h>

HARD_CASES("Programs that use the library")

static int errors; /* that the host's handler was told of */

static void count_error(const char *reason, const char *file, int line, int number)
{
    (void)reason, (void)file, (void)line, (void)number;
    errors++;
}

static void raise_gsl_error(void)
{
    GSL_ERROR_VOID("a test", GSL_EDOM);
}

TEST_CASE(gsl_errors_stay_with_the_host)
{
    struct host outer, inner;
    gsl_error_handler_t *before = gsl_set_error_handler(count_error);
    errors = 0;
    raise_gsl_error();
    assert_int_equal(errors, 1);
    host_put_aside(&outer);
    raise_gsl_error(); /* the library's own: silent */
    assert_int_equal(errors, 1);
    host_put_aside(&inner);
    raise_gsl_error();
    host_give_back(&inner);
    raise_gsl_error();
    assert_int_equal(errors, 1);
    host_give_back(&outer);
    raise_gsl_error();
    assert_int_equal(errors, 2);
    assert_ptr_equal(gsl_set_error_handler(before), count_error);
}

/** Everything the library can be asked of one scan, as text. */
static char *ask(const char *bytes, const char *model)
{
    struct roughcontact_status status;
    struct roughcontact_scan *scan;
    struct roughcontact_surface *surface;
    struct roughcontact_material *tin;
    struct roughcontact_curve *curve;
    struct roughcontact_run_options how;
    const double loads[] = {1e-6, 3e-5, 1e-3, 2e-2};
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out || roughcontact_scan_read_bytes(&scan, bytes, strlen(bytes), "scan", NULL, &status) != ROUGHCONTACT_OK)
        return NULL;
    roughcontact_run_options_init(&how);
    bool done = roughcontact_surface_make(&surface, scan, NULL, &status) == ROUGHCONTACT_OK &&
                roughcontact_material_new(&tin, "tin", &status) == ROUGHCONTACT_OK;
    how.material = done ? tin : NULL;
    done = done && roughcontact_run(&curve, surface, model, loads, 4, &how, &status) == ROUGHCONTACT_OK;
    if (!done)
        return NULL;
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    fprintf(out, "%a %a %a\n", roughcontact_surface_roughness(surface)->m4_per_m2, law->gamma, law->gamma_error);
    for (size_t i = 0; roughcontact_scan_warning(scan, i); i++)
        fprintf(out, "%s\n", roughcontact_scan_warning(scan, i));
    for (size_t i = 0; roughcontact_surface_note(surface, i); i++)
        fprintf(out, "%s\n", roughcontact_surface_note(surface, i));
    for (size_t i = 0; i < 4; i++) {
        const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
        fprintf(out, "%a %a %a %a %a\n", point->area_ratio, point->separation_m, point->ecr_ohm_m2,
                point->tcr_K_m2_per_W, point->tcr_sd_K_m2_per_W);
    }
    roughcontact_curve_free(curve);
    roughcontact_material_free(tin);
    roughcontact_surface_free(surface);
    roughcontact_scan_free(scan);
    fclose(out);
    return text;
}

/** A locale with a decimal comma: an installed one, else one made here. False: neither can be had. */
static bool set_comma(const char *place)
{
    static const char *const installed[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8"};
    for (size_t i = 0; i < sizeof installed / sizeof *installed; i++)
        if (setlocale(LC_NUMERIC, installed[i]))
            return true;
    workspace_write(place, "comma",
                    "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n");
    const char *const make[] = {"localedef", "-c", "-f", "ANSI_X3.4-1968", "-i", "./comma", "./comma_DE", NULL};
    process_end(process_start_list(place, make, NULL));
    setenv("LOCPATH", place, 1);
    bool set = setlocale(LC_NUMERIC, "comma_DE");
    unsetenv("LOCPATH");
    return set;
}

/** Of uneven x, with a missing point and a descending x, so that there are warnings with numbers in them. */
static char *uneven_scan(void)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fprintf(out, "x [um],z [um]\n");
    for (int i = 400; i > 0; i--)
        if (i % 50 == 7)
            fprintf(out, "%.4f,NaN\n", 0.5 * i + 0.1 * sin(i));
        else
            fprintf(out, "%.4f,%.6f\n", 0.5 * i + 0.1 * sin(i), sin(0.2 * i) + 0.3 * sin(1.1 * i * i));
    fclose(out);
    return text;
}

TEST_IN_WORKSPACE(the_locale_changes_nothing)
{
    char *bytes = uneven_scan(), shown[16];
    char *expected = ask(bytes, "multiscale-plastic");
    assert_non_null(expected);
    if (!set_comma(place)) {
        free(bytes);
        free(expected);
        print_message("no locale with a decimal comma can be had here\n");
        skip();
    }
    char *found = ask(bytes, "multiscale-plastic");
    snprintf(shown, sizeof shown, "%.1f", 1.5);
    assert_string_equal(shown, "1,5"); /* the host still has its own */
    struct roughcontact_material *tin;
    struct roughcontact_status status;
    assert_int_equal(roughcontact_material_new(&tin, "tin", NULL), ROUGHCONTACT_OK);
    assert_int_equal(roughcontact_material_set(tin, "nu", 0.75, &status), ROUGHCONTACT_USAGE);
    setlocale(LC_NUMERIC, "C");
    expect_part(status.message, "0.75");
    roughcontact_material_free(tin);
    /* the numbers of `found` were written here, in hexadecimal with a decimal comma */
    for (char *comma = found; (comma = strstr(comma, "0x")) != NULL; comma += 3)
        if (comma[3] == ',')
            comma[3] = '.';
    assert_string_equal(found, expected);
    free(found);
    free(expected);
    free(bytes);
}

TEST_CASE(rounding_and_traps_change_nothing)
{
    char *bytes = uneven_scan();
    static const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    static const char *const models[] = {"multiscale-plastic", "jg", "strip"};
    for (size_t m = 0; m < 3; m++) {
        char *expected = ask(bytes, models[m]);
        assert_non_null(expected);
        for (size_t i = 0; i < 3; i++) {
            fesetround(modes[i]);
            feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
            char *found = ask(bytes, models[m]);
            int mode = fegetround(), traps = fegetexcept();
            fedisableexcept(FE_ALL_EXCEPT);
            fesetround(FE_TONEAREST);
            hard_case("a host that rounds up, down or to zero and traps exceptions",
                      "other numbers, or a signal in the host", "computes as always, and gives the host its modes back",
                      "answers that differ in any bit", strcmp(found, expected) != 0, 0);
            assert_int_equal(mode, modes[i]);
            assert_int_equal(traps, FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
            free(found);
        }
        free(expected);
    }
    free(bytes);
}

enum { THREADS = 8, ROUNDS = 6, MODELS = 4 };
static const char *const thread_models[MODELS] = {"multiscale-plastic", "jg", "corrected-persson-plastic", "strip"};

struct worker {
    const char *bytes;
    char *const *expected;
    const struct roughcontact_surface *shared;
    double shared_area;
    size_t number, agreed;
};

static void *work(void *argument)
{
    struct worker *worker = argument;
    const double load = 1e-3;
    for (size_t r = 0; r < ROUNDS; r++) {
        size_t m = (worker->number + r) % MODELS;
        struct roughcontact_curve *curve;
        char *text = ask(worker->bytes, thread_models[m]);
        worker->agreed += text && strcmp(text, worker->expected[m]) == 0;
        free(text);
        if (roughcontact_run(&curve, worker->shared, "corrected-persson", &load, 1, NULL, NULL) == ROUGHCONTACT_OK)
            worker->agreed += roughcontact_curve_point(curve, 0)->area_ratio == worker->shared_area;
        roughcontact_curve_free(curve);
    }
    return NULL;
}

TEST_CASE(threads_do_not_disturb_each_other)
{
    char *bytes = uneven_scan(), *expected[MODELS];
    for (size_t m = 0; m < MODELS; m++)
        assert_non_null(expected[m] = ask(bytes, thread_models[m]));
    struct roughcontact_scan *scan;
    struct roughcontact_surface *shared;
    struct roughcontact_curve *curve;
    const double load = 1e-3;
    assert_int_equal(roughcontact_scan_read_bytes(&scan, bytes, strlen(bytes), "scan", NULL, NULL), ROUGHCONTACT_OK);
    assert_int_equal(roughcontact_surface_make(&shared, scan, NULL, NULL), ROUGHCONTACT_OK);
    assert_int_equal(roughcontact_run(&curve, shared, "corrected-persson", &load, 1, NULL, NULL), ROUGHCONTACT_OK);
    struct worker workers[THREADS];
    pthread_t threads[THREADS];
    gsl_error_handler_t *before = gsl_set_error_handler(count_error);
    for (size_t t = 0; t < THREADS; t++) {
        workers[t] = (struct worker){bytes, expected, shared, roughcontact_curve_point(curve, 0)->area_ratio, t, 0};
        assert_int_equal(pthread_create(&threads[t], NULL, work, &workers[t]), 0);
    }
    for (size_t t = 0; t < THREADS; t++) {
        pthread_join(threads[t], NULL);
        assert_int_equal(workers[t].agreed, 2 * ROUNDS);
    }
    assert_ptr_equal(gsl_set_error_handler(before), count_error);
    roughcontact_curve_free(curve);
    roughcontact_surface_free(shared);
    roughcontact_scan_free(scan);
    for (size_t m = 0; m < MODELS; m++)
        free(expected[m]);
    free(bytes);
}
