/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scene's key `shape`: how the parts bulge, a map of the gap between them, pressures from elsewhere, or bolts. */
#include "base/limits.h"
#include "scan/scan.h"
#include "scene/measured_file.h"
#include "scene/scene_source.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double balance = 0.02;    /* between two statements of a force, or of an area */
static const double same_place = 1e-6; /* of the range of places */
static const double rounded = 0.1;     /* of a step */
static const double largest = 1e15;    /* of what a file may hold, in SI */
static const double hole = 0.65;       /* over the head: ISO 273, medium, beneath ISO 4762, 0.62 (M3) to 0.69 (M10) */
enum { BOLTS_MOST = 1000 };

/* Fails in the line of the key. */
#define SHAPE_FAIL(source, ...) FAIL_KEY((source), "shape", __VA_ARGS__)

/* Places, each a pair. */
static bool read_bolts(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value, void *field)
{
    struct shape_bolts *bolts = field;
    size_t count = value->type == YAML_SEQUENCE_NODE ? scene_source_item_count(value) : 0;
    if (count == 0 || count > BOLTS_MOST)
        return scene_source_fail_at(source, value, "'bolts' lists %zu places; give 1 to %d, as [[10 mm, 10 mm]]", count,
                                    BOLTS_MOST);
    if (!(bolts->middle_m = calloc(count, sizeof *bolts->middle_m)))
        return scene_source_memory(source);
    for (; bolts->count < count; bolts->count++)
        if (!scene_source_pair(source, key, scene_source_item(source, value, bolts->count),
                               bolts->middle_m[bolts->count]))
            return false;
    return true;
}

#define AT(member) offsetof(struct scene, shape.member)
enum { FLATNESS, CROWN, HEIGHT, PRESSURE, BOLTS };
static const struct scene_key shape_keys[] = {
    [FLATNESS] = {"flatness", NULL, SCENE_QUANTITY(AT(flatness_m), UNIT_DISTANCE, 1e-12, 1.0), .needs = "over"},
    [CROWN] = {"crown", NULL, SCENE_QUANTITY(AT(crown_m), UNIT_DISTANCE, 1e-6, 1e9)},
    [HEIGHT] = {"height", NULL, scene_surfaces_files, .at = AT(files)},
    [PRESSURE] = {"pressure", NULL, scene_surfaces_files, .at = AT(files)},
    [BOLTS] = {"bolts", NULL, read_bolts, .at = AT(bolts), .quantities = UNIT_DISTANCE, .least = -1e3, .most = 1e3,
               .needs = "force, head, thickness"},
    {"over", NULL, SCENE_QUANTITY(AT(over_m), UNIT_DISTANCE, 1e-9, 1e3), .needs = "flatness", .above = "flatness"},
    {"size", NULL, scene_source_pair, .at = offsetof(struct scene, joint.size_m), .quantities = UNIT_DISTANCE,
     .least = 1e-9, .most = 1e3},
    {"thickness", NULL, scene_source_pair, .at = offsetof(struct scene, joint.thickness_m), .quantities = UNIT_DISTANCE,
     .least = 1e-9, .most = 1e3},
    {"scale", NULL, SCENE_YES(AT(scale)), .needs = "pressure or bolts"},
    {"force", NULL, SCENE_QUANTITY(AT(bolts.force_N), UNIT_FORCE, 1e-9, 1e9), .needs = "bolts"},
    {"head", NULL, SCENE_QUANTITY(AT(head_m), UNIT_DISTANCE, 1e-4, 1.0), .needs = "bolts"},
};

static bool complete_way(struct scene_source *source, const size_t *lines, size_t line, void *into)
{
    struct scene_shape *shape = &((struct scene *)into)->shape;
    (void)line;
    shape->kind = lines[HEIGHT]     ? SCENE_SHAPE_HEIGHT
                  : lines[PRESSURE] ? SCENE_SHAPE_PRESSURE
                  : lines[BOLTS]    ? SCENE_SHAPE_BOLTS
                                    : SCENE_SHAPE_BULGE;
    return !lines[HEIGHT] || shape->files.count == 1 ||
           scene_source_fail(source, lines[HEIGHT], "'height' is one map, not %zu", shape->files.count);
}

