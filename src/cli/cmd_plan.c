#include "cli/command.h"
#include "cli/scene_options.h"
#include "contact/model.h"
#include "scene/plan.h"

#include <stdio.h>
#include <stdlib.h>

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

static void print_plan(const struct scene *scene, const struct plan *plan, size_t load_count)
{
    printf("%-16s %-8s %s\n", "effect", "", "why");
    for (int e = 0; e < EFFECT_COUNT; e++)
        printf("%-16s %-8s %s\n", effect_rows[e].name, plan->effects[e].runs ? "run" : "skipped",
               plan->effects[e].reason);
    printf("\n%-28s %-8s %s\n", "model", "", "valid");
    for (int m = 0; m < MODEL_COUNT; m++)
        printf("%-28s %-8s %s\n", model_rows[m].label,
               model_called_for((enum model_id)m, plan->families, plan->running) ? "run" : "skipped", model_rows[m].valid);
    printf("\n%zu surface%s, %zu loads, tolerance %g, closure %s\n", scene->surface_count,
           scene->surface_count == 1 ? "" : "s", load_count, scene->tolerance, scene_closure_names[scene->closure]);
}

int command_plan(int argc, char **argv)
{
    static const struct argp_child children[] = {{&scene_options_argp, 0, "What the scene says, overridden:", 1}, {0}};
    static const struct argp argp = {NULL, parse, "DIR", "Says what `report DIR` would simulate, and why. Runs nothing.",
                                     children, NULL, NULL};
    struct arguments arguments = {0};
    struct status status = {0};
    struct scene scene = {0};
    struct plan plan;
    double *loads = NULL;
    size_t load_count = 0;
    argp_parse(&argp, argc, argv, 0, NULL, &arguments);
    int exit_status = COMMAND_DONE;
    if (scene_read(&scene, arguments.directory, &arguments.overrides, &status) != STATUS_OK) {
        exit_status = command_fail(&status);
    } else {
        plan_make(&plan, &scene);
        if (scene_loads(&loads, &load_count, &scene, plan.pair.effective_modulus_Pa, &status) != STATUS_OK)
            exit_status = command_fail(&status);
        else
            print_plan(&scene, &plan, load_count);
    }
    free(loads);
    scene_free(&scene);
    return command_finish(exit_status);
}
