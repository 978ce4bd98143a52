/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library against the program: the same numbers to the last bit, the same refusals; and that a fault of the caller
 * comes back as an error. Of the library, only the public header is used. */
#include "cli/process.h"
#include "contact/model.h"
#include "library/roughcontact.h"
#include "scan/zip_support.h"

static struct roughcontact_scan *read_scan(const char *place, const char *path)
{
    struct roughcontact_status status;
    struct roughcontact_scan *scan;
    if (roughcontact_scan_read_file(&scan, filled("%s/%s", place, path), NULL, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    return scan;
}

static struct roughcontact_scan *scan_of_bytes(const char *bytes, size_t length)
{
    struct roughcontact_status status;
    struct roughcontact_scan *scan;
    if (roughcontact_scan_read_bytes(&scan, bytes, length, "in memory", NULL, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    return scan;
}

/** Of a scan, which is freed. */
static struct roughcontact_surface *make_surface(struct roughcontact_scan *scan,
                                                 const struct roughcontact_surface_options *options)
{
    struct roughcontact_status status;
    struct roughcontact_surface *surface;
    if (roughcontact_surface_make(&surface, scan, options, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    roughcontact_scan_free(scan);
    return surface;
}

struct property {
    const char *key;
    double value;
};

/** A material of these properties, up to one without a key. */
static struct roughcontact_material *make_material(const char *name, const struct property *properties)
{
    struct roughcontact_status status;
    struct roughcontact_material *material;
    if (roughcontact_material_new(&material, name, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    for (const struct property *p = properties; p && p->key; p++)
        if (roughcontact_material_set(material, p->key, p->value, &status) != ROUGHCONTACT_OK)
            fail_msg("%s", status.message);
    return material;
}

/** Bit for bit, an empty cell being NaN. */
static void expect_cell(const struct table *table, size_t row, const char *column, double value)
{
    const char *cell = table_text(table, row, column);
    double expected = *cell ? strtod(cell, NULL) : NAN;
    if (isnan(expected) ? !isnan(value) : value != expected)
        fail_msg("row %zu, %s: the program has '%s', the library %.17g", row, column, cell, value);
}

/** The load of a row of contact.csv; infinite where the rows of this model have ended. */
static double load_of(const struct table *table, size_t row, const char *model)
{
    return row < table->rows && strcmp(table_text(table, row, "model"), model) == 0
               ? table_number(table, row, "load_over_AnEp")
               : INFINITY;
}

/** What contact.csv has of one surface and model, from row `first` on; returns how many rows. */
static size_t expect_curve(const struct table *table, size_t first, const struct roughcontact_surface *surface,
                           const struct roughcontact_run_options *how, const double *loads, size_t count)
{
    struct roughcontact_status status;
    struct roughcontact_curve *curve;
    const char *model = table_text(table, first, "model");
    if (roughcontact_run(&curve, surface, model, loads, count, how, &status) != ROUGHCONTACT_OK)
        fail_msg("%s: %s", model, status.message);
    size_t row = first, met = 0;
    for (size_t i = 0; i < count; i++) {
        const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
        assert_true(point->load == loads[i]);
        if (load_of(table, row, model) != loads[i]) { /* the program's rows have ended, or with one at full contact */
            assert_false(point->exists || point->valid);
            assert_true(isnan(point->area_ratio) && isnan(point->ecr_ohm_m2) && isnan(point->separation_m));
            assert_true(isinf(load_of(table, row, model)) || isinf(load_of(table, row + 1, model)));
            continue;
        }
        assert_true(point->exists);
        if (how->material) {
            expect_cell(table, row, "pressure_Pa", point->pressure_Pa);
            expect_cell(table, row, "ecr_ohm_m2", point->ecr_ohm_m2);
            expect_cell(table, row, "tcr_K_m2_per_W", point->tcr_K_m2_per_W);
            expect_cell(table, row, "tcr_sd_K_m2_per_W", point->tcr_sd_K_m2_per_W);
        }
        expect_cell(table, row, "area_ratio", point->area_ratio);
        expect_cell(table, row, "separation_m", point->separation_m);
        row++;
        met++;
    }
    assert_null(roughcontact_curve_point(curve, count));
    assert_true(met > count / 4);
    roughcontact_curve_free(curve);
    return row - first + (isfinite(load_of(table, row, model)) ? 1 : 0);
}

static void expect_surface(const struct table *table, const struct table *amplitudes,
                           const struct roughcontact_surface *surface)
{
    const struct roughcontact_roughness *r = roughcontact_surface_roughness(surface);
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    const struct roughcontact_spectrum *spectrum = roughcontact_surface_spectrum(surface);
    const struct property cells[] = {{"rq_m", r->rq_m},
                                     {"ra_m", r->ra_m},
                                     {"m0_m2", r->m0_m2},
                                     {"m2", r->m2},
                                     {"m4_per_m2", r->m4_per_m2},
                                     {"alpha_SI", law->alpha},
                                     {"gamma", law->gamma},
                                     {"gamma_stderr", law->gamma_error},
                                     {"fit_amplitude_m", law->amplitude_m},
                                     {"fit_amplitude_stderr_decades", law->amplitude_error_decades},
                                     {"fit_wavelength_m", law->wavelength_m},
                                     {"fit_low_m", law->low_m},
                                     {"fit_high_m", law->high_m},
                                     {"fit_misfit_decades", law->misfit_decades}};
    for (size_t c = 0; c < sizeof cells / sizeof *cells; c++)
        expect_cell(table, 0, cells[c].key, cells[c].value);
    if (law->law == ROUGHCONTACT_LAW_SCATTERED) /* about a line, by more than a law's lack of fit may be */
        assert_true(law->misfit_decades > 0.1);
    else
        assert_int_equal(law->law, isnan(law->gamma)               ? ROUGHCONTACT_LAW_NONE
                                   : law->high_m < 10 * law->low_m ? ROUGHCONTACT_LAW_NARROW
                                                                   : ROUGHCONTACT_LAW_FOUND);
    assert_int_equal(spectrum->count, amplitudes->rows);
    for (size_t n = 1; n <= spectrum->count; n++) {
        expect_cell(amplitudes, n - 1, "amplitude_m", spectrum->amplitude_m[n - 1]);
        assert_near(spectrum->length_m / (double)n, table_number(amplitudes, n - 1, "wavelength_m"), 1e-15);
    }
}

static struct table report_table(const char *place, const char *name)
{
    return table_read_path(filled("%s/out/data/%s", place, name));
}

/** Reports d/a.csv with every model under `scene`, and asks the library for all of the same. */
static void compare(const char *place, const char *scene, const struct roughcontact_surface_options *options,
                    const struct roughcontact_run_options *how)
{
    char text[2048];
    int length =
        snprintf(text, sizeof text, "%s\neffects: [%sseparation]\nload: {from: 1e-7, to: 0.3, points: 25}\nmodels: [",
                 scene, how->material ? "plasticity, electrical, thermal, scale-dependent, " : "");
    for (size_t m = 0; m < model_count; m++)
        if (how->material || !model_rows[m]->plastic)
            length +=
                snprintf(text + length, sizeof text - (size_t)length, "%s%s", m > 0 ? ", " : "", model_rows[m]->name);
    snprintf(text + length, sizeof text - (size_t)length, "]\n");
    workspace_write(place, "d/scene.yaml", text);
    run_to_exit(place, 0, "report", "d", "-o", "out", "--no-cost", "--brief");
    struct table contact = report_table(place, "contact.csv"), surfaces = report_table(place, "surfaces.csv"),
                 amplitudes = report_table(place, "spectrum.csv");

    struct roughcontact_surface *surface = make_surface(read_scan(place, "d/a.csv"), options);
    expect_surface(&surfaces, &amplitudes, surface);
    double loads[25]; /* all of them: stacked scales go on beyond full contact */
    size_t count = 0, models = 0;
    for (; count < 25; count++)
        loads[count] = table_number(&contact, count, "load_over_AnEp");
    assert_true(loads[24] == 0.3);
    for (size_t row = 0; row < contact.rows; models++)
        row += expect_curve(&contact, row, surface, how, loads, count);
    assert_true(models >= (how->material ? 9 : 4));
    roughcontact_surface_free(surface);
}

/** Uneven x, points missing, a record that does not close on itself. */
static void write_uneven(const char *place)
{
    char uneven[32768] = "x [um],z [um]\n";
    for (int i = 0, length = (int)strlen(uneven); i < 600; i++)
        length += snprintf(uneven + length, sizeof uneven - (size_t)length, i % 50 == 7 ? "%.4f,NaN\n" : "%.4f,%.6f\n",
                           0.5 * i + 0.1 * sin(i), 1e-3 * i + sin(0.2 * i) + 0.3 * sin(1.1 * i * i));
    workspace_write(place, "d/a.csv", uneven);
}

TEST_IN_WORKSPACE(report_and_library_agree)
{
    static const struct property properties[] = {{"E_Pa", 70e9},
                                                 {"nu", 0.33},
                                                 {"Sy_Pa", 120e6},
                                                 {"resistivity_ohm_m", 2.8e-8},
                                                 {"conductivity_W_per_mK", 200},
                                                 {"density_kg_per_m3", 2700},
                                                 {"specific_heat_J_per_kgK", 900},
                                                 {"sound_speed_m_per_s", 6000},
                                                 {NULL, 0}};
    struct roughcontact_material *tin = make_material("tin", NULL), *copper = make_material("copper", NULL),
                                 *own = make_material(NULL, properties);
    const struct {
        const char *scene;
        const struct roughcontact_material *material, *counterface;
        double hardness_Pa, lambda_s_m, lambda_c_m;
        bool uneven;
    } cases[] = {
        {"material: tin", tin, NULL, NAN, 0, 0, false},
        {"material: tin\nlambda_s: 4 um", tin, NULL, NAN, 4e-6, 0, false}, /* no wave below twice that is fitted */
        {"material: tin\ncounterface: copper\nhardness: 55 MPa\nlambda_s: 2 um\nlambda_c: 200 um", tin, copper, 55e6,
         2e-6, 2e-4, false},
        {"material: {E: 70 GPa, nu: 0.33, Sy: 120 MPa, resistivity: 2.8e-8, conductivity: 200, density: 2700,\n"
         "  specific_heat: 900, sound_speed: 6000}",
         own, NULL, NAN, 0, 0, false},
        {"", NULL, NULL, NAN, 0, 0, false},
        {"material: tin", tin, NULL, NAN, 0, 0, true},
    };
    workspace_scan(place, "d/a.csv", 700, 3);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct roughcontact_run_options how;
        struct roughcontact_surface_options options;
        roughcontact_run_options_init(&how);
        roughcontact_surface_options_init(&options);
        how.material = cases[i].material;
        how.counterface = cases[i].counterface;
        how.hardness_Pa = cases[i].hardness_Pa;
        options.lambda_s_m = cases[i].lambda_s_m;
        options.lambda_c_m = cases[i].lambda_c_m;
        if (cases[i].uneven)
            write_uneven(place);
        compare(place, cases[i].scene, i == 0 ? NULL : &options, &how);
    }
    roughcontact_material_free(own);
    roughcontact_material_free(tin);
    roughcontact_material_free(copper);
}

/** What `inspect` says of a scan; returns how many warnings. */
static size_t expect_inspected(const char *place, const char *path, bool even)
{
    struct process process = expect_exit(place, 0, "inspect", "--json", path);
    json_t *all = support_json(process.out), *said = json_array_get(all, 0);
    json_t *warnings = json_object_get(said, "warnings"), *parameters = json_object_get(said, "parameters");
    struct roughcontact_scan *scan = read_scan(place, path);
    size_t met = 0;
    for (const char *warning; (warning = roughcontact_scan_warning(scan, met)) != NULL; met++)
        assert_string_equal(json_string_value(json_array_get(warnings, met)), warning);
    struct roughcontact_surface *surface = make_surface(scan, NULL);
    const struct roughcontact_roughness *r = roughcontact_surface_roughness(surface);
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    const struct property numbers[] = {
        {"rq_m", r->rq_m},        {"ra_m", r->ra_m},     {"pv_m", r->pv_m},          {"m2", r->m2},
        {"alpha_SI", law->alpha}, {"gamma", law->gamma}, {"m4_per_m2", r->m4_per_m2}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        json_t *value = json_object_get(said, numbers[i].key);
        if (json_is_null(value) ? !isnan(numbers[i].value) : json_real_value(value) != numbers[i].value)
            fail_msg("%s: the library has %.17g", numbers[i].key, numbers[i].value);
    }
    if (even) {
        assert_near(json_real_value(json_object_get(parameters, "Psk")), r->rsk, 1e-9);
        assert_near(json_real_value(json_object_get(parameters, "Pku")), r->rku, 1e-9);
    }
    for (size_t n = 0; roughcontact_surface_note(surface, n); n++, met++)
        assert_string_equal(json_string_value(json_array_get(warnings, met)), roughcontact_surface_note(surface, n));
    assert_int_equal(met, json_array_size(warnings));
    roughcontact_surface_free(surface);
    return met;
}

TEST_IN_WORKSPACE(inspect_and_library_agree)
{
    workspace_scan(place, "a.csv", 1200, 5);
    (void)expect_inspected(place, "a.csv", true);
    write_uneven(place);
    assert_true(expect_inspected(place, "d/a.csv", false) > 0);
}

TEST_IN_WORKSPACE(bytes_are_as_the_file)
{
    workspace_scan(place, "a.csv", 500, 7);
    char *content = workspace_read(place, "a.csv");
    size_t length = strlen(content);
    char *exact = support_room(length); /* no NUL behind it */
    memcpy(exact, content, length);
    struct roughcontact_scan *bytes = scan_of_bytes(exact, length);
    memset(exact, 0, length); /* they were copied */
    struct roughcontact_surface *one = make_surface(read_scan(place, "a.csv"), NULL), *two = make_surface(bytes, NULL);
    const struct roughcontact_spectrum *a = roughcontact_surface_spectrum(one), *b = roughcontact_surface_spectrum(two);
    assert_int_equal(a->count, 250);
    assert_int_equal(b->count, 250);
    assert_memory_equal(a->amplitude_m, b->amplitude_m, 250 * sizeof(double));
    roughcontact_surface_free(one);
    roughcontact_surface_free(two);
}

/** Of an archive the first scan is read, and that there are more is said. */
TEST_IN_WORKSPACE(archives_say_what_was_read)
{
    char *content;
    workspace_scan(place, "a.csv", 300, 1);
    content = workspace_read(place, "a.csv");
    struct packed members[] = {pack("one.csv", content, strlen(content), true),
                               pack("two.csv", content, strlen(content), true)};
    for (size_t count = 1; count <= 2; count++) {
        struct text zip = zip_of(members, count);
        struct roughcontact_scan *scan = scan_of_bytes(zip.data, zip.length);
        const char *last = NULL;
        for (size_t i = 0; roughcontact_scan_warning(scan, i); i++)
            last = roughcontact_scan_warning(scan, i);
        assert_true((count == 2) == (last && strstr(last, "several scans; 'one.csv', the first, is read")));
        roughcontact_scan_free(scan);
        text_free(&zip);
    }
    text_free(&members[0].bytes);
    text_free(&members[1].bytes);
}

/** What the program says of a file, the library says, but of the remedy: it never guesses a unit. */
TEST_IN_WORKSPACE(units_are_not_guessed)
{
    struct roughcontact_status status;
    struct roughcontact_scan_options options;
    struct roughcontact_scan *scan = (struct roughcontact_scan *)&status;
    char text[1024] = "";
    for (int i = 0; i < 64; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%d,%d\n", i, i * i % 7);
    workspace_write(place, "bare.csv", text);
    struct process process = process_run(place, "inspect", "bare.csv");
    assert_int_equal(process.status, 4);
#define READ(code)                                                                                                     \
    assert_int_equal(roughcontact_scan_read_bytes(&scan, text, strlen(text), "bare.csv", &options, &status), code)
    roughcontact_scan_options_init(&options);
    READ(ROUGHCONTACT_SCAN);
    assert_null(scan);
    expect_part(process.err, status.message);

    options.z_unit = "furlong";
    READ(ROUGHCONTACT_USAGE);
    expect_part(status.message, "furlong");
    options.x_unit = "mm";
    options.z_unit = "um";
    READ(ROUGHCONTACT_OK);
#undef READ
    struct roughcontact_surface *surface = make_surface(scan, NULL);
    assert_near(roughcontact_surface_spectrum(surface)->length_m, 64e-3, 1e-12);
    assert_within(roughcontact_surface_roughness(surface)->pv_m, 4e-6, 0.5e-6);
    roughcontact_surface_free(surface);

    assert_int_equal(roughcontact_scan_read_file(&scan, "/nowhere/at all", NULL, &status), ROUGHCONTACT_IO);
    expect_part(status.message, "/nowhere/at all");
    assert_int_equal(roughcontact_scan_read_file(&scan, "/no\n\033]0;x\a\xff", NULL, &status), ROUGHCONTACT_IO);
    expect_part(status.message, "'/no\\x0a\\x1b]0;x\\x07\\xff'");
    assert_int_equal(roughcontact_scan_read_file(&scan, place, NULL, &status), ROUGHCONTACT_IO);
    assert_int_equal(roughcontact_scan_read_file(&scan, NULL, NULL, &status), ROUGHCONTACT_USAGE);
    assert_int_equal(roughcontact_scan_read_bytes(&scan, "", 0, NULL, NULL, NULL), ROUGHCONTACT_SCAN);
    assert_int_equal(roughcontact_scan_read_bytes(&scan, NULL, 3, NULL, NULL, NULL), ROUGHCONTACT_USAGE);
}

#define EXPECT(call, expected, part)                                                                                   \
    do {                                                                                                               \
        struct roughcontact_status status;                                                                             \
        assert_int_equal(call, expected);                                                                              \
        assert_int_equal(status.code, expected);                                                                       \
        expect_part(status.message, part);                                                                             \
    } while (0)

TEST_IN_WORKSPACE(faults_of_surfaces_are_errors)
{
    const size_t profile = ROUGHCONTACT_NO_ROW;
    const struct {
        struct roughcontact_surface_options options;
        int code;
        const char *part;
    } faults[] = {
        {{profile, NAN, 0}, ROUGHCONTACT_USAGE, "lambda_s_m is nan"},
        {{profile, 0, -1}, ROUGHCONTACT_USAGE, "lambda_c_m is -1"},
        {{profile, 1e-5, 1e-6}, ROUGHCONTACT_USAGE, "nothing would be left"},
        {{profile, 1e-5, 1}, ROUGHCONTACT_SCAN, "lambda_c"},
        {{1, 0, 0}, ROUGHCONTACT_USAGE, "there is no row 1"},
    };
    struct roughcontact_surface *surface;
    workspace_scan(place, "a.csv", 300, 9);
    struct roughcontact_scan *scan = read_scan(place, "a.csv");
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        EXPECT(roughcontact_surface_make(&surface, scan, &faults[i].options, &status), faults[i].code, faults[i].part);
        assert_null(surface);
    }
    EXPECT(roughcontact_surface_make(&surface, NULL, NULL, &status), ROUGHCONTACT_USAGE, "no scan");
    roughcontact_scan_free(scan);
    roughcontact_scan_free(NULL);
    roughcontact_surface_free(NULL);
}

TEST_CASE(faults_of_materials_are_errors)
{
    struct roughcontact_material *material;
    EXPECT(roughcontact_material_new(&material, "unobtainium", &status), ROUGHCONTACT_USAGE, "unobtainium");
    assert_null(material);
    material = make_material(NULL, NULL);
    EXPECT(roughcontact_material_set(material, "E", 1e9, &status), ROUGHCONTACT_USAGE, "'E'");
    EXPECT(roughcontact_material_set(material, NULL, 1e9, &status), ROUGHCONTACT_USAGE, "no property");
    EXPECT(roughcontact_material_set(material, "nu", 0.6, &status), ROUGHCONTACT_USAGE, "nu is 0.6");
    EXPECT(roughcontact_material_set(material, "nu", NAN, &status), ROUGHCONTACT_USAGE, "nu is nan");
    EXPECT(roughcontact_material_set(NULL, "nu", 0.3, &status), ROUGHCONTACT_USAGE, "no material");
    roughcontact_material_free(material);
    roughcontact_material_free(NULL);
}

/** What is wrong is said, and no handle comes of it. */
TEST_IN_WORKSPACE(faults_of_runs_are_errors)
{
    static const double rising[] = {1e-4, 1e-3}, falling[] = {1e-3, 1e-4}, zero[] = {0, 1e-3};
    static const struct property elastic[] = {{"E_Pa", 1e11}, {"nu", 0.3}, {NULL, 0}};
    struct roughcontact_material *none = make_material(NULL, NULL), *some = make_material(NULL, elastic);
    struct roughcontact_curve *curve;
    struct roughcontact_run_options how;
    workspace_scan(place, "a.csv", 300, 9);
    struct roughcontact_surface *surface = make_surface(read_scan(place, "a.csv"), NULL);
    const struct {
        const char *model;
        const double *loads;
        size_t count;
        const struct roughcontact_material *material, *counterface;
        double hardness_Pa;
        int load;
        const char *part;
    } faults[] = {
        {"gw", rising, 2, none, NULL, NAN, 0, "the material has no E_Pa"},
        {"gw", rising, 2, some, none, NAN, 0, "the counterface has no E_Pa"},
        {"jg", rising, 2, some, NULL, NAN, 0, "'jg' needs a material with Sy_Pa"},
        {"jg", rising, 2, NULL, NULL, NAN, 0, "needs a material with Sy_Pa"},
        {"no such", rising, 2, some, NULL, NAN, 0, "no such"},
        {NULL, rising, 2, some, NULL, NAN, 0, "unknown model"},
        {"gw", falling, 2, some, NULL, NAN, 0, "load 2 is 0.0001"},
        {"gw", zero, 2, some, NULL, NAN, 0, "load 1 is 0"},
        {"gw", rising, 0, some, NULL, NAN, 0, "no loads"},
        {"gw", rising, 2, some, NULL, NAN, 2, "load 2 is not known"},
        {"gw", rising, 2, NULL, NULL, NAN, ROUGHCONTACT_LOAD_PRESSURE_PA, "loads in Pa need a material"},
        {"gw", rising, 2, NULL, NULL, 1e9, 0, "hardness"},
        {"gw", rising, 2, some, NULL, 1, 0, "hardness_Pa is 1;"},
        {"gw", rising, 2, NULL, some, NAN, 0, "counterface"},
    };
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        roughcontact_run_options_init(&how);
        how.material = faults[i].material;
        how.counterface = faults[i].counterface;
        how.hardness_Pa = faults[i].hardness_Pa;
        how.load = faults[i].load;
        EXPECT(roughcontact_run(&curve, surface, faults[i].model, faults[i].loads, faults[i].count, &how, &status),
               ROUGHCONTACT_USAGE, faults[i].part);
        assert_null(curve);
    }
    EXPECT(roughcontact_run(&curve, NULL, "gw", rising, 2, NULL, &status), ROUGHCONTACT_USAGE, "no surface");
    roughcontact_surface_free(surface);

    /* of a mere hollow the Nayak parameter is one for which no asperities exist */
    char hollow[4096] = "x [um],z [um]\n";
    for (int i = 0; i < 128; i++)
        snprintf(hollow + strlen(hollow), sizeof hollow - strlen(hollow), "%d,%.3f\n", i, 1e-3 * i * (i - 127));
    surface = make_surface(scan_of_bytes(hollow, strlen(hollow)), NULL);
    EXPECT(roughcontact_run(&curve, surface, "gw", rising, 2, NULL, &status), ROUGHCONTACT_MODEL, "no gw");
    roughcontact_surface_free(surface);
    roughcontact_material_free(none);
    roughcontact_material_free(some);
    roughcontact_curve_free(NULL);
}

/** A map is no profile until a row of it is named. */
TEST_CASE(a_map_needs_a_row)
{
    static const char head[] = "Gwyddion Simple Field 1.0\nXRes = 64\nYRes = 3\nXReal = 64e-6\nYReal = 3e-6\n"
                               "XYUnits = m\nZUnits = m\n";
    char bytes[2048];
    size_t length = strlen(head);
    memcpy(bytes, head, length);
    do
        bytes[length++] = '\0';
    while (length % 4 != 0);
    for (int i = 0; i < 192; i++, length += sizeof(float)) {
        float z = (float)(1e-7 * sin(i * i * 0.37) * (i / 64 + 1));
        memcpy(bytes + length, &z, sizeof z);
    }
    struct roughcontact_scan *scan = scan_of_bytes(bytes, length);
    struct roughcontact_surface *surface;
    struct roughcontact_surface_options options;
    EXPECT(roughcontact_surface_make(&surface, scan, NULL, &status), ROUGHCONTACT_USAGE, "`row`");
    roughcontact_surface_options_init(&options);
    double rq_m[3];
    for (options.row = 0; options.row < 3; options.row++) {
        assert_int_equal(roughcontact_surface_make(&surface, scan, &options, NULL), ROUGHCONTACT_OK);
        rq_m[options.row] = roughcontact_surface_roughness(surface)->rq_m;
        roughcontact_surface_free(surface);
    }
    assert_true(rq_m[0] < 0.7 * rq_m[1] && rq_m[1] < 0.85 * rq_m[2]);
    EXPECT(roughcontact_surface_make(&surface, scan, &options, &status), ROUGHCONTACT_USAGE, "no row 3");
    roughcontact_scan_free(scan);
}

/** Loads in Pa are those over E' times E'. */
TEST_IN_WORKSPACE(loads_may_be_pressures)
{
    static const struct property elastic[] = {{"E_Pa", 40e9}, {"nu", 0.3}, {NULL, 0}};
    const double modulus_Pa = 40e9 / (1 - 0.3 * 0.3), loads[] = {1e-5, 1e-4, 1e-3};
    const double pressures_Pa[] = {1e-5 * modulus_Pa, 1e-4 * modulus_Pa, 1e-3 * modulus_Pa};
    workspace_scan(place, "a.csv", 400, 2);
    struct roughcontact_surface *surface = make_surface(read_scan(place, "a.csv"), NULL);
    struct roughcontact_material *material = make_material(NULL, elastic);
    struct roughcontact_run_options how;
    struct roughcontact_curve *one, *two;
    roughcontact_run_options_init(&how);
    how.material = material;
    assert_int_equal(roughcontact_run(&one, surface, "multiscale-elastic", loads, 3, &how, NULL), ROUGHCONTACT_OK);
    how.load = ROUGHCONTACT_LOAD_PRESSURE_PA;
    assert_int_equal(roughcontact_run(&two, surface, "multiscale-elastic", pressures_Pa, 3, &how, NULL),
                     ROUGHCONTACT_OK);
    for (size_t i = 0; i < 3; i++) {
        const struct roughcontact_point *a = roughcontact_curve_point(one, i), *b = roughcontact_curve_point(two, i);
        assert_near(b->load, loads[i], 1e-15);
        assert_near(a->pressure_Pa, pressures_Pa[i], 1e-15);
        assert_near(b->area_ratio, a->area_ratio, 1e-12);
        assert_true(isnan(a->ecr_ohm_m2)); /* the material has no resistivity */
    }
    roughcontact_curve_free(one);
    roughcontact_curve_free(two);
    roughcontact_material_free(material);
    roughcontact_surface_free(surface);
}

/** Beyond the range that a model was made for its points exist but are not valid. */
TEST_IN_WORKSPACE(validity_is_told)
{
    workspace_scan(place, "a.csv", 400, 2);
    struct roughcontact_surface *surface = make_surface(read_scan(place, "a.csv"), NULL);
    size_t bounded = 0, m = 0;
    double loads[60];
    for (int i = 0; i < 60; i++)
        loads[i] = pow(10, -7 + 0.1 * i);
    for (; roughcontact_model_name(m); m++) {
        const struct model_row *model = model_rows[m];
        struct roughcontact_curve *curve;
        size_t valid = 0;
        assert_string_equal(roughcontact_model_name(m), model->name);
        if (model->plastic || model->uses_strip || model->uses_map)
            continue;
        assert_int_equal(roughcontact_run(&curve, surface, model->name, loads, 60, NULL, NULL), ROUGHCONTACT_OK);
        for (size_t i = 0; i < 60; i++) {
            const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
            bool touching = model->largest_area > 0 && point->area_ratio > model->largest_area;
            assert_true(!point->valid || (point->exists && !touching));
            if (model->stacks_scales && point->exists && !touching && i > 0 &&
                roughcontact_curve_point(curve, i - 1)->valid)
                assert_true(point->valid);
            bounded += point->exists && touching;
            valid += point->valid != 0;
        }
        assert_true(valid > 10);
        roughcontact_curve_free(curve);
    }
    assert_int_equal(m, model_count);
    assert_true(bounded > 0);
    roughcontact_surface_free(surface);
}