const struct scene_mapping scene_shape_ways = {"shape", shape_keys, SCENE_COUNT(shape_keys),
                                               .one_of = "flatness or crown or height or pressure or bolts",
                                               .then = complete_way};

void scene_shape_size(struct scene *scene, struct scene_source *source)
{
    const struct scene_shape *shape = &scene->shape;
    double *side_m = scene->joint.size_m, area_m2 = side_m[0] * side_m[1];
    if (!shape->given)
        return;
    scene->joint.bulge_per_m = shape->crown_m > 0  ? 1 / (2 * shape->crown_m)
                               : shape->over_m > 0 ? 4 * shape->flatness_m / pow(shape->over_m, 2)
                                                   : 0;
    if (area_m2 > 0 && isnan(scene->nominal_area_m2))
        scene->nominal_area_m2 = area_m2;
    if (isnan(scene->nominal_area_m2))
        SHAPE_FAIL(source, "'shape' is of which area? add 'nominal_area', or 'size' to it");
    else if (area_m2 > 0 && !(fabs(area_m2 / scene->nominal_area_m2 - 1) < 1e-3))
        SHAPE_FAIL(source, "'size' is %g m2 and 'nominal_area' %g m2; correct either", area_m2, scene->nominal_area_m2);
    if (!(area_m2 > 0))
        side_m[0] = side_m[1] = sqrt(scene->nominal_area_m2);
}

/* ---- Files ---- */

/* Moves `count` places so that they count from the corner. They are middles of cells (*cells), or nodes of which the
 * outer ones lie on the edges, whichever comes nearer to `side`, to which they are stretched; equal steps that were
 * rounded are made equal again. Returns the factor of the stretch, 1 for rounding; NaN: neither is that long. */
static double fit(bool *cells, double *at, size_t count, double side_m)
{
    double first = at[0], range = at[count - 1] - first, step = range / (double)(count - 1);
    *cells = fabs(range + step - side_m) < fabs(range - side_m);
    double length = range + (*cells ? step : 0), times = side_m / length;
    bool equal = true;
    for (size_t i = 0; i < count; i++)
        equal = equal && fabs(at[i] - first - step * (double)i) < rounded * step;
    for (size_t i = 0; i < count; i++)
        at[i] = ((equal ? step * (double)i : at[i] - first) + (*cells ? step / 2 : 0)) * times;
    if (fabs(length - side_m) < 2 * rounded * step)
        return 1;
    return fabs(length - side_m) <= balance * side_m ? times : NAN;
}

/* Interpolates values at places to the cells. A stretched pressure keeps its force; heights always lie at points. */
static bool lay(struct scene_source *source, const char *file, double *const at[2], const size_t count[2],
                const double *value)
{
    struct joint *joint = &source->scene->joint;
    const double *side_m = joint->size_m;
    struct shape_grid grid = {{at[0], at[1]}, {count[0], count[1]}, value, {false, false}};
    struct shape_field *field = &joint->fields[joint->field_count++];
    double times = 1;
    for (int side = 0; side < 2; side++) {
        double range = at[side][count[side] - 1] - at[side][0],
               own = fit(&grid.cells[side], at[side], count[side], side_m[side]);
        if (isnan(own))
            return SHAPE_FAIL(source, "'%s' is %g m long in %c, the nominal area %g m; correct 'size' or the file",
                              scene_words_show(file).text, range, "xy"[side], side_m[side]);
        grid.cells[side] = grid.cells[side] && joint->pressed;
        times *= own;
    }
    if (shape_field_grid(field, &grid, side_m, source->status) != STATUS_OK)
        return false;
    field->mean /= joint->pressed ? times : 1;
    for (size_t k = 0; joint->pressed && k < field->nx * field->ny; k++)
        field->value[k] /= times;
    return true;
}

