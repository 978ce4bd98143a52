/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The text of JSON, byte by byte what jansson makes of the same. */
#include "output/json_print.h"
#include "support.h"

#include <math.h>
#include <stdlib.h>

static void check(json_t *json)
{
    struct text text = {0};
    char *wanted = json_dumps(json, JSON_INDENT(1) | JSON_REAL_PRECISION(17) | JSON_ENCODE_ANY);
    json_print(&text, json);
    assert_false(text.failed);
    assert_string_equal(text_string(&text), wanted);
    text_free(&text);
    free(wanted);
    json_decref(json);
}

static void test_values(void **state)
{
    (void)state;
    check(json_null());
    check(json_true());
    check(json_false());
    check(json_integer(-12));
    check(json_real(0.1));
    check(json_real(3));
    check(json_real(-1e-300));
    check(json_object());
    check(json_array());
}

static void test_strings(void **state)
{
    (void)state;
    check(json_string("plain"));
    check(json_string(""));
    check(json_string("\"quoted\" and \\ and / and \x7f"));
    check(json_string("tab\t line\n return\r bell\a escape\x1b form\f back\b"));
    check(json_string("µ, 10⁻⁶, \u2028, 𝄞"));
    check(json_stringn("a\0b", 3));
}

/* Deeper than the spaces at hand, with every kind of value and hostile keys on the way. */
static void test_nesting(void **state)
{
    (void)state;
    json_t *inner = json_pack("{s:f, s:n, s:[i, f, s, b], s:{}, s:[]}", "x", 2.5e-9, "nothing", "list", 3, 1e22, "text",
                              1, "empty \"object\"", "line\nend");
    for (int depth = 0; depth < 40; depth++)
        inner = depth % 2 ? json_pack("{s:o, s:f}", "in", inner, "depth", depth / 7.0)
                          : json_pack("[f, o, s]", depth / 3.0, inner, "after");
    check(inner);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_values), cmocka_unit_test(test_strings),
                                       cmocka_unit_test(test_nesting)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
