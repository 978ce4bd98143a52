/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene_source.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* A scene needs 4 levels and few anchors. libyaml's time grows with the square of both, hence limits. */
enum { DEEPEST_NESTING = 16, MOST_ANCHORS = 1000 };

const char *const scene_source_yes[2] = {"false", "true"};

bool scene_source_fail(struct scene_source *source, size_t line, const char *format, ...)
{
    char message[sizeof source->status->message];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    if (source->option)
        (void)status_fail(source->status, STATUS_USAGE, "--%s: %s", source->option, message);
    else
        (void)status_fail(source->status, STATUS_SCENE, "%s:%zu: %s", source->scene->path, line, message);
    return false;
}

bool scene_source_memory(struct scene_source *source)
{
    (void)status_memory(source->status);
    return false;
}

static bool parser_error(struct scene_source *source, const yaml_parser_t *parser, const char *bytes)
{
    if (parser->error == YAML_MEMORY_ERROR)
        return scene_source_memory(source);
    size_t line = parser->problem_mark.line + 1;
    if (parser->error == YAML_READER_ERROR) { /* knows an offset only */
        line = 1;
        for (size_t i = 0; i < parser->problem_offset; i++)
            line += bytes[i] == '\n';
    }
    return scene_source_fail(source, line, "not valid YAML: %s; check brackets, quotes and indentation",
                             parser->problem ? parser->problem : "it cannot be read");
}

struct nesting {
    int depth, anchors, documents;
};

static bool check_event(struct scene_source *source, const yaml_event_t *event, struct nesting *nesting)
{
    size_t line = event->start_mark.line + 1;
    bool start = event->type == YAML_SEQUENCE_START_EVENT || event->type == YAML_MAPPING_START_EVENT;
    nesting->depth += start;
    nesting->depth -= event->type == YAML_SEQUENCE_END_EVENT || event->type == YAML_MAPPING_END_EVENT;
    nesting->documents += event->type == YAML_DOCUMENT_START_EVENT;
    nesting->anchors += event->type == YAML_ALIAS_EVENT ||
                        (event->type == YAML_SCALAR_EVENT && event->data.scalar.anchor) ||
                        (event->type == YAML_SEQUENCE_START_EVENT && event->data.sequence_start.anchor) ||
                        (event->type == YAML_MAPPING_START_EVENT && event->data.mapping_start.anchor);
    if (nesting->documents > 1)
        return scene_source_fail(source, line, "a second document starts here; a scene is one, remove the '---'");
    if (nesting->depth > DEEPEST_NESTING)
        return scene_source_fail(source, line, "nested too deep; a scene needs at most 4 levels");
    if (nesting->anchors > MOST_ANCHORS)
        return scene_source_fail(source, line, "more than %d anchors and aliases; write the values out", MOST_ANCHORS);
    return true;
}

/* Directives are refused: libyaml's time grows with the square of their number. */
static bool check_directives(struct scene_source *source, const char *bytes, size_t length)
{
    size_t line = 1;
    for (size_t i = 0; i < length; i++) {
        if (bytes[i] == '%' && (i == 0 || bytes[i - 1] == '\n' || bytes[i - 1] == '\r'))
            return scene_source_fail(source, line, "a directive of YAML (%%); a scene needs none, remove it");
        line += bytes[i] == '\n';
    }
    return true;
}

