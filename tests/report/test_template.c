#include "report/template.h"
#include "support.h"

/* Fields: "name" and "mark<up>" have a text, "empty" has none, everything else does not exist. */
static bool field(struct text *out, const char *name, void *context)
{
    ++*(int *)context;
    if (strcmp(name, "name") == 0)
        text_add(out, "Tin {{empty}} & co");
    else if (strcmp(name, "figure 6-05") == 0)
        text_add(out, "![](6-05.svg)");
    else if (strcmp(name, "empty") != 0)
        return false;
    return true;
}

static enum status_code render(struct text *out, const char *source, struct status *status)
{
    int asked = 0;
    const struct template_source fields = {field, &asked};
    return template_render(out, source, "report.md", &fields, status);
}

static void assert_renders(const char *source, const char *expected)
{
    struct text out = {0};
    struct status status = {0};
    if (render(&out, source, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    assert_string_equal(text_string(&out), expected);
    text_free(&out);
}

static void assert_fails(const char *source, const char *message)
{
    struct text out = {0};
    struct status status = {0};
    assert_int_equal(render(&out, source, &status), STATUS_IO);
    assert_string_equal(status.message, message);
    text_free(&out);
}

static void test_fields(void **state)
{
    (void)state;
    assert_renders("", "");
    assert_renders("no tag, one { and two } }", "no tag, one { and two } }");
    assert_renders("a {{name}} b {{empty}}c", "a Tin {{empty}} & co b c"); /* what a field gives is not read again */
    assert_renders("{{figure 6-05}}\n", "![](6-05.svg)\n");
    assert_renders("{{name}}{{name}}", "Tin {{empty}} & coTin {{empty}} & co");
}

static void test_sections(void **state)
{
    (void)state;
    assert_renders("a{{#name}}b{{/name}}c", "abc");
    assert_renders("a{{#empty}}b{{/empty}}c", "ac");
    assert_renders("a{{^name}}b{{/name}}c", "ac");
    assert_renders("a{{^empty}}b{{/empty}}c", "abc");
    assert_renders("one\n{{#name}}\ntwo\n{{/name}}\nthree\n",
                   "one\ntwo\nthree\n"); /* no empty lines where tags stood */
    assert_renders("one\n{{#empty}}\ntwo\n{{/empty}}\nthree\n", "one\nthree\n");
}

static void test_nested_sections(void **state)
{
    (void)state;
    assert_renders("{{#name}}1{{#empty}}2{{/empty}}3{{^empty}}4{{/empty}}5{{/name}}6", "13456");
    assert_renders("{{#empty}}1{{#name}}2{{/name}}3{{^name}}4{{/name}}5{{name}}{{/empty}}6", "6");
    assert_renders("{{#name}}{{#name}}a{{/name}}b{{/name}}", "ab");
    assert_renders("{{^name}}{{#name}}a{{/name}}b{{/name}}{{#name}}c{{/name}}", "c");
    assert_renders("{{#empty}}{{#empty}}a{{/empty}}b{{/empty}}c", "c");
}

/* A hidden field is not computed. */
static void test_hidden_fields_are_not_asked_for(void **state)
{
    (void)state;
    int asked = 0;
    const struct template_source fields = {field, &asked};
    struct text out = {0};
    struct status status = {0};
    assert_int_equal(template_render(&out, "{{#empty}}{{name}}{{name}}{{/empty}}", "t", &fields, &status), STATUS_OK);
    assert_int_equal(asked, 1);
    text_free(&out);
}

static void test_errors_name_file_and_line(void **state)
{
    (void)state;
    assert_fails("one\ntwo {{name}} {{nme}}\n", "report.md:2: no field 'nme'");
    assert_fails("{{#nme}}\n{{/nme}}", "report.md:1: no field 'nme'");
    assert_fails("{{#empty}}\na\n{{/empty}}\n{{nme}}\n", "report.md:4: no field 'nme'"); /* swallowed lines count */
    assert_fails("\n\n{{/name}}", "report.md:3: section closed but not open: 'name'");
    assert_fails("{{#name}}{{#empty}}\n{{/name}}{{/empty}}", "report.md:2: section closed but not open: 'name'");
    assert_fails("a\n{{#name}}\nb\n", "report.md:4: section not closed: 'name'");
    assert_fails("{{#empty}}\nb\n", "report.md:3: section not closed: 'empty'");
    assert_fails("a\n{{name", "report.md:2: tag not closed at '{{'");
}

static void test_absurd_templates_are_refused(void **state)
{
    (void)state;
    struct text source = {0}, out = {0};
    struct status status = {0};
    for (int depth = 0; depth < 100; depth++)
        text_add(&source, "{{#name}}");
    assert_int_equal(render(&out, text_string(&source), &status), STATUS_IO);
    assert_string_equal(status.message, "report.md:1: too many sections inside each other at 'name'");
    text_free(&source);
    text_free(&out);
    text_add(&source, "{{");
    for (int i = 0; i < 1000; i++)
        text_add(&source, "x");
    text_add(&source, "}}");
    status = (struct status){0};
    assert_int_equal(render(&out, text_string(&source), &status), STATUS_IO);
    text_free(&source);
    text_free(&out);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fields),
        cmocka_unit_test(test_sections),
        cmocka_unit_test(test_nested_sections),
        cmocka_unit_test(test_hidden_fields_are_not_asked_for),
        cmocka_unit_test(test_errors_name_file_and_line),
        cmocka_unit_test(test_absurd_templates_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
