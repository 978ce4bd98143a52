/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `init`: a scene for the scans of a directory, with what they do not say left to be filled in. */
#include "base/limits.h"
#include "base/mustache.h"
#include "cli/command.h"
#include "profile/profile.h"
#include "scene/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const struct argp command_init_argp = {
    .parser = command_directory,
    .args_doc = "DIR",
    .doc =
        "Writes DIR/scene.yaml, whole or not at all and never over another: the surfaces that the names of the files "
        "tell, files that differ in a number or letter at the end alone as repeated scans of one, or in a direction "
        "(x, y; 0, 90; across, along; q, l; perp, par) as scans in two, and, behind a #, "
        "the units where a file has none, material, loads and targets, to be filled in."};

/** Adds a text inside the double quotes of YAML, where characters that may not be shown are escaped in the same way. */
static void add_quoted(struct text *out, const char *string)
{
    while (*string) {
        bool mark = *string == '"' || *string == '\\';
        struct text_shown shown = mark ? (struct text_shown){{'\\', *string}, 1} : text_show(string);
        text_add(out, "%s", shown.text);
        string += shown.bytes;
    }
}

/** Paths, those that a scene can name: of UTF-8 and without control characters. */
static json_t *paths_json(const struct scene_files *files)
{
    json_t *paths = json_array();
    for (size_t i = 0; i < files->count; i++) {
        const char *c = files->path[i];
        while ((unsigned char)*c >= 0x20 && *c != 0x7f)
            c++;
        json_array_append_new(paths, *c ? NULL : json_string(files->path[i]));
    }
    return paths;
}

/** Adds the units that a scan of a surface lacks, or else the reason why it cannot be used. */
static void add_lacks(json_t *view, const struct scene *scene, const char *file)
{
    OWNED(memory_free) char *path = scene_file_path(scene, file);
    OWNED(scan_free) struct scan scan = {0};
    struct status problem = {0};
    enum status_code code = scan_read(&scan, path ? path : file, &(struct scan_options){0}, &problem);
    if (code == STATUS_OK && scan.kind == SCAN_PROFILE) { /* flat, or with too many gaps? */
        OWNED(profile_free) struct profile profile = {0};
        if ((code = profile_make(&profile, &scan, 0, &profile_defaults, &problem)) != STATUS_OK)
            (void)status_prefix(&problem, "%s", path ? path : file);
    }
    const bool said = *scan.unknown_unit[0] || *scan.unknown_unit[1]; /* a unit, which is none of length */
    const bool units = code == STATUS_SCAN && scan.units_lacking && !said && !(*scan.x_unit && *scan.z_unit);
    if (units && !*scan.x_unit)
        json_object_set_new(view, "x_unit", json_string("mm"));
    if (units && !*scan.z_unit)
        json_object_set_new(view, "z_unit", json_string("um"));
    if (code != STATUS_OK && !units)
        json_object_set_new(view, "problem", json_shown(problem.message));
    status_lost = status_lost || !path;
}

static enum status_code add_surface(json_t *view, const struct scene *scene, const struct scene_surface *surface,
                                    struct status *status)
{
    json_t *files = paths_json(&surface->files), *along = paths_json(&surface->along),
           *name = json_shown(surface->name);
    bool several = surface->files.count > 1, folder = strchr(surface->files.path[0], '/');
    bool good = json_string_length(name) <= limit_most(LIMIT_NAME_BYTES) &&
                json_array_size(files) == surface->files.count && json_array_size(along) == surface->along.count;
    json_t *one =
        json_pack("{s:o, s:o, s:b, s:b, s:o, s:b, s:o}", "name", name, "files", files, "folder", several && folder,
                  "alike", several && !folder, "count", json_sprintf("%zu", surface->files.count), "directions",
                  surface->along.count > 0, "along", along);
    if (surface->files.count == 1)
        json_object_set(one, "file", json_array_get(json_object_get(one, "files"), 0));
    for (size_t k = surface->along.count; good && k-- > 0;)
        add_lacks(one, scene, surface->along.path[k]);
    for (size_t k = surface->files.count; good && k-- > 0;) /* the first one's reason stays */
        add_lacks(one, scene, surface->files.path[k]);
    json_array_append_new(json_object_get(view, good ? "surfaces" : "left_out"), one);
    return one && !status_lost ? status->code : status_memory(status);
}

