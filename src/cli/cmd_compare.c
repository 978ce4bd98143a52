/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `compare`: finished reports side by side. */
#include "cli/command.h"
#include "report/report.h"

#include <stdio.h>

struct arguments {
    char **outs;
    size_t count;
    int format; /* one of these keys; 0: text */
};
enum { JSON = 0x100, MARKDOWN, HTML };

static const struct argp_option options[] = {
    {"json", JSON, 0, 0, "print one object, for scripts (default: tables)", 0},
    {"markdown", MARKDOWN, 0, 0, "print Markdown (default: text of 80 columns)", 0},
    {"html", HTML, 0, 0, "print a page (default: text of 80 columns)", 0},
    {0}};

static error_t parse(int key, __attribute__((unused)) char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    if (key == JSON || key == MARKDOWN || key == HTML)
        arguments->format = key;
    else if (key == ARGP_KEY_ARGS) {
        arguments->outs = state->argv + state->next;
        arguments->count = (size_t)(state->argc - state->next);
    } else if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    else if (arguments->count < 2)
        argp_error(state, "give the OUT of two reports or more");
    return 0;
}

const struct argp command_compare_argp = {
    .options = options,
    .parser = parse,
    .args_doc = "OUT OUT...",
    .doc = "Ranks the surfaces of finished reports at the first one's operating load, by its leading model (with or "
           "without hardness, as each has it), with 95 % intervals and a test whether more scans would show the order "
           "again; and prints up to 20 reports side by "
           "side, with what went in that differs."};

int command_compare(int argc, char **argv)
{
    struct arguments arguments = {0};
    struct status status = {0};
    OWNED(text_free) struct text words = {0}, page = {0};
    const char *templates = "";
    json_auto_t *view = NULL;
    command_parse(&command_compare_argp, argc, argv, &arguments);
    enum status_code rc = report_compare(&view, arguments.outs, arguments.count, &status);
    if (rc == STATUS_OK && arguments.format != JSON && (rc = command_templates(&templates, &status)) == STATUS_OK)
        rc = report_terminal(&words, "compare", view, templates, arguments.format >= MARKDOWN, &status);
    if (rc == STATUS_OK && arguments.format == HTML)
        rc = html_render(&page, text_string(&words), "Reports compared", ".", templates, &status);
    if (rc != STATUS_OK)
        json_object_set_new(view, "error", json_shown(status.message));
    if (arguments.format == JSON)
        command_json_print(json_incref(view));
    fputs(text_string(page.length > 0 ? &page : &words), stdout);
    return command_finish(rc == STATUS_OK ? COMMAND_DONE : command_fail(&status), NULL);
}
