/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number_format.h"
#include "support.h"

#include <float.h>

/* Plain numbers; powers of ten; what rounds up to one is shown as that; signs and zero; what is no number. */
TEST_CASE(test_numbers)
{
    static const struct {
        double value;
        int digits;
        const char *expected;
    } cases[] = {
        {1, 3, "1.00"},
        {0.24, 2, "0.24"},
        {0.001, 1, "0.001"},
        {0.0012345, 3, "0.00123"},
        {12.345, 3, "12.3"},
        {1234.5, 5, "1234.5"},
        {1234.5, 3, "1234"}, /* digits before the point are never dropped */
        {1234.5, 2, "1200"}, /* but those that a wide interval has not, */
        {12345, 2, "12000"},
        {9999, 4, "9999"},
        {12345, 3, "1.23·10⁴"}, /* and in powers of ten */
        {12345, 5, "12345"},
        {1.2e-5, 2, "1.2·10⁻⁵"},
        {100000, 3, "1.00·10⁵"},
        {6.02214076e23, 4, "6.022·10²³"},
        {1e100, 1, "1·10¹⁰⁰"},
        {DBL_MAX, 3, "1.80·10³⁰⁸"},
        {DBL_TRUE_MIN, 2, "4.9·10⁻³²⁴"},
        {1234567890e60, 10, "1.234567890·10⁶⁹"},
        {0.00099999, 2, "0.0010"},
        {9999.9, 3, "1.00·10⁴"},
        {99999, 3, "1.00·10⁵"},
        {9.996, 3, "10.0"},
        {0.00099994, 4, "9.999·10⁻⁴"},
        {999.96, 4, "1000"},
        {0, 3, "0"},
        {-0.0, 3, "0"},
        {-2.5, 2, "−2.5"},
        {-1.5e-7, 2, "−1.5·10⁻⁷"},
        {-123456, 3, "−1.23·10⁵"},
        {NAN, 3, "–"},
        {INFINITY, 3, "–"},
        {-INFINITY, 3, "–"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct text *text = support_text();
        number_format(text, cases[i].value, cases[i].digits);
        assert_string_equal(text_string(text), cases[i].expected);
    }
}

TEST_CASE(test_ranges)
{
    static const struct {
        double least, most;
        int digits;
        const char *expected;
    } cases[] = {{1, 2, 2, "1.0 to 2.0"},      {1.001, 1.002, 2, "1.0"},    {1.001, 1.002, 4, "1.001 to 1.002"},
                 {1.5, NAN, 2, "≥\u00a01.5"},  {NAN, 1.5, 2, "≤\u00a01.5"}, {NAN, NAN, 2, "–"},
                 {-1e-6, 0, 1, "−1·10⁻⁶ to 0"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct text *text = support_text();
        number_format_range(text, cases[i].least, cases[i].most, cases[i].digits, " to ");
        assert_string_equal(text_string(text), cases[i].expected);
    }
}

TEST_CASE(test_value_and_error_have_the_same_decimals)
{
    static const struct {
        double value, error;
        const char *expected;
    } cases[] = {
        {0.006, 0.00094, "0.00600 ± 0.00094"},
        {0.13, 0.212, "0.13 ± 0.21"},
        {0.085, 0.171, "0.085 ± 0.171"},
        {1.8571, 0.0121, "1.857 ± 0.012"},
        {-1.5, 0.25, "−1.50 ± 0.25"},
        {3.5e11, 3.2e11, "(3.5 ± 3.2)·10¹¹"},
        {2e-5, 4e-7, "(2.000 ± 0.040)·10⁻⁵"},
        {120, 30, "120 ± 30"},
        {1.5, NAN, "1.50"},
        {1.5, 0, "1.50"},
        {NAN, 1, "–"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct text *text = support_text();
        number_format_uncertain(text, cases[i].value, cases[i].error);
        assert_string_equal(text_string(text), cases[i].expected);
    }
}

/* Every digit that printf() has: short numbers, powers of ten and two, halves, steps beside them, any exponent, and
 * what the fast way leaves to printf(). */
TEST_CASE(test_exact)
{
    enum { RANDOM = 200000 };
    static const double some[] = {0,    -0.0, 1,    -1,   0.1,      100,     1e16,    1e17,     123456789012345678.0,
                                  9.5,  1e-4, 1e-5, 0.5,  0.000125, DBL_MIN, DBL_MAX, 5e-324,   99999999999999999.0,
                                  1e22, 1e23, 2e-7, 1e-3, 1e300,    -1e-24,  9e-25,   INFINITY, 0.99999999999999989};
    uint64_t drawn = 1;
    size_t listed = sizeof some / sizeof *some;
    for (size_t k = 0; k < listed + RANDOM; k++) {
        char expected[64];
        struct text text = {0};
        double share = support_uniform(&drawn);
        double any = ldexp(1 + share, (int)(drawn % 140) - 90),
               rounded = (double)(drawn >> 50) * pow(10, (double)(k % 9) - 6);
        double value = k < listed ? some[k] : k % 3 ? any : rounded;
        static const int digits[] = {17, 9, 1, 3};
        for (int d = 0; d < 4; d++) {
            snprintf(expected, sizeof expected, "%.*g", digits[d], value);
            number_digits(&text, value, digits[d]);
            assert_string_equal(text_string(&text), expected);
            text_free(&text);
        }
    }
}
