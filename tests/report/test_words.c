#include "report/words.h"
#include "support.h"

static void assert_text(struct text *text, const char *expected)
{
    assert_string_equal(text_string(text), expected);
    text_free(text);
}

static void test_numbers_are_plain_where_that_reads_well(void **state)
{
    static const struct {
        double value;
        int digits;
        const char *expected;
    } cases[] = {
        {0.24, 3, "0.240"},
        {0.0012345, 3, "0.00123"},
        {12345, 3, "12345"},
        {-2.5, 2, "−2.5"},
        {9.996, 3, "10.0"},
        {0.000999, 3, "9.99·10⁻⁴"},
        {123456, 3, "1.23·10⁵"},
        {-1e-12, 2, "−1.0·10⁻¹²"},
        {0.0009999, 3, "0.00100"},
        {0, 3, "0"},
        {NAN, 3, "–"},
        {INFINITY, 3, "–"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct text text = {0};
        words_number(&text, cases[i].value, cases[i].digits);
        assert_text(&text, cases[i].expected);
    }
}

static void test_loads_are_powers_of_ten(void **state)
{
    (void)state;
    struct text text = {0};
    words_power(&text, 0.834, 3);
    words_add(&text, " ", 1, 1, " ");
    words_power(&text, 1e-6, 3);
    assert_text(&text, "8.34·10⁻¹ 1 1.00·10⁻⁶");
}

static void test_given_numbers_keep_no_zeros(void **state)
{
    (void)state;
    struct text text = {0};
    words_given(&text, 0.36);
    text_add(&text, " ");
    words_given(&text, 41.369e9);
    text_add(&text, " ");
    words_given(&text, 7310);
    text_add(&text, " ");
    words_given(&text, 1e-6);
    text_add(&text, " ");
    words_given(&text, NAN);
    assert_text(&text, "0.36 4.1369·10¹⁰ 7310 1·10⁻⁶ –");
}

static void test_value_and_error_have_the_same_decimals(void **state)
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
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct text text = {0};
        words_uncertain(&text, cases[i].value, cases[i].error);
        assert_text(&text, cases[i].expected);
    }
}

static void test_a_range_of_one_is_one_number(void **state)
{
    (void)state;
    struct text text = {0};
    words_range(&text, 1.2341, 1.2339, 3);
    text_add(&text, "; ");
    words_range(&text, 1, 2, 2);
    assert_text(&text, "1.23; 1.0 to 2.0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_numbers_are_plain_where_that_reads_well),
        cmocka_unit_test(test_loads_are_powers_of_ten),
        cmocka_unit_test(test_given_numbers_keep_no_zeros),
        cmocka_unit_test(test_value_and_error_have_the_same_decimals),
        cmocka_unit_test(test_a_range_of_one_is_one_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
