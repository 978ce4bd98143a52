/* Times the program's kernels and prints a table: case, method, evaluations, nanoseconds each, error.
 * cmake --workflow --preset bench. Times are the least of several runs; ratios are taken within this one run. */
#include "base/clock.h"
#include "contact/multiscale.h"
#include "contact/statistical.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { EVERYTHING = CONTACT_SEPARATION | CONTACT_ELECTRICAL | CONTACT_THERMAL | CONTACT_SCALE_DEPENDENT, LOADS = 121 };

static double load_at(int i)
{
    return 1e-6 * pow(10, 5.0 * i / (LOADS - 1));
}

static double bench_multiscale(const struct material_pair *pair, bool plastic, double gamma, uint64_t *evaluations)
{
    size_t count = 4096;
    struct spectrum spectrum = {malloc(count * sizeof(double)), count, 3e-4, false};
    struct status status = {0};
    struct spot spot = spot_make(pair);
    for (size_t i = 0; i < count; i++)
        spectrum.amplitude_m[i] = 0.085 * pow(3e-4, 1.5 - gamma) * pow(spectrum.length_m / (double)(i + 1), gamma);
    double best = INFINITY;
    for (int run = 0; run < 5; run++) {
        struct multiscale stack;
        struct contact_point point;
        *evaluations = 0;
        double started = clock_seconds();
        if (multiscale_make(&stack, &spectrum, pair, plastic, SCENE_CLOSURE_THESIS, &status) != STATUS_OK)
            exit(1);
        for (int i = 0; i < LOADS; i++)
            multiscale_solve(&point, &stack, &spot, EVERYTHING, load_at(i), evaluations);
        multiscale_free(&stack);
        best = fmin(best, clock_seconds() - started);
    }
    spectrum_free(&spectrum);
    return best;
}

static double bench_statistical(const struct material_pair *pair, enum asperity_law_id law, double tolerance, uint64_t *evaluations, bool loads)
{
    struct asperities surface;
    struct roughness roughness = {.m0_m2 = 1.156e-13, .m2 = 0.0012, .m4_per_m2 = 4.5e8};
    struct status status = {0};
    if (roughness_asperities(&surface, &roughness, &status) != STATUS_OK) exit(1);
    double best = INFINITY;
    for (int run = 0; run < 20; run++) {
        struct statistical model;
        struct contact_point point;
        double d = 3;
        *evaluations = 0;
        double started = clock_seconds();
        if (statistical_make(&model, &surface, pair, law, EVERYTHING, tolerance, INFINITY, evaluations, &status) != STATUS_OK) exit(1);
        for (int i = 0; i < (loads ? LOADS : 100); i++)
            if (loads) { if (!statistical_solve(&point, &model, load_at(i), &d)) break; }
            else statistical_at(&point, &model, 6 - 0.08 * i);
        statistical_free(&model);
        best = fmin(best, clock_seconds() - started);
    }
    return best;
}

int main(void)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    uint64_t e;
    for (int p = 0; p < 2; p++)
        for (double gamma = 0.5; gamma < 1.6; gamma += 0.5) {
            double s = bench_multiscale(&pair, p, gamma, &e);
            printf("multiscale %s gamma %.1f: %.2f ms, %lu evaluations, %.1f ns\n", p ? "plastic" : "elastic", gamma, s * 1e3, e, s / (double)e * 1e9);
        }
    for (int l = 0; l < 2; l++)
        for (double tol = 1e-6; tol > 1e-11; tol *= 1e-4)
            for (int loads = 0; loads < 2; loads++) {
                double s = bench_statistical(&pair, l, tol, &e, loads);
                printf("%s tol %.0e %s: %.3f ms, %lu law evaluations\n", l ? "jg" : "gw", tol, loads ? "121 loads" : "100 separations", s * 1e3, e);
            }
    return 0;
}
