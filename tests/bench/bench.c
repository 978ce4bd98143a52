/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Times the direct solution: convolutions, CPU and elapsed time, memory held, and what is aimed at; parts that are not
 * flat, and stacks of scales. cmake --workflow --preset bench, with growth.sh, of whole reports. Times are the least of
 * several runs; those of the methods for a model's integrals stand in any report's cost.csv. */
#include "base/clock.h"
#include "contact/multiscale.h"
#include "direct/direct_ensemble.h"
#include "joint/shape.h"

#include <malloc.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum {
    EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_RESISTANCES,
    LOADS = 121,
    RUNS = 10,
};

static void must(enum status_code code)
{
    if (code != STATUS_OK)
        exit(1);
}

static double load_at(int i)
{
    return 1e-6 * pow(10, 5.0 * i / (LOADS - 1));
}

static struct spectrum law_spectrum(size_t scales, double gamma)
{
    struct spectrum spectrum = {malloc(scales * sizeof(double)), scales, 3e-4, false};
    if (!spectrum.amplitude_m)
        exit(1);
    for (size_t i = 0; i < scales; i++)
        spectrum.amplitude_m[i] = 0.085 * pow(3e-4, 1.5 - gamma) * pow(spectrum.length_m / (double)(i + 1), gamma);
    return spectrum;
}

static double cpu_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** CPU seconds of a stack made and pressed at all loads. */
static double stack_run(const struct spectrum *spectrum, const struct material_pair *pair, bool plastic,
                        uint64_t *visits)
{
    struct constriction spot = constriction_make(pair);
    struct multiscale stack;
    struct contact_point point;
    double started = cpu_seconds();
    if (multiscale_make(&stack, spectrum, pair, plastic, SINUSOID_FIT_THESIS, &(struct status){0}) != STATUS_OK)
        abort();
    for (int i = 0; i < LOADS; i++)
        multiscale_solve(&point, &stack, &spot, EVERYTHING, load_at(i), visits);
    multiscale_free(&stack);
    return cpu_seconds() - started;
}

/** A tin-like surface: gamma 1.3, Rq 0.24 um in 0.3 mm, lambda_s = 6 dx. */
static struct direct_spectrum direct_case_spectrum(size_t n)
{
    struct direct_law law = {.lambda_s_m = 3e-4 / ((double)n / 6), .length_m = 3e-4};
    struct direct_spectrum spectrum;
    struct status status = {0};
    must(direct_law_match(&law, (double[]){5.86e-14, 1e-30, 1.8e-4 * (double)n / 256}, law.length_m, law.lambda_s_m,
                          &status));
    must(direct_spectrum_of_law(&spectrum, &law, &status));
    return spectrum;
}

/** Of a direct solution. */
struct direct_result {
    size_t convolutions;
    double cpu_seconds, elapsed_seconds, bytes_a_point;
};

static double bytes_held(void)
{
    struct mallinfo2 held = mallinfo2();
    return (double)held.uordblks + (double)held.hblkhd;
}

/** One load solved cold, to 1e-6. */
static struct direct_result direct_case(size_t n, double hardness)
{
    enum { DIRECT_RUNS = 2 };
    struct direct_spectrum spectrum = direct_case_spectrum(n);
    struct direct_result result = {0, INFINITY, INFINITY, NAN};
    struct status status = {0};
    struct direct_contact contact;
    struct direct_contact_load load = {.mean_pressure = 1e-4, .hardness = hardness, .tolerance = 1e-6};
    OWNED(memory_free) double *height_m = malloc(n * n * sizeof *height_m);
    if (!height_m)
        exit(1);
    must(direct_surface_make(height_m, n, &(struct direct_recipe){direct_spectrum_variance, &spectrum, NULL, 0}, 1,
                             &status));
    double before = bytes_held();
    must(direct_contact_make(&contact, height_m, &(struct direct_grid){n, n, 3e-4 / (double)n, false, false}, &status));
    for (int run = 0; run < DIRECT_RUNS; run++) {
        double started = clock_seconds(), cpu = cpu_seconds();
        must(direct_contact_solve(&contact, &load, &status));
        result.elapsed_seconds = fmin(result.elapsed_seconds, clock_seconds() - started);
        result.cpu_seconds = fmin(result.cpu_seconds, cpu_seconds() - cpu);
        result.convolutions = contact.convolutions;
    }
    result.bytes_a_point = (bytes_held() - before) / (double)(n * n);
    direct_contact_free(&contact);
    direct_spectrum_free(&spectrum);
    return result;
}

/** Twelve seeds at 256 x 256 up 13 loads, with resistance, on two threads. */
static struct direct_result direct_ladder_case(void)
{
    double load[13];
    for (int i = 0; i < 13; i++)
        load[i] = 1e-5 * pow(10, i / 4.0);
    struct direct_spectrum spectrum = direct_case_spectrum(256);
    struct direct_ensemble_def def = {.ladder = {load, 13, INFINITY, 1e-6, true, NULL},
                                      .length_m = 3e-4,
                                      .n = 256,
                                      .recipe = {direct_spectrum_variance, &spectrum, NULL, 0},
                                      .seeds = 12,
                                      .threads = 2};
    struct direct_result result = {0, INFINITY, INFINITY, NAN};
    for (int run = 0; run < 2; run++) {
        struct direct_ensemble ensemble;
        struct status status = {0};
        double started = clock_seconds(), cpu = cpu_seconds();
        must(direct_ensemble_run(&ensemble, &def, &status));
        result.elapsed_seconds = fmin(result.elapsed_seconds, clock_seconds() - started);
        result.cpu_seconds = fmin(result.cpu_seconds, cpu_seconds() - cpu);
        result.convolutions = 0;
        for (size_t k = 0; k < ensemble.seeds * ensemble.loads; k++)
            result.convolutions += ensemble.seed_point[k].convolutions;
        direct_ensemble_free(&ensemble);
    }
    direct_spectrum_free(&spectrum);
    return result;
}

