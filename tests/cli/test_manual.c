/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The manual page and bash's completion agree with the program's tables, and man and bash can read them. */
#include "base/version.h"
#include "cli/command.h"
#include "cli/process.h"
#include "contact/quantity.h"
#include "material/material.h"
#include "output/tables.h"
#include "scene/scene_source.h"

/** The manual page without its roff: what a reader sees of each line. */
static char *manual_read(void)
{
    static const char *const marks[][2] = {{"\\fB", ""},   {"\\fI", ""},  {"\\fR", ""},   {"\\&", ""},
                                           {"\\-", "-"},   {"\\e", "\\"}, {"\\(aq", "'"}, {"\\(ga", "`"},
                                           {"\\(ha", "^"}, {"\\(ti", "~"}};
    char *page = workspace_read(PROJECT_SOURCE, "docs/roughcontact.1");
    struct text *plain = support_text();
    for (const char *at = page; *at;) {
        size_t m = 0, count = sizeof marks / sizeof *marks;
        assert_true(*at == '\n' || (*at >= ' ' && *at < 127));
        while (m < count && strncmp(at, marks[m][0], strlen(marks[m][0])) != 0)
            m++;
        text_add(plain, "%.*s", m < count ? 9 : 1, m < count ? marks[m][1] : at);
        at += m < count ? strlen(marks[m][0]) : 1;
    }
    return plain->data;
}

/** Replies of the completion to a command line, one a line; its last word may be begun. */
static char *complete(const char *place, const char *line)
{
    static const char script[] = "source \"$1\"; shift\n"
                                 "COMP_WORDS=(\"$@\") COMP_CWORD=$(($# - 1))\n"
                                 "_roughcontact roughcontact\n"
                                 "printf '%s\\n' \"${COMPREPLY[@]}\"\n";
    const char *arguments[24] = {"bash", "-c", script, "bash", PROJECT_SOURCE "/docs/roughcontact.bash"};
    char *rest = lasting("%s", line);
    size_t count = 5;
    for (char *word; (word = strsep(&rest, " "));)
        arguments[count++] = word;
    struct process process = expect_status(process_end(process_start_list(place, arguments, NULL)), 0);
    assert_string_equal(process.err, "");
    return process.out;
}

/** Options of a parser and of those below it stand in the page with what --help says of them, and in the replies of
 * the completion; counts them. */
static size_t check_options(const char *manual, const char *replies, const struct argp *argp)
{
    size_t options = 0;
    for (const struct argp_option *option = argp->options; option && option->name; option++, options++) {
        char letter[8] = "";
        if (option->key > ' ' && option->key < 127)
            snprintf(letter, sizeof letter, "-%c, ", option->key);
        expect_part(manual, filled("\n.TP\n%s--%s%s%s\n%s\n", letter, option->name, option->arg ? "=" : "",
                                   option->arg ? option->arg : "", option->doc));
        expect_part(replies, filled("--%s%s\n", option->name, option->arg ? "=" : ""));
    }
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        options += check_options(manual, replies, child->argp);
    return options;
}

/** A command's section of the page, of those that take options of `report` with its section. */
static const char *section_of(const char *manual, const struct command_row *row)
{
    const char *section = strstr(manual, lasting("\n.SS %s\n%s\n", row->name, row->argp->doc));
    assert_non_null(section);
    const char *text = lasting("%.*s", (int)(strstr(section + 1, "\n.S") + 1 - section), section);
    return strstr(text, "options of report") ? lasting("%s%s", text, section_of(manual, command_rows)) : text;
}

TEST_IN_WORKSPACE(manual_and_completion_have_every_option)
{
    char *manual = manual_read();
    size_t options = 0;
    for (size_t c = 0; c < COMMANDS; c++) {
        const struct command_row *row = &command_rows[c];
        expect_part(manual, filled("\nroughcontact %s %s%s[OPTION...]\n", row->name, row->arguments,
                                   *row->arguments ? " " : ""));
        options +=
            check_options(section_of(manual, row), complete(place, filled("roughcontact %s --", row->name)), row->argp);
    }
    assert_true(options > 40);
}

