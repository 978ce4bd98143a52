/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The text of a scene as a tree of nodes with their lines, and readers of values. Private to src/scene. False means
 * failure: STATUS_SCENE with file, line and key, or STATUS_MEMORY, in source->status. */
#ifndef SCENE_SCENE_SOURCE_H
#define SCENE_SCENE_SOURCE_H

#include "scene/scene.h"

#include <yaml.h>

enum { SCENE_KEYS_MOST = 48 }; /* of one mapping */

struct scene_mapping;
struct scene_source {
    struct scene *scene; /* with path and directory */
    struct status *status;
    yaml_document_t document;
    const struct scene_overrides *overrides;
    const char *option;            /* of the command line that is being read; NULL: the scene is */
    bool effects_overridden;       /* by the command line */
    size_t lines[SCENE_KEYS_MOST]; /* of scene_keys: where the scene gives them; 0: it does not */
    size_t file_count;             /* of all surfaces so far */
};

struct scene_key;
/** Reads a value into `field`, which lies at `key->at` of what the mapping is read into. */
typedef bool scene_reader(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                          void *field);

/** One key of a mapping: how its value is read and where it goes. */
struct scene_key {
    const char *name; /* in a reader's argument: as the scene spells it, this or `alias` */
    const char *text; /* meaning and default; docs/scene.md and the manual page are made from it */
    scene_reader *read;
    size_t at;
    double least, most;         /* numbers: range, inclusive; short text: `most` is the size of the array */
    const char *const *choices; /* words that the value may be, in the order of their enum */
    size_t choice_count;
    const char *word;    /* numbers: a word that leaves the default, or NULL */
    unsigned quantities; /* quantities: what they may be, enum unit_quantity bits */
    const char *alias;   /* an older name, or NULL */
    size_t given;        /* offset of a bool that becomes true; 0: none */
    /* Rules about other keys of its mapping, or NULL. A list: "a, b or c" is a, and one of b and c. */
    const char *needs;                  /* these must be given, too */
    const char *excludes;               /* none of these may be given */
    const char *above;                  /* quantities: the key whose number must be less */
    const struct scene_mapping *within; /* of the value, or of each item; NULL: none, or made while reading */
};

/** The keys of scene.yaml, which lie in a struct scene. */
extern const struct scene_key scene_keys[];
extern const size_t scene_key_count;
extern const struct scene_mapping scene_keys_whole;
extern const struct scene_key *const scene_budget_key; /* of struct scene_direct */
/** Index of the key of that name, which exists; the line that gives it, 0: none does. */
size_t scene_keys_find(const char *name);
size_t scene_keys_line(const struct scene_source *source, const char *name);

/** Parses `bytes` and reads the keys of the scene; their rules are checked later. Errors: not YAML, nested too
 * deep, more than one document, those of the keys. */
MUST_CHECK bool scene_source_read(struct scene_source *source, const char *bytes, size_t length);
/** A mapping: its name in messages, its keys, and its rules, lists as those of a key. */
struct scene_mapping {
    const char *name;
    const struct scene_key *keys;
    size_t count;
    const char *needs;  /* these must be given */
    const char *one_of; /* of "a or b" exactly one must be */
    /* Called once it is read and its rules hold, or NULL; it stands in line `line`, its keys in lines[k]. */
    bool (*then)(struct scene_source *source, const size_t *lines, size_t line, void *into);
};
#define SCENE_MAPPING(name, keys)    SCENE_RULED(name, keys, .needs = NULL)
#define SCENE_RULED(name, keys, ...) (&(const struct scene_mapping){(name), (keys), SCENE_COUNT(keys), __VA_ARGS__})
/** Fails where a rule is broken. Key k stands in lines[k] (0: not given), the mapping in `line`, values in `into`. */
bool scene_source_rules(struct scene_source *source, const struct scene_mapping *mapping, const size_t *lines,
                        size_t line, const void *into);
/** Reads a mapping into `into`, checks its rules and calls `then`; of scene_keys_whole it only fills source->lines. A
 * key that may be `none` and is counts as not given. */
MUST_CHECK bool scene_source_mapping(struct scene_source *source, const yaml_node_t *node,
                                     const struct scene_mapping *mapping, void *into);
/** Reads an option of the command line as the value of `key`. Error: STATUS_USAGE. */
bool scene_source_option(struct scene_source *source, const struct scene_key *key, const char *option, const char *text,
                         void *into);

/** Items of a node that is a list, or itself the one item. */
size_t scene_source_item_count(const yaml_node_t *node);
const yaml_node_t *scene_source_item(struct scene_source *source, const yaml_node_t *node, size_t i);
size_t scene_source_line(const yaml_node_t *node);
bool scene_source_is(const yaml_node_t *node, const char *word);

/** Fails with "path:line: " before the message, or with the option being read. */
bool scene_source_fail(struct scene_source *source, size_t line, const char *format, ...) PRINTF_LIKE(3, 4);
#define FAIL_KEY(source, key, ...)              scene_source_fail((source), scene_keys_line((source), (key)), __VA_ARGS__)
#define scene_source_fail_at(source, node, ...) scene_source_fail((source), scene_source_line(node), __VA_ARGS__)
/** Fails: the value of `what` is not of the type `expected` ("a number"). */
bool scene_source_wrong_type(struct scene_source *source, const yaml_node_t *node, const char *what,
                             const char *expected);
