/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands on a scene, `report` and `plan`. */
#include "base/clock.h"
#include "base/threads.h"
#include "base/version.h"
#include "cli/command.h"
#include "report/report.h"
#include "run/messages.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

struct arguments {
    const char *directory; /* first, for command_directory() */
    struct scene_overrides overrides;
    struct run_options run;
    bool show, verbose, check, json;
};

enum {
    KEY_X_UNIT = 0x100,
    KEY_Z_UNIT,
    KEY_NO_COST,
    KEY_CHECK,
    KEY_BRIEF,
    KEY_JSON,
    KEY_TEMPLATE,
    KEY_EXPORT,
    KEY_BUDGET,
    KEY_ACCURACY
};

/* Options of both, which override the scene. */
static const struct argp_option scene_options[] = {
    {"material", 'm', "MATERIAL", 0, "a built-in material (default: the scene's, else none)", 1},
    {"effects", 'e', "EFFECTS", 0,
     "auto, some of plasticity, separation, electrical, thermal, scale-dependent, stiffness, last-scale, "
     "convergence, uncertainty, direct, gap, film, plating, heating, shape, or both, with commas (default: "
     "the scene's, else auto)",
     1},
    {"tolerance", 't', "REL", 0, "relative tolerance of closed forms, 1e-14 to 0.1 (default: the scene's, else 1e-6)",
     1},
    {"accuracy", KEY_ACCURACY, "SHARE", 0,
     "run the cheapest model whose 95 % error is at most that, as 200% (default: the scene's, else all run)", 1},
    {"budget", KEY_BUDGET, "TIME", 0,
     "solve directly too, on the grid and as many surfaces as take so long on one core, by count, not by the clock "
     "(default: the scene's)",
     1},
    {"x-unit", KEY_X_UNIT, "UNIT", 0, "unit of x where a file names none (default: the scene's)", 1},
    {"z-unit", KEY_Z_UNIT, "UNIT", 0, "unit of z where a file names none (default: the scene's)", 1},
    {0},
};

static const char *unit(const char *value, const char *name, struct argp_state *state)
{
    if (scan_unit_m(value) == 0)
        argp_error(state, "--%s must be a unit of length such as m, mm, um, nm or in, not '%s'", name, value);
    return value;
}

static error_t parse_scene(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    struct scene_overrides *overrides = &arguments->overrides;
    if (key == 'm')
        overrides->material = value;
    else if (key == 'e')
        overrides->effects = value;
    else if (key == 't')
        overrides->tolerance = value;
    else if (key == KEY_ACCURACY)
        overrides->accuracy = value;
    else if (key == KEY_BUDGET)
        overrides->budget = value;
    else if (key == KEY_X_UNIT)
        overrides->x_unit = unit(value, "x-unit", state);
    else if (key == KEY_Z_UNIT)
        overrides->z_unit = unit(value, "z-unit", state);
    else
        return command_directory(key, value, state);
    return 0;
}

static const struct argp scene_argp = {.options = scene_options, .parser = parse_scene};
static const struct argp_child scene_child[] = {{&scene_argp, 0, "What the scene says, overridden:", 1}, {0}};

static const struct argp_option report_options[] = {
    {"output", 'o', "OUT", 0, "where the report goes (default: out/<name of DIR>)", 0},
    {"jobs", 'j', "N", 0, "threads, 1 to 64 (default: one a processor)", 0},
    {"show", 's', 0, 0, "also draw the main charts as text (default: not)", 0},
    {"no-cost", KEY_NO_COST, 0, 0, "leave out what accuracy costs in time (default: not)", 0},
    {"check", KEY_CHECK, 0, 0,
     "end with exit status 5 where a surface misses one of the scene's limits, 6 where none does and one is undecided "
     "(default: not)",
     0},
    {"brief", KEY_BRIEF, 0, 0, "write the report's first page alone; data and results.json as ever (default: not)", 0},
    {"template", KEY_TEMPLATE, "FILE", 0, "fill FILE in place of the program's report.md (docs/templates.md)", 0},
    {"export", KEY_EXPORT, "PROGRAMS", 0,
     "also write tables of conductance over pressure for abaqus, ansys, calculix, comsol, elmer, moose, with commas; "
     "calculix:mm in N, mm, s (default: the scene's, else none)",
     0},
    {"json", KEY_JSON, 0, 0, "print what came out as one object, for scripts (default: a table)", 0},
    {"verbose", 'v', 0, 0, "end with where the time went (default: not)", 0},
    {0},
};

static const struct argp_option plan_options[] = {
    {"json", KEY_JSON, 0, 0, "print the plan as one object (default: tables)", 0},
    {0},
};