/** The values that a key may have: its words, its range, its units. */
static void add_values(struct text *out, const struct scene_key *key)
{
    const char *between = "";
    for (size_t i = 0; i < key->choice_count; i++, between = " | ")
        text_add(out, "%s%s", between, key->choices[i]);
    if (key->word)
        text_add(out, "%s%s", between, key->word), between = " | ";
    for (unsigned bit = 1; bit <= key->quantities; bit *= 2) {
        const struct unit_known known = unit_known(key->quantities & bit);
        size_t first = strcspn(known.text, ",("); /* "ohm m2 (Ω·m²), ..." */
        if (key->quantities == UNIT_NUMBER)
            text_add(out, "%s%g to %g", between, key->least, key->most);
        else if (key->quantities & bit)
            text_add(out, "%s%.*s", between, (int)(first - (known.text[first] == '(')), known.text);
        between = key->quantities & bit ? " | " : between;
    }
}

/** The rules of a key, and of those within it. */
static void add_rules(struct text *out, const char *of, const struct scene_key *key)
{
    const struct {
        const char *verb, *list;
    } rules[] = {{"needs", key->needs}, {"excludes", key->excludes}, {"is above", key->above}};
    for (size_t r = 0; r < sizeof rules / sizeof *rules; r++)
        if (rules[r].list)
            text_add(out, "; %s%s%s %s", of, *of ? " " : "", rules[r].verb, rules[r].list);
    if (!key->within)
        return;
    if (key->within->needs)
        text_add(out, "; its mapping needs %s", key->within->needs);
    if (key->within->one_of)
        text_add(out, "; its mapping has one of %s", key->within->one_of);
    for (size_t k = 0; k < key->within->count; k++)
        if (!key->within->keys[k].within)
            add_rules(out, key->within->keys[k].name, &key->within->keys[k]);
}

/** As roff, or in a cell of Markdown, has it. */
static void add_escaped(struct text *out, const char *string, bool roff)
{
    static const char *const marks[][3] = {
        {"-", "\\-", "-"}, {"'", "\\(aq", "'"}, {"`", "\\(ga", "`"}, {"|", "|", "\\|"}};
    for (; *string; string++) {
        size_t m = 0;
        while (m < 4 && *marks[m][0] != *string)
            m++;
        text_add(out, "%.*s", m < 4 ? 9 : 1, m < 4 ? marks[m][roff ? 1 : 2] : string);
    }
}

/** Compares the text between `before` and `after` in a document with what is made; or writes it there. */
static void check_made(const char *name, const char *before, const struct text *made, const char *after)
{
    char *all = workspace_read(PROJECT_SOURCE, name), *start = strstr(all, before) + strlen(before);
    const char *end = strstr(start, after);
    if (getenv("ROUGHCONTACT_WRITE_DOCS")) {
        struct text *whole = support_text();
        text_add(whole, "%.*s%s%s", (int)(start - all), all, made->data, end);
        workspace_write(PROJECT_SOURCE, name, whole->data);
    } else if ((size_t)(end - start) != made->length || memcmp(start, made->data, made->length) != 0)
        fail_msg("%s is not of the program's tables: run this test with ROUGHCONTACT_WRITE_DOCS=1", name);
}

