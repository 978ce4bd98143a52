/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The manual page and the completion of bash say what the tables of the program do, and are of use to man and bash. */
#include "base/version.h"
#include "cli/command.h"
#include "cli/process.h"
#include "contact/effect.h"
#include "material/material.h"
#include "scene/scene.h"

#include <stdio.h>
#include <unistd.h>

/** The manual page without its roff: what a reader sees of each line. */
static char *manual_read(void)
{
    static const char *const marks[][2] = {{"\\fB", ""},   {"\\fI", ""},  {"\\fR", ""},   {"\\&", ""},
                                           {"\\-", "-"},   {"\\e", "\\"}, {"\\(aq", "'"}, {"\\(ga", "`"},
                                           {"\\(ha", "^"}, {"\\(ti", "~"}};
    char *page = workspace_read(PROJECT_SOURCE, "docs/roughcontact.1");
    struct text plain = {0};
    for (const char *at = page; *at;) {
        size_t m = 0, marks_count = sizeof marks / sizeof *marks;
        assert_true(*at == '\n' || (*at >= ' ' && *at < 127));
        while (m < marks_count && strncmp(at, marks[m][0], strlen(marks[m][0])) != 0)
            m++;
        text_add_bytes(&plain, m < marks_count ? marks[m][1] : at, m < marks_count ? strlen(marks[m][1]) : 1);
        at += m < marks_count ? strlen(marks[m][0]) : 1;
    }
    free(page);
    return plain.data;
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

/** Options of a parser and of those below it stand in the page with what --help says of them, and in the replies of
 * the completion; counts them. */
static size_t check_options(const char *manual, const char *replies, const struct argp *argp)
{
    size_t options = 0;
    for (const struct argp_option *option = argp->options; option && option->name; option++, options++) {
        char term[1024], completed[96], letter[8] = "";
        if (option->key > ' ' && option->key < 127)
            snprintf(letter, sizeof letter, "-%c, ", option->key);
        snprintf(term, sizeof term, "\n.TP\n%s--%s%s%s\n%s\n", letter, option->name, option->arg ? "=" : "",
                 option->arg ? option->arg : "", option->doc);
        expect_part(manual, term);
        snprintf(completed, sizeof completed, "--%s%s\n", option->name, option->arg ? "=" : "");
        expect_part(replies, completed);
    }
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        options += check_options(manual, replies, child->argp);
    return options;
}

TEST_IN_WORKSPACE(manual_and_completion_have_every_option)
{
    char *manual = manual_read(), part[1024];
    size_t options = 0;
    for (size_t c = 0; c < COMMANDS; c++) {
        const struct command_row *row = &command_rows[c];
        snprintf(part, sizeof part, "\nroughcontact %s %s%s[OPTION...]\n", row->name, row->arguments,
                 *row->arguments ? " " : "");
        expect_part(manual, part);
        snprintf(part, sizeof part, "\n.SS %s\n%s\n", row->name, row->argp->doc);
        expect_part(manual, part);
        char *section = strdup(strstr(manual, part)), *end = strstr(section + 1, "\n.S");
        end[1] = '\0';
        snprintf(part, sizeof part, "roughcontact %s --", row->name);
        char *replies = complete(place, part);
        options += check_options(section, replies, row->argp);
        free(replies);
        free(section);
    }
    assert_true(options > 40);
    free(manual);
}

/** docs/scene.md has a line for every key that the program knows, and for no other. */
TEST_IN_WORKSPACE(the_scenes_page_has_every_key)
{
    char *page = workspace_read(PROJECT_SOURCE, "docs/scene.md"), *end = strstr(page, "\n```\n");
    struct text known = {0}, shown = {0};
    workspace_write(place, "d/scene.yaml", "foo: 1\n");
    struct process process = expect_exit(place, 3, "plan", "d");
    text_add(&known, " %s", strstr(process.err, "allowed: ") + strlen("allowed: "));
    text_add(&shown, " ");
    assert_non_null(end);
    *end = '\0';
    for (const char *line = strstr(page, "```yaml\n"); line; line = strchr(line + 1, '\n')) {
        const char *key = line + 1 + (strncmp(line, "\n# ", 3) == 0 ? 2 : 0);
        int length = (int)strspn(key, "abcdefghijklmnopqrstuvwxyz_");
        if (*line == '\n' && length > 0 && key[length] == ':')
            text_add(&shown, "%.*s, ", length, key);
    }
    for (int both = 0; both < 2; both++) /* each of either is in the other */
        for (const char *at = text_string(both ? &known : &shown); *(at += strspn(at, ", \n"));) {
            char key[64];
            int length = (int)strcspn(at, ",\n");
            snprintf(key, sizeof key, " %.*s%s", length, at, both ? "," : "");
            if (!strstr(text_string(both ? &shown : &known), key))
                fail_msg("%s has no%s", both ? "docs/scene.md" : "the program", key);
            at += length;
        }
    text_free(&known);
    text_free(&shown);
    process_free(&process);
    free(page);
}

/** The keys of a scene are those that the program names when it knows one not, in the same order. */
TEST_IN_WORKSPACE(manual_has_every_key)
{
    static const struct {
        const char *key, *const *choices;
        size_t count;
    } choices[] = {{"level", level_names, LEVEL_COUNT},
                   {"window", spectrum_window_names, SPECTRUM_WINDOW_COUNT},
                   {"fit", power_law_method_names, POWER_LAW_METHOD_COUNT},
                   {"moments", roughness_moments_names, ROUGHNESS_MOMENTS_COUNT},
                   {"data", scene_data_names, SCENE_DATA_COUNT}};
    char *manual = manual_read(), *scene = strstr(manual, "\n.SH SCENE\n"), *end = strstr(scene, "\n.SH EXIT STATUS\n");
    struct text expected = {0}, terms = {0};
    workspace_write(place, "d/scene.yaml", "foo: 1\n");
    struct process process = expect_exit(place, 3, "plan", "d");
    text_add(&expected, "%s", strstr(process.err, "allowed: ") + strlen("allowed: "));
    for (const char *term = scene; (term = strstr(term, "\n.TP\n")) && term < end;) {
        term += strlen("\n.TP\n");
        text_add(&terms, "%s%.*s", terms.length > 0 ? ", " : "", (int)strcspn(term, ":\n"), term);
    }
    text_add(&terms, "\n");
    assert_string_equal(text_string(&terms), text_string(&expected));
    for (size_t k = 0; k < sizeof choices / sizeof *choices; k++) {
        struct text line = {0};
        text_add(&line, "\n%s: ", choices[k].key);
        for (size_t i = 0; i < choices[k].count; i++)
            text_add(&line, "%s%s", i > 0 ? " | " : "", choices[k].choices[i]);
        text_add(&line, "\n");
        expect_part(scene, text_string(&line));
        text_free(&line);
    }
    text_free(&terms);
    text_free(&expected);
    process_free(&process);
    free(manual);
}

TEST_IN_WORKSPACE(manual_has_chapters_and_statuses)
{
    static const char *const chapters[] = {"NAME",        "SYNOPSIS", "DESCRIPTION", "COMMANDS", "SCENE",
                                           "EXIT STATUS", "FILES",    "ENVIRONMENT", "EXAMPLES", "SEE ALSO"};
    char *manual = manual_read(), *commands = workspace_read(PROJECT_SOURCE, "docs/commands.md"), part[256];
    for (size_t i = 0; i < COMMAND_STATUSES; i++) {
        snprintf(part, sizeof part, "\n.TP\n%zu\n%s\n", i, command_statuses[i]);
        expect_part(manual, part);
        snprintf(part, sizeof part, "\n| %zu | %s |\n", i, command_statuses[i]);
        expect_part(commands, part);
    }
    for (size_t i = 0; i < sizeof chapters / sizeof *chapters; i++) {
        snprintf(part, sizeof part, "\n.SH %s\n", chapters[i]);
        expect_part(manual, part);
    }
    snprintf(part, sizeof part, "\"roughcontact %s\"", version_string());
    expect_part(manual, part);
    free(commands);
    free(manual);
}

/** groff has no warning for it, neither has man; skipped where there is none. */
TEST_IN_WORKSPACE(groff_reads_the_manual)
{
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

TEST_IN_WORKSPACE(bash_completes)
{
    static const struct {
        const char *line, *replies;
    } cases[] = {
        {"roughcontact re", "report\n"},
        {"roughcontact --v", "--version\n"},
        {"roughcontact report --ju", "\n"},
        {"roughcontact report --jo", "--jobs=\n"},
        {"roughcontact plan --material = copper", "copper\ncopper-nickel-silicon\n"},
        {"roughcontact plan --effects = th", "thermal\n"},
        {"roughcontact plan -e electrical,gap,fi", "electrical,gap,film\n"},
        {"roughcontact inspect --quantity = s", "slope\n"},
        {"roughcontact inspect --x-unit = u", "um\nuin\n"},
        {"roughcontact report in", "inner\n"},
        {"roughcontact report -o in", "inner\n"},
        {"roughcontact models --j", "--json \n"},
        {"roughcontact self-test --ver", "--verbose \n"},
        {"roughcontact report -j ", "\n"},
        {"roughcontact report -s in", "inner\n"},
    };
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
    char *units = complete(place, "roughcontact report --x-unit = "), list[512] = "";
    for (char *unit = strtok(units, "\n"); unit; unit = strtok(NULL, "\n"))
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s", *list ? ", " : "", unit);
    assert_string_equal(list, unit_known(UNIT_DISTANCE).text);
    free(units);
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
