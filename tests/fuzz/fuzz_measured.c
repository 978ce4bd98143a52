/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "base/mustache.h"
#include "directory.h"
#include "report/report.h"
#include "scan/text_header.h"
#include "scene/measured_file.h"
#include "scene/scene.h"
#include <math.h>

static const char kinds[] = "ETJMRP";
static size_t runs[sizeof kinds], taken[sizeof kinds];

void fuzz_measured_counts(void)
{
    static const char *const names[] = {"ECR", "TCR", "sidecar", "material", "results", "template"};
    for (size_t i = 0; i < sizeof kinds - 1; i++)
        fprintf(stderr, "runs of %-8s %9zu, good ones %9zu\n", names[i], runs[i], taken[i]);
}

static bool measured(const struct text *text, enum scene_measured_quantity quantity)
{
    const unsigned resistances = scene_measured_resistances[quantity];
    const unsigned quantities[MEASURED_COLUMNS] = {UNIT_LOADS, resistances, resistances | UNIT_NUMBER | UNIT_PERCENT};
    struct measured_file file;
    struct status status = {0};
    enum status_code code = measured_file_read(&file, string_view_of(text_string(text)), "file", quantities, &status);
    for (size_t i = 0; code == STATUS_OK && i < file.count; i++) {
        const double *value = file.rows[i].value;
        FUZZ_REQUIRE(value[MEASURED_LOAD] > 0 && isfinite(value[MEASURED_LOAD]));
        FUZZ_REQUIRE(value[MEASURED_RESISTANCE] > 0 && isfinite(value[MEASURED_RESISTANCE]));
        FUZZ_REQUIRE(!isinf(value[MEASURED_ERROR]));
    }
    if (code == STATUS_OK)
        FUZZ_REQUIRE(file.count > 0);
    else
        FUZZ_REQUIRE(code == STATUS_SCENE && *status.message && !strchr(status.message, '\n'));
    measured_file_free(&file);
    return code == STATUS_OK;
}

/* The text is a flow mapping, or lines that are indented. */
static bool material(const struct text *text)
{
    struct scene scene;
    struct status status = {0};
    struct text whole = {0};
    text_add(&whole, "material: ");
    text_add_bytes(&whole, text_string(text), text->length);
    enum status_code code =
        scene_read(&scene, TEST_DATA "/scene/full", &(struct scene_overrides){.text = &whole}, &status);
    if (code == STATUS_OK) {
        struct material_pair pair = scene_pair(&scene.bodies);
        FUZZ_REQUIRE(pair.unknown || (pair.effective_modulus_Pa > 0 && isfinite(pair.effective_modulus_Pa)));
    } else
        FUZZ_REQUIRE(code == STATUS_SCENE && *status.message && !strchr(status.message, '\n'));
    scene_free(&scene);
    text_free(&whole);
    return code == STATUS_OK;
}

static struct directory place;

static void remove_place(void)
{
    directory_remove(&place);
}

/* Two files results.json, a form feed between, or the same one twice; and what is said of them. */
static bool compared(const struct text *text)
{
    if (!place.path[0]) {
        if (!getenv("TMPDIR") && access("/dev/shm", W_OK) == 0)
            setenv("TMPDIR", "/dev/shm", 1);
        place = directory_make();
        atexit(remove_place);
        directory_write(&place, "a/results.json", "");
        directory_write(&place, "b/results.json", "");
    }
    const char *bytes = text_string(text), *between = memchr(bytes, '\f', text->length);
    size_t first = between ? (size_t)(between - bytes) : text->length, second = between ? first + 1 : 0;
    char a[sizeof place.path + 2], b[sizeof a], *paths[] = {a, b};
    json_t *view;
    struct text shown = {0};
    struct status status = {0};
    snprintf(a, sizeof a, "%s/a", place.path);
    snprintf(b, sizeof b, "%s/b", place.path);
    FUZZ_REQUIRE(text_write_file(directory_path(&place, "a/results.json"), bytes, first, &status) == STATUS_OK);
    FUZZ_REQUIRE(text_write_file(directory_path(&place, "b/results.json"), bytes + second, text->length - second,
                                 &status) == STATUS_OK);
    enum status_code code = report_compare(&view, paths, 2, &status);
    FUZZ_REQUIRE(code == STATUS_OK || code == STATUS_IO || code == STATUS_SCAN);
    FUZZ_REQUIRE(code == STATUS_OK || (*status.message && !strchr(status.message, '\n')));
    if (code == STATUS_OK) {
        FUZZ_REQUIRE(report_terminal(&shown, "compare", view, PROJECT_SOURCE "/templates", false, &status) ==
                     STATUS_OK);
        FUZZ_REQUIRE(shown.length > 0);
    }
    text_free(&shown);
    json_decref(view);
    return code == STATUS_OK;
}

/* The partial of every name: one that has sections, and no partial of its own. */
static const char *some_partial(void *context, const char *name)
{
    (void)context;
    return *name == 'x' ? NULL : "{{#list}}{{name}}{{^last}}, {{/last}}{{/list}}\n";
}

static bool filled(const struct text *text)
{
    json_t *view = json_pack("{s:s, s:f, s:b, s:n, s:{s:s, s:{s:[]}}, s:[{s:s}, {s:s, s:b}]}", "name", "<a&b>|*\x1b",
                             "number", 1e-300, "flag", 1, "none", "part", "name", "", "part", "list", "list", "name",
                             "one", "name", "two", "last", 1);
    const struct mustache how = {view, text_add_markdown_shown, some_partial, NULL};
    struct text out = {0};
    struct status status = {0};
    enum status_code code = mustache_render(&out, text_string(text), "template", &how, &status);
    FUZZ_REQUIRE(view && (code == STATUS_OK || code == STATUS_USAGE));
    FUZZ_REQUIRE(code == STATUS_OK || (*status.message && !strchr(status.message, '\n')));
    text_free(&out);
    json_decref(view);
    return code == STATUS_OK;
}

void fuzz_measured(const uint8_t *bytes, size_t length)
{
    const char *kind = length > 0 && *bytes ? strchr(kinds, *bytes) : NULL;
    struct text text = {0};
    struct sidecar sidecar;
    if (!kind)
        return;
    text_add_bytes(&text, (const char *)bytes + 1, length - 1);
    bool good = *kind == 'J'   ? sidecar_read_text(&sidecar, &text, "file.json")
                : *kind == 'M' ? material(&text)
                : *kind == 'R' ? compared(&text)
                : *kind == 'P' ? filled(&text)
                               : measured(&text, *kind == 'E' ? SCENE_MEASURED_ECR : SCENE_MEASURED_TCR);
    runs[kind - kinds]++;
    taken[kind - kinds] += good;
    text_free(&text);
}
