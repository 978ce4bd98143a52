/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/unit.h"
#include "contact/model.h"
#include "made_up_results.h"
#include "output/tables.h"
#include "results/results.h"
#include "run/pipeline.h"

#include <float.h>

/* What docs/report.md says. */
static const char surfaces_columns[] =
    "surface,files,points,spacing_m,scan_length_m,rq_m,ra_m,m0_m2,m2,m4_per_m2,nayak,asperity_density_per_m2,"
    "asperity_radius_m,asperity_sigma_m,asperity_offset_m,alpha_SI,gamma,gamma_stderr,fit_amplitude_m,"
    "fit_amplitude_stderr_decades,fit_wavelength_m,fit_low_m,fit_high_m,fit_misfit_decades,"
    "line_alpha_SI,line_gamma,line_rms_decades,heights_factor_ecr,beta_gw,"
    "beta_jg";
static const char spectrum_columns[] = "surface,wavelength_m,amplitude_m,fit_m";
static const char contact_columns[] =
    "surface,model,load_over_AnEp,pressure_Pa,area_ratio,separation_m,separation_over_sigma,"
    "adjusted_separation_over_sigma,ecr_ohm_m2,tcr_K_m2_per_W,tcr_sd_K_m2_per_W,gap_m";
static const char convergence_columns[] = "sweep,value,model,wavelength_m,area_ratio";

static const char everything[] =
    "material: tin\n"
    "fit: thesis\n"
    "window: none\n"
    "effects: [plasticity, separation, electrical, thermal, scale-dependent, convergence]\n"
    "load: {from: 1e-5, to: 0.5, points: 11}\n"
    "convergence: {scales: 40}\n"
    "nominal_area: 1 mm2\n"
    "targets: [{ecr: 1 mohm}]\n"
    "limits: {ecr: {most: 1 mohm}}\n"
    "surfaces:\n"
    "  - {name: smooth, file: smooth.csv}\n"
    "  - {name: bowl, file: bowl.csv}\n"
    "  - {name: rough, file: [rough-1.csv, rough-2.csv]}\n";

/* The scene with everything, run once for all tests: place/out. */
static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    static const char *const folders[] = {"in", "few"};
    for (size_t i = 0; i < 2; i++) {
        pipeline_rough(&place, filled("%s/smooth.csv", folders[i]), 120, 0.3, 1);
        pipeline_bowl(&place, filled("%s/bowl.csv", folders[i]), 121);
    }
    pipeline_rough(&place, "in/rough-1.csv", 120, 1, 2);
    pipeline_rough(&place, "in/rough-2.csv", 120, 1, 3);
    directory_write(&place, "in/scene.yaml", everything);
    assert_int_equal(pipeline_run(&place, "in", "out", 2), 0);
    *state = &place;
    return 0;
}

static void assert_header(const struct table *table, const char *expected)
{
    struct text *header = support_text();
    for (size_t c = 0; c < table->columns; c++)
        text_add(header, "%s%s", c > 0 ? "," : "", table->cell[c]);
    assert_string_equal(text_string(header), expected);
}

static bool has_column(const struct table *table, const char *name)
{
    for (size_t c = 0; c < table->columns; c++)
        if (strcmp(table->cell[c], name) == 0)
            return true;
    return false;
}

enum cell { CELL_NUMBER, CELL_EMPTY, CELL_EITHER };

/* Every cell but those of names is a finite number in full, or empty where `holds` says so. */
static void assert_numbers(const struct table *table, const char *texts,
                           enum cell (*holds)(const struct table *table, size_t row, const char *column))
{
    for (size_t row = 0; row < table->rows; row++)
        for (size_t c = 0; c < table->columns; c++) {
            const char *column = table->cell[c], *cell = table->cell[(row + 1) * table->columns + c];
            char *end;
            if (strstr(texts, column))
                continue;
            double number = strtod(cell, &end);
            enum cell held = holds ? holds(table, row, column) : CELL_NUMBER;
            bool empty = held == CELL_EMPTY || (held == CELL_EITHER && *cell == '\0');
            if (empty ? *cell != '\0' : end == cell || *end != '\0' || !isfinite(number))
                fail_msg("row %zu, %s: '%s'", row, column, cell);
        }
}

