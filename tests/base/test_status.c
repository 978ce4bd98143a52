/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support.h"

#include <stdio.h>

TEST_CASE(test_a_failure_stores_its_code_and_message)
{
    struct status status = {0};
    assert_int_equal(status_fail(&status, STATUS_SCAN, "line %d: no number in '%s'", 7, "x;y"), STATUS_SCAN);
    assert_int_equal(status.code, STATUS_SCAN);
    assert_string_equal(status.message, "line 7: no number in 'x;y'");
}

TEST_CASE(test_the_first_failure_stays)
{
    struct status status = {0};
    assert_int_equal(status_fail(&status, STATUS_IO, "disk full"), STATUS_IO);
    assert_int_equal(status_fail(&status, STATUS_SCENE, "something else"), STATUS_IO);
    assert_int_equal(status_memory(&status), STATUS_IO);
    assert_string_equal(status.message, "disk full");
    status = (struct status){0};
    assert_int_equal(status_memory(&status), STATUS_MEMORY);
    assert_string_equal(status.message, "out of memory");
}

TEST_CASE(test_prefixes_stack_and_keep_the_code)
{
    struct status status = {0};
    assert_int_equal(status_fail(&status, STATUS_SCAN, "flat"), STATUS_SCAN);
    assert_int_equal(status_prefix(&status, "%s:%d", "a.csv", 3), STATUS_SCAN);
    assert_int_equal(status_prefix(&status, "surface '%s'", "50 %s"), STATUS_SCAN);
    assert_string_equal(status.message, "surface '50 %s': a.csv:3: flat");
}

/* Whatever the lengths of prefix and message, the result is a string that fits, cut at its end. */
TEST_CASE(test_long_messages_are_cut_not_overrun)
{
    enum { SIZE = sizeof((struct status *)NULL)->message };
    char longest[2 * SIZE];
    memset(longest, 'm', sizeof longest - 1);
    longest[sizeof longest - 1] = '\0';
    for (int length = SIZE - 6; length <= SIZE + 6; length++)
        for (int prefix = SIZE - 6; prefix <= SIZE + 6; prefix++) {
            struct status status = {0};
            assert_int_equal(status_fail(&status, STATUS_IO, "%.*s", length, longest), STATUS_IO);
            assert_int_equal(strlen(status.message), length < SIZE ? length : SIZE - 1);
            assert_int_equal(status_prefix(&status, "%.*s", prefix, longest), STATUS_IO);
            assert_int_equal(strlen(status.message), SIZE - 1);
        }
    struct status status = {0};
    assert_int_equal(status_fail(&status, STATUS_IO, "%.*s", 100, longest), STATUS_IO);
    assert_int_equal(status_prefix(&status, "%.*s", SIZE - 12, longest), STATUS_IO);
    assert_int_equal(strlen(status.message), SIZE - 1);
    assert_string_equal(status.message + SIZE - 12, ": mmmmmmmmm");
}