/** Of both: `plan` has some of the options of `report`. */
static error_t parse_report(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    char *end;
    if (key == ARGP_KEY_INIT)
        state->child_inputs[0] = arguments;
    else if (key == 'o' && strcmp(value, "-") == 0)
        argp_error(state, "-o takes the folder of the report, not '-': --json prints its numbers to standard output");
    else if (key == 'o')
        arguments->run.output = value;
    else if (key == 'j') {
        arguments->run.jobs = (unsigned)strtoul(value, &end, 10);
        if (*end != '\0' || arguments->run.jobs < 1 || arguments->run.jobs > 64)
            argp_error(state, "--jobs must be 1 to 64, not '%s'", value);
    } else if (key == 's')
        arguments->show = true;
    else if (key == KEY_NO_COST)
        arguments->run.no_cost = true;
    else if (key == KEY_CHECK)
        arguments->check = true;
    else if (key == KEY_BRIEF)
        arguments->run.brief = true;
    else if (key == KEY_TEMPLATE)
        arguments->run.template = value;
    else if (key == KEY_EXPORT)
        arguments->overrides.exports = value;
    else if (key == KEY_JSON)
        arguments->json = true;
    else if (key == 'v')
        arguments->verbose = true;
    else if (key != ARGP_KEY_END)
        return ARGP_ERR_UNKNOWN;
    else if (arguments->json && arguments->show)
        argp_error(state, "--show draws where --json prints; give one of them");
    return 0;
}

/* ---- With --json (docs/commands.md) */

/** The members that every object begins with. */
static json_t *begin_json(const char *directory, const char *messages, int exit_status, const char *error)
{
    return json_pack("{s:s, s:s, s:o, s:i, s:s, s:o, s:o}", "program", "roughcontact", "version", version_string(),
                     "directory", json_shown(directory), "exit_status", exit_status, "exit_reason",
                     command_statuses[exit_status], "error", json_shown(error), "messages", json_lines(messages));
}

/** The path of results.json, beside the page. */
static json_t *results_json(const char *page)
{
    OWNED(text_free) struct text path = {0};
    text_add(&path, "%.*s/results.json", (int)(strrchr(page, '/') - page), page);
    return json_shown(text_string(&path));
}

/** The outcome of a report on `directory`: `outcome` NULL where it did not begin, `error` NULL where it was written. */
static void print_report(const struct run_outcome *outcome, const char *directory, int exit_status, const char *error)
{
    json_t *json = begin_json(directory, outcome ? text_string(&outcome->messages) : "", exit_status, error);
    const char *path = outcome && !error ? outcome->path : NULL;
    json_object_set_new(json, "report", json_shown(path));
    json_object_set_new(json, "results", path ? results_json(path) : json_null());
    if (outcome && outcome->outline)
        json_object_update(json, outcome->outline);
    if (outcome && !error)
        json_object_set_new(json, "work", json_pack("{s:I}", "evaluations", (json_int_t)outcome->evaluations));
    command_json_print(json);
}

static json_t *surfaces_json(const struct results *results)
{
    json_t *surfaces = json_array();
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = &results->surfaces[i].summary;
        json_array_append_new(surfaces, json_pack("{s:o, s:b, s:o}", "surface", json_shown(s->scene->name), "usable",
                                                  s->usable, "refused", json_shown(s->refusal)));
    }
    return surfaces;
}

static json_t *effects_json(const struct results *results)
{
    struct work_row rows[WORK_ROWS];
    json_t *effects = json_array();
    work_account(rows, results);
    for (int r = 0; r < WORK_ROWS; r++)
        json_array_append_new(effects, json_pack("{s:s, s:b, s:o, s:s}", "effect", rows[r].name, "runs", rows[r].runs,
                                                 "reason", json_shown(rows[r].reason), "changes", rows[r].changes));
    return effects;
}

static json_t *models_json(const struct plan *plan)
{
    json_t *models = json_array();
    for (size_t m = 0; m < model_count; m++)
        json_array_append_new(models, json_pack("{s:s, s:s, s:b, s:s}", "model", model_rows[m]->name, "label",
                                                model_rows[m]->label, "runs", plan_runs_model(plan, m), "valid",
                                                model_rows[m]->valid));
    return models;
}

/** The plan of a report, and roughly how long it takes: `results` NULL where there is none, and `error` says why. */
static void print_plan(const struct results *results, double rough_seconds, const char *directory, const char *messages,
                       int exit_status, const char *error)
{
    json_t *json = begin_json(directory, messages, exit_status, results ? NULL : error);
    if (results) {
        const struct scene *scene = results->scene;
        json_object_update_new(
            json, json_pack("{s:o, s:f, s:o, s:o, s:b, s:I, s:I, s:f, s:s}", "effects", effects_json(results),
                            "seconds", rough_seconds, "models", models_json(results->plan), "surfaces",
                            surfaces_json(results), "material_known", results_has_material(results), "loads",
                            (json_int_t)results->load_count, "targets", (json_int_t)scene->target_count, "tolerance",
                            scene->tolerance, "closure", sinusoid_fits[scene->closure].name));
    }
    command_json_print(json);
}