/** The model's row, and the quantity that a column of contact.csv holds. */
static const struct model_row *model_of(const struct table *table, size_t row)
{
    size_t m = model_named(table_text(table, row, "model"));
    return model_rows[m];
}

static unsigned quantity_of(const char *column)
{
    unsigned bits = 0;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        for (int sigma = 0; sigma < 2; sigma++) {
            const char *name = sigma                                          ? quantity_rows[q].sigma_column
                               : (quantity_rows[q].is & QUANTITY_SIGMA_ALONE) ? NULL
                                                                              : quantity_rows[q].name;
            bits |= name && strcmp(name, column) == 0 ? QUANTITY_BIT(q) : 0;
        }
    return bits;
}

/** What a model does not compute is empty; what it need not answer is where its own curve ends. */
static enum cell empty_in_contact(const struct table *table, size_t row, const char *column)
{
    const struct model_row *model = model_of(table, row);
    unsigned quantity = quantity_of(column);
    return quantity && !(quantity_with_made(model->quantities) & quantity) ? CELL_EMPTY
           : quantity_with_made(model->may_be_empty) & quantity            ? CELL_EITHER
                                                                           : CELL_NUMBER;
}

static enum cell empty_in_surfaces(const struct table *table, size_t row, const char *column)
{
    bool empty = strcmp(table_text(table, row, "surface"), "bowl") == 0 &&
                 (strcmp(column, "asperity_sigma_m") == 0 || strncmp(column, "beta", 4) == 0);
    bool may_be = strcmp(column, "heights_factor_ecr") == 0; /* beyond the end of the model's curve */
    return empty ? CELL_EMPTY : may_be ? CELL_EITHER : CELL_NUMBER;
}

TEST_CASE(test_columns_are_those_promised)
{
    static const struct {
        const char *name, *columns, *texts;
        enum cell (*holds)(const struct table *table, size_t row, const char *column);
    } files[] = {
        {"out/data/surfaces.csv", surfaces_columns, "surface,files", empty_in_surfaces},
        {"out/data/spectrum.csv", spectrum_columns, "surface", NULL},
        {"out/data/contact.csv", contact_columns, "surface,model", empty_in_contact},
        {"out/data/convergence.csv", convergence_columns, "sweep,model", NULL},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct table table = directory_table(*state, files[i].name);
        assert_header(&table, files[i].columns);
        assert_numbers(&table, files[i].texts, files[i].holds);
    }
}

TEST_CASE(test_the_surfaces)
{
    struct table table = directory_table(*state, "out/data/surfaces.csv");
    static const char *const files[] = {"smooth.csv", "bowl.csv", "\"rough-1.csv;rough-2.csv\""};
    assert_int_equal(table.rows, 3);
    for (size_t row = 0; row < 3; row++) {
        assert_string_equal(table_text(&table, row, "files"), files[row]);
        assert_near(table_number(&table, row, "points"), row == 1 ? 121 : 120, 0);
        assert_near(table_number(&table, row, "spacing_m"), 5e-7, 1e-12);
        assert_near(table_number(&table, row, "scan_length_m"), row == 1 ? 60.5e-6 : 60e-6, 1e-12);
        assert_near(table_number(&table, row, "m0_m2"), pow(table_number(&table, row, "rq_m"), 2), 1e-13);
        assert_near(table_number(&table, row, "nayak"),
                    table_number(&table, row, "m0_m2") * table_number(&table, row, "m4_per_m2") /
                        pow(table_number(&table, row, "m2"), 2),
                    1e-13);
        const double rq_m = table_number(&table, row, "rq_m"), ra_m = table_number(&table, row, "ra_m"),
                     fit_m = table_number(&table, row, "fit_wavelength_m");
        assert_true(0.7 * rq_m < ra_m && ra_m < rq_m);
        assert_true(table_number(&table, row, "fit_low_m") < fit_m && fit_m < table_number(&table, row, "fit_high_m"));
        assert_near(table_number(&table, row, "fit_amplitude_m"),
                    table_number(&table, row, "alpha_SI") * pow(fit_m, table_number(&table, row, "gamma")), 1e-6);
    }
    assert_within(table_number(&table, 1, "nayak"), 0.2, 0.02);          /* a parabola */
    assert_near(table_number(&table, 0, "alpha_SI"), 0.3 * 0.085, 1e-3); /* heights are printed to the femtometre */
    assert_near(table_number(&table, 0, "gamma"), 1.5, 1e-4);
}