TEST_CASE(documents_are_made_of_the_keys)
{
    struct text *page = support_text(), *manual = support_text();
    for (size_t k = 0; k < scene_key_count; k++) {
        struct text *values = support_text(), *rules = support_text();
        add_values(values, &scene_keys[k]);
        add_rules(rules, "", &scene_keys[k]);
        text_add(page, "| `%s` | ", scene_keys[k].name);
        add_escaped(page, text_string(values), false);
        text_add(page, "%s| ", values->length > 0 ? " " : "");
        add_escaped(page, scene_keys[k].text, false);
        add_escaped(page, text_string(rules), false);
        text_add(page, " |\n");
        text_add(manual, "\\fB%s\\fR%s", scene_keys[k].name, values->length > 0 ? ": " : "");
        add_escaped(manual, text_string(values), true);
        text_add(manual, "\n");
        add_escaped(manual, scene_keys[k].text, true);
        add_escaped(manual, text_string(rules), true);
        text_add(manual, "\n%s", k + 1 < scene_key_count ? ".TP\n" : "");
    }
    struct scene scene = {0};
    struct text *schema = support_text();
    struct scene_said said;
    for (size_t k = 0; scene_said(&said, &scene, k); k++) {
        const struct scene_key *key = &scene_keys[k];
        if (said.kind == SCENE_SAID_APART)
            continue;
        text_add(schema, "    \"%s\": {", said.key);
        if (said.kind != SCENE_SAID_TEXT)
            text_add(schema, "\"$ref\": \"#/$defs/%s\"", said.kind == SCENE_SAID_NUMBER ? "number" : "count");
        else if (key->choice_count == 0)
            text_add(schema, "\"type\": [\"string\", \"null\"]");
        for (size_t c = 0; c < key->choice_count; c++)
            text_add(schema, "%s\"%s\"%s", c == 0 ? "\"enum\": [" : ", ", key->choices[c],
                     c + 1 == key->choice_count ? "]" : "");
        text_add(schema, "},\n");
    }
    check_made("docs/results.schema.json", "\"shape_size_m\": {\"$ref\": \"#/$defs/numbers\"},\n", schema,
               "    \"models\": {");
    check_made("docs/scene.md", "| key | may be | what it says |\n|---|---|---|\n", page, "\n**Quantities**");
    check_made("docs/roughcontact.1", "14 MPa, 10 %.\n.TP\n", manual, ".SH EXIT STATUS\n");
}

/** The schema is made of the quantities; a page tells each by its name and unit, in their order. */
TEST_CASE(documents_have_all_quantities)
{
    struct text *schema = support_text();
    const char *at = strstr(workspace_read(PROJECT_SOURCE, "docs/report.md"), "\n| `surface`, `model` | | names |\n");
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        const struct quantity_row *row = &quantity_rows[q];
        if (!(row->is & QUANTITY_SIGMA_ALONE))
            at = strstr(at, filled("\n| `%s` | %s | ", row->name, row->unit[0] ? row->unit : "1"));
        assert_non_null(at);
        if (row->sigma_column)
            at = strstr(at, filled("\n| `%s` | 1 | ", row->sigma_column));
        assert_non_null(at);
        text_add(schema, "    \"%s\": {\"$ref\": \"#/$defs/numbers\"},\n", row->name);
    }
    check_made("docs/results.schema.json",
               "\"largest_load_share_clamped_at_radius\": {\"$ref\": \"#/$defs/number\"},\n", schema,
               "    \"operating\": {");
}

/** The fields of a record that are in JSON, as properties of the schema; the last ends with `end`. */
static void add_properties(struct text *out, const struct record_field *fields, const char *end)
{
    static const char *const kinds[] = {[RECORD_NUMBER] = "number",
                                        [RECORD_COUNT] = "count",
                                        [RECORD_PAIR] = "numbers",
                                        [RECORD_ESTIMATE] = "estimate"};
    const char *between = "";
    for (; fields->key; fields++) {
        if (!(fields->when & RECORD_JSON))
            continue;
        text_add(out, "%s    \"%s\": {", between, fields->key);
        if (fields->kind == RECORD_FLAG || fields->kind == RECORD_TEXT)
            text_add(out, fields->kind == RECORD_FLAG ? "\"type\": \"boolean\"}" : "\"type\": [\"string\", \"null\"]}");
        else
            text_add(out, "\"$ref\": \"#/$defs/%s\"}", kinds[fields->kind]);
        between = ",\n";
    }
    text_add(out, "%s\n", end);
}