/* First a pass over the events, to refuse hostile text; then (`tree`) the tree. */
static bool parse(struct scene_source *source, const char *bytes, size_t length, bool tree)
{
    yaml_parser_t parser;
    struct nesting nesting = {0};
    if (!yaml_parser_initialize(&parser))
        return scene_source_memory(source);
    yaml_parser_set_input_string(&parser, (const unsigned char *)bytes, length);
    bool good = !tree || yaml_parser_load(&parser, &source->document) || parser_error(source, &parser, bytes);
    for (bool end = tree; good && !end;) {
        yaml_event_t event;
        good = yaml_parser_parse(&parser, &event) ? check_event(source, &event, &nesting)
                                                  : parser_error(source, &parser, bytes);
        end = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    return good;
}

struct string_view scene_source_scalar(const yaml_node_t *node)
{
    const char *text = (const char *)node->data.scalar.value;
    return node->type == YAML_SCALAR_NODE ? (struct string_view){text, text + node->data.scalar.length}
                                          : (struct string_view){0};
}

/* A key without a value, or one of the ways YAML spells "nothing". */
static bool is_null(const yaml_node_t *node)
{
    static const char *const spellings[] = {"", "~", "null", "Null", "NULL"};
    return scene_words_find(scene_source_scalar(node), spellings, SCENE_COUNT(spellings)) < SCENE_COUNT(spellings) &&
           node->data.scalar.style == YAML_PLAIN_SCALAR_STYLE;
}

bool scene_source_read(struct scene_source *source, const char *bytes, size_t length)
{
    if (!check_directives(source, bytes, length) || !parse(source, bytes, length, false) ||
        !parse(source, bytes, length, true))
        return false;
    const yaml_node_t *root = yaml_document_get_root_node(&source->document);
    bool good = !root || is_null(root) || scene_source_mapping(source, root, &scene_keys_whole, source->scene);
    yaml_document_delete(&source->document);
    return good;
}

size_t scene_source_item_count(const yaml_node_t *node)
{
    if (node->type != YAML_SEQUENCE_NODE)
        return 1;
    return (size_t)(node->data.sequence.items.top - node->data.sequence.items.start);
}

const yaml_node_t *scene_source_item(struct scene_source *source, const yaml_node_t *node, size_t i)
{
    return node->type == YAML_SEQUENCE_NODE
               ? yaml_document_get_node(&source->document, node->data.sequence.items.start[i])
               : node;
}

size_t scene_source_line(const yaml_node_t *node)
{
    return node->start_mark.line + 1;
}

bool scene_source_is(const yaml_node_t *node, const char *word)
{
    return scene_words_find(scene_source_scalar(node), &word, 1) == 0;
}

bool scene_source_wrong_type(struct scene_source *source, const yaml_node_t *node, const char *what,
                             const char *expected)
{
    if (node->type != YAML_SCALAR_NODE)
        return scene_source_fail_at(source, node, "'%s' is a %s; give %s", what,
                                    node->type == YAML_SEQUENCE_NODE ? "list" : "mapping", expected);
    return scene_source_fail_at(source, node, "'%s' is '%s'; give %s", what,
                                scene_words_show_view(scene_source_scalar(node)).text, expected);
}

bool scene_source_unknown(struct scene_source *source, const yaml_node_t *node, struct string_view word,
                          const char *what, const char *const *names, size_t count)
{
    struct scene_words_shown shown = scene_words_show_view(word);
    return scene_source_fail_at(source, node, "unknown %s '%s'; %s", what, shown.text,
                                scene_words_hint(shown.text, names, count, count).text);
}

static bool read_value(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *into)
{
    if (key->given)
        *(bool *)((char *)into + key->given) = true;
    return key->read(source, key, value, (char *)into + key->at);
}

/* Reads a key and its value; sets lines[k], and none[k] where the key may be `none` and is. */
static bool read_pair(struct scene_source *source, const yaml_node_pair_t *pair, const struct scene_mapping *mapping,
                      size_t *lines, bool *none, void *into)
{
    const yaml_node_t *name = yaml_document_get_node(&source->document, pair->key);
    const yaml_node_t *value = yaml_document_get_node(&source->document, pair->value);
    const struct scene_key *keys = mapping->keys;
    const char *names[2 * SCENE_KEYS_MOST] = {NULL}; /* of keys, then their aliases */
    const size_t count = mapping->count, all = 2 * count, line = scene_source_line(name);
    assert(count <= SCENE_KEYS_MOST);
    for (size_t i = 0; i < count; i++) {
        names[i] = keys[i].name;
        names[count + i] = keys[i].alias ? keys[i].alias : keys[i].name;
    }
    const size_t n = scene_words_find(scene_source_scalar(name), names, all), k = n % count;
    if (name->type != YAML_SCALAR_NODE)
        return scene_source_fail(source, line, "a key of '%s' is no text; write 'key: value'", mapping->name);
    if (n == all) { /* a near alias is proposed, but aliases are not listed */
        struct scene_words_shown shown = scene_words_show_view(scene_source_scalar(name));
        return scene_source_fail(source, line, "unknown key '%s'; %s", shown.text,
                                 scene_words_hint(shown.text, names, count, all).text);
    }
    struct scene_key key = keys[k];
    key.name = names[n];
    if (lines[k] != 0)
        return scene_source_fail(source, line, "'%s' is given twice, first in line %zu; remove one", key.name,
                                 lines[k]);
    lines[k] = line;
    none[k] = key.word && strcmp(key.word, "none") == 0 && scene_source_is(value, "none");
    if (is_null(value))
        return scene_source_fail(source, line, "'%s' has no value; give one or remove the line", key.name);
    return read_value(source, &key, value, into);
}

/* One demand of a rule, "b or c": its text in messages, and how many of its keys are given. */
struct demand {
    char text[160];
    size_t keys, given;
    size_t key; /* the last of them */
};

/* The next demand, advancing `*rest`; false at the end, or where *rest is NULL. */
static bool next_demand(struct demand *out, const char **rest, const struct scene_mapping *mapping, const size_t *lines)
{
    size_t used = 0;
    *out = (struct demand){0};
    for (bool more = *rest && **rest; more; out->keys++) {
        size_t length = strcspn(*rest, " ,"), k = 0;
        while (k < mapping->count && (strncmp(mapping->keys[k].name, *rest, length) || mapping->keys[k].name[length]))
            k++;
        assert(k < mapping->count);
        more = strncmp(*rest + length, " or ", 4) == 0;
        out->given += lines[k] > 0;
        out->key = k;
        used += (size_t)snprintf(out->text + used, sizeof out->text - used, "%s'%s'",
                                 out->keys == 0 ? ""
                                 : more         ? ", "
                                                : " or ",
                                 mapping->keys[k].name);
        *rest += length + (more ? 4 : strspn(*rest + length, ", "));
    }
    return out->keys > 0;
}

bool scene_source_rules(struct scene_source *source, const struct scene_mapping *mapping, const size_t *lines,
                        size_t line, const void *into)
{
    const struct scene_key whole = {.name = mapping->name, .needs = mapping->needs};
    struct demand demand;
    for (const char *ways = mapping->one_of; next_demand(&demand, &ways, mapping, lines);)
        if (demand.given != 1)
            return scene_source_fail(source, line, "'%s' has %s of %s; give one", mapping->name,
                                     demand.given ? "several" : "none", demand.text);
    for (size_t i = 0; i <= mapping->count; i++) {
        const struct scene_key *key = i == 0 ? &whole : &mapping->keys[i - 1];
        const size_t own = i == 0 ? line : lines[i - 1];
        const char *needs = key->needs, *excludes = key->excludes, *above = key->above;
        while (own && next_demand(&demand, &needs, mapping, lines))
            if (demand.given == 0)
                return scene_source_fail(source, own, "'%s' needs %s; add %s, or leave '%s' out", key->name,
                                         demand.text, demand.keys > 1 ? "one" : "it", key->name);
        while (own && next_demand(&demand, &excludes, mapping, lines))
            if (demand.given > 0)
                return scene_source_fail(source, own, "'%s' stands beside %s; remove either", key->name, demand.text);
        if (!own || !next_demand(&demand, &above, mapping, lines) || demand.given == 0)
            continue;
        const void *own_at = (const char *)into + key->at, *less_at = (const char *)into + mapping->keys[demand.key].at;
        const double more = *(const double *)own_at, less = *(const double *)less_at;
        const char *si = unit_si((enum unit_quantity)key->quantities);
        if (!(more > less))
            return scene_source_fail(source, own, "'%s' is %g %s, not above %s, %g %s; correct either", key->name, more,
                                     si, demand.text, less, si);
    }
    return true;
}

bool scene_source_mapping(struct scene_source *source, const yaml_node_t *node, const struct scene_mapping *mapping,
                          void *into)
{
    bool none[SCENE_KEYS_MOST] = {false};
    const bool whole = mapping == &scene_keys_whole;
    size_t own[SCENE_KEYS_MOST] = {0}, *lines = whole ? source->lines : own;
    const size_t line = scene_source_line(node);
    if (node->type != YAML_MAPPING_NODE)
        return scene_source_wrong_type(source, node, mapping->name, "'key: value' pairs");
    for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; pair++)
        if (!read_pair(source, pair, mapping, lines, none, into))
            return false;
    for (size_t k = 0; k < mapping->count; k++)
        lines[k] = none[k] ? 0 : lines[k];
    return whole || /* options of the command line come first */
           (scene_source_rules(source, mapping, lines, line, into) &&
            (!mapping->then || mapping->then(source, lines, line, into)));
}

