#include "analysis/work.h"
#include "cli/command.h"
#include "cli/scene_options.h"
#include "contact/model.h"
#include "run/prepare.h"

#include <stdio.h>

struct arguments {
    const char *directory;
    struct scene_overrides overrides;
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &arguments->overrides;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->directory)
            argp_error(state, "one directory at a time: '%s' is too many", value);
        arguments->directory = value;
        return 0;
    case ARGP_KEY_END:
        if (!arguments->directory)
            argp_error(state, "which directory of scans?");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_plan(const struct scene *scene, const struct prepared *prepared)
{
    const struct plan *plan = &prepared->plan;
    struct text table = {0};
    prepare_table(&table, prepared, NULL);
    fputs(text_string(&table), stdout);
    text_free(&table);
    printf("\n%-28s %-8s %s\n", "model", "", "valid");
    for (size_t m = 0; m < model_count; m++)
        printf("%-28s %-8s %s\n", model_rows[m]->label, plan_runs_model(plan, m) ? "run" : "skipped",
               model_rows[m]->valid);
    printf("\n%zu surface%s, %zu loads, tolerance %g, closure %s\n", scene->surface_count,
           scene->surface_count == 1 ? "" : "s", prepared->results.load_count, scene->tolerance,
           sinusoid_fits[scene->closure].name);
}

int command_plan(int argc, char **argv)
{
    static const struct argp_child children[] = {{&scene_options_argp, 0, "What the scene says, overridden:", 1}, {0}};
    static const struct argp argp = {
        NULL,
        parse,
        "DIR",
        "Says what `report DIR` would simulate, why, and at which cost. Reads the scans and "
        "runs no model.",
        children,
        NULL,
        NULL};
    struct arguments arguments = {0};
    struct status status = {0};
    struct scene scene = {0};
    struct prepared prepared = {0};
    struct run_options options = {0};
    struct text messages = {0};
    argp_parse(&argp, argc, argv, 0, NULL, &arguments);
    int exit_status = COMMAND_DONE;
    enum status_code rc = scene_read(&scene, arguments.directory, &arguments.overrides, &status);
    if (rc == STATUS_OK)
        rc = prepare(&prepared, &scene, &options, NULL, &status);
    size_t refused = prepare_messages(&messages, &prepared.store);
    fputs(text_string(&messages), stderr);
    if (rc == STATUS_OK && refused == scene.surface_count)
        rc = status_fail(&status, STATUS_SCAN, "no readable scan in '%s'", scene.directory);
    if (rc != STATUS_OK)
        exit_status = command_fail(&status);
    else
        print_plan(&scene, &prepared);
    if (exit_status == COMMAND_DONE && refused > 0)
        exit_status = COMMAND_REFUSED;
    text_free(&messages);
    prepared_free(&prepared);
    scene_free(&scene);
    return command_finish(exit_status);
}
