#include "scene/scene_source.h"
#include "scene/scene_words.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* A scene needs 4 levels and few anchors. libyaml's time grows with the square of both, so they are bounded. */
enum { DEEPEST_NESTING = 16, MOST_ANCHORS = 1000 };

enum status_code scene_source_fail(struct scene_source *source, size_t line, const char *format, ...)
{
    char message[sizeof source->status->message];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    return status_fail(source->status, STATUS_SCENE, "%s:%zu: %s", source->path, line, message);
}

static enum status_code parser_error(struct scene_source *source, const yaml_parser_t *parser, const char *bytes)
{
    if (parser->error == YAML_MEMORY_ERROR)
        return status_memory(source->status);
    size_t line = parser->problem_mark.line + 1;
    if (parser->error == YAML_READER_ERROR) { /* knows an offset only */
        line = 1;
        for (size_t i = 0; i < parser->problem_offset; i++)
            line += bytes[i] == '\n';
    }
    return scene_source_fail(source, line, "not valid YAML: %s; check brackets, quotes and indentation",
                             parser->problem ? parser->problem : "it cannot be read");
}

struct shape {
    int depth, documents, anchors;
};

static enum status_code check_event(struct scene_source *source, const yaml_event_t *event, struct shape *shape)
{
    size_t line = event->start_mark.line + 1;
    bool start = event->type == YAML_SEQUENCE_START_EVENT || event->type == YAML_MAPPING_START_EVENT;
    shape->depth += start;
    shape->depth -= event->type == YAML_SEQUENCE_END_EVENT || event->type == YAML_MAPPING_END_EVENT;
    shape->documents += event->type == YAML_DOCUMENT_START_EVENT;
    shape->anchors += event->type == YAML_ALIAS_EVENT ||
                      (event->type == YAML_SCALAR_EVENT && event->data.scalar.anchor) ||
                      (event->type == YAML_SEQUENCE_START_EVENT && event->data.sequence_start.anchor) ||
                      (event->type == YAML_MAPPING_START_EVENT && event->data.mapping_start.anchor);
    if (shape->depth > DEEPEST_NESTING)
        return scene_source_fail(source, line, "nested too deep; a scene needs at most 4 levels");
    if (shape->documents > 1)
        return scene_source_fail(source, line, "a second document starts here; a scene is one, remove the '---'");
    if (shape->anchors > MOST_ANCHORS)
        return scene_source_fail(source, line, "more than %d anchors and aliases; write the values out", MOST_ANCHORS);
    return STATUS_OK;
}

/* A first pass over the events, so that nothing hostile reaches the tree builder. */
static enum status_code check_shape(struct scene_source *source, const char *bytes, size_t length)
{
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return status_memory(source->status);
    yaml_parser_set_input_string(&parser, (const unsigned char *)bytes, length);
    struct shape shape = {0};
    enum status_code code = STATUS_OK;
    for (bool end = false; code == STATUS_OK && !end;) {
        yaml_event_t event;
        if (!yaml_parser_parse(&parser, &event)) {
            code = parser_error(source, &parser, bytes);
            break;
        }
        end = event.type == YAML_STREAM_END_EVENT;
        code = check_event(source, &event, &shape);
        yaml_event_delete(&event);
    }
    yaml_parser_delete(&parser);
    return code;
}

enum status_code scene_source_open(struct scene_source *source, const char *bytes, size_t length)
{
    enum status_code code = check_shape(source, bytes, length);
    if (code != STATUS_OK)
        return code;
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return status_memory(source->status);
    yaml_parser_set_input_string(&parser, (const unsigned char *)bytes, length);
    source->open = yaml_parser_load(&parser, &source->document) != 0;
    if (!source->open)
        code = parser_error(source, &parser, bytes);
    yaml_parser_delete(&parser);
    return code;
}

void scene_source_close(struct scene_source *source)
{
    if (source->open)
        yaml_document_delete(&source->document);
    source->open = false;
}

/* A key without a value, or one of the ways YAML spells "nothing". */
static bool is_null(const yaml_node_t *node)
{
    static const char *const spellings[] = {"", "~", "null", "Null", "NULL"};
    if (node->type != YAML_SCALAR_NODE || node->data.scalar.style != YAML_PLAIN_SCALAR_STYLE)
        return false;
    size_t count = sizeof spellings / sizeof *spellings;
    return scene_words_find((const char *)node->data.scalar.value, node->data.scalar.length, spellings, count) < count;
}