/* ---- On a terminal */

/** A line that is overwritten: the stage and, from its first step on, the time left. */
static void progress(const char *stage, const char *name, double done, double all)
{
    static double started;
    OWNED(text_free) struct text shown = {0};
    if (done <= 0)
        started = clock_seconds();
    double left = (clock_seconds() - started) * (all - done) / done;
    text_add_shown(&shown, name);
    fprintf(stderr, "\r\033[K");
    if (done < all)
        fprintf(stderr, "%s %.*s: %.0f %%", stage, (int)text_fit(text_string(&shown), 40), text_string(&shown),
                100 * done / all);
    if (done < all && done > 0)
        fprintf(stderr, left < 100 ? ", %.0f s left" : ", %.0f min left", left < 100 ? left : left / 60);
    fflush(stderr);
}

static void print_time(const char *stage, double seconds)
{
    fprintf(stderr, "%-30s %10.4f\n", stage, seconds);
}

static void print_times(const struct run_times *times)
{
    struct rusage usage;
    fprintf(stderr, "\n%-30s %10s\n", "stage", "seconds");
    print_time("read scans", times->read);
    print_time("level", times->prepare);
    print_time("spectra", times->spectrum);
    print_time("strips", times->strips);
    print_time("direct of maps", times->tiles);
    for (size_t m = 0; m < model_count; m++)
        print_time(model_rows[m]->label, times->models[m]);
    print_time("convergence", times->convergence);
    print_time("uncertainty", times->uncertainty);
    print_time("direct solution", times->direct);
    print_time("what accuracy costs", times->cost);
    print_time("tables and json", times->tables);
    print_time("chart data", times->figures);
    print_time("gnuplot", times->gnuplot);
    print_time("report", times->report);
    print_time("total", times->total);
    print_time("total without gnuplot", times->total - times->gnuplot);
    if (getrusage(RUSAGE_SELF, &usage) == 0)
        fprintf(stderr, "%-30s %7.1f MB\n", "largest memory", (double)usage.ru_maxrss / 1024);
}

enum { STOP_MS = 300 }; /* time for a run to end in order after a signal */

/** Prints the message, also as JSON where that is asked for, and returns the exit status. */
static int fail(const struct arguments *arguments, const struct run_outcome *outcome, const struct status *status)
{
    int exit_status = command_fail(status);
    if (arguments->json)
        print_report(outcome, arguments->directory, exit_status, status->message);
    return exit_status;
}

static int report(struct run_outcome *outcome, struct arguments *arguments, const struct scene *scene,
                  struct status *status)
{
    char size[32];
    int columns, rows, exit_status = COMMAND_DONE;
    command_terminal_size(&columns, &rows);
    snprintf(size, sizeof size, "%d,%d", columns, rows > 34 ? 34 : rows - 1);
    arguments->run.terminal_size = arguments->show ? size : NULL;
    arguments->run.outline = arguments->json;
    arguments->run.stop = signals_stop(STOP_MS);
    arguments->run.progress = isatty(STDERR_FILENO) ? progress : NULL;
    signal(SIGPIPE,
           SIG_IGN); /* without a reader of the output the report is still made, and command_finish() says so */
    enum status_code rc = run_report(outcome, scene, &arguments->run, status);
    if (rc != STATUS_INTERRUPTED)
        fputs(text_string(&outcome->messages), stderr);
    if (rc != STATUS_OK) {
        exit_status = fail(arguments, outcome, status);
    } else {
        fputs(text_string(&outcome->charts), stdout);
        if (!arguments->json)
            printf("%s\n%s\n", text_string(&outcome->table), outcome->path);
        if (outcome->refused + outcome->left_out > 0)
            exit_status = COMMAND_REFUSED;
        if (arguments->check && outcome->missed + outcome->undecided > 0) {
            fputs(text_string(&outcome->limits), stderr);
            /* refused scans are named too, but the check is what was asked for */
            exit_status = outcome->missed > 0 ? COMMAND_MISSED : COMMAND_UNDECIDED;
        }
        if (arguments->verbose) {
            fprintf(stderr, "\n%s", text_string(&outcome->work));
            print_times(&outcome->times);
        }
        if (arguments->json)
            print_report(outcome, arguments->directory, exit_status, NULL);
    }
    return exit_status;
}

