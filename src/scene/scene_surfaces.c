#include "scene/scene_surfaces.h"
#include "base/text.h"
#include "scene/scene_value.h"
#include "scene/scene_words.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Far beyond any measurement; keeps aliases of long lists from multiplying without end. */
enum { MOST_FILES = 100000 };

static enum status_code check_file(struct scene_source *source, const yaml_node_t *node, const char *file)
{
    char *path = scene_surfaces_path(source->directory, file);
    if (!path)
        return status_memory(source->status);
    struct stat info;
    int failed = stat(path, &info), reason = errno;
    free(path);
    struct scene_words_shown shown = scene_words_show(file, strlen(file));
    if (failed)
        return scene_source_fail(source, scene_source_line(node),
                                 "cannot find surface file '%s': %s; paths start at the scene's directory", shown.text,
                                 strerror(reason));
    if (!S_ISREG(info.st_mode))
        return scene_source_fail(source, scene_source_line(node), "surface file '%s' is no regular file; name a scan",
                                 shown.text);
    return STATUS_OK;
}

enum status_code scene_surfaces_files(struct scene_source *source, const struct scene_key *key,
                                      const yaml_node_t *value, void *field)
{
    struct scene_surface *surface = field;
    size_t count = scene_source_item_count(value);
    source->file_count += count;
    if (count == 0)
        return scene_source_fail(source, scene_source_line(value), "'%s' lists none; name one or more scans",
                                 key->name);
    if (source->file_count > MOST_FILES)
        return scene_source_fail(source, scene_source_line(value), "more than %d files in one scene; split it",
                                 MOST_FILES);
    surface->files = calloc(count, sizeof *surface->files);
    if (!surface->files)
        return status_memory(source->status);
    surface->file_count = count;
    for (size_t i = 0; i < count; i++) {
        const yaml_node_t *item = scene_source_item(source, value, i);
        enum status_code code = scene_value_text(source, key, item, &surface->files[i]);
        if (code == STATUS_OK)
            code = check_file(source, item, surface->files[i]);
        if (code != STATUS_OK)
            return code;
    }
    return STATUS_OK;
}

/* Columns count from 1; what is no number is a title. */
static enum status_code read_column(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    char *column)
{
    enum status_code code = scene_value_short_text(source, key, value, column);
    const char *number = column + (*column == '+' || *column == '-');
    if (code == STATUS_OK && *number && number[strspn(number, "0123456789.")] == '\0' &&
        (number[strspn(number, "0123456789")] || number > column || !number[strspn(number, "0")]))
        return scene_source_fail(source, scene_source_line(value),
                                 "'%s' is '%s'; give a column's number, from 1, or its title", key->name, column);
    return code;
}

enum status_code scene_surfaces_column(struct scene_source *source, const struct scene_key *key,
                                       const yaml_node_t *value, void *field)
{
    struct scene_surface *surface = field;
    struct scene_key one = {.name = key->name, .most = sizeof surface->z_column};
    if (value->type == YAML_SCALAR_NODE)
        return read_column(source, &one, value, surface->z_column);
    if (value->type != YAML_SEQUENCE_NODE || scene_source_item_count(value) != 2)
        return scene_source_fail(source, scene_source_line(value),
                                 "'%s' is no column; give one, as in `column: 3`, or x and z, as in `column: [1, 3]`",
                                 key->name);
    enum status_code code = read_column(source, &one, scene_source_item(source, value, 0), surface->x_column);
    return code == STATUS_OK ? read_column(source, &one, scene_source_item(source, value, 1), surface->z_column) : code;
}

