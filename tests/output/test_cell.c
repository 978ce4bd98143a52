/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers on their way into files: what is absent, and what must not be. */
#include "output/cell.h"
#include "support.h"

TEST_CASE(test_cells)
{
    struct results_lost lost = {.lock = PTHREAD_MUTEX_INITIALIZER};
    const struct cell_guard guard = {"dull", &lost};
    struct text row = {0};
    cell_number(&row, &guard, "rq_m", 0.1);
    cell_number(&row, &guard, "rq_m", NAN);
    cell_number(&row, &guard, "rq_m", -5e-324);
    assert_string_equal(text_string(&row), ",0.10000000000000001,,-4.9406564584124654e-324");
    json_t *number = cell_json(&guard, "rq_m", 0.1), *absent = cell_json(&guard, "rq_m", NAN);
    assert_true(json_is_real(number) && json_real_value(number) == 0.1 && json_is_null(absent));
    assert_int_equal(lost.count, 0);
    json_decref(number);
    json_decref(absent);
    text_free(&row);
}

/* They cost no report: both are counted, and the first is named, by quantity and surface, or by quantity alone. */
TEST_CASE(test_infinite_numbers)
{
    struct results_lost lost = {.lock = PTHREAD_MUTEX_INITIALIZER}, other = lost;
    const struct cell_guard guard = {"dull", &lost}, of_scene = {NULL, &other};
    struct text row = {0};
    cell_number(&row, &guard, "rq_m", -INFINITY);
    cell_number(&row, &guard, "ra_m", INFINITY);
    assert_string_equal(text_string(&row), ",,");
    assert_int_equal(lost.count, 2);
    assert_non_null(strstr(lost.first, "rq_m of surface 'dull' came out infinite and was left empty"));
    json_t *absent = cell_json(&of_scene, "tolerance", INFINITY);
    assert_true(json_is_null(absent));
    assert_int_equal(other.count, 1);
    assert_non_null(strstr(other.first, "tolerance came out infinite"));
    json_decref(absent);
    text_free(&row);
}
