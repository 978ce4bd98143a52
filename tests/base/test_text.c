#include "base/text.h"
#include "support.h"

/* What begins a list, a link or emphasis is escaped; what only reads worse for it is left alone. */
static void test_markdown_is_escaped_where_it_means_something(void **state)
{
    static const struct {
        const char *string, *expected;
    } cases[] = {
        {"surface-1.csv", "surface-1.csv"},
        {"fit_band_m (0.5 um)", "fit_band_m (0.5 um)"},
        {"- item", "\\- item"},
        {"12. item", "12\\. item"},
        {"3) item", "3\\) item"},
        {"# title", "\\# title"},
        {"_a_ __b__", "\\_a\\_ \\_\\_b\\_\\_"},
        {"*a* `b` ~c~", "\\*a\\* \\`b\\` \\~c\\~"},
        {"[x](y)", "\\[x\\](y)"},
        {"![x](y)", "!\\[x\\](y)"},
        {"a|b", "a\\|b"},
        {"a\\b", "a\\\\b"},
        {"http://x", "http\\://x"},
        {"<b>&\"", "&#60;b&#62;&#38;&#34;"},
        {"a\nb\033", "a?b?"},
        {"---", "\\-\\-\\-"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct text text = {0};
        text_add_markdown(&text, cases[i].string);
        assert_string_equal(text_string(&text), cases[i].expected);
        text_free(&text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_markdown_is_escaped_where_it_means_something)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