TEST_CASE(the_schema_is_made_of_the_fields)
{
    struct text *surface = support_text(), *estimate = support_text();
    add_properties(surface, surface_fields, ",");
    check_made("docs/results.schema.json", "\"units\": {\"type\": \"string\"},\n", surface,
               "    \"material\": {\"$ref\": \"#/$defs/material\"},\n");
    add_properties(estimate, record_estimate_fields, "");
    check_made("docs/results.schema.json", "\"mean_95\", \"next_scan_95\"],\n   \"properties\": {\n", estimate,
               "   }\n  },\n  \"material\": {");
}

/** Does a scene's key say that each quantity's key may be asked for? */
TEST_CASE(targets_name_the_quantities)
{
    size_t k = 0;
    while (strcmp(scene_keys[k].name, "targets") != 0)
        k++;
    for (int p = 0; p < 2 * QUANTITY_COUNT; p++)
        if (quantity_rows[p / 2].asked[p % 2].key)
            expect_part(scene_keys[k].text, quantity_rows[p / 2].asked[p % 2].key);
}

TEST_IN_WORKSPACE(manual_has_chapters_and_statuses)
{
    static const char *const chapters[] = {"NAME",        "SYNOPSIS", "DESCRIPTION", "COMMANDS", "SCENE",
                                           "EXIT STATUS", "FILES",    "ENVIRONMENT", "EXAMPLES", "SEE ALSO"};
    char *manual = manual_read(), *commands = workspace_read(PROJECT_SOURCE, "docs/commands.md");
    for (size_t i = 0; i < COMMAND_STATUSES; i++) {
        expect_part(manual, filled("\n.TP\n%zu\n%s\n", i, command_statuses[i]));
        expect_part(commands, filled("\n| %zu | %s |\n", i, command_statuses[i]));
    }
    for (size_t i = 0; i < sizeof chapters / sizeof *chapters; i++)
        expect_part(manual, filled("\n.SH %s\n", chapters[i]));
    expect_part(manual, filled("\"roughcontact %s\"", version_string()));
}

/** groff has no warning for it, neither has man; skipped where there is none. */
TEST_IN_WORKSPACE(groff_reads_the_manual)
{
    if (access("/usr/bin/groff", X_OK) != 0) {
        print_message("no groff\n");
        skip();
    }
    struct process process =
        expect_status(run_program(place, "groff", "-man", "-ww", "-Tutf8", PROJECT_SOURCE "/docs/roughcontact.1"), 0);
    assert_string_equal(process.err, "");
    expect_part(process.out, "scene.yaml");
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
        {"roughcontact inspect --x-unit = u", "um\nuin\n"},
        {"roughcontact report in", "inner\n"},
        {"roughcontact report -o in", "inner\n"},
        {"roughcontact models --j", "--json \n"},
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
    }
    expect_parts(complete(place, "roughcontact inspect in"), "in.csv\n", "inner\n"); /* in any order */
    struct text *list = support_text();
    for (char *unit = strtok(complete(place, "roughcontact report --x-unit = "), "\n"); unit; unit = strtok(NULL, "\n"))
        text_add(list, "%s%s", list->length > 0 ? ", " : "", unit);
    assert_string_equal(text_string(list), unit_known(UNIT_DISTANCE).text);
    char *materials = complete(place, "roughcontact report --material = ");
    for (size_t i = 0; i < material_table_count; i++)
        if (!isnan(material_table[i].youngs_modulus_Pa))
            expect_part(materials, material_table[i].name);
    char *effects = complete(place, "roughcontact report --effects ");
    for (int e = 0; e < EFFECT_COUNT; e++)
        expect_part(effects, effect_rows[e].name);
}
