/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/reader.h"
#include "scan/text_header.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char *const endings[] = {".json", ".txt", ".hdr"};
static const off_t most_bytes = 65536;

/* DABAM's FILE_FORMAT: what column 2 is, and whether each y has its own x before it. */
enum { DABAM_SLOPES = 1, DABAM_HEIGHTS, DABAM_SLOPES_IN_PAIRS, DABAM_HEIGHTS_IN_PAIRS };

#define COUNT(array) (sizeof(array) / sizeof *(array))

bool sidecar_ending(const char *name, size_t *length)
{
    for (size_t i = 0; i < COUNT(endings); i++) {
        size_t all = strlen(name), ending = strlen(endings[i]);
        *length = all > ending ? all - ending : 0;
        if (*length > 0 && strcmp(name + *length, endings[i]) == 0)
            return true;
    }
    return false;
}

/* A number, which may be written as a string; 0 where there is none. */
static double dabam_number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    double number = json_number_value(value);
    if (json_is_string(value) && !number_read(string_view_of(json_string_value(value)), &number))
        return 0;
    return number;
}

/* The number at a key such as Y2_FACTOR. */
static double dabam_factor(const json_t *object, char axis, size_t index)
{
    char key[32];
    snprintf(key, sizeof key, "%c%zu_FACTOR", axis, index);
    return dabam_number(object, key);
}

/* The unit of y number `index`: of the first by FILE_FORMAT, of any other by its title; NULL: not said. */
static const char *dabam_unit(const json_t *object, size_t index, double format)
{
    char key[32];
    snprintf(key, sizeof key, "PLOT_TITLE_Y%zu", index);
    const char *string = json_string_value(json_object_get(object, key));
    struct string_view title = string_view_of(string ? string : "");
    bool told = index == 1 && format >= DABAM_SLOPES && format <= DABAM_HEIGHTS_IN_PAIRS;
    if (told ? format == DABAM_SLOPES || format == DABAM_SLOPES_IN_PAIRS : text_header_title_slope(title))
        return scan_slope;
    bool height = told || text_header_says(title, "height heights heigth heigths");
    return height ? scan_unit_of(dabam_factor(object, 'Y', index)) : NULL;
}

static bool read_dabam(struct text_header *out, const struct text *bytes)
{
    const char *start = strchr(text_string(bytes), '{'); /* behind a byte order mark */
    json_auto_t *root = json_loadb(start, bytes->length - (size_t)(start - text_string(bytes)), 0, NULL);
    const bool any = dabam_factor(root, 'X', 1) > 0;
    double format = dabam_number(root, "FILE_FORMAT");
    bool pairs = format == DABAM_SLOPES_IN_PAIRS || format == DABAM_HEIGHTS_IN_PAIRS;
    for (size_t i = 1; any && 2 * i <= TEXT_HEADER_COLUMNS; i++) {
        size_t x = pairs ? 2 * i - 2 : 0, y = pairs ? 2 * i - 1 : i;
        out->unit[x] = scan_unit_of(dabam_factor(root, 'X', pairs ? i : 1));
        out->unit[y] = dabam_unit(root, i, format);
    }
    return any;
}

bool sidecar_read_text(struct sidecar *out, const struct text *bytes, const char *path)
{
    const char *slash = strrchr(path, '/'), *start = text_string(bytes);
    *out = (struct sidecar){.header = {.valid = SIZE_MAX}};
    snprintf(out->name, sizeof out->name, "%s", slash ? slash + 1 : path);
    if (start[strspn(start, "\xEF\xBB\xBF \t\r\n")] == '{')
        return read_dabam(&out->header, bytes);
    return scan_text_read_keys(&out->header, &(struct scan_file){.bytes = start, .length = bytes->length, .path = ""});
}

bool sidecar_read(struct sidecar *out, const char *path)
{
    struct stat info;
    struct status ignored = {0};
    OWNED(text_free) struct text bytes = {0};
    return stat(path, &info) == 0 && S_ISREG(info.st_mode) && info.st_size <= most_bytes &&
           text_read_file(&bytes, path, &ignored) == STATUS_OK && sidecar_read_text(out, &bytes, path);
}

enum status_code sidecar_find(struct sidecar *out, char **found, const char *path, struct status *status)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    const int stems[2] = {(int)strlen(path), dot && dot > name ? (int)(dot - path) : 0};
    *found = NULL;
    for (size_t i = 0; i < 2 * COUNT(endings) && !*found; i++) {
        char *candidate;
        int stem = stems[i / COUNT(endings)];
        if (asprintf(&candidate, "%.*s%s", stem, path, endings[i % COUNT(endings)]) < 0)
            return status_memory(status);
        if (stem > 0 && strcmp(candidate, path) != 0 && sidecar_read(out, candidate))
            *found = candidate;
        else
            free(candidate);
    }
    return STATUS_OK;
}