static bool read_height(struct scene_source *source, const char *file)
{
    OWNED(scan_free) struct scan scan = {0};
    struct status problem = {0};
    OWNED(memory_free) char *path = scene_file_path(source->scene, file);
    OWNED(memory_free) double *room = NULL;
    double top = -INFINITY;
    bool good = path && scan_read(&scan, path, &(struct scan_options){0}, &problem) == STATUS_OK;
    if (!path)
        good = scene_source_memory(source);
    else if (!good)
        good = SHAPE_FAIL(source, "%s", problem.message);
    else if (scan.kind != SCAN_AREAL || scan.missing > 0 || scan.units_lacking)
        good = SHAPE_FAIL(source, "'%s' %s", scene_words_show(file).text,
                          scan.kind != SCAN_AREAL ? "is a profile; give a map of the part's height"
                          : scan.missing > 0      ? "has points missing; fill them"
                                                  : "names no units; write them into it");
    if (good) {
        const size_t count[2] = {scan.nx, scan.ny};
        room = calloc(scan.nx + scan.ny, sizeof *room);
        double *const at[2] = {room, room ? room + scan.nx : NULL};
        for (size_t i = 0; room && i < scan.nx + scan.ny; i++)
            room[i] = i < scan.nx ? (double)i * scan.dx_m : (double)(i - scan.nx) * scan.dy_m;
        for (size_t k = 0; k < scan.nx * scan.ny; k++)
            top = fmax(top, scan.z_m[k]);
        for (size_t k = 0; k < scan.nx * scan.ny; k++)
            scan.z_m[k] = top - scan.z_m[k];
        good = room ? lay(source, file, at, count, scan.z_m) : scene_source_memory(source);
    }
    return good;
}

/* The different values, ascending. */
static size_t distinct(double *out, const double *value, size_t count)
{
    size_t kept = 0;
    memcpy(out, value, count * sizeof *out);
    gsl_sort(out, 1, count);
    double least = same_place * (out[count - 1] - out[0]);
    for (size_t i = 0; i < count; i++)
        if (kept == 0 || out[i] - out[kept - 1] > least)
            out[kept++] = out[i];
    return kept;
}

static size_t place(const double *at, size_t count, double value)
{
    size_t i = 0;
    while (i + 1 < count && fabs(at[i + 1] - value) < fabs(at[i] - value))
        i++;
    return i;
}

/* Rows of x, y and pressure, in any order. */
static bool lay_rows(struct scene_source *source, const char *file, const double *column[3], size_t rows)
{
    size_t count[2];
    OWNED(memory_free) double *room = calloc(3 * rows, sizeof *room);
    if (!room)
        return scene_source_memory(source);
    double *at[2] = {room, room + rows}, *value = room + 2 * rows;
    for (int side = 0; side < 2; side++)
        count[side] = distinct(at[side], column[side], rows);
    bool good = count[0] * count[1] == rows && count[0] > 1 && count[1] > 1;
    for (size_t k = 0; good && k < rows; k++)
        value[k] = NAN;
    for (size_t k = 0; good && k < rows; k++)
        value[place(at[1], count[1], column[1][k]) * count[0] + place(at[0], count[0], column[0][k])] = column[2][k];
    for (size_t k = 0; good && k < rows; k++)
        good = !isnan(value[k]);
    good = good ? lay(source, file, at, count, value)
                : SHAPE_FAIL(source, "'%s' has %zu places, no grid of x and y; give each x with each y",
                             scene_words_show(file).text, rows);
    return good;
}