const yaml_node_t *scene_source_root(struct scene_source *source)
{
    const yaml_node_t *root = yaml_document_get_root_node(&source->document);
    return root && is_null(root) ? NULL : root;
}

const yaml_node_t *scene_source_node(struct scene_source *source, int index)
{
    return yaml_document_get_node(&source->document, index);
}

size_t scene_source_item_count(const yaml_node_t *node)
{
    if (node->type != YAML_SEQUENCE_NODE)
        return 1;
    return (size_t)(node->data.sequence.items.top - node->data.sequence.items.start);
}

const yaml_node_t *scene_source_item(struct scene_source *source, const yaml_node_t *node, size_t i)
{
    return node->type == YAML_SEQUENCE_NODE ? scene_source_node(source, node->data.sequence.items.start[i]) : node;
}

size_t scene_source_line(const yaml_node_t *node)
{
    return node->start_mark.line + 1;
}

bool scene_source_is(const yaml_node_t *node, const char *word)
{
    return node->type == YAML_SCALAR_NODE && node->data.scalar.length == strlen(word) &&
           memcmp(node->data.scalar.value, word, strlen(word)) == 0;
}

enum status_code scene_source_wrong_type(struct scene_source *source, const yaml_node_t *node, const char *what,
                                         const char *expected)
{
    size_t line = scene_source_line(node);
    if (node->type == YAML_SEQUENCE_NODE)
        return scene_source_fail(source, line, "'%s' is a list; give %s", what, expected);
    if (node->type == YAML_MAPPING_NODE)
        return scene_source_fail(source, line, "'%s' is a mapping; give %s", what, expected);
    struct scene_words_shown shown = scene_words_show((const char *)node->data.scalar.value, node->data.scalar.length);
    return scene_source_fail(source, line, "'%s' is '%s'; give %s", what, shown.text, expected);
}

enum status_code scene_source_unknown(struct scene_source *source, const yaml_node_t *node, const char *what,
                                      const char *const *names, size_t count)
{
    const char *word = (const char *)node->data.scalar.value;
    return scene_source_fail(source, scene_source_line(node), "unknown %s '%s'; %s", what,
                             scene_words_show(word, node->data.scalar.length).text,
                             scene_words_hint(word, names, count).text);
}

static enum status_code read_pair(struct scene_source *source, const yaml_node_pair_t *pair, const char *what,
                                  const struct scene_key *keys, size_t count, void *base, size_t *lines)
{
    const yaml_node_t *name = scene_source_node(source, pair->key), *value = scene_source_node(source, pair->value);
    enum { MOST_KEYS = 32 };
    const char *names[MOST_KEYS];
    for (size_t i = 0; i < count && i < MOST_KEYS; i++)
        names[i] = keys[i].name;
    size_t line = scene_source_line(name);
    if (name->type != YAML_SCALAR_NODE)
        return scene_source_fail(source, line, "a key of '%s' is no text; write 'key: value'", what);
    size_t k = scene_words_find((const char *)name->data.scalar.value, name->data.scalar.length, names, count);
    if (k == count)
        return scene_source_unknown(source, name, "key", names, count);
    if (lines[k] != 0)
        return scene_source_fail(source, line, "'%s' is given twice, first in line %zu; remove one", keys[k].name,
                                 lines[k]);
    lines[k] = line;
    if (is_null(value))
        return scene_source_fail(source, line, "'%s' has no value; give one or remove the line", keys[k].name);
    return keys[k].read(source, &keys[k], value, (char *)base + keys[k].offset);
}

enum status_code scene_source_mapping(struct scene_source *source, const yaml_node_t *node, const char *what,
                                      const struct scene_key *keys, size_t count, void *base, size_t *lines)
{
    memset(lines, 0, count * sizeof *lines);
    if (node->type != YAML_MAPPING_NODE)
        return scene_source_wrong_type(source, node, what, "'key: value' pairs");
    enum status_code code = STATUS_OK;
    const yaml_node_pair_t *top = node->data.mapping.pairs.top;
    for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start; code == STATUS_OK && pair < top; pair++)
        code = read_pair(source, pair, what, keys, count, base, lines);
    return code;
}
