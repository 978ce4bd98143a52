/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The manual page and the completion: made of the tables, named nowhere else, and of use to man and bash. */
#include "cli/command.h"
#include "cli/process.h"
#include "contact/effect.h"
#include "material/material.h"
#include "scene/scene.h"

#include <stdio.h>
#include <unistd.h>

/** Fails unless a committed file is what `help` prints with the option. */
static void expect_made(const char *place, const char *option, const char *path)
{
    struct process process = expect_exit(place, 0, "help", option);
    char *file = workspace_read(PROJECT_SOURCE, path);
    if (strcmp(file, process.out) != 0)
        fail_msg("%s is not what the program says: build/bin/roughcontact help %s > %s", path, option, path);
    free(file);
    process_free(&process);
}

static void committed_files_are_made(void **state)
{
    expect_made(*state, "--man", "docs/roughcontact.1");
    expect_made(*state, "--completion", "docs/roughcontact.bash");
}

/** As the manual writes it. */
static void expect_in_manual(const char *manual, const char *before, const char *name)
{
    char roff[256];
    size_t used = (size_t)snprintf(roff, sizeof roff, "%s", before);
    for (; *name && used + 3 < sizeof roff; name++) {
        if (*name == '-')
            roff[used++] = '\\';
        roff[used++] = *name;
    }
    roff[used] = '\0';
    expect_part(manual, roff);
}

/** Options of a parser and of those below it; counts them, and looks that the completion knows their values. */
static size_t check_options(const char *manual, const char *completion, const struct argp *argp)
{
    size_t options = 0;
    for (const struct argp_option *option = argp->options; option && option->name; option++, options++) {
        char completed[96];
        expect_in_manual(manual, "\\fB\\-\\-", option->name);
        snprintf(completed, sizeof completed, "--%s%s", option->name, option->arg ? "=" : "");
        expect_part(completion, completed);
        if (option->arg && !command_completes(option->arg))
            fail_msg("--%s takes %s, which src/cli/completion.c does not know", option->name, option->arg);
    }
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        options += check_options(manual, completion, child->argp);
    return options;
}

static void check_key(const char *name, const char *value, const char *about, void *context)
{
    char *const *manual = context;
    char term[96];
    assert_true(about && strlen(about) > 5 && value);
    snprintf(term, sizeof term, ".TP\n\\fB%s\\fR", name);
    expect_part(*manual, term);
}

static void manual_has_everything(void **state)
{
    (void)state;
    char *manual = workspace_read(PROJECT_SOURCE, "docs/roughcontact.1");
    char *completion = workspace_read(PROJECT_SOURCE, "docs/roughcontact.bash");
    size_t options = 0;
    for (size_t c = 0; c < command_count; c++) {
        expect_in_manual(manual, ".SS ", command_rows[c].name);
        options += check_options(manual, completion, command_rows[c].argp);
    }
    assert_true(options > 40);
    scene_each_key(check_key, &manual);
    char *commands = workspace_read(PROJECT_SOURCE, "docs/commands.md");
    for (size_t i = 0; i < command_status_count; i++) {
        char status[96];
        snprintf(status, sizeof status, ".TP\n\\fB%zu\\fR\n", i);
        expect_part(manual, status);
        snprintf(status, sizeof status, "\n| %zu | %s |\n", i, command_statuses[i]);
        expect_part(commands, status);
    }
    free(commands);
    static const char *const chapters[] = {"NAME",        "SYNOPSIS", "DESCRIPTION", "COMMANDS", "SCENE",
                                           "EXIT STATUS", "FILES",    "ENVIRONMENT", "EXAMPLES", "SEE ALSO"};
    for (size_t i = 0; i < sizeof chapters / sizeof *chapters; i++)
        expect_in_manual(manual, ".SH ", chapters[i]);
    for (const char *c = manual; *c; c++)
        assert_true(*c == '\n' || (*c >= ' ' && *c < 127));
    free(manual);
    free(completion);
}

