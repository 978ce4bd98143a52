/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "directory.h"
#include "fuzz/fuzz.h"

#include "scan/text_header.h"
#include "scene/measured_file.h"
#include "scene/scene.h"

static const char kinds[] = "ETJMP";
static const char *const names[] = {"ECR", "TCR", "sidecar", "material", "pressure"};

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
    OWNED(text_free) struct text whole = {0};
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
    return code == STATUS_OK;
}

/* A field of pressure on the parts, or map of height, in the scene's directory. */
static bool pressure(const struct text *text)
{
    static const char line[] = "material: copper\nnominal_area: 400 mm2\nshape: {pressure: f.csv, scale: true}\n";
    const struct directory directory = directory_make();
    struct scene scene;
    struct status status = {0};
    OWNED(text_free) struct text whole = {0};
    text_add(&whole, "%s", line);
    FUZZ_REQUIRE(text_write_file(directory_path(&directory, "f.csv"), text_string(text), text->length, &status) ==
                 STATUS_OK);
    enum status_code code = scene_read(&scene, directory.path, &(struct scene_overrides){.text = &whole}, &status);
    if (code == STATUS_OK) {
        const struct shape_field *field = scene.joint.fields;
        FUZZ_REQUIRE(field->mean > 0 && isfinite(field->mean));
        for (size_t k = 0; k < field->nx * (field->ny > 0 ? field->ny : 1); k++)
            FUZZ_REQUIRE(field->value[k] >= 0 && isfinite(field->value[k]));
    } else
        FUZZ_REQUIRE(code == STATUS_SCENE && *status.message && !strchr(status.message, '\n'));
    scene_free(&scene);
    directory_remove(&directory);
    return code == STATUS_OK;
}

void fuzz_measured(const uint8_t *bytes, size_t length)
{
    const char *kind = length > 0 && *bytes ? strchr(kinds, *bytes) : NULL;
    OWNED(text_free) struct text text = {0};
    struct sidecar sidecar;
    if (!kind)
        return;
    text_add_bytes(&text, (const char *)bytes + 1, length - 1);
    bool good = *kind == 'J'   ? sidecar_read_text(&sidecar, &text, "file.json")
                : *kind == 'M' ? material(&text)
                : *kind == 'P' ? pressure(&text)
                               : measured(&text, *kind == 'E' ? SCENE_MEASURED_ECR : SCENE_MEASURED_TCR);
    fuzz_count(names[kind - kinds], good);
}
