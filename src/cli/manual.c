/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The manual page roughcontact(1): docs/roughcontact.1 is what this writes, which a test holds it to. */
#include "base/version.h"
#include "cli/command.h"
#include "scene/scene.h"

#include <stdio.h>
#include <string.h>

/** Bytes of the first character of UTF-8 text, and its code. */
static size_t decode(unsigned *code, const char *s)
{
    const unsigned char *u = (const unsigned char *)s;
    size_t length = text_character(s);
    *code = length == 2   ? (u[0] & 0x1fU) << 6 | (u[1] & 0x3fU)
            : length == 3 ? (u[0] & 0x0fU) << 12 | (u[1] & 0x3fU) << 6 | (u[2] & 0x3fU)
            : length == 4 ? (u[0] & 0x07U) << 18 | (u[1] & 0x3fU) << 12 | (u[2] & 0x3fU) << 6 | (u[3] & 0x3fU)
                          : u[0];
    return length > 0 ? length : 1;
}

/** Adds text as it stands: nothing in it is a request, a quote or a hyphen. */
static void add_plain(struct text *out, const char *plain)
{
    static const struct {
        char c;
        const char *roff;
    } special[] = {{'\\', "\\e"}, {'-', "\\-"}, {'\'', "\\(aq"}, {'`', "\\(ga"}, {'^', "\\(ha"}, {'~', "\\(ti"}};
    size_t length;
    for (const char *at = plain; *at; at += length) {
        unsigned code;
        size_t s = 0;
        length = decode(&code, at);
        while (s < sizeof special / sizeof special[0] && special[s].c != *at)
            s++;
        if (s < sizeof special / sizeof special[0])
            text_add(out, "%s", special[s].roff);
        else if (code > 126)
            text_add(out, "\\[u%04X]", code);
        else
            text_add(out, *at == '.' && at == plain ? "\\&%c" : "%c", *at);
    }
}

static void add_line(struct text *out, const char *plain)
{
    add_plain(out, plain);
    text_add(out, "\n");
}

static void add_bold(struct text *out, const char *plain)
{
    text_add(out, "\\fB");
    add_plain(out, plain);
    text_add(out, "\\fR");
}

static void add_entry(struct text *out, const char *term, const char *says)
{
    text_add(out, ".TP\n");
    add_bold(out, term);
    text_add(out, "\n");
    add_line(out, says);
}

static void add_option(struct text *out, const struct argp_option *option)
{
    text_add(out, ".TP\n");
    if (option->key > ' ' && option->key < 127) {
        add_bold(out, (const char[]){'-', (char)option->key, '\0'});
        text_add(out, ", ");
    }
    text_add(out, "\\fB\\-\\-");
    add_plain(out, option->name);
    text_add(out, "\\fR");
    if (option->arg) {
        text_add(out, "=\\fI");
        add_plain(out, option->arg);
        text_add(out, "\\fR");
    }
    text_add(out, "\n");
    add_line(out, option->doc);
}

/** The options of a parser and of those below it. */
static void add_options(struct text *out, const struct argp *argp)
{
    for (const struct argp_option *option = argp->options; option && option->name; option++)
        add_option(out, option);
    for (const struct argp_child *child = argp->children; child && child->argp; child++) {
        if (child->header) {
            text_add(out, ".PP\n");
            add_line(out, child->header);
        }
        add_options(out, child->argp);
    }
}

static void add_key(const char *name, const char *value, const char *about, void *context)
{
    struct text *out = context;
    text_add(out, ".TP\n");
    add_bold(out, name);
    if (*value) {
        text_add(out, ": ");
        add_plain(out, value);
    }
    text_add(out, "\n");
    add_line(out, about);
}