/* Parseval over the file, the fit as in surfaces.csv, wavelengths L/n. */
TEST_CASE(test_the_spectra)
{
    struct table spectrum = directory_table(*state, "out/data/spectrum.csv");
    struct table surfaces = directory_table(*state, "out/data/surfaces.csv");
    size_t row = 0;
    for (size_t s = 0; s < surfaces.rows; s++) {
        size_t points = (size_t)table_number(&surfaces, s, "points");
        double power = 0;
        for (size_t n = 1; n <= points / 2; n++, row++) {
            double wavelength_m = table_number(&spectrum, row, "wavelength_m");
            double amplitude_m = table_number(&spectrum, row, "amplitude_m");
            assert_string_equal(table_text(&spectrum, row, "surface"), table_text(&surfaces, s, "surface"));
            assert_near(wavelength_m, table_number(&surfaces, s, "scan_length_m") / (double)n, 1e-14);
            assert_near(table_number(&spectrum, row, "fit_m"),
                        table_number(&surfaces, s, "alpha_SI") * pow(wavelength_m, table_number(&surfaces, s, "gamma")),
                        1e-12);
            power += amplitude_m * amplitude_m / (2 * n == points ? 1 : 2);
        }
        assert_near(power, table_number(&surfaces, s, "m0_m2"), 1e-12);
    }
    assert_int_equal(row, spectrum.rows);
}

/* One row against its own units and the row before of the same curve. */
static void assert_contact_row(const struct table *t, size_t row, bool starts, double sigma_m)
{
    const struct material *tin = material_find("tin");
    double load = table_number(t, row, "load_over_AnEp"), area = table_number(t, row, "area_ratio");
    double ecr = table_number(t, row, "ecr_ohm_m2"), tcr = table_number(t, row, "tcr_K_m2_per_W");
    double effective_Pa = tin->youngs_modulus_Pa / (1 - tin->poisson_ratio * tin->poisson_ratio);
    assert_near(table_number(t, row, "pressure_Pa"), load * effective_Pa, 1e-14);
    if (*table_text(t, row, "separation_m"))
        assert_near(table_number(t, row, "separation_over_sigma"), table_number(t, row, "separation_m") / sigma_m,
                    1e-13);
    assert_true(area > 0 && area <= 1);
    bool told = *table_text(t, row, "ecr_ohm_m2"), scaled = *table_text(t, row, "tcr_sd_K_m2_per_W");
    if (told)
        assert_true(area < 1 ? ecr > 0 && (!scaled || table_number(t, row, "tcr_sd_K_m2_per_W") > tcr)
                             : ecr == 0 && tcr == 0);
    if (told && ecr > 0)
        assert_near(tcr / ecr * tin->resistivity_ohm_m * tin->conductivity_W_per_mK, 1, 1e-12);
    if (starts)
        return;
    assert_true(load > table_number(t, row - 1, "load_over_AnEp"));
    assert_true(area >= table_number(t, row - 1, "area_ratio"));
    if (told)
        assert_true(ecr <= table_number(t, row - 1, "ecr_ohm_m2"));
}

static double spread_mean(const struct table *spread, const char *surface, const char *quantity)
{
    size_t from = table_find(spread, 0, "surface", surface);
    return table_number(spread, table_find(spread, from, "quantity", quantity), "mean");
}

TEST_CASE(test_the_contact_curves)
{
    struct table spread = directory_table(*state, "out/data/spread.csv");
    struct table contact = directory_table(*state, "out/data/contact.csv");
    struct table surfaces = directory_table(*state, "out/data/surfaces.csv");
    size_t curves = 0, full = 0;
    for (size_t row = 0; row < contact.rows; row++) {
        const char *surface = table_text(&contact, row, "surface"), *model = table_text(&contact, row, "model");
        size_t at = table_find(&surfaces, 0, "surface", surface);
        bool starts = row == 0 || strcmp(model, table_text(&contact, row - 1, "model")) != 0;
        bool ends = row + 1 == contact.rows || strcmp(model, table_text(&contact, row + 1, "model")) != 0;
        bool statistical = strcmp(model, "gw") == 0 || strcmp(model, "jg") == 0;
        assert_contact_row(&contact, row, starts, table_number(&surfaces, at, "rq_m"));
        curves += starts;
        if (!statistical)
            continue;
        assert_string_not_equal(surface, "bowl");
        double area = table_number(&contact, row, "area_ratio");
        assert_true(ends ? area == 1 : area < 1); /* the rows end at full contact, and there only */
        if (ends) {
            assert_within(table_number(&contact, row, "adjusted_separation_over_sigma"), 0, 1e-12);
            char column[16];
            snprintf(column, sizeof column, "beta_%s", model);
            double beta = table_number(&surfaces, at, column);
            if (strcmp(surface, "rough") != 0) /* whose is the mean of two scans' */
                assert_near(beta, -2 * table_number(&contact, row, "separation_over_sigma"), 1e-10);
            else
                assert_near(beta, spread_mean(&spread, surface, column), 1e-12);
            full++;
        }
    }
    assert_int_equal(curves, 3 * (model_count - 4) + 2 * 2); /* none is a map */
    assert_int_equal(full, 4);
}

