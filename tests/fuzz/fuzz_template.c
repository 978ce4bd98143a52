/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "base/mustache.h"

static json_t *view;

static void free_view(void)
{
    json_decref(view);
}

/* Every partial has sections and sets delimiters, and names no other partial. */
static const char *some_partial(void *context, const char *name)
{
    (void)context;
    return *name == 'x' ? NULL : "{{#list}}{{name}}{{^last}}, {{/last}}{{/list}}\n{{=[ &]=}}[number&]\n";
}

/* Items of a list hide the list, so that the output cannot grow without limit, which is tested elsewhere. */
void fuzz_template(const uint8_t *bytes, size_t length)
{
    if (!view) {
        view = json_pack("{s:s, s:f, s:b, s:n, s:{s:s, s:{s:[]}}, s:[{s:s, s:n}, {s:s, s:b, s:b}], s:[{s:b, s:s}, "
                         "{s:{s:i}, s:b}]}",
                         "name", "<a&b>|*\x1b", "number", 1e-300, "flag", 1, "none", "part", "name", "", "part", "list",
                         "list", "name", "one", "list", "name", "two", "last", 1, "list", 1, "rows", "rows", 1, "name",
                         "row", "part", "number", 7, "rows", 0);
        FUZZ_REQUIRE(view);
        atexit(free_view);
    }
    const struct mustache how = {view, text_add_markdown_shown, some_partial, NULL};
    OWNED(text_free) struct text source = {0}, out = {0};
    struct status status = {0};
    text_add_bytes(&source, (const char *)bytes, length);
    OWNED(memory_free) char *exact = strdup(text_string(&source)); /* its end where AddressSanitizer sees it passed */
    FUZZ_REQUIRE(exact);
    enum status_code code = mustache_render(&out, exact, "template", &how, &status);
    FUZZ_REQUIRE(code == STATUS_OK || code == STATUS_USAGE);
    FUZZ_REQUIRE(code == STATUS_OK || (*status.message && !strchr(status.message, '\n')));
    fuzz_count("template", code == STATUS_OK);
}