/** groff has no warning for it, neither has man; skipped where there is none. */
static void groff_reads_the_manual(void **state)
{
    const char *place = *state;
    if (access("/usr/bin/groff", X_OK) != 0) {
        print_message("no groff\n");
        skip();
    }
    const char *const groff[] = {"groff", "-man", "-ww", "-Tutf8", PROJECT_SOURCE "/docs/roughcontact.1", NULL};
    struct process process = process_expect(process_end(process_start_list(place, groff, NULL)), 0, __FILE__, __LINE__);
    assert_string_equal(process.err, "");
    expect_part(process.out, "scene.yaml");
    process_free(&process);
}

/** Replies of the completion to a command line, one a line; its last word may be begun. */
static char *complete(const char *place, const char *line)
{
    static const char script[] = "source \"$1\"; shift\n"
                                 "COMP_WORDS=(\"$@\") COMP_CWORD=$(($# - 1))\n"
                                 "_roughcontact roughcontact\n"
                                 "printf '%s\\n' \"${COMPREPLY[@]}\"\n";
    const char *arguments[24] = {"bash", "-c", script, "bash", PROJECT_SOURCE "/docs/roughcontact.bash"};
    char words[256], *rest = words;
    size_t count = 5;
    snprintf(words, sizeof words, "%s", line);
    for (char *word; (word = strsep(&rest, " "));)
        arguments[count++] = word;
    struct process process =
        process_expect(process_end(process_start_list(place, arguments, NULL)), 0, __FILE__, __LINE__);
    assert_string_equal(process.err, "");
    char *replies = strdup(process.out);
    process_free(&process);
    return replies;
}

static void bash_completes(void **state)
{
    static const struct {
        const char *line, *replies;
    } cases[] = {
        {"roughcontact re", "report\n"},
        {"roughcontact --v", "--version\n"},
        {"roughcontact report --ju", "\n"},
        {"roughcontact report --jo", "--jobs=\n"},
        {"roughcontact report --che", "--check \n"},
        {"roughcontact plan --material = copper", "copper\ncopper-nickel-silicon\n"},
        {"roughcontact plan -m ti", "tin\n"},
        {"roughcontact plan --effects = th", "thermal\n"},
        {"roughcontact plan -e electrical,gap,fi", "electrical,gap,film\n"},
        {"roughcontact inspect --level = p", "parabola\n"},
        {"roughcontact inspect --fit th", "thesis\n"},
        {"roughcontact inspect --quantity = s", "slope\n"},
        {"roughcontact inspect --x-unit = u", "um\nuin\n"},
        {"roughcontact report in", "inner\n"},
        {"roughcontact report -o in", "inner\n"},
        {"roughcontact help mod", "models\n"},
        {"roughcontact models --j", "--json \n"},
        {"roughcontact self-test --ver", "--verbose \n"},
        {"roughcontact report -j ", "\n"},
    };
    const char *place = *state;
    if (access("/bin/bash", X_OK) != 0) {
        print_message("no bash\n");
        skip();
    }
    workspace_write(place, "in.csv", "");
    workspace_folder(place, "inner");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *replies = complete(place, cases[i].line);
        if (strcmp(replies, cases[i].replies) != 0)
            fail_msg("'%s': '%s', not '%s'", cases[i].line, replies, cases[i].replies);
        free(replies);
    }
    char *files = complete(place, "roughcontact inspect in"); /* in any order */
    expect_part(files, "in.csv\n");
    expect_part(files, "inner\n");
    free(files);
    char *materials = complete(place, "roughcontact report --material = ");
    for (size_t i = 0; i < material_table_count; i++)
        if (!isnan(material_table[i].youngs_modulus_Pa))
            expect_part(materials, material_table[i].name);
    char *effects = complete(place, "roughcontact report --effects ");
    for (int e = 0; e < EFFECT_COUNT; e++)
        expect_part(effects, effect_rows[e].name);
    free(materials);
    free(effects);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        workspace_test(committed_files_are_made),
        workspace_test(manual_has_everything),
        workspace_test(groff_reads_the_manual),
        workspace_test(bash_completes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