/** Do the names of two sub-directories suggest the two sides of a joint? */
static bool are_mates(const struct scene_surface *one, const struct scene_surface *other)
{
    static const char *const pairs[][2] = {
        {"pin", "socket"},   {"plug", "socket"}, {"plug", "jack"},   {"plug", "header"},   {"tab", "recept"},
        {"blade", "recept"}, {"male", "female"}, {"upper", "lower"}, {"top", "bottom"},    {"ball", "flat"},
        {"rider", "flat"},   {"spring", "pad"},  {"chip", "sink"},   {"spreader", "sink"}, {"spreader", "plate"},
        {"case", "sink"},    {"base", "plate"},  {"contact", "mate"}};
    bool are = false;
    for (size_t p = 0;
         p < sizeof pairs / sizeof *pairs && strchr(one->files.path[0], '/') && strchr(other->files.path[0], '/'); p++)
        are = are || (strcasestr(one->name, pairs[p][0]) && strcasestr(other->name, pairs[p][1]));
    return are;
}

/** Proposes the first two such surfaces as the sides of a joint. */
static void add_mates(json_t *view, const struct scene *scene)
{
    const json_t *surfaces = json_object_get(view, "surfaces");
    for (size_t i = 0; i < scene->surface_count; i++)
        for (size_t j = 0; j < scene->surface_count; j++)
            if (i != j && are_mates(&scene->surfaces[i], &scene->surfaces[j]) &&
                json_array_size(surfaces) == scene->surface_count && !json_object_get(view, "mates")) {
                const json_t *one = json_array_get(surfaces, i), *other = json_array_get(surfaces, j);
                json_object_set_new(view, "mates",
                                    json_pack("{s:O, s:O, s:O}", "one", json_object_get(one, "name"), "other",
                                              json_object_get(other, "name"), "files",
                                              json_object_get(other, "files")));
            }
}

/** The scene as text. */
static enum status_code make_text(struct text *out, struct scene *scene, const char *templates, struct status *status)
{
    OWNED(mustache_folder_free) struct mustache_folder folder = {templates, ".yaml", NULL, status};
    json_auto_t *view = json_pack("{s:o, s:[], s:[]}", "passed_over",
                                  json_lines(scene->passed_over ? scene->passed_over : ""), "surfaces", "left_out");
    if (!view)
        return status_memory(status);
    if (scene_join_repeats(scene, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < scene->surface_count; i++)
        if (add_surface(view, scene, &scene->surfaces[i], status) != STATUS_OK)
            return status->code;
    add_mates(view, scene);
    json_object_set_new(view, "any", json_boolean(json_array_size(json_object_get(view, "surfaces")) > 0));
    if (mustache_file(out, &folder, "scene", view, add_quoted) == STATUS_OK && out->length > SCENE_BYTES_MOST)
        return status_fail(status, STATUS_SCENE, "%zu surfaces in '%s', more than one scene can list; split them",
                           scene->surface_count, scene->directory);
    return status->code;
}

int command_init(int argc, char **argv)
{
    const char *directory = NULL;
    struct status status = {0};
    OWNED(scene_free) struct scene scene = {0};
    OWNED(text_free) struct text text = {0};
    const char *templates = "";
    const struct scene_overrides empty = {.text = &(struct text){0}}; /* whatever scene there is */
    command_parse(&command_init_argp, argc, argv, &directory);
    enum status_code rc = scene_read(&scene, directory, &empty, &status);
    if (rc == STATUS_OK && scene.surface_count == 0)
        rc = status_fail(&status, STATUS_SCAN, "no scan in '%s': put the profilometer's files there", scene.directory);
    if (rc == STATUS_OK && access(scene.path, F_OK) == 0) /* before all the scans are read */
        rc = status_fail(&status, STATUS_IO, "'%s' is there already; move it away", scene.path);
    if (rc == STATUS_OK)
        rc = command_templates(&templates, &status);
    if (rc == STATUS_OK)
        rc = make_text(&text, &scene, templates, &status);
    if (rc == STATUS_OK)
        rc = command_write(scene.path, &text, true, &status);
    return command_finish(rc == STATUS_OK ? COMMAND_DONE : command_fail(&status), NULL);
}