/** Fails: `word` of the scalar `node` is no known `what` ("effect"), which are `names`. */
bool scene_source_unknown(struct scene_source *source, const yaml_node_t *node, struct string_view word,
                          const char *what, const char *const *names, size_t count);
/** The scalar's characters; nothing of a list or a mapping. */
struct string_view scene_source_scalar(const yaml_node_t *node);
bool scene_source_memory(struct scene_source *source);

/** For scene_key.read; the field is a double in SI, two of them, a size_t, enum, malloc'ed char *, or char array. */
scene_reader scene_source_quantity, scene_source_pair, scene_source_whole, scene_source_choice, scene_source_text,
    scene_source_short_text;
/** The mapping key->within; the spelling of a unit of key->quantities, into a char[UNIT_LENGTH]; a quantity with its
 * kind and unit, into a struct scene_quantity. */
scene_reader scene_source_within, scene_source_unit, scene_source_quantity_of;

/* Parts of a key's row; `place` is an offsetof(). */
#define SCENE_COUNT(array) (sizeof(array) / sizeof *(array))
#define SCENE_QUANTITY(place, kinds, lowest, highest)                                                                  \
    scene_source_quantity, .at = (place), .quantities = (kinds), .least = (lowest), .most = (highest)
#define SCENE_NUMBER(place, lowest, highest) SCENE_QUANTITY(place, UNIT_NUMBER, lowest, highest)
#define SCENE_WHOLE(place, lowest, highest)                                                                            \
    scene_source_whole, .at = (place), .quantities = UNIT_NUMBER, .least = (lowest), .most = (highest)
#define SCENE_CHOICE(place, spellings)                                                                                 \
    scene_source_choice, .at = (place), .choices = (spellings), .choice_count = SCENE_COUNT(spellings)
extern const char *const scene_source_yes[2];
#define SCENE_YES(place) SCENE_CHOICE(place, scene_source_yes)
#define SCENE_HARDNESS(place)                                                                                          \
    scene_surfaces_hardness, .at = (place), .quantities = UNIT_PRESSURE, .least = 1e3, .most = 1e12,                   \
                             .alias = "hardness_Pa", .within = &scene_surfaces_vickers
#define SCENE_MEASURED(place)         scene_source_within, .at = (place), .within = &scene_surfaces_measured
#define SCENE_SHORT_TEXT(place, size) scene_source_short_text, .at = (place), .most = (size)

/** `effects` with those they build on. */
unsigned scene_keys_with_needed(unsigned effects);

/** The list `surfaces`, into a struct scene. */
scene_reader scene_surfaces_read;
extern const struct scene_mapping scene_surfaces_each;
/** rigid | same | a material's name | a mapping of properties | {surface: file, material: ..., x_unit, z_unit}, into
 * source->scene. */
scene_reader scene_surfaces_counterface;
/** A pressure, HV 120 or {c1, c2}, into a struct scene_bodies. */
scene_reader scene_surfaces_hardness;
extern const struct scene_mapping scene_surfaces_vickers;
/** A built-in name or a mapping of properties, into a struct material. */
scene_reader scene_surfaces_material;
/** What was measured, into a struct scene_measured. */
extern const struct scene_mapping scene_surfaces_measured;
/** One file or a list of them, each checked to exist, into a struct scene_files. */
scene_reader scene_surfaces_files;

/** What bodies lack for an effect, for a message: "'resistivity'; add it to 'material' of surface 'b'"; `owner`: the
 * surface's name, NULL: the scene's bodies. False: nothing. */
struct scene_lack_words {
    char text[240];
};
bool scene_lack_words(struct scene_lack_words *out, const struct scene_bodies *bodies, const char *owner,
                      const struct effect_row *effect);

/** Adds to `files` those of `kind` (S_IFREG, S_IFDIR) whose last component matches that of `pattern` (fnmatch(3)),
 * below the scene's directory unless it is absolute, in natural order, without hidden files and sidecars; perhaps none.
 * Errors: STATUS_IO: the directory cannot be listed; STATUS_SCENE: LIMIT_FILES; STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_match(struct scene_files *files, const struct scene *scene, const char *pattern,
                                              mode_t kind, struct status *status);

/** Adds one file. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code scene_files_add(struct scene_files *files, const char *file, struct status *status);

/** Adds to a scene without surfaces one for each scan of its directory, as scene_read() says, and one for each
 * sub-directory of repeated scans; scene->passed_over names the rest. Errors: STATUS_IO, STATUS_MEMORY. */
void scene_files_list(struct scene *scene, struct scene_source *source);

/** The name of a surface read from `file`: its last component, without the ending unless `ending`; malloc'ed. */
char *scene_files_name(const char *file, bool ending);
void scene_files_free(struct scene_files *files);
void scene_surfaces_free(struct scene_surface *surface);

/** How the parts are shaped, into a struct scene. */
extern const struct scene_mapping scene_shape_ways;
/** Completes the sides of the nominal area, once that is known, and the fields, once the bodies are. */
void scene_shape_size(struct scene *scene, struct scene_source *source);
void scene_shape_complete(struct scene *scene, struct scene_source *source);
void scene_shape_free(struct scene *scene);

/* Into a struct scene: `targets`, a list of {quantity: value}; `limits`, {quantity: {most: value, least: value}}. */
scene_reader scene_asked_read;
/** Turns them into the models' quantities, once the nominal area is known. */
void scene_asked_complete(struct scene *scene, struct scene_source *source);

#endif