static enum status_code read_surface(struct scene_source *source, const yaml_node_t *node,
                                     struct scene_surface *surface)
{
    enum { SURFACE_NAME, SURFACE_FILE, SURFACE_X_UNIT, SURFACE_Z_UNIT, SURFACE_QUANTITY, SURFACE_COLUMN, SURFACE_KEYS };
    static const struct scene_key keys[SURFACE_KEYS] = {
        [SURFACE_NAME] = {"name", scene_value_text, .offset = offsetof(struct scene_surface, name)},
        [SURFACE_FILE] = {"file", scene_surfaces_files, .offset = 0},
        [SURFACE_X_UNIT] = {"x_unit", scene_value_short_text, .offset = offsetof(struct scene_surface, x_unit),
                            .most = sizeof surface->x_unit},
        [SURFACE_Z_UNIT] = {"z_unit", scene_value_short_text, .offset = offsetof(struct scene_surface, z_unit),
                            .most = sizeof surface->z_unit},
        [SURFACE_QUANTITY] = {"quantity", scene_value_choice, .offset = offsetof(struct scene_surface, quantity),
                              .choices = scan_quantity_names, .choice_count = SCAN_QUANTITY_COUNT},
        [SURFACE_COLUMN] = {"column", scene_surfaces_column, .offset = 0},
    };
    size_t lines[SURFACE_KEYS];
    enum status_code code = scene_source_mapping(source, node, "surfaces", keys, SURFACE_KEYS, surface, lines);
    if (code != STATUS_OK)
        return code;
    if (lines[SURFACE_FILE] == 0)
        return scene_source_fail(source, scene_source_line(node), "a surface has no 'file'; add one");
    if (!surface->name)
        surface->name = scene_surfaces_name(surface->files[0], false);
    return surface->name ? STATUS_OK : status_memory(source->status);
}

struct named_line {
    const char *name;
    size_t line;
};

static int compare_named_lines(const void *a, const void *b)
{
    const struct named_line *first = a, *second = b;
    int order = strcmp(first->name, second->name);
    return order ? order : (first->line > second->line) - (first->line < second->line);
}

static enum status_code check_names(struct scene_source *source, const yaml_node_t *list, const struct scene *scene)
{
    size_t count = scene->surface_count;
    struct named_line *names = malloc(count * sizeof *names);
    if (!names)
        return status_memory(source->status);
    for (size_t i = 0; i < count; i++)
        names[i] = (struct named_line){scene->surfaces[i].name, scene_source_line(scene_source_item(source, list, i))};
    qsort(names, count, sizeof *names, compare_named_lines);
    enum status_code code = STATUS_OK;
    for (size_t i = 1; i < count && code == STATUS_OK; i++)
        if (strcmp(names[i].name, names[i - 1].name) == 0)
            code = scene_source_fail(source, names[i].line,
                                     "two surfaces are named '%s', the first in line %zu; "
                                     "give each its own 'name'",
                                     scene_words_show(names[i].name, strlen(names[i].name)).text, names[i - 1].line);
    free(names);
    return code;
}

enum status_code scene_surfaces_read(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                     void *field)
{
    struct scene *scene = field;
    if (value->type != YAML_SEQUENCE_NODE)
        return scene_source_wrong_type(source, value, key->name, "a list of '- {name: ..., file: ...}'");
    size_t count = scene_source_item_count(value);
    if (count == 0)
        return scene_source_fail(source, scene_source_line(value),
                                 "'surfaces' lists none; remove it to report every file of the directory");
    scene->surfaces = calloc(count, sizeof *scene->surfaces);
    if (!scene->surfaces)
        return status_memory(source->status);
    scene->surface_count = count;
    for (size_t i = 0; i < count; i++) {
        enum status_code code = read_surface(source, scene_source_item(source, value, i), &scene->surfaces[i]);
        if (code != STATUS_OK)
            return code;
    }
    return check_names(source, value, scene);
}

void scene_surfaces_free(struct scene_surface *surface)
{
    for (size_t i = 0; i < surface->file_count; i++)
        free(surface->files[i]);
    free(surface->files);
    free(surface->name);
}

char *scene_surfaces_path(const char *directory, const char *file)
{
    struct text path = {0};
    if (file[0] != '/') {
        size_t length = strlen(directory);
        text_add(&path, "%s%s", directory, length > 0 && directory[length - 1] == '/' ? "" : "/");
    }
    text_add(&path, "%s", file);
    if (!path.failed)
        return path.data;
    text_free(&path);
    return NULL;
}

char *scene_surfaces_name(const char *file, bool ending)
{
    const char *slash = strrchr(file, '/'), *start = slash ? slash + 1 : file, *dot = strrchr(start, '.');
    return !ending && dot && dot > start ? strndup(start, (size_t)(dot - start)) : strdup(start);
}
