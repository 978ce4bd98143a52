/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report.h"

#include "base/mustache.h"
#include "report/view.h"
#include "scene/scene_words.h"
#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** The files of templates/export in order of their names, each cut in two at its last dot. */
struct programs {
    struct text folder;
    struct dirent **entry;
    const char *name[SCENE_EXPORTS_MOST], *ending[SCENE_EXPORTS_MOST];
    size_t count, files;
};

static enum status_code programs_read(struct programs *out, const char *templates, struct status *status)
{
    *out = (struct programs){0};
    text_add(&out->folder, "%s/export", templates);
    int found = scandir(text_string(&out->folder), &out->entry, NULL, alphasort);
    if (found < 0)
        return status_fail(status, STATUS_IO, "cannot read the templates in '%s': %s", text_string(&out->folder),
                           status_reason(errno));
    out->files = (size_t)found;
    for (size_t i = 0; i < out->files && out->count < SCENE_EXPORTS_MOST; i++) {
        char *name = out->entry[i]->d_name, *dot = strrchr(name, '.');
        if (!dot || name[0] == '.' || dot[1] == '\0')
            continue;
        *dot = '\0';
        out->name[out->count] = name;
        out->ending[out->count++] = dot + 1;
    }
    return status->code;
}

static void programs_free(struct programs *programs)
{
    text_free(&programs->folder);
    for (size_t i = 0; i < programs->files; i++)
        free(programs->entry[i]);
    free(programs->entry);
}

/** Takes the unit off a word that names a program: is it mm? */
static bool take_mm(struct string_view *word)
{
    const size_t ending = strlen(view_export_mm);
    bool mm = string_view_length(*word) > ending && strncmp(word->end - ending, view_export_mm, ending) == 0;
    word->end -= mm ? ending : 0;
    return mm;
}

enum status_code export_check(const struct scene *scene, const char *templates, struct status *status)
{
    OWNED(programs_free) struct programs programs = {.count = 0};
    OWNED(text_free) struct text problem = {0};
    struct string_view word;
    size_t words = 0;
    if (!scene->exports || programs_read(&programs, templates, status) != STATUS_OK)
        return status->code;
    for (const char *rest = scene->exports; scene_words_next(&word, &rest); words++) {
        (void)take_mm(&word);
        if (problem.length == 0 && scene_words_find(word, programs.name, programs.count) == programs.count) {
            text_add(&problem, "unknown program '%s'; there are", scene_words_show_view(word).text);
            for (size_t k = 0; k < programs.count; k++)
                text_add(&problem, "%s %s", k > 0 ? "," : "", programs.name[k]);
            text_add(&problem, "; %s behind one gives N, mm, s", view_export_mm);
        }
    }
    if (words == 0)
        text_add(&problem, "names no program; name one, such as calculix");
    for (size_t i = 0; i < scene->surface_count && problem.length == 0; i++)
        if (isnan(scene->surfaces[i].bodies.material.youngs_modulus_Pa))
            text_add(&problem, "surface '%s' has no material, and so no pressures; add 'material' or export nothing",
                     scene_words_show(scene->surfaces[i].name).text);
    if (problem.length > 0 && scene->exports_overridden)
        (void)status_fail(status, STATUS_USAGE, "--export: %s", text_string(&problem));
    else if (problem.length > 0)
        (void)status_fail(status, STATUS_SCENE, "%s: export: %s", scene->path, text_string(&problem));
    return status->code;
}

/** For a comment of any of the programs: what ends one, continues a line or is computed in one of them is a "_". */
static void add_comment(struct text *out, const char *string)
{
    for (const char *s = string; *s; s++)
        text_add_bytes(out, strchr("$&#%!*\"'`\\", *s) ? "_" : s, 1);
}

/** The table `item` as the k-th of the programs takes it. */
static enum status_code write_one(json_t *view, const json_t *item, const struct programs *programs, size_t k,
                                  const char *directory, struct status *status)
{
    OWNED(text_free) struct text content = {0}, name = {0};
    const char *program = programs->name[k], *ending = programs->ending[k];
    const bool mm = json_is_true(json_object_get(item, "mm"));
    char dotted[NAME_MAX + 2];
    snprintf(dotted, sizeof dotted, ".%s", ending);
    OWNED(mustache_folder_free)
    struct mustache_folder templates = {text_string(&programs->folder), dotted, NULL, status};
    text_add(&name, "export/%s.%s%s.%s", json_string_value(json_object_get(item, "file")), program, mm ? "-mm" : "",
             ending);
    if (mustache_file(&content, &templates, program, item, add_comment) != STATUS_OK)
        return status->code;
    if (json_array_size(json_object_get(view, "exported")) < VIEW_ROWS)
        view_text(view_item(view_list(view, "exported")), "file", text_string(&name));
    else
        view_flag(view, "exported_more", true);
    return text_save(&content, status, "%s/%s", directory, text_string(&name));
}

enum status_code export_write(json_t *view, const struct scene *scene, const char *templates, const char *directory,
                              struct status *status)
{
    OWNED(programs_free) struct programs programs = {.count = 0};
    struct string_view word;
    size_t i;
    const json_t *item, *exports = json_object_get(view, "exports");
    if (!scene->exports || programs_read(&programs, templates, status) != STATUS_OK)
        return status->code;
    bool asked[2][SCENE_EXPORTS_MOST + 1] = {{false}}; /* in SI, in mm */
    for (const char *rest = scene->exports; scene_words_next(&word, &rest);) {
        bool mm = take_mm(&word);
        asked[mm][scene_words_find(word, programs.name, programs.count)] = true;
    }
    json_array_foreach (exports, i, item) {
        for (size_t k = 0; k < programs.count && status->code == STATUS_OK; k++)
            if (asked[json_is_true(json_object_get(item, "mm"))][k])
                (void)write_one(view, item, &programs, k, directory, status);
    }
    return status->code;
}
