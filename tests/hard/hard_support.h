/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the hard cases share. Each program runs twice: as it is and, with ROUGHCONTACT_TRAPS set, with every invalid
 * operation, division by zero and overflow a signal, which cmocka reports as a failure. */
#ifndef HARD_SUPPORT_H
#define HARD_SUPPORT_H

#include "contact/model_support.h"
#include "hard_case.h"

#include <fenv.h>
#include <gsl/gsl_errno.h>

static int hard_start(void **state)
{
    (void)state;
    gsl_set_error_handler_off(); /* as the program does */
    return getenv("ROUGHCONTACT_TRAPS") && feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) < 0;
}
TEST_GROUP(hard_start, NULL)

static const double hard_length_m = 3e-4; /* of a scan */

/** Tin, but with S_y/E' and nu as given. */
static inline struct material_pair hard_pair(double yield_ratio, double nu)
{
    struct material material = *material_find("tin");
    material.poisson_ratio = nu;
    material.yield_strength_Pa = yield_ratio * material.youngs_modulus_Pa / (1 - nu * nu);
    return material_pair(&material, MATERIAL_COUNTERFACE_RIGID, NULL);
}

/* The ends of what metals reach and beyond. */
static const double hard_yield_ratios[] = {1e-7, 1e-5, 3e-4, 5e-3, 0.05};
static const double hard_nus[] = {0, 0.25, 0.36, 0.5};
enum { HARD_YIELD_RATIOS = 5, HARD_NUS = 4 };

/** The address sanitizer slows everything five to ten times: then the grids are coarser by this. */
#ifdef __SANITIZE_ADDRESS__
enum { HARD_COARSER = 5 };
#else
enum { HARD_COARSER = 1 };
#endif

#endif
