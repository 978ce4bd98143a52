/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The text of a scene as a tree of nodes that know their lines, and readers for its values. Private to src/scene.
 * What returns false has failed: STATUS_SCENE with file, line and key, or STATUS_MEMORY, in source->status. */
#ifndef SCENE_SCENE_SOURCE_H
#define SCENE_SCENE_SOURCE_H

#include "scene/scene.h"
#include "scene/scene_quantity.h"
#include <yaml.h>

struct scene_source {
    struct scene *scene; /* that is read: its path and directory are known */
    struct status *status;
    yaml_document_t document;
    /* What is checked only once the command line has had its say: */
    size_t effect_line[EFFECT_COUNT]; /* where an effect is asked for, 0: not in the file */
    size_t call_line[EFFECT_COUNT];   /* where the key is given that calls for it, 0: it is not */
    size_t baseline_line, operating_line;
    size_t hardness_line;
    double mean_free_path_m; /* where the scene gives one */
    size_t mean_free_path_line;
    size_t file_count; /* of all surfaces so far */
};

enum { SCENE_KEYS_MOST = 48 }; /* of one mapping */

/** One key of a mapping: how its value is read and where it goes. */
struct scene_key {
    const char *name; /* what a reader is given has the one the scene uses, `alias` or this */
    bool (*read)(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
    void *field;
    double least, most;         /* numbers: range, inclusive; short text: `most` is the size of the array */
    const char *const *choices; /* words that the value may be, in the order of their enum */
    size_t choice_count;
    const char *word;    /* numbers: a word that leaves the default, or NULL */
    unsigned quantities; /* quantities: what they may be, enum unit_quantity bits */
    const char *alias;   /* an older name, or NULL: not shown in messages where the other will do */
    const char *given;   /* the name by which it does; set with `line` */
    size_t line;         /* where the scene gives it, 0: it does not; set by scene_source_mapping() */
};

/** Parses `bytes` and calls `read` with the outermost node, unless the text says nothing. Errors: not YAML, nested too
 * deep, more than one document, those of `read`. */
MUST_CHECK bool scene_source_read(struct scene_source *source, const char *bytes, size_t length,
                                  bool (*read)(struct scene_source *source, const yaml_node_t *root));
/** Reads a mapping called `what`. */
MUST_CHECK bool scene_source_mapping(struct scene_source *source, const yaml_node_t *node, const char *what,
                                     struct scene_key *keys, size_t count);
/** The line of a key of such a mapping. */
size_t scene_source_line_of(const struct scene_key *keys, const char *name);

/** Is it a mapping with the key `name`? */
bool scene_source_has(struct scene_source *source, const yaml_node_t *node, const char *name);
/** Items of a node that is a list or stands for a list of one. */
size_t scene_source_item_count(const yaml_node_t *node);
const yaml_node_t *scene_source_item(struct scene_source *source, const yaml_node_t *node, size_t i);
size_t scene_source_line(const yaml_node_t *node);
/** Is it the plain or quoted scalar `word`? */
bool scene_source_is(const yaml_node_t *node, const char *word);

/** Fails with "path:line: " before the message. */
bool scene_source_fail(struct scene_source *source, size_t line, const char *format, ...) PRINTF_LIKE(3, 4);
/** Fails: the value of `what` is not of the type `expected` ("a number"). */
bool scene_source_wrong_type(struct scene_source *source, const yaml_node_t *node, const char *what,
                             const char *expected);
/** Fails: the scalar `node` is no known `what` ("effect"); `names` may go on beyond `count` with names that are near
 * enough to propose, but not to list, up to `all`. */
bool scene_source_unknown(struct scene_source *source, const yaml_node_t *node, const char *what,
                          const char *const *names, size_t count, size_t all);
/** Fails: out of memory. */
bool scene_source_memory(struct scene_source *source);

/** To stand in scene_key.read; the field is a double, a size_t, an enum, a malloc'ed char *, a char array. */
/** A number in SI or, where the quantities have units, with its unit. */
bool scene_source_quantity(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
/** The same, with all there is to know of it. */
bool scene_source_quantity_of(struct scene_quantity *out, struct scene_source *source, const struct scene_key *key,
                              const yaml_node_t *value);
bool scene_source_whole(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
bool scene_source_choice(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
bool scene_source_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);
bool scene_source_short_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value);

/* Parts of a key's row. */
#define SCENE_COUNT(array) (sizeof(array) / sizeof *(array))
#define SCENE_QUANTITY(number, kinds, lowest, highest)                                                                 \
    scene_source_quantity, &(number), .quantities = (kinds), .least = (lowest), .most = (highest)
#define SCENE_NUMBER(number, lowest, highest) SCENE_QUANTITY(number, UNIT_NUMBER, lowest, highest)
#define SCENE_WHOLE(number, lowest, highest)                                                                           \
    scene_source_whole, &(number), .quantities = UNIT_NUMBER, .least = (lowest), .most = (highest)
#define SCENE_CHOICE(choice, spellings)                                                                                \
    scene_source_choice, &(choice), .choices = (spellings), .choice_count = SCENE_COUNT(spellings)
#define SCENE_SHORT_TEXT(array) scene_source_short_text, (array), .most = sizeof(array)

#endif