bool scene_source_within(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                         void *field)
{
    return scene_source_mapping(source, value, key->within, field);
}

size_t scene_keys_find(const char *name)
{
    size_t k = 0;
    while (k + 1 < scene_key_count && strcmp(scene_keys[k].name, name) != 0)
        k++;
    assert(strcmp(scene_keys[k].name, name) == 0);
    return k;
}

size_t scene_keys_line(const struct scene_source *source, const char *name)
{
    return source->lines[scene_keys_find(name)];
}

bool scene_source_option(struct scene_source *source, const struct scene_key *key, const char *option, const char *text,
                         void *into)
{
    const yaml_node_t node = {.type = YAML_SCALAR_NODE,
                              .data.scalar = {.value = (yaml_char_t *)text, .length = strlen(text)}};
    source->option = option;
    bool good = read_value(source, key, &node, into);
    source->option = NULL;
    return good;
}

bool scene_source_quantity_of(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                              void *field)
{
    struct scene_quantity *out = field;
    struct string_view text = scene_source_scalar(value);
    if (!text.start || !scene_quantity_read(out, text, key->quantities))
        return scene_source_wrong_type(source, value, key->name, scene_quantity_help(key->quantities).text);
    const char *si = unit_si(out->kind);
    if (!(out->value >= key->least && out->value <= key->most))
        return scene_source_fail_at(source, value, "'%s' is %s; allowed is %g to %g%s%s", key->name,
                                    scene_words_show_view(text).text, key->least, key->most, *si ? " " : "", si);
    return true;
}