/* ---- Records: output/record.h ---- */

/** Can a cell hold it? Pairs, flags and estimates are objects of JSON alone. */
static bool field_is_cell(const struct record_field *field)
{
    return field->kind == RECORD_NUMBER || field->kind == RECORD_COUNT || field->kind == RECORD_TEXT;
}

/** The columns from `first` on are the fields that are in tables, and no more where the record is the `whole` row. */
static void assert_columns(const void *place, const char *name, size_t first, const struct record_field *fields,
                           bool whole)
{
    struct table table = directory_table(place, name);
    size_t column = first;
    for (; fields->key; fields++)
        if (fields->when & (RECORD_CSV | RECORD_ASPERITIES)) {
            assert_true(field_is_cell(fields));
            assert_true(column < table.columns);
            assert_string_equal(table.cell[column++], fields->key);
        }
    assert_true(!whole || column == table.columns);
}

/** The keys from the first field's on are the fields that are in JSON, and no others where it is the `whole` object. */
static void assert_keys(json_t *object, const struct record_field *fields, bool whole)
{
    void *at = json_object_iter(object);
    while (fields->key && !(fields->when & RECORD_JSON))
        fields++;
    while (!whole && at && strcmp(json_object_iter_key(at), fields->key) != 0)
        at = json_object_iter_next(object, at);
    for (; fields->key; fields++)
        if (fields->when & RECORD_JSON) {
            assert_non_null(at);
            assert_string_equal(json_object_iter_key(at), fields->key);
            at = json_object_iter_next(object, at);
        }
    assert_true(!whole || !at);
}

/* A record's columns and its keys come from one table. */
TEST_CASE(test_a_table_of_fields_is_header_and_keys)
{
    json_t *root = directory_json(*state, "out/results.json");
    json_t *surface = json_array_get(json_object_get(root, "surfaces"), 2),
           *spread = json_object_get(surface, "spread");
    assert_columns(*state, "out/data/surfaces.csv", 2, surface_fields, false);
    assert_keys(surface, surface_fields, false);
    assert_columns(*state, "out/data/answers.csv", 0, answer_fields, true);
    assert_keys(json_array_get(json_object_get(root, "answers"), 0), answer_fields, true);
    assert_columns(*state, "out/data/limits.csv", 0, limit_fields, true);
    assert_keys(json_array_get(json_object_get(root, "limits"), 0), limit_fields, true);
    assert_columns(*state, "out/data/spread.csv", 2, record_estimate_fields, true);
    assert_keys(json_object_get(spread, "rq_m"), record_estimate_fields, true);
    assert_keys(spread, repeats_fields, true);
}

/** Fails where two fields of what the bits `when` say lie at one place: one of them has the other's. */
static void assert_apart(const struct record_field *fields, unsigned when)
{
    for (const struct record_field *a = fields; a->key; a++)
        for (const struct record_field *b = fields; b < a; b++)
            if ((a->when & b->when & when) && (a->offset == b->offset || strcmp(a->key, b->key) == 0))
                fail_msg("'%s' and '%s' are one field", a->key, b->key);
}

/* A field lies where its name says: none has another's number; test_the_surfaces has the equations between them. */
TEST_CASE(test_fields_lie_where_they_say)
{
    const struct record_field *const tables[] = {surface_fields, repeats_fields, answer_fields, limit_fields,
                                                 record_estimate_fields};
    for (size_t t = 0; t < sizeof tables / sizeof *tables; t++) {
        assert_apart(tables[t], RECORD_CSV);
        assert_apart(tables[t], RECORD_JSON);
    }
}