static int run(int argc, char **argv, const struct argp *argp, bool direct)
{
    struct arguments arguments = {.overrides.direct = direct};
    struct status status = {0};
    OWNED(scene_free) struct scene scene = {0};
    OWNED(run_outcome_free) struct run_outcome outcome = {0};
    command_parse(argp, argc, argv, &arguments);
    enum status_code rc = scene_read(&scene, arguments.directory, &arguments.overrides, &status);
    if (rc == STATUS_OK && arguments.check && scene.limit_count == 0) /* a check of nothing must not pass */
        rc = status_fail(&status, STATUS_USAGE,
                         "--check: the scene has no 'limits' to check; add them, or leave --check out");
    if (rc == STATUS_OK)
        rc = command_templates(&arguments.run.templates, &status);
    int exit_status = rc == STATUS_OK ? report(&outcome, &arguments, &scene, &status) : fail(&arguments, NULL, &status);
    exit_status = command_finish(exit_status, outcome.path);
    return exit_status;
}

const struct argp command_direct_argp = {
    .options = report_options,
    .parser = parse_report,
    .args_doc = "DIR",
    .doc = "Writes the report, with a direct numerical solution of the contact beside the models (the scene's "
           "`direct:` says how; `plan` says what it costs).",
    .children = scene_child};

int command_direct(int argc, char **argv)
{
    return run(argc, argv, &command_direct_argp, true);
}

const struct argp command_report_argp = {
    .options = report_options,
    .parser = parse_report,
    .args_doc = "DIR",
    .doc = "Reads the scans in DIR (with DIR/scene.yaml, if there is one), runs the contact models and writes "
           "report.md, report.html, figures, data and results.json.",
    .children = scene_child};

int command_report(int argc, char **argv)
{
    return run(argc, argv, &command_report_argp, false);
}

enum { WIDTH = 80 };

static void add_plan(struct text *table, const struct results *results, double rough_seconds)
{
    const struct plan *plan = results->plan;
    const struct scene *scene = results->scene;
    work_table(table, results, false);
    text_add(table, "\n%s\n", words_say(plan->words, "plan.models"));
    for (size_t m = 0; m < model_count; m++) {
        text_add(table, "%-31s %-8s ", model_rows[m]->label,
                 words_say(plan->words, plan_runs_model(plan, m) ? "plan.run" : "plan.skipped"));
        text_add_wrapped(table, model_rows[m]->valid, WIDTH, 41);
        text_add(table, "\n");
    }
    text_add(table, "\n");
    if (!results_has_material(results)) {
        text_add_wrapped(table, words_say(plan->words, "effect.without_material"), WIDTH, 0);
        text_add(table, "\n\n");
    }
    text_add(table, "%s\n",
             words_say(plan->words, "plan.end\nsurfaces %zu\nloads %zu\ntolerance %g\nclosure %s\ntime %.2g",
                       results->usable_count, results->load_count, scene->tolerance, sinusoid_fits[scene->closure].name,
                       rough_seconds));
}

const struct argp command_plan_argp = {
    .options = plan_options,
    .parser = parse_report,
    .args_doc = "DIR",
    .doc = "Says what `report DIR` would simulate, why, and roughly how long. Reads the scans and runs no model.",
    .children = scene_child};

int command_plan(int argc, char **argv)
{
    struct arguments arguments = {0};
    struct status status = {0};
    OWNED(scene_free) struct scene scene = {0};
    OWNED(all_surfaces_free) struct all_surfaces prepared = {0};
    OWNED(text_free) struct text messages = {0}, table = {0};
    command_parse(&command_plan_argp, argc, argv, &arguments);
    enum status_code rc = scene_read(&scene, arguments.directory, &arguments.overrides, &status);
    if (rc == STATUS_OK && (rc = command_templates(&arguments.run.templates, &status)) == STATUS_OK)
        rc = export_check(&scene, arguments.run.templates, &status);
    if (rc == STATUS_OK)
        rc = all_surfaces_run(&prepared, &scene, &arguments.run, true, NULL, &status);
    const struct results *results = &prepared.results;
    size_t left_out, refused = messages_add(&messages, &left_out, results, false);
    fputs(text_string(&messages), stderr);
    const struct threads threads = {.jobs = arguments.run.jobs};
    double seconds = rc == STATUS_OK ? work_seconds(results, threads_number(&threads, SIZE_MAX)) : 0;
    if (rc == STATUS_OK && !arguments.json)
        add_plan(&table, results, seconds);
    if ((rc = status.code) == STATUS_OK) /* words.txt may lack a line */
        fputs(text_string(&table), stdout);
    int exit_status = rc != STATUS_OK ? command_fail(&status) : refused + left_out > 0 ? COMMAND_REFUSED : COMMAND_DONE;
    if (arguments.json)
        print_plan(rc == STATUS_OK ? results : NULL, seconds, arguments.directory, text_string(&messages), exit_status,
                   status.message);
    return command_finish(exit_status, NULL);
}
