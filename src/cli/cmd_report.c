#include "cli/command.h"
#include "cli/scene_options.h"
#include "contact/model.h"
#include "run/run.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

struct arguments {
    const char *directory;
    struct scene_overrides overrides;
    struct run_options run;
    bool show, verbose;
};

enum { KEY_NO_COST = 0x200 };

static const struct argp_option options[] = {
    {"output", 'o', "OUT", 0, "where the report goes (default: out/<name of DIR>)", 0},
    {"jobs", 'j', "N", 0, "threads, 1 to 64 (default: one a processor)", 0},
    {"show", 's', 0, 0, "also draw the main charts as text (default: not)", 0},
    {"no-cost", KEY_NO_COST, 0, 0, "leave out the section on what accuracy costs in time (default: not)", 0},
    {"verbose", 'v', 0, 0, "end with where the time went (default: not)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    char *end;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &arguments->overrides;
        return 0;
    case 'o':
        arguments->run.output = value;
        return 0;
    case 'j':
        arguments->run.jobs = (unsigned)strtoul(value, &end, 10);
        if (*end != '\0' || arguments->run.jobs < 1 || arguments->run.jobs > 64)
            argp_error(state, "--jobs must be 1 to 64, not '%s'", value);
        return 0;
    case 's':
        arguments->show = true;
        return 0;
    case KEY_NO_COST:
        arguments->run.no_cost = true;
        return 0;
    case 'v':
        arguments->verbose = true;
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

static volatile sig_atomic_t stop; /* a signal handler can reach nothing but a global */

static void ask_to_stop(int signal_number)
{
    (void)signal_number;
    stop = 1;
}

static void progress(size_t done, size_t total, const char *name)
{
    struct text shown = {0};
    text_add_shown(&shown, name);
    fprintf(stderr, "\r\033[K%zu of %zu  %.40s%s", done, total, text_string(&shown), done == total ? "\r\033[K" : "");
    fflush(stderr);
    text_free(&shown);
}

static void print_times(const struct run_times *times)
{
    const struct {
        const char *stage;
        double seconds;
    } before[] = {{"read scans", times->read}, {"level", times->prepare}, {"spectra", times->spectrum}},
      after[] = {
          {"convergence", times->convergence},
          {"what accuracy costs", times->cost},
          {"tables and json", times->tables},
          {"chart data", times->figures},
          {"gnuplot", times->gnuplot},
          {"report", times->report},
          {"total", times->total},
          {"total without gnuplot", times->total - times->gnuplot},
      };
    struct rusage usage;
    fprintf(stderr, "\n%-28s %10s\n", "stage", "seconds");
    for (size_t i = 0; i < sizeof before / sizeof before[0]; i++)
        fprintf(stderr, "%-28s %10.4f\n", before[i].stage, before[i].seconds);
    for (size_t m = 0; m < model_count; m++)
        fprintf(stderr, "%-28s %10.4f\n", model_rows[m]->label, times->models[m]);
    for (size_t i = 0; i < sizeof after / sizeof after[0]; i++)
        fprintf(stderr, "%-28s %10.4f\n", after[i].stage, after[i].seconds);
    if (getrusage(RUSAGE_SELF, &usage) == 0)
        fprintf(stderr, "%-28s %7.1f MB\n", "largest memory", (double)usage.ru_maxrss / 1024);
}

static void catch_signals(void)
{
    struct sigaction action = {.sa_handler = ask_to_stop,
                               .sa_flags = (int)SA_RESETHAND}; /* a second one ends at once */
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (int i = 0; i < 3; i++)
        sigaction(signals[i], &action, NULL);
}

static int report(struct arguments *arguments, struct scene *scene, struct status *status)
{
    struct text templates = {0};
    struct run_outcome outcome = {0};
    char size[32];
    int columns, rows, exit_status = COMMAND_DONE;
    command_terminal_size(&columns, &rows);
    snprintf(size, sizeof size, "%d,%d", columns, rows > 34 ? 34 : rows - 1);
    if (command_templates(&templates, status) != STATUS_OK) {
        text_free(&templates);
        return command_fail(status);
    }
    arguments->run.templates = text_string(&templates);
    arguments->run.terminal_size = arguments->show ? size : NULL;
    arguments->run.stop = &stop;
    arguments->run.progress = isatty(STDERR_FILENO) ? progress : NULL;
    catch_signals();
    enum status_code rc = run_report(&outcome, scene, &arguments->run, status);
    if (rc != STATUS_INTERRUPTED)
        fputs(text_string(&outcome.messages), stderr);
    if (rc != STATUS_OK) {
        exit_status = command_fail(status);
    } else {
        fputs(text_string(&outcome.charts), stdout);
        printf("%s\n%s\n", text_string(&outcome.table), outcome.path);
        if (outcome.refused > 0)
            exit_status = COMMAND_REFUSED;
        const struct run_times *times = &outcome.times;
        double models = times->convergence;
        for (size_t m = 0; m < model_count; m++)
            models += times->models[m];
        fprintf(stderr, "models: %llu evaluations%s; %.3g s predicted, %.3g s taken\n",
                (unsigned long long)outcome.evaluations, outcome.work_agrees ? ", as predicted" : "",
                outcome.predicted_seconds, models);
        if (arguments->verbose)
            fprintf(stderr, "\n%s", text_string(&outcome.work));
        if (!outcome.work_agrees)
            fputs("roughcontact: the evaluations done are not those predicted; please report this\n", stderr);
        if (arguments->verbose)
            print_times(&outcome.times);
    }
    run_outcome_free(&outcome);
    text_free(&templates);
    return exit_status;
}

int command_report(int argc, char **argv)
{
    static const struct argp_child children[] = {{&scene_options_argp, 0, "What the scene says, overridden:", 1}, {0}};
    static const struct argp argp = {options,
                                     parse,
                                     "DIR",
                                     "Reads the scans in DIR (with DIR/scene.yaml, if there is one), runs the contact "
                                     "models and writes report.md, report.html, figures, data and results.json.",
                                     children,
                                     NULL,
                                     NULL};
    struct arguments arguments = {0};
    struct status status = {0};
    struct scene scene = {0};
    argp_parse(&argp, argc, argv, 0, NULL, &arguments);
    int exit_status;
    if (scene_read(&scene, arguments.directory, &arguments.overrides, &status) != STATUS_OK)
        exit_status = command_fail(&status);
    else
        exit_status = report(&arguments, &scene, &status);
    scene_free(&scene);
    return command_finish(exit_status);
}