/* What is shown in a column is a number, in a unit of the dimension that its key ends in. */
TEST_CASE(test_shown_fields_have_units)
{
    size_t shown = 0;
    const char *words = directory_read(PROJECT_SOURCE, "templates/words.txt");
    for (const struct record_field *field = surface_fields; field->key; field++) {
        struct unit unit = {.factor = 1}, key = {.factor = 1};
        const char *ending = strrchr(field->key, '_');
        if (field->digits == 0)
            continue;
        shown++;
        assert_int_equal(field->kind, RECORD_NUMBER);
        assert_in_range(field->digits, 2, 4);
        if (field->unit[0]) {
            assert_true(unit_read(&unit, field->unit, strlen(field->unit)));
            assert_true(ending && unit_read(&key, ending + 1, strlen(ending + 1)));
            assert_memory_equal(unit.power, key.power, sizeof unit.power);
        }
        assert_near(record_unit(field), unit.factor, 0);
        assert_non_null(strstr(words, filled("\ncolumn.%s ", field->key)));
    }
    assert_true(shown >= 2);
}

/* And the estimates have the same names in spread.csv and in results.json. */
TEST_CASE(test_estimates_have_one_name)
{
    struct table spread = directory_table(*state, "out/data/spread.csv");
    json_t *root = directory_json(*state, "out/results.json"), *of, *estimate;
    json_t *surface = json_array_get(json_object_get(root, "surfaces"), 2);
    const char *model, *key;
    size_t found = 0, rows = 0;
    json_object_foreach (json_object_get(surface, "models"), model, of)
        json_object_foreach (json_object_get(of, "at_middle_load"), key, estimate) {
            bool curve = strcmp(key, "beta") == 0 || strcmp(key, "full_contact_load_over_AnEp") == 0;
            const char *name = filled("%s%s_%s", key, curve ? "" : "_at_middle_load", model);
            assert_near(json_number_value(json_object_get(estimate, "mean")), spread_mean(&spread, "rough", name), 0);
            found++;
        }
    json_object_foreach (json_object_get(surface, "spread"), key, estimate) {
        const json_t *mean = json_object_get(estimate, "mean");
        if (json_is_number(mean)) /* else nothing is known of it, which is no row */
            assert_near(json_number_value(mean), spread_mean(&spread, "rough", key), 0);
        found += json_is_number(mean);
    }
    for (size_t row = 0; row < spread.rows; row++)
        rows += strcmp(table_text(&spread, row, "surface"), "rough") == 0;
    assert_int_equal(found, rows);
}

/* One function writes a number, one a text, one what is missing. */
TEST_CASE(test_every_kind_of_field)
{
    struct record {
        double number, none, endless, pair[2];
        const char *text, *missing;
        size_t count;
        bool flag;
    };
    const struct record record = {1.5, NAN, INFINITY, {1, NAN}, "a\x01", NULL, 3, true};
#define FIELD(...) RECORD_FIELD(struct record, __VA_ARGS__)
    static const struct record_field fields[] = {
        FIELD(NUMBER, "number", number, ALWAYS), FIELD(NUMBER, "none", none, ALWAYS),
        FIELD(NUMBER, "endless", endless, JSON), FIELD(PAIR, "pair", pair, JSON),
        FIELD(TEXT, "text", text, ALWAYS),       FIELD(TEXT, "missing", missing, JSON),
        FIELD(COUNT, "count", count, JSON),      FIELD(FLAG, "flag", flag, JSON),
        FIELD(NUMBER, "elsewhere", number, CSV), {0}};
#undef FIELD
    json_auto_t *json = record_json(fields, &record),
                *expected = json_pack("{s:f, s:n, s:n, s:[f, n], s:s, s:n, s:i, s:b}", "number", 1.5, "none", "endless",
                                      "pair", 1.0, "text", "a\\x01", "missing", "count", 3, "flag", true);
    assert_true(json_equal(json, expected));
}