/* Rows of an area and its pressure, by falling pressure. */
static bool take_parts(struct scene_source *source, const char *file, const double *column[2], size_t rows)
{
    const double area_m2 = source->scene->nominal_area_m2;
    struct joint *joint = &source->scene->joint;
    struct shape_field *field = &joint->fields[joint->field_count++];
    OWNED(memory_free) size_t *order = calloc(rows, sizeof *order);
    double sum = 0;
    *field = (struct shape_field){
        .nx = rows, .value = calloc(rows, sizeof *field->value), .share = calloc(rows, sizeof *field->share)};
    if (!order || !field->value || !field->share)
        return scene_source_memory(source);
    gsl_sort_index(order, column[1], 1, rows);
    for (size_t k = 0; k < rows; k++) {
        size_t from = order[rows - 1 - k];
        field->value[k] = column[1][from];
        field->share[k] = column[0][from] / area_m2;
        field->mean += field->value[k] * field->share[k];
        sum += field->share[k];
    }
    return sum <= 1 + balance || SHAPE_FAIL(source, "the areas of '%s' are %g m2 together, the nominal one %g m2",
                                            scene_words_show(file).text, sum * area_m2, area_m2);
}

/* The file's columns in SI: rows of place, place and pressure, or of area and pressure. */
static bool take_columns(struct scene_source *source, const char *file, const struct measured_file *read)
{
    size_t rows = read->count;
    const bool parts = unit_of(&read->units[0].unit, UNIT_AREA);
    const int columns = parts ? 2 : 3;
    OWNED(memory_free) double *room = calloc(3 * rows, sizeof *room);
    const double *column[3] = {room, room + rows, room + 2 * rows};
    bool good = room || scene_source_memory(source);
    for (int c = 0; good && c < columns; c++) {
        const struct measured_unit *unit = &read->units[c];
        if (!unit->known || !unit_of(&unit->unit, c == columns - 1 ? UNIT_PRESSURE : parts ? UNIT_AREA : UNIT_DISTANCE))
            good = SHAPE_FAIL(source, "'%s' is not headed x [mm], y [mm], p [MPa], or A [mm2], p [MPa]; head it so",
                              scene_words_show(file).text);
        for (size_t i = 0; good && i < rows; i++) {
            double value = read->rows[i].value[c] * unit->unit.factor;
            room[(size_t)c * rows + i] = value;
            if (!(fabs(value) < largest && (value >= 0 || (!parts && c < 2))))
                good = SHAPE_FAIL(source, "'%s', line %zu: %s", scene_words_show(file).text, read->rows[i].line,
                                  fabs(value) < largest ? "negative; correct the pressure or area"
                                                        : "a number is missing or too large");
        }
    }
    good = good && (parts ? take_parts(source, file, column, rows) : lay_rows(source, file, column, rows));
    return good;
}

static bool read_pressure(struct scene_source *source, const char *file)
{
    static const unsigned quantities[MEASURED_COLUMNS] = {UNIT_DISTANCE | UNIT_AREA, UNIT_DISTANCE | UNIT_PRESSURE,
                                                          UNIT_PRESSURE};
    const struct joint *joint = &source->scene->joint;
    OWNED(measured_file_free) struct measured_file read = {0};
    struct status problem = {0};
    OWNED(memory_free) char *path = scene_file_path(source->scene, file);
    bool good = path && measured_file_take(&read, path, path, quantities, &problem) == STATUS_OK;
    good = !path  ? scene_source_memory(source)
           : good ? take_columns(source, file, &read)
                  : SHAPE_FAIL(source, "%s", problem.message);
    if (good && !(joint->fields[joint->field_count - 1].mean > 0))
        good = SHAPE_FAIL(source, "'%s' presses nowhere", scene_words_show(file).text);
    return good;
}

/* ---- Loads ---- */

static int by_load(const void *a, const void *b)
{
    const struct shape_field *x = a, *y = b;
    return (x->mean > y->mean) - (x->mean < y->mean);
}