bool scene_source_quantity(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                           void *field)
{
    struct scene_quantity quantity;
    if (key->word && scene_source_is(value, key->word))
        return true;
    if (!scene_source_quantity_of(source, key, value, &quantity))
        return false;
    *(double *)field = quantity.value;
    return true;
}

bool scene_source_pair(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    double *pair = field;
    if (scene_source_item_count(value) != 2)
        return scene_source_wrong_type(source, value, key->name, "two lengths, as [10 mm, 20 mm]");
    return scene_source_quantity(source, key, scene_source_item(source, value, 0), &pair[0]) &&
           scene_source_quantity(source, key, scene_source_item(source, value, 1), &pair[1]);
}

bool scene_source_whole(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct string_view text = scene_source_scalar(value);
    struct scene_quantity number;
    bool is_number = text.start && scene_quantity_read(&number, text, UNIT_NUMBER);
    if (!is_number || (isfinite(number.value) && number.value != floor(number.value)))
        return scene_source_wrong_type(source, value, key->name, "a whole number");
    if (!scene_source_quantity_of(source, key, value, &number))
        return false;
    *(size_t *)field = (size_t)number.value;
    return true;
}

bool scene_source_choice(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                         void *field)
{
    size_t choice = scene_words_find(scene_source_scalar(value), key->choices, key->choice_count);
    if (value->type != YAML_SCALAR_NODE)
        return scene_source_wrong_type(source, value, key->name, "one word");
    if (choice == key->choice_count)
        return scene_source_unknown(source, value, scene_source_scalar(value), key->name, key->choices,
                                    key->choice_count);
    *(unsigned *)field = (unsigned)choice; /* an enum of small constants is unsigned in gcc and clang */
    return true;
}

/* The scalar as a text of printable characters, not empty; NULL: failed. */
static const char *read_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *node)
{
    const struct string_view text = scene_source_scalar(node);
    bool good = true;
    if (node->type != YAML_SCALAR_NODE)
        good = scene_source_wrong_type(source, node, key->name, "text");
    else if (text.start == text.end)
        good = scene_source_fail_at(source, node, "'%s' is empty; give a text or remove the line", key->name);
    for (const char *p = text.start; good && p < text.end; p++)
        if ((unsigned char)*p < 0x20 || *p == 0x7f)
            good = scene_source_fail_at(source, node, "'%s' has a line end or control character inside; remove it",
                                        key->name);
    return good ? text.start : NULL;
}

bool scene_source_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    const char *text = read_text(source, key, value);
    return text && ((*(char **)field = strdup(text)) || scene_source_memory(source));
}

bool scene_source_short_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                             void *field)
{
    const char *text = read_text(source, key, value);
    size_t size = (size_t)key->most;
    if (text && strlen(text) >= size)
        return scene_source_fail_at(source, value, "'%s' is longer than %zu bytes; shorten it", key->name, size - 1);
    if (text)
        memcpy(field, text, strlen(text) + 1);
    return text;
}

bool scene_source_unit(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct scene_key text = *key;
    struct unit unit;
    text.most = UNIT_LENGTH;
    return scene_source_short_text(source, &text, value, field) &&
           ((unit_read(&unit, field, strlen(field)) && unit_of(&unit, key->quantities)) ||
            scene_source_fail_at(source, value, "'%s' is '%s'; understood: %s", key->name, scene_words_show(field).text,
                                 unit_known(key->quantities).text));
}
