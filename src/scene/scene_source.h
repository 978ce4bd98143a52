/* The text of a scene as a tree of nodes that know their lines, and readers for its values. Private to src/scene. */
#ifndef SCENE_SCENE_SOURCE_H
#define SCENE_SCENE_SOURCE_H

#include "base/status.h"
#include "contact/effect.h"
#include <stdbool.h>
#include <stddef.h>
#include <yaml.h>

struct scene_source {
    const char *path;      /* of the file, named in every message */
    const char *directory; /* that it is in */
    struct status *status;
    yaml_document_t document;
    bool open; /* `document` is to be deleted */
    /* What is checked only once the command line has had its say: */
    size_t effect_line[EFFECT_COUNT]; /* where an effect is asked for, 0: not in the file */
    size_t baseline_line;
    bool counterface_elastic; /* a second body, not a rigid flat */
    bool counterface_same;    /* and it is whatever the material is */
    size_t file_count;        /* of all surfaces so far */
};

/** One key of a mapping: how its value is read and where it goes. */
struct scene_key {
    const char *name;
    enum status_code (*read)(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                             void *field);
    size_t offset;              /* of the field in the struct that the mapping fills */
    double least, most;         /* numbers: range, inclusive; short text: `most` is the size of the array */
    const char *const *choices; /* words that the value may be, in the order of their enum */
    size_t choice_count;
    const char *word; /* numbers: a word that leaves the default, or NULL */
};

/** Parses `bytes`. Errors: STATUS_SCENE (not YAML, nested too deep, more than one document), STATUS_MEMORY. */
MUST_CHECK enum status_code scene_source_open(struct scene_source *source, const char *bytes, size_t length);
void scene_source_close(struct scene_source *source);
/** The outermost node, NULL when the text says nothing. */
const yaml_node_t *scene_source_root(struct scene_source *source);
/** Node number `index` (as items and pairs hold them). */
const yaml_node_t *scene_source_node(struct scene_source *source, int index);
/** Items of a node that is a list or stands for a list of one: item `i`, counted by scene_value_count(). */
size_t scene_source_item_count(const yaml_node_t *node);
const yaml_node_t *scene_source_item(struct scene_source *source, const yaml_node_t *node, size_t i);
size_t scene_source_line(const yaml_node_t *node);
/** Is it the plain or quoted scalar `word`? */
bool scene_source_is(const yaml_node_t *node, const char *word);

/** STATUS_SCENE with "path:line: " before the message. */
enum status_code scene_source_fail(struct scene_source *source, size_t line, const char *format, ...) PRINTF_LIKE(3, 4);
/** STATUS_SCENE: the value of `what` is not of the type `expected` ("a number"). */
enum status_code scene_source_wrong_type(struct scene_source *source, const yaml_node_t *node, const char *what,
                                         const char *expected);
/** STATUS_SCENE: the scalar `node` is no known `what` ("effect"). */
enum status_code scene_source_unknown(struct scene_source *source, const yaml_node_t *node, const char *what,
                                      const char *const *names, size_t count);

/** Reads a mapping called `what` into the struct at `base`. `lines` gets the line of each of the `count` keys, 0 for
 * those not given. */
MUST_CHECK enum status_code scene_source_mapping(struct scene_source *source, const yaml_node_t *node, const char *what,
                                                 const struct scene_key *keys, size_t count, void *base, size_t *lines);

#endif
