/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Quadrature, and the integrals of asperities over Gaussian heights. */
#include "base/integral.h"
#include "contact/gaussian.h"
#include "selftest/selftest.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

static const struct selftest_reference references[] = {
    {"quadrature", "4/(1+x^2)", {0, 1}, M_PI, 1e-12},      {"quadrature", "ln x", {0, 1}, -1, 1e-8},
    {"quadrature", "|x-1/3|", {0, 1}, 5.0 / 18, 1e-10},    {"F_n", "F_1/2", {-10}, 3.1582867358815187, 1e-12},
    {"F_n", "F_3/2", {-10}, 31.741587709726317, 1e-12},    {"F_n", "F_1/2", {0}, 0.41108947933122928, 1e-12},
    {"F_n", "F_1", {0}, 0.39894228040143268, 1e-12},       {"F_n", "F_3/2", {0}, 0.43001999366225977, 1e-12},
    {"F_n", "F_1/2", {3}, 0.00064185043934855080, 1e-12},  {"F_n", "F_3/2", {3}, 0.00026396755426946728, 1e-12},
    {"F_n", "F_1/2", {20}, 5.4449378883054642e-90, 1e-12}, {"F_n", "F_3/2", {37}, 3.3735350268342333e-302, 1e-12},
};

static double integrand(double x, void *context)
{
    const char *of = context;
    return *of == '4' ? 4 / (1 + x * x) : *of == 'l' ? log(x) : fabs(x - 1.0 / 3);
}

static enum status_code compute(double *values, const struct selftest_reference *all, size_t count,
                                struct status *status)
{
    (void)status;
    for (size_t i = 0; i < count; i++) {
        const struct selftest_reference *r = &all[i];
        if (strcmp(r->what, "quadrature") == 0) {
            values[i] = integral(integrand, (void *)(uintptr_t)r->of, r->at[0], r->at[1], 1e-13);
            continue;
        }
        struct gaussian_integrals f = gaussian_integrals(r->at[0]);
        double plain = strcmp(r->of, "F_1/2") == 0 ? f.half : strcmp(r->of, "F_1") == 0 ? f.one : f.three_halves;
        values[i] = plain * exp(f.log_factor);
    }
    return STATUS_OK;
}

const struct selftest_group selftest_integrals = {
    .name = "integrals",
    .source = "closed forms; parabolic cylinder functions in 30 digits",
    .references = references,
    .count = sizeof references / sizeof references[0],
    .compute = compute,
};