/* A single field is of the operating load, which it sets where the scene does not; several have a load each. */
static bool hold_load(struct scene *scene, struct scene_source *source)
{
    const struct shape_field *fields = scene->joint.fields;
    const struct material_pair pair = scene_pair(scene_bodies_of(scene, 0));
    size_t count = scene->joint.field_count;
    qsort(scene->joint.fields, count, sizeof *fields, by_load);
    for (size_t i = 1; i < count; i++)
        if (fields[i].nx != fields[0].nx || fields[i].ny != fields[0].ny || !(fields[i].mean > fields[i - 1].mean) ||
            fields[0].share)
            return SHAPE_FAIL(source, "the files of 'pressure' must be grids of the same places, each at another load");
    if (count > 1 || scene->shape.scale || pair.unknown)
        return true;
    if (scene->operating.value == 0) {
        scene->operating = (struct scene_quantity){.value = fields[0].mean, .kind = UNIT_PRESSURE};
        return true;
    }
    double asked_Pa = scene_load_of(&scene->operating, scene, &pair) * pair.effective_modulus_Pa;
    double off = fields[0].mean / asked_Pa - 1;
    return fabs(off) <= balance ||
           SHAPE_FAIL(source,
                      "'shape' carries %g N, %+.3g %% from 'operating_load'; correct either, or add scale: true",
                      fields[0].mean * scene->nominal_area_m2, 100 * off);
}

/* Each hole lies inside the area, and none in another. */
static bool check_bolts(struct scene_source *source, const struct shape_bolts *bolts, const double side_m[2])
{
    for (size_t i = 0; i < bolts->count; i++) {
        const double *own = bolts->middle_m[i];
        for (int side = 0; side < 2; side++)
            if (own[side] < bolts->hole_m || own[side] > side_m[side] - bolts->hole_m)
                return SHAPE_FAIL(source,
                                  "bolt %zu is at %g m in %c, where its hole of %.3g m leaves the area, 0 to %g m; "
                                  "coordinates count from a corner",
                                  i + 1, own[side], "xy"[side], 2 * bolts -> hole_m, side_m[side]);
        for (size_t k = 0; k < i; k++)
            if (hypot(own[0] - bolts->middle_m[k][0], own[1] - bolts->middle_m[k][1]) < 2 * bolts->hole_m)
                return SHAPE_FAIL(source,
                                  "the holes of bolts %zu and %zu overlap; correct either, "
                                  "coordinates count from a corner",
                                  k + 1, i + 1);
    }
    return true;
}

void scene_shape_complete(struct scene *scene, struct scene_source *source)
{
    struct scene_shape *shape = &scene->shape;
    struct joint *joint = &scene->joint;
    struct shape_bolts *bolts = &shape->bolts;
    struct status problem = {0};
    if (!shape->given || shape->kind == SCENE_SHAPE_BULGE)
        return;
    joint->fields = calloc(shape->files.count + 1, sizeof *joint->fields);
    joint->pressed = shape->kind != SCENE_SHAPE_HEIGHT;
    bool good = joint->fields || scene_source_memory(source);
    for (size_t i = 0; i < shape->files.count && good; i++)
        good = (joint->pressed ? read_pressure : read_height)(source, shape->files.path[i]);
    if (good && bolts->count > 0) {
        bolts->hole_m = hole * shape->head_m / 2;
        bolts->reach_m = shape->head_m / 2 + fmin(joint->thickness_m[0], joint->thickness_m[1]);
        joint->field_count = 1;
        good = check_bolts(source, bolts, joint->size_m) &&
               (shape_field_bolts(joint->fields, bolts, joint->size_m, &problem) == STATUS_OK ||
                SHAPE_FAIL(source, "%s", problem.message));
    }
    if (good && joint->pressed)
        (void)hold_load(scene, source);
}

void scene_shape_free(struct scene *scene)
{
    for (size_t i = 0; i < scene->joint.field_count; i++)
        shape_field_free(&scene->joint.fields[i]);
    free(scene->joint.fields);
    free(scene->shape.bolts.middle_m);
    scene_files_free(&scene->shape.files);
}