static void print_direct(const char *name, const struct direct_result *result, const char *more)
{
    printf("%-46s %9zu %9.1f %9.1f", name, result->convolutions, result->cpu_seconds * 1e3,
           result->elapsed_seconds * 1e3);
    if (isnan(result->bytes_a_point))
        printf(" %8s", "");
    else
        printf(" %8.1f", result->bytes_a_point);
    printf("  %s\n", more);
}

/** Beside what is aimed at: a processor of its own is taken for granted, so on a busy machine compare CPU time. */
static void direct_cases(void)
{
    static const struct {
        size_t n;
        double target_ms;
    } cases[] = {{256, 35}, {512, 190}, {1024, 1200}};
    char name[64], more[80];
    printf("\n%-46s %9s %9s %9s %8s  %s\n", "direct solution", "convs", "CPU ms", "ms", "B/point", "aimed at");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct direct_result elastic = direct_case(cases[k].n, INFINITY);
        snprintf(name, sizeof name, "%zu x %zu, one load, cold, to 1e-6", cases[k].n, cases[k].n);
        snprintf(more, sizeof more, "%.0f ms, 60 B/point", cases[k].target_ms);
        print_direct(name, &elastic, more);
        if (cases[k].n > 512) /* it would take as long as all the rest */
            continue;
        struct direct_result capped = direct_case(cases[k].n, 4.97e-4);
        snprintf(more, sizeof more, "8 times elastic: %.1f times", capped.cpu_seconds / elastic.cpu_seconds);
        print_direct("  with a hardness", &capped, more);
    }
    struct direct_result ladder = direct_ladder_case();
    print_direct("12 x 256 x 256, 13 loads, resistance, 2 threads", &ladder, "3500 ms");
}

/** A stack of so many scales made and pressed at every load, of a law so flat that it is visited to its end. */
static double stack_seconds(size_t scales)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct spectrum spectrum = law_spectrum(scales, 0.5);
    double seconds = INFINITY;
    for (int run = 0; run < RUNS; run++)
        seconds = fmin(seconds, stack_run(&spectrum, &pair, true, &(uint64_t){0}));
    spectrum_free(&spectrum);
    return seconds;
}

/** CPU seconds of parts with a bulge of F over 20 mm at 61 loads over two decades, pressure and resistance, in n x n
 * cells; aluminium, a gap that is logarithmic and a conductance that is a power of the pressure. */
static double shape_seconds(size_t n, double bulge_m)
{
    enum { POINTS = 221, SHAPE_LOADS = 61 };
    const double side_m[2] = {20e-3, 20e-3};
    const struct shape_body bodies[2] = {{1. / 170, INFINITY}, {1. / 170, INFINITY}};
    double pressure_Pa[POINTS], gap_m[POINTS], conductance[POINTS], resistance, spots;
    OWNED(memory_free) double *field_m = malloc(n * n * sizeof *field_m);
    struct shape shape;
    struct shape_curve gap, ways;
    struct status status = {0};
    for (int i = 0; i < POINTS; i++) {
        pressure_Pa[i] = pow(10, -12 + 0.1 * i);
        gap_m[i] = -0.3e-6 * log(pressure_Pa[i] / 3e8);
        conductance[i] = 0.05 * pow(pressure_Pa[i], 0.95);
    }
    must(field_m ? STATUS_OK : STATUS_MEMORY);
    for (size_t k = 0; k < n * n; k++)
        field_m[k] = bulge_m * (pow(2 * ((double)(k % n) + 0.5) / (double)n - 1, 2) +
                                pow(2 * ((double)(k / n) + 0.5) / (double)n - 1, 2));
    must(shape_make(&shape, n, n, side_m, &status));
    must(shape_curve_gap(&gap, pressure_Pa, gap_m, POINTS, INFINITY, &status));
    must(shape_curve_conductance(&ways, pressure_Pa, conductance, POINTS, &status));
    double begin = cpu_seconds();
    for (int i = 0; i < SHAPE_LOADS; i++) {
        double mean_Pa = 1e5 * pow(100, i / (SHAPE_LOADS - 1.));
        must(shape_press(&shape, field_m, &gap, 3.9e10, mean_Pa, &status));
        must(shape_resistance(&resistance, &spots, &shape, &ways, bodies, &status));
    }
    double seconds = cpu_seconds() - begin;
    shape_free(&shape);
    shape_curve_free(&gap);
    shape_curve_free(&ways);
    return seconds;
}

static void shapes(void)
{
    printf("\nParts that are not flat at 61 loads, CPU; aimed at: 1 s for 64 x 64 cells, of which a bulge takes a "
           "quarter\n");
    for (double bulge_um = 0.5; bulge_um < 60; bulge_um *= 10)
        printf("  bulge %4.1f um: %.2f s in 64 x 64 cells, %.2f s in 32 x 32\n", bulge_um,
               shape_seconds(64, bulge_um * 1e-6), shape_seconds(32, bulge_um * 1e-6));
}

int main(void)
{
    direct_cases();
    shapes();
    puts("\nA stack of scales made and pressed at 121 loads, CPU; aimed at: an exponent of 1.05 or less");
    for (size_t scales = 1000; scales <= 100000; scales *= 10)
        printf("  %6zu scales: %.4g s\n", scales, stack_seconds(scales));
    return 0;
}
