/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Surfaces made up for a test, and models run on them. What is made here is the test's. */
#ifndef TEST_MODEL_SUPPORT_H
#define TEST_MODEL_SUPPORT_H

#include "contact/model.h"
#include "contact/multiscale.h"
#include "contact/persson.h"
#include "contact/statistical.h"
#include "support.h"

enum {
    MODEL_LOADS = 25,
    MODEL_EVERYTHING = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                       QUANTITY_BIT(QUANTITY_ADJUSTED) | QUANTITY_RESISTANCES
};

/** Runs a row of the table and checks the count of its evaluations. `points`: load_count + 1 of them. */
struct model_curve model_support_run(struct contact_point *points, const char *model, const struct model_task *task);

/** Asks for everything, at a hardness of 2.84 S_y, of a surface without asperities and strips. */
struct model_task model_support_task(const struct spectrum *spectrum, const struct material_pair *pair,
                                     const double *loads, size_t count);

/** The spots that a model has at the loads of the task, one of `spots` a load. */
void model_support_spots(struct contact_spots *spots, const char *model, const struct model_task *task);

/** Fails unless load, area and resistances are those of a row of a reference table. */
void model_support_matches(const struct contact_point *point, const struct table *table, size_t row, double rtol);

/** Loads by equal factors. */
void model_support_loads(double *load, size_t count, double from, double to);

/** alpha lambda^gamma of a scan of that length. */
struct spectrum model_support_law(double length_m, double alpha, double gamma, size_t count);

/** Mean spectrum of rows of heights. */
struct spectrum model_support_spectrum(const double *height_m, size_t rows, size_t points, double spacing_m);

/** The waves of a spectrum, ready for Persson's theory. */
struct persson model_support_persson(const struct spectrum *spectrum);

/** The harmonics of a spectrum as scales. */
struct multiscale model_support_stack(const struct spectrum *spectrum, const struct material_pair *pair, bool plastic,
                                      enum sinusoid_fit_id closure);

/** A statistical model for separations from lowest_d on: statistical_make(). */
struct statistical model_support_statistical(const struct asperities *surface, const struct material_pair *pair,
                                             bool plastic, double tolerance, double lowest_d);

/** The heights of rows, in order. */
const struct bearing *model_support_bearing(const struct strip_rows *rows);

/** The asperities of a surface with these moments. */
struct asperities model_support_asperities(double m0_m2, double m2, double m4_per_m2);

/** Tin against a rigid flat. */
struct material_pair model_support_tin(void);

/** The same number, or the same lack of one. */
#define assert_same_number(actual, expected, rtol)                                                                     \
    do {                                                                                                               \
        double actual_ = (actual), expected_ = (expected);                                                             \
        assert_int_equal(isnan(actual_) != 0, isnan(expected_) != 0);                                                  \
        if (!isnan(expected_))                                                                                         \
            assert_near(actual_, expected_, rtol);                                                                     \
    } while (0)

#endif
