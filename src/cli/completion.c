/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Completion for bash: docs/roughcontact.bash is what this writes, which a test holds it to. */
#include "base/unit.h"
#include "cli/command.h"
#include "contact/effect.h"
#include "material/material.h"
#include "profile/level.h"
#include "scan/scan.h"
#include "spectrum/power_law.h"

#include <math.h>
#include <string.h>

static void add_words(struct text *out, const char *const *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        text_add(out, "%s%s", out->length > 0 ? " " : "", words[i]);
}

static void add_materials(struct text *out)
{
    for (size_t i = 0; i < material_table_count; i++)
        if (!isnan(material_table[i].youngs_modulus_Pa)) /* else it bears no load */
            add_words(out, (const char *const[]){material_table[i].name}, 1);
}

static void add_effects(struct text *out)
{
    text_add(out, "auto");
    for (int e = 0; e < EFFECT_COUNT; e++)
        add_words(out, &effect_rows[e].name, 1);
}

static void add_units(struct text *out)
{
    struct unit_known known = unit_known(UNIT_DISTANCE);
    char *rest = known.text;
    for (char *word; (word = strsep(&rest, ", "));)
        if (*word && strcmp(word, "or") != 0)
            add_words(out, (const char *const[]){word}, 1);
}

static void add_levels(struct text *out)
{
    add_words(out, level_names, LEVEL_COUNT);
}

static void add_quantities(struct text *out)
{
    add_words(out, scan_quantity_names, SCAN_QUANTITY_COUNT);
}

static void add_fits(struct text *out)
{
    add_words(out, power_law_method_names, POWER_LAW_METHOD_COUNT);
}

static void add_commands(struct text *out)
{
    for (size_t c = 0; c < command_count; c++)
        add_words(out, &command_rows[c].name, 1);
}

/** What a word in --help stands for. */
static const struct value_row {
    const char *word;
    const char *kind; /* words, list (some of them, with commas), files, directories, or nothing that can be known */
    void (*add)(struct text *out);
} values[] = {
    {"MATERIAL", "words", add_materials},
    {"EFFECTS", "list", add_effects},
    {"UNIT", "words", add_units},
    {"LEVEL", "words", add_levels},
    {"QUANTITY", "words", add_quantities},
    {"FIT", "words", add_fits},
    {"COMMAND", "words", add_commands},
    {"FILE", "files", NULL},
    {"DIR", "directories", NULL},
    {"OUT", "directories", NULL},
    {"N", "nothing", NULL},
    {"REL", "nothing", NULL},
    {"LENGTH", "nothing", NULL},
    {"SI", "nothing", NULL},
    {"G", "nothing", NULL},
    {"DECADES", "nothing", NULL},
    {"Z|X,Z", "nothing", NULL},
    {NULL, NULL, NULL},
};

static const struct value_row *value_find(const char *word)
{
    const struct value_row *row = values;
    while (row->word && strcmp(row->word, word) != 0)
        row++;
    return row->word ? row : NULL;
}

bool command_completes(const char *word)
{
    return value_find(word) != NULL;
}

/** What may stand where the command line takes no option: what its arguments begin with. */
static const struct value_row *argument_of(const struct command_row *row)
{
    static const char *const words[] = {"FILE", "DIR", "COMMAND"}; /* the first includes the second */
    const char *takes = row->argp->args_doc ? row->argp->args_doc : "";
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strstr(takes, words[i]))
            return value_find(words[i]);
    return value_find("N");
}

static void add_kind(struct text *out, const struct value_row *row)
{
    struct text words = {0};
    if (row && row->add)
        row->add(&words);
    text_add(out, "kind=%s words='%s'", row ? row->kind : "nothing", text_string(&words));
    text_free(&words);
}

/** Every option of a parser and of those below it. */
static void add_options(struct text *out, const struct argp *argp)
{
    for (const struct argp_option *option = argp->options; option && option->name; option++) {
        text_add(out, "%s--%s%s", out->length > 0 ? " " : "", option->name, option->arg ? "=" : "");
        if (option->key > ' ' && option->key < 127)
            text_add(out, " -%c", option->key);
    }
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        add_options(out, child->argp);
}

/** A case for every option that takes a value. */
static void add_cases(struct text *out, const struct argp *argp)
{
    for (const struct argp_option *option = argp->options; option && option->name; option++) {
        if (!option->arg)
            continue;
        text_add(out, "        --%s", option->name);
        if (option->key > ' ' && option->key < 127)
            text_add(out, " | -%c", option->key);
        text_add(out, ") ");
        add_kind(out, value_find(option->arg));
        text_add(out, " ;;\n");
    }
    for (const struct argp_child *child = argp->children; child && child->argp; child++)
        add_cases(out, child->argp);
}

static void add_command(struct text *out, const struct command_row *row)
{
    struct text options = {0};
    add_options(&options, row->argp);
    add_options(&options, &command_common_argp);
    text_add(out, "    %s)\n        options='%s'\n        case $previous in\n", row->name, text_string(&options));
    add_cases(out, row->argp);
    text_add(out, "        *) ");
    add_kind(out, argument_of(row));
    text_add(out, " argument=1 ;;\n        esac ;;\n");
    text_free(&options);
}

void command_completion(struct text *out)
{
    struct text commands = {0};
    add_commands(&commands);
    text_add(out,
             "# SPDX-License-Identifier: GPL-3.0-or-later\n"
             "# bash completion of roughcontact. Written by `roughcontact help --completion`.\n"
             "_roughcontact()\n"
             "{\n"
             "    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
             "    local options='' kind=nothing words='' argument='' before=''\n"
             "    COMPREPLY=()\n"
             "    if ((COMP_CWORD == 1)); then\n"
             "        mapfile -t COMPREPLY < <(compgen -W '%s --help --version' -- \"$word\")\n"
             "        return\n"
             "    fi\n"
             "    if [[ $word == '=' ]]; then # --option=, which bash takes apart\n"
             "        word=''\n"
             "    elif [[ $previous == '=' ]]; then\n"
             "        previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
             "    fi\n"
             "    case ${COMP_WORDS[1]} in\n",
             text_string(&commands));
    for (size_t c = 0; c < command_count; c++)
        add_command(out, &command_rows[c]);
    text_add(out, "    esac\n"
                  "    if [[ -n $argument && $word == -* ]]; then\n"
                  "        kind=words words=$options\n"
                  "        compopt -o nospace 2>/dev/null\n"
                  "    fi\n"
                  "    case $kind in\n"
                  "    list)\n"
                  "        [[ $word == *,* ]] && before=${word%%,*},\n"
                  "        mapfile -t COMPREPLY < <(compgen -P \"$before\" -W \"$words\" -- \"${word##*,}\") ;;\n"
                  "    words) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;;\n"
                  "    files)\n"
                  "        mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n"
                  "        compopt -o filenames 2>/dev/null ;;\n"
                  "    directories)\n"
                  "        mapfile -t COMPREPLY < <(compgen -d -- \"$word\")\n"
                  "        compopt -o filenames 2>/dev/null ;;\n"
                  "    esac\n"
                  "    if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == -* && ${COMPREPLY[0]} != *= ]]; then\n"
                  "        COMPREPLY[0]+=' '\n"
                  "    fi\n"
                  "}\n"
                  "complete -F _roughcontact roughcontact\n");
    text_free(&commands);
}