/* JSON has the bytes that jansson gives it. */
TEST_CASE(test_json_is_as_jansson_prints_it)
{
    static const double numbers[] = {0,      -0.0,    1,      -2,    0.1,    1.0 / 3, 1e-7,  -1.5e-7,  1e16,
                                     1e17,   1e22,    2.5e30, 1e100, 1e-45,  1e-4,    1e-5,  123456.5, 6.02214076e23,
                                     1e-300, DBL_MAX, 1e-10,  1e10,  5e-324, 100,     7e-20, 0.5};
    json_auto_t *json = json_pack("{s:s, s:[], s:{}, s:n, s:b, s:i, s:{s:[[s], {s:s}]}, s:o}", "text \"\\\n", "µ\x01\"",
                                  "none", "nothing", "null", "flag", 1, "count", -7, "deep", "er", "a", "b", "ü",
                                  "numbers", json_numbers(numbers, sizeof numbers / sizeof *numbers));
    struct text *text = support_text();
    OWNED(memory_free) char *expected = json_dumps(json, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
    assert_true(json_text(text, json));
    assert_string_equal(text_string(text), expected);
    assert_false(json_text(text, NULL));
}

/* Nothing that was not called for leaves a column, a row or a file. */
TEST_CASE(test_what_does_not_run_leaves_nothing)
{
    static const struct {
        const char *scene, *contact, *models;
        bool beta, study;
    } cases[] = {
        {"effects: [electrical]\n", "surface,model,load_over_AnEp,pressure_Pa,area_ratio,ecr_ohm_m2", NULL, false,
         false},
        {"models: [multiscale]\nconvergence: {scales: 9}\n",
         "surface,model,load_over_AnEp,pressure_Pa,area_ratio,separation_m,separation_over_sigma,ecr_ohm_m2,"
         "tcr_K_m2_per_W,tcr_sd_K_m2_per_W,gap_m",
         "multiscale-elastic multiscale-plastic", false, true},
        {"models: [statistical]\nconvergence: {scales: 9}\n", NULL, "gw jg", true, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        OWNED(text_free) struct text scene = {0};
        text_add(&scene, "material: tin\n%s", cases[i].scene);
        directory_write(*state, "few/scene.yaml", text_string(&scene));
        assert_int_equal(pipeline_run(*state, "few", "out-few", 1), 0);
        struct table contact = directory_table(*state, "out-few/data/contact.csv");
        struct table surfaces = directory_table(*state, "out-few/data/surfaces.csv");
        if (cases[i].contact)
            assert_header(&contact, cases[i].contact);
        assert_numbers(&contact, "surface,model", empty_in_contact);
        for (size_t row = 0; row < contact.rows; row++) {
            const char *model = table_text(&contact, row, "model");
            assert_true(cases[i].models ? strstr(cases[i].models, model) != NULL
                                        : !model_rows[model_named(model)]->plastic);
        }
        assert_int_equal(has_column(&surfaces, "beta_jg"), cases[i].beta);
        assert_int_equal(has_column(&surfaces, "asperity_radius_m"), cases[i].beta || !cases[i].models);
        assert_int_equal(directory_has(*state, "out-few/data/convergence.csv"), cases[i].study);
    }
}

static void grow_beyond(struct surface_record *record, size_t index)
{
    struct model_curve *curve = &record->curves[model_named("gw")];
    if (index == 1 && curve->exists)
        curve->points[1].value[QUANTITY_ECR] = INFINITY;
}

/* A number that is infinite has an empty cell. */
TEST_CASE(test_infinite_numbers_are_left_out)
{
    struct made_up made;
    directory_write(*state, "infinite/data/x", "");
    made_up_make(&made, grow_beyond);
    expect_ok(tables_write, &made.results, directory_path(*state, "infinite"));
    assert_null(strstr(directory_read(*state, "infinite/data/contact.csv"), "inf"));
    made_up_free(&made);
}

TEST_CASE(test_scales_are_spread_evenly)
{
    size_t index[50];
    for (size_t scales = 1; scales <= 100000; scales *= 10) {
        size_t count = results_sweep_scales(index, 50, scales);
        assert_true(count >= 1 && count <= 50 && count <= scales);
        assert_int_equal(index[0], 0);
        assert_int_equal(index[count - 1], scales - 1);
        for (size_t k = 1; k < count; k++) {
            assert_true(index[k] > index[k - 1]);
            assert_true((double)(index[k] + 1) / (double)(index[k - 1] + 1) <=
                        fmax(2, 1.5 * pow((double)scales, 1 / 49.0)));
        }
    }
}

TEST_GROUP(place_setup, directory_teardown)
