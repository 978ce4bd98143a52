/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A model's row run on a surface made up for a test. */
#ifndef TEST_MODEL_SUPPORT_H
#define TEST_MODEL_SUPPORT_H

#include "contact/model.h"
#include "contact/persson.h"
#include "support.h"

enum {
    MODEL_LOADS = 25,
    MODEL_EVERYTHING = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
                       QUANTITY_BIT(QUANTITY_ADJUSTED) | QUANTITY_RESISTANCES
};

/** Runs a row of the table; what it took is counted. `points`: load_count + 1 of them. */
struct model_curve model_support_run(struct contact_point *points, const char *model, const struct model_task *task);

/** Loads by equal factors. */
void model_support_loads(double *load, size_t count, double from, double to);

/** alpha lambda^gamma of a scan of that length; to be freed. */
struct spectrum model_support_law(double length_m, double alpha, double gamma, size_t count);

/** Its waves ready for Persson's theory. To be freed. */
struct persson model_support_persson(const struct spectrum *spectrum);

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
