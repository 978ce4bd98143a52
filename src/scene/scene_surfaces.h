/* The surfaces that the text of a scene lists. Private to src/scene. */
#ifndef SCENE_SCENE_SURFACES_H
#define SCENE_SCENE_SURFACES_H

#include "scene/scene.h"
#include "scene/scene_source.h"

/** Reads `surfaces` into the struct scene; to stand in scene_key.read. */
enum status_code scene_surfaces_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field);

/** Frees what one surface holds. */
void scene_surfaces_free(struct scene_surface *surface);

/** `directory`/`file` (or `file` when that is absolute), malloc'ed; NULL: out of memory. */
char *scene_surfaces_path(const char *directory, const char *file);
/** The name of a surface read from `file`: its last component, without the ending unless `ending`; malloc'ed. */
char *scene_surfaces_name(const char *file, bool ending);

/** Reads one file or a list of them, each checked to exist, into a struct scene_surface. */
enum status_code scene_surfaces_files(struct scene_source *source, const struct scene_key *key,
                                      const yaml_node_t *value, void *field);

/** Reads `column`, a number or a title, or two of them, x and z, into a struct scene_surface. */
enum status_code scene_surfaces_column(struct scene_source *source, const struct scene_key *key,
                                       const yaml_node_t *value, void *field);

#endif