static const struct {
    const char *name, *says;
} files[] =
    {
        {"DIR/scene.yaml", "what the directory of scans cannot say; every key is optional (see SCENE)"},
        {"OUT/report.html", "the report, in one file that opens offline; OUT/report.md is its source"},
        {"OUT/results.json", "all numbers of the report; OUT/data/*.csv are its tables"},
        {"OUT/figures", "the charts, with the data and the script that redraw each"},
        {"OUT/manifest.txt", "the files that the program wrote, which the next run replaces"},
        {"PREFIX/share/roughcontact",
         "templates of report and charts and the numbers of self-test, which the program looks for beside its own "
         "PREFIX/bin, and example surfaces"},
},
  environment[] =
      {
          {"PATH",
           "where gnuplot, which draws the charts, and gwyddion, which may read further formats, are looked for"},
          {"TMPDIR", "where temporary files go (default: /tmp)"},
          {"COLUMNS, LINES", "size of charts in text where the output is no terminal (default: 100 and 30)"},
},
  examples[] = {
      {"roughcontact inspect scan.csv", "says what is in a scan."},
      {"roughcontact report DIR --material copper", "reports every scan in DIR to out/DIR/report.html."},
      {"roughcontact report DIR --check --json | jq .missed_limits",
       "asks in a script which limits the surfaces miss."},
      {"roughcontact plan DIR", "says what a report would run, why, and how long it would take."},
      {"roughcontact synth --rq 0.4um | roughcontact inspect -", "makes a rough scan and looks at it."},
      {"roughcontact self-test", "holds this build's numbers against those of other programs and closed forms."},
};
enum {
    FILES = sizeof files / sizeof files[0],
    VARIABLES = sizeof environment / sizeof environment[0],
    EXAMPLES = sizeof examples / sizeof examples[0]
};

void command_manual(struct text *out)
{
    text_add(out, ".\\\" SPDX-License-Identifier: GPL-3.0-or-later\n"
                  ".\\\" Written by `roughcontact help --man`.\n");
    text_add(out, ".TH ROUGHCONTACT 1 \"\" \"roughcontact %s\" \"User Commands\"\n.nh\n", version_string());
    text_add(out, ".SH NAME\nroughcontact \\- contact of measured rough surfaces\n.SH SYNOPSIS\n");
    for (size_t c = 0; c < command_count; c++) {
        text_add(out, "%s", c > 0 ? ".br\n" : "");
        add_bold(out, "roughcontact ");
        add_bold(out, command_rows[c].name);
        text_add(out, " ");
        add_plain(out, command_rows[c].arguments);
        text_add(out, "%s[\\fIOPTION\\fR...]\n", *command_rows[c].arguments ? " " : "");
    }
    text_add(out, ".br\n\\fBroughcontact \\-\\-version\\fR\n.SH DESCRIPTION\n");
    add_line(out,
             "Reads a directory of surface-profilometer scans and tells what those surfaces do when pressed together: "
             "real contact area, separation, electrical and thermal contact resistance against load, by several "
             "models side by side and with confidence intervals, in a report with charts. Results go to standard "
             "output, progress and messages to standard error.");
    text_add(out, ".SH COMMANDS\n");
    for (size_t c = 0; c < command_count; c++) {
        text_add(out, ".SS ");
        add_plain(out, command_rows[c].name);
        text_add(out, "\n");
        add_line(out, command_rows[c].argp->doc);
        add_options(out, command_rows[c].argp);
    }
    text_add(out, ".SS every command\n");
    add_options(out, &command_common_argp);
    add_entry(out, "-V, --version", "in the place of a command: version, and the libraries that the program runs with");
    text_add(out, ".SH SCENE\n");
    add_line(out,
             "DIR/scene.yaml is a YAML mapping of these keys, every one optional. A quantity is a number in SI, or a "
             "number with its unit as text: 4 mm2, 2.5 um, 14 MPa, 10 %.");
    scene_each_key(add_key, out);
    text_add(out, ".SH EXIT STATUS\n");
    for (size_t i = 0; i < command_status_count; i++) {
        char number[24];
        snprintf(number, sizeof number, "%zu", i);
        add_entry(out, number, command_statuses[i]);
    }
    text_add(out, ".PP\n");
    add_line(out, "self-test ends with 1 where a number is off.");
    text_add(out, ".SH FILES\n");
    for (size_t i = 0; i < FILES; i++)
        add_entry(out, files[i].name, files[i].says);
    text_add(out, ".SH ENVIRONMENT\n");
    for (size_t i = 0; i < VARIABLES; i++)
        add_entry(out, environment[i].name, environment[i].says);
    text_add(out, ".SH EXAMPLES\n");
    for (size_t i = 0; i < EXAMPLES; i++)
        add_entry(out, examples[i].name, examples[i].says);
    text_add(out, ".SH SEE ALSO\n\\fBgnuplot\\fR(1), \\fBgwyddion\\fR(1), \\fBjq\\fR(1)\n");
}
