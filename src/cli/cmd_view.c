/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `view`: the tree of worded values that the report's templates are filled from. */
#include "base/temporary.h"
#include "cli/command.h"

#include <stdio.h>
#include <sys/stat.h>

enum { KEY_JSON = 0x100 };

static const struct argp_option options[] = {
    {"json", KEY_JSON, 0, 0, "as JSON, which is all there is (default: so)", 0}, {0}};

static error_t parse(int key, char *value, struct argp_state *state)
{
    return key == KEY_JSON ? 0 : command_directory(key, value, state);
}

const struct argp command_view_argp = {
    .options = options,
    .parser = parse,
    .args_doc = "DIR|OUT",
    .doc = "Prints the tree of worded values that templates/report.md is filled from (docs/templates.md): of the "
           "report in OUT, or of the one that `report DIR --no-cost` would write."};

/** Prints OUT/view.json. */
static enum status_code print_view(const char *path, struct status *status)
{
    struct text tree = {0};
    enum status_code rc = text_read_file(&tree, path, status);
    if (rc == STATUS_OK)
        fputs(text_string(&tree), stdout);
    text_free(&tree);
    return rc;
}

/** Runs the report into a directory that goes again. */
static enum status_code run_view(const char *directory, struct status *status)
{
    struct temporary temporary;
    struct scene scene = {0};
    struct run_outcome outcome = {0};
    struct text templates = {0}, out = {0};
    const struct scene_overrides none = {0};
    enum status_code rc = scene_read(&scene, directory, &none, status);
    if (rc == STATUS_OK)
        rc = command_share(&templates, "templates", status);
    if (rc == STATUS_OK && (rc = temporary_make(&temporary, NULL, NULL, status)) == STATUS_OK) {
        text_add(&out, "%s/out", temporary.path);
        const struct run_options how = {
            .output = text_string(&out), .templates = text_string(&templates), .no_cost = true};
        rc = run_report(&outcome, &scene, &how, status);
        fputs(text_string(&outcome.messages), stderr);
        run_outcome_free(&outcome);
        text_add(&out, "/view.json");
        if (rc == STATUS_OK)
            rc = out.failed ? status_memory(status) : print_view(text_string(&out), status);
        temporary_remove(&temporary);
    }
    scene_free(&scene);
    text_free(&templates);
    text_free(&out);
    return rc;
}

int command_view(int argc, char **argv)
{
    const char *directory = NULL;
    struct status status = {0};
    struct stat found;
    char path[4096];
    command_parse(&command_view_argp, argc, argv, &directory);
    snprintf(path, sizeof path, "%s/view.json", directory);
    bool made = stat(path, &found) == 0;
    enum status_code rc = made ? print_view(path, &status) : run_view(directory, &status);
    return command_finish(rc == STATUS_OK ? COMMAND_DONE : command_fail(&status), NULL);
}
