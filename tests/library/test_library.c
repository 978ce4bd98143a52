/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library against the program: the same numbers to the last bit, the same refusals; and that a fault of the caller
 * comes back as an error. Only the public header is used. */
#include "cli/process.h"
#include "library/roughcontact.h"

#include <jansson.h>
#include <stdio.h>
#include <sys/stat.h>

static struct roughcontact_scan *read_scan(const char *place, const char *path)
{
    struct roughcontact_status status;
    struct roughcontact_scan *scan;
    char full[512];
    snprintf(full, sizeof full, "%s/%s", place, path);
    if (roughcontact_scan_read_file(&scan, full, NULL, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    return scan;
}

static struct roughcontact_surface *make_surface(const struct roughcontact_scan *scan,
                                                 const struct roughcontact_surface_options *options)
{
    struct roughcontact_status status;
    struct roughcontact_surface *surface;
    if (roughcontact_surface_make(&surface, scan, options, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    return surface;
}

static struct roughcontact_material *make_material(const char *name)
{
    struct roughcontact_status status;
    struct roughcontact_material *material;
    if (roughcontact_material_new(&material, name, &status) != ROUGHCONTACT_OK)
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

/** What contact.csv has of one surface and model, from row `first` on; returns how many rows. */
static size_t expect_curve(const struct table *table, size_t first, const struct roughcontact_surface *surface,
                           const struct roughcontact_run_options *how, const double *loads, size_t count)
{
    struct roughcontact_status status;
    struct roughcontact_curve *curve;
    const char *model = table_text(table, first, "model");
    if (roughcontact_run(&curve, surface, model, loads, count, how, &status) != ROUGHCONTACT_OK)
        fail_msg("%s: %s", model, status.message);
    assert_int_equal(roughcontact_curve_info(curve)->count, count);
    double sigma_m = sqrt(roughcontact_surface_roughness(surface)->m0_m2);
    size_t row = first, met = 0;
    for (size_t i = 0; i < count; i++) {
        const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
        assert_true(point->load == loads[i]);
        double load = row < table->rows && strcmp(table_text(table, row, "model"), model) == 0
                          ? table_number(table, row, "load_over_AnEp")
                          : INFINITY;
        if (load != loads[i]) { /* the program's rows have ended, or with one at full contact itself */
            assert_false(point->exists || point->valid);
            assert_true(isnan(point->area_ratio) && isnan(point->ecr_ohm_m2) && isnan(point->separation_m));
            if (isfinite(load) && load != roughcontact_curve_info(curve)->full_load)
                fail_msg("%s: the program has a row at %g, the library is at %g", model, load, loads[i]);
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
        expect_cell(table, row, "adjusted_separation_over_sigma", point->adjusted_m / sigma_m);
        row++;
        met++;
    }
    assert_true(met > count / 4);
    if (row < table->rows && strcmp(table_text(table, row, "model"), model) == 0) {
        assert_true(table_number(table, row, "load_over_AnEp") == roughcontact_curve_info(curve)->full_load);
        row++;
    }
    roughcontact_curve_free(curve);
    return row - first;
}

static void expect_surface(const struct table *table, const struct roughcontact_surface *surface)
{
    const struct roughcontact_roughness *r = roughcontact_surface_roughness(surface);
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    const struct roughcontact_surface_info *info = roughcontact_surface_info(surface);
    const struct {
        const char *column;
        double value;
    } cells[] = {{"points", (double)info->points},
                 {"spacing_m", info->spacing_m},
                 {"scan_length_m", info->length_m},
                 {"rq_m", r->rq_m},
                 {"ra_m", r->ra_m},
                 {"m0_m2", r->m0_m2},
                 {"m2", r->m2},
                 {"m4_per_m2", r->m4_per_m2},
                 {"nayak", r->nayak},
                 {"asperity_density_per_m2", r->asperity_density_per_m2},
                 {"asperity_radius_m", r->asperity_radius_m},
                 {"asperity_sigma_m", r->asperity_sigma_m},
                 {"asperity_offset_m", r->asperity_offset_m},
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
        expect_cell(table, 0, cells[c].column, cells[c].value);
}

static void expect_spectrum(const struct table *table, const struct roughcontact_surface *surface)
{
    const struct roughcontact_spectrum *spectrum = roughcontact_surface_spectrum(surface);
    assert_int_equal(spectrum->count, table->rows);
    for (size_t n = 1; n <= spectrum->count; n++) {
        expect_cell(table, n - 1, "amplitude_m", spectrum->amplitude_m[n - 1]);
        assert_near(spectrum->length_m / (double)n, table_number(table, n - 1, "wavelength_m"), 1e-15);
    }
}

static struct table report_table(const char *place, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s/out/data/%s", place, name);
    return table_read_path(path);
}

/** Reports d/a.csv with every model under `scene`, and asks the library for all of the same. */
static void compare(const char *place, const char *scene, const struct roughcontact_surface_options *options,
                    const struct roughcontact_run_options *how)
{
    char text[2048];
    int length = snprintf(text, sizeof text, "%s\nload: {from: 1e-7, to: 0.3, points: 25}\nmodels: [", scene);
    for (size_t m = 0; roughcontact_model(m); m++)
        if (how->material || !roughcontact_model(m)->plastic)
            length += snprintf(text + length, sizeof text - (size_t)length, "%s%s", m > 0 ? ", " : "",
                               roughcontact_model(m)->name);
    snprintf(text + length, sizeof text - (size_t)length, "]\n");
    workspace_write(place, "d/scene.yaml", text);
    struct process process = expect_exit(place, 0, "report", "d", "-o", "out", "--no-cost", "--brief");
    process_free(&process);
    struct table contact = report_table(place, "contact.csv"), surfaces = report_table(place, "surfaces.csv"),
                 amplitudes = report_table(place, "spectrum.csv");

    struct roughcontact_scan *scan = read_scan(place, "d/a.csv");
    struct roughcontact_surface *surface = make_surface(scan, options);
    roughcontact_scan_free(scan); /* the surface does not need it */
    expect_surface(&surfaces, surface);
    expect_spectrum(&amplitudes, surface);
    double loads[25]; /* all of them: stacked scales go on beyond full contact */
    size_t count = 0, models = 0;
    for (; count < 25; count++)
        loads[count] = table_number(&contact, count, "load_over_AnEp");
    assert_true(loads[24] == 0.3);
    for (size_t row = 0; row < contact.rows; models++)
        row += expect_curve(&contact, row, surface, how, loads, count);
    assert_true(models >= (how->material ? 9 : 5));
    roughcontact_surface_free(surface);
    table_free(&contact);
    table_free(&surfaces);
    table_free(&amplitudes);
}

static void report_and_library_agree(void **state)
{
    struct roughcontact_run_options how;
    struct roughcontact_material *tin = make_material("tin"), *copper = make_material("copper"), *own;
    workspace_scan(*state, "d/a.csv", 700, 3);
    roughcontact_run_options_init(&how, sizeof how);
    how.material = tin;
    compare(*state, "material: tin\neffects: [plasticity, separation, electrical, thermal, scale-dependent]", NULL,
            &how);

    struct roughcontact_surface_options options;
    roughcontact_surface_options_init(&options, sizeof options);
    options.lambda_s_m = 4e-6; /* no wave below twice that is fitted */
    options.max_missing = 0;
    compare(*state,
            "material: tin\nlambda_s: 4 um\nmax_missing: 0\n"
            "effects: [plasticity, separation, electrical, thermal, scale-dependent]",
            &options, &how);

    how.counterface = copper;
    how.hardness_Pa = 55e6;
    how.tolerance = 1e-4;
    roughcontact_surface_options_init(&options, sizeof options);
    options.level = ROUGHCONTACT_LEVEL_PARABOLA;
    options.window = ROUGHCONTACT_WINDOW_NONE;
    options.lambda_s_m = 2e-6;
    options.lambda_c_m = 2e-4;
    options.fit = ROUGHCONTACT_FIT_THESIS;
    options.fit_low_m = 4e-6;
    options.fit_high_m = 1e-4;
    compare(*state,
            "material: tin\ncounterface: copper\nhardness: 55 MPa\ntolerance: 1e-4\nlevel: parabola\nwindow: none\n"
            "lambda_s: 2 um\nlambda_c: 200 um\nfit: thesis\nfit_band: [4 um, 100 um]\n"
            "effects: [plasticity, separation, electrical, thermal, scale-dependent]",
            &options, &how);

    /* a material of properties */
    own = make_material(NULL);
    const struct {
        const char *key;
        double value;
    } properties[] = {{"E_Pa", 70e9},
                      {"nu", 0.33},
                      {"Sy_Pa", 120e6},
                      {"resistivity_ohm_m", 2.8e-8},
                      {"conductivity_W_per_mK", 200},
                      {"density_kg_per_m3", 2700},
                      {"specific_heat_J_per_kgK", 900},
                      {"sound_speed_m_per_s", 6000}};
    for (size_t i = 0; i < sizeof properties / sizeof *properties; i++) {
        assert_int_equal(roughcontact_material_set(own, properties[i].key, properties[i].value, NULL), 0);
        assert_true(roughcontact_material_get(own, properties[i].key) == properties[i].value);
    }
    roughcontact_run_options_init(&how, sizeof how);
    how.material = own;
    roughcontact_surface_options_init(&options, sizeof options);
    options.window = ROUGHCONTACT_WINDOW_HANN;
    options.level = ROUGHCONTACT_LEVEL_ROBUST;
    options.fit_low_m = 4e-6;
    options.fit_high_m = 1e-4;
    compare(*state,
            "material: {E: 70 GPa, nu: 0.33, Sy: 120 MPa, resistivity: 2.8e-8, conductivity: 200, density: 2700,\n"
            "  specific_heat: 900, sound_speed: 6000}\nwindow: hann\nlevel: robust\nfit_band: [4 um, 100 um]\n"
            "effects: [plasticity, separation, electrical, thermal, scale-dependent]",
            &options, &how);
    roughcontact_material_free(own);

    roughcontact_run_options_init(&how, sizeof how);
    compare(*state, "effects: [separation]", NULL, &how);

    /* uneven x, points missing, a record that does not close on itself */
    char uneven[32768] = "x [um],z [um]\n";
    for (int i = 0, length = (int)strlen(uneven); i < 600; i++)
        length += snprintf(uneven + length, sizeof uneven - (size_t)length, i % 50 == 7 ? "%.4f,NaN\n" : "%.4f,%.6f\n",
                           0.5 * i + 0.1 * sin(i), 1e-3 * i + sin(0.2 * i) + 0.3 * sin(1.1 * i * i));
    workspace_write(*state, "d/a.csv", uneven);
    how.material = tin;
    compare(*state, "material: tin\neffects: [plasticity, separation, electrical, thermal, scale-dependent]", NULL,
            &how);
    roughcontact_material_free(tin);
    roughcontact_material_free(copper);
}

static void inspect_and_library_agree(void **state)
{
    workspace_scan(*state, "a.csv", 1200, 5);
    struct process process = expect_exit(*state, 0, "inspect", "--json", "a.csv");
    json_t *all = json_loads(process.out, 0, NULL), *said = json_array_get(all, 0);
    json_t *parameters = json_object_get(said, "parameters");
    struct roughcontact_scan *scan = read_scan(*state, "a.csv");
    struct roughcontact_surface *surface = make_surface(scan, NULL);
    const struct roughcontact_roughness *r = roughcontact_surface_roughness(surface);
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    const struct roughcontact_scan_info *info = roughcontact_scan_info(scan);
#define EXPECT(key, value) assert_true(json_real_value(json_object_get(said, key)) == (value))
    EXPECT("rq_m", r->rq_m);
    EXPECT("ra_m", r->ra_m);
    EXPECT("pv_m", r->pv_m);
    EXPECT("m2", r->m2);
    EXPECT("m4_per_m2", r->m4_per_m2);
    EXPECT("alpha_SI", law->alpha);
    EXPECT("gamma", law->gamma);
    EXPECT("spacing_m", roughcontact_surface_info(surface)->spacing_m);
#undef EXPECT
    assert_string_equal(json_string_value(json_object_get(said, "format")), info->format);
    assert_string_equal(json_string_value(json_object_get(said, "x_unit")), info->x_unit);
    assert_int_equal(json_integer_value(json_object_get(said, "points")), info->nx);
    double values[32];
    size_t count = roughcontact_parameter_count();
    assert_true(count >= 15 && count <= 32);
    assert_int_equal(roughcontact_surface_parameters(surface, values, count, NULL), ROUGHCONTACT_OK);
    for (size_t i = 0; i < count; i++) {
        char key[32];
        snprintf(key, sizeof key, "P%s", roughcontact_parameter(i)->name);
        json_t *value = json_object_get(parameters, key);
        assert_non_null(value);
        assert_true(json_is_null(value) ? isnan(values[i]) : json_real_value(value) == values[i]);
    }
    size_t warnings = json_array_size(json_object_get(said, "warnings")), met = 0;
    while (roughcontact_scan_warning(scan, met))
        met++;
    for (size_t n = 0; roughcontact_surface_note(surface, n); n++, met++)
        assert_string_equal(json_string_value(json_array_get(json_object_get(said, "warnings"), met)),
                            roughcontact_surface_note(surface, n));
    assert_int_equal(met, warnings);
    roughcontact_surface_free(surface);
    roughcontact_scan_free(scan);
    json_decref(all);
    process_free(&process);
}

/** R parameters of a surface with lambda_c. */
static void filtered_parameters_agree(void **state)
{
    workspace_scan(*state, "a.csv", 1200, 5);
    struct process process =
        expect_exit(*state, 0, "inspect", "--json", "--lambda-c", "80e-6", "--lambda-s", "2.5e-6", "a.csv");
    json_t *all = json_loads(process.out, 0, NULL);
    json_t *parameters = json_object_get(json_array_get(all, 0), "parameters");
    struct roughcontact_surface_options options;
    roughcontact_surface_options_init(&options, sizeof options);
    options.lambda_c_m = 80e-6;
    options.lambda_s_m = 2.5e-6;
    struct roughcontact_scan *scan = read_scan(*state, "a.csv");
    struct roughcontact_surface *surface = make_surface(scan, &options);
    double values[2];
    assert_int_equal(roughcontact_surface_parameters(surface, values, 2, NULL), ROUGHCONTACT_OK);
    for (size_t i = 0; i < 2; i++) {
        char key[32];
        snprintf(key, sizeof key, "R%s", roughcontact_parameter(i)->name);
        assert_true(json_real_value(json_object_get(parameters, key)) == values[i]);
    }
    roughcontact_surface_free(surface);
    roughcontact_scan_free(scan);
    json_decref(all);
    process_free(&process);
}

static void bytes_are_as_the_file(void **state)
{
    workspace_scan(*state, "a.csv", 500, 7);
    char *content = workspace_read(*state, "a.csv");
    struct roughcontact_status status = {.code = 99};
    struct roughcontact_scan *file = read_scan(*state, "a.csv"), *bytes;
    size_t length = strlen(content);
    char *exact = malloc(length); /* no NUL behind it */
    assert_non_null(exact);
    memcpy(exact, content, length);
    assert_int_equal(roughcontact_scan_read_bytes(&bytes, exact, length, "in memory", NULL, &status), ROUGHCONTACT_OK);
    assert_int_equal(status.code, ROUGHCONTACT_OK);
    assert_string_equal(status.message, "");
    memset(exact, 0, length); /* they were copied */
    const struct roughcontact_scan_info *a = roughcontact_scan_info(file), *b = roughcontact_scan_info(bytes);
    assert_int_equal(a->nx, 500);
    assert_int_equal(b->nx, 500);
    assert_memory_equal(a->z_m, b->z_m, 500 * sizeof(double));
    free(exact);
    free(content);
    roughcontact_scan_free(file);
    roughcontact_scan_free(bytes);
}

/** What the program says of a file, the library says, but of the remedy: it never guesses a unit. */
static void units_are_not_guessed(void **state)
{
    struct roughcontact_status status;
    struct roughcontact_scan_options options;
    struct roughcontact_scan *scan = (struct roughcontact_scan *)&status;
    const char text[] = "0,1\n1,2\n2,1\n3,4\n4,2\n";
    workspace_write(*state, "bare.csv", text);
    struct process process = process_run(*state, "inspect", "bare.csv");
    assert_int_equal(process.status, 4);
    assert_int_equal(roughcontact_scan_read_bytes(&scan, text, strlen(text), "bare.csv", NULL, &status),
                     ROUGHCONTACT_SCAN);
    assert_null(scan);
    expect_part(process.err, status.message);
    process_free(&process);

    roughcontact_scan_options_init(&options, sizeof options);
    options.x_unit = "mm";
    options.z_unit = "um";
    assert_int_equal(roughcontact_scan_read_bytes(&scan, text, strlen(text), "bare.csv", &options, &status),
                     ROUGHCONTACT_OK);
    assert_near(roughcontact_scan_info(scan)->z_m[3], 4e-6, 1e-15);
    assert_near(roughcontact_scan_info(scan)->dx_m, 1e-3, 1e-15);
    roughcontact_scan_free(scan);

    options.z_unit = "furlong";
    assert_int_equal(roughcontact_scan_read_bytes(&scan, text, strlen(text), "bare.csv", &options, &status),
                     ROUGHCONTACT_USAGE);
    expect_part(status.message, "furlong");
    options.z_unit = "um";
    options.quantity = ROUGHCONTACT_SLOPE; /* a length is no unit of a slope */
    assert_int_equal(roughcontact_scan_read_bytes(&scan, text, strlen(text), "bare.csv", &options, &status),
                     ROUGHCONTACT_USAGE);
    options.quantity = ROUGHCONTACT_HEIGHT;
    options.z_column = "5";
    assert_int_equal(roughcontact_scan_read_bytes(&scan, text, strlen(text), "bare.csv", &options, &status),
                     ROUGHCONTACT_SCAN);

    assert_int_equal(roughcontact_scan_read_file(&scan, "/nowhere/at all", NULL, &status), ROUGHCONTACT_IO);
    expect_part(status.message, "/nowhere/at all");
    assert_int_equal(roughcontact_scan_read_file(&scan, *state, NULL, &status), ROUGHCONTACT_IO);
    assert_int_equal(roughcontact_scan_read_bytes(&scan, "", 0, NULL, NULL, NULL), ROUGHCONTACT_SCAN);
    assert_int_equal(roughcontact_scan_read_bytes(&scan, NULL, 3, NULL, NULL, NULL), ROUGHCONTACT_USAGE);
}

/** What is wrong is said, and no handle comes of it. */
static void faults_are_errors(void **state)
{
    struct roughcontact_status status;
    struct roughcontact_surface *surface;
    struct roughcontact_curve *curve;
    struct roughcontact_material *material;
    struct roughcontact_surface_options options;
    struct roughcontact_run_options how;
    const double loads[] = {1e-4, 1e-3}, falling[] = {1e-3, 1e-4}, zero[] = {0, 1e-3};
    workspace_scan(*state, "a.csv", 300, 9);
    struct roughcontact_scan *scan = read_scan(*state, "a.csv");

#define EXPECT(call, expected, part)                                                                                   \
    do {                                                                                                               \
        assert_int_equal(call, expected);                                                                              \
        assert_int_equal(status.code, expected);                                                                       \
        expect_part(status.message, part);                                                                             \
    } while (0)
#define EXPECT_OPTION(member, value, part)                                                                             \
    do {                                                                                                               \
        roughcontact_surface_options_init(&options, sizeof options);                                                   \
        options.member = (value);                                                                                      \
        EXPECT(roughcontact_surface_make(&surface, scan, &options, &status), ROUGHCONTACT_USAGE, part);                \
        assert_null(surface);                                                                                          \
    } while (0)
    EXPECT_OPTION(level, 7, "level 7");
    EXPECT_OPTION(level, -1, "level -1");
    EXPECT_OPTION(window, 3, "window 3");
    EXPECT_OPTION(fit, 2, "fit 2");
    EXPECT_OPTION(max_missing, 1.5, "max_missing is 1.5");
    EXPECT_OPTION(lambda_s_m, NAN, "lambda_s_m is nan");
    EXPECT_OPTION(lambda_c_m, -1, "lambda_c_m is -1");
    EXPECT_OPTION(tip_radius_m, 5, "tip_radius_m is 5");
    EXPECT_OPTION(fit_low_m, 1e-5, "the fit's band");
    EXPECT_OPTION(row, 1, "there is no row 1");
    EXPECT_OPTION(size, 0, "roughcontact_surface_options_init");
    EXPECT(roughcontact_surface_make(&surface, NULL, NULL, &status), ROUGHCONTACT_USAGE, "no scan");
    roughcontact_surface_options_init(&options, sizeof options);
    options.lambda_s_m = 1e-5;
    options.lambda_c_m = 1e-6;
    EXPECT(roughcontact_surface_make(&surface, scan, &options, &status), ROUGHCONTACT_USAGE, "nothing would be left");
    options.lambda_c_m = 1;
    EXPECT(roughcontact_surface_make(&surface, scan, &options, &status), ROUGHCONTACT_SCAN, "lambda_c");

    EXPECT(roughcontact_material_new(&material, "unobtainium", &status), ROUGHCONTACT_USAGE, "unobtainium");
    assert_null(material);
    material = make_material(NULL);
    EXPECT(roughcontact_material_set(material, "E", 1e9, &status), ROUGHCONTACT_USAGE, "'E'");
    EXPECT(roughcontact_material_set(material, "nu", 0.6, &status), ROUGHCONTACT_USAGE, "nu is 0.6");
    EXPECT(roughcontact_material_set(material, "nu", NAN, &status), ROUGHCONTACT_USAGE, "nu is nan");
    assert_true(isnan(roughcontact_material_get(material, "nu")));
    assert_true(isnan(roughcontact_material_get(material, "colour")));

    surface = make_surface(scan, NULL);
    roughcontact_run_options_init(&how, sizeof how);
    how.material = material;
#define EXPECT_RUN(model, loads, count, code, part)                                                                    \
    do {                                                                                                               \
        EXPECT(roughcontact_run(&curve, surface, model, loads, count, &how, &status), code, part);                     \
        assert_null(curve);                                                                                            \
    } while (0)
    EXPECT_RUN("gw", loads, 2, ROUGHCONTACT_USAGE, "the material has no E_Pa");
    assert_int_equal(roughcontact_material_set(material, "E_Pa", 1e11, NULL), ROUGHCONTACT_OK);
    assert_int_equal(roughcontact_material_set(material, "nu", 0.3, NULL), ROUGHCONTACT_OK);
    EXPECT_RUN("jg", loads, 2, ROUGHCONTACT_USAGE, "'jg' needs Sy_Pa");
    EXPECT_RUN("no such", loads, 2, ROUGHCONTACT_USAGE, "no such");
    EXPECT_RUN(NULL, loads, 2, ROUGHCONTACT_USAGE, "unknown model");
    EXPECT_RUN("gw", falling, 2, ROUGHCONTACT_USAGE, "load 2 is 0.0001");
    EXPECT_RUN("gw", zero, 2, ROUGHCONTACT_USAGE, "load 1 is 0");
    EXPECT_RUN("gw", loads, 0, ROUGHCONTACT_USAGE, "no loads");
    how.tolerance = 0;
    EXPECT_RUN("gw", loads, 2, ROUGHCONTACT_USAGE, "tolerance is 0");
    how.tolerance = 1e-6;
    how.load = 2;
    EXPECT_RUN("gw", loads, 2, ROUGHCONTACT_USAGE, "load 2 is not known");
    how.material = NULL;
    how.load = ROUGHCONTACT_LOAD_PRESSURE_PA;
    EXPECT_RUN("gw", loads, 2, ROUGHCONTACT_USAGE, "loads in Pa need a material");
    how.load = ROUGHCONTACT_LOAD_OVER_MODULUS;
    how.hardness_Pa = 1e9;
    EXPECT_RUN("gw", loads, 2, ROUGHCONTACT_USAGE, "hardness");
    how.hardness_Pa = NAN;
    how.counterface = material;
    EXPECT_RUN("gw", loads, 2, ROUGHCONTACT_USAGE, "counterface");
    how.counterface = NULL;
    EXPECT_RUN("jg", loads, 2, ROUGHCONTACT_USAGE, "needs a material with Sy_Pa");
    EXPECT(roughcontact_run(&curve, NULL, "gw", loads, 2, NULL, &status), ROUGHCONTACT_USAGE, "no surface");
    double values[2];
    EXPECT(roughcontact_surface_parameters(surface, values, 1000, &status), ROUGHCONTACT_USAGE, "not 1000");

    /* of a mere hollow the Nayak parameter is one for which no asperities exist */
    char hollow[4096] = "x [um],z [um]\n";
    for (int i = 0; i < 128; i++)
        snprintf(hollow + strlen(hollow), sizeof hollow - strlen(hollow), "%d,%.3f\n", i, 1e-3 * i * (i - 127));
    struct roughcontact_scan *flat;
    struct roughcontact_surface *square;
    assert_int_equal(roughcontact_scan_read_bytes(&flat, hollow, strlen(hollow), "hollow", NULL, &status),
                     ROUGHCONTACT_OK);
    square = make_surface(flat, NULL);
    roughcontact_run_options_init(&how, sizeof how);
    if (isnan(roughcontact_surface_roughness(square)->asperity_sigma_m))
        EXPECT(roughcontact_run(&curve, square, "gw", loads, 2, &how, &status), ROUGHCONTACT_MODEL, "no gw");
    else
        fail_msg("the hollow has asperities");
    roughcontact_surface_free(square);
    roughcontact_scan_free(flat);

    roughcontact_surface_free(surface);
    roughcontact_material_free(material);
    roughcontact_scan_free(scan);
    roughcontact_scan_free(NULL);
    roughcontact_surface_free(NULL);
    roughcontact_material_free(NULL);
    roughcontact_curve_free(NULL);
#undef EXPECT
}

/** A map is no profile until a row of it is named. */
static void a_map_needs_a_row(void **state)
{
    (void)state;
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
    struct roughcontact_status status;
    struct roughcontact_scan *scan;
    struct roughcontact_surface *surface;
    struct roughcontact_surface_options options;
    if (roughcontact_scan_read_bytes(&scan, bytes, length, "map", NULL, &status) != ROUGHCONTACT_OK)
        fail_msg("%s", status.message);
    assert_int_equal(roughcontact_scan_info(scan)->ny, 3);
    assert_int_equal(roughcontact_surface_make(&surface, scan, NULL, &status), ROUGHCONTACT_USAGE);
    expect_part(status.message, "`row`");
    roughcontact_surface_options_init(&options, sizeof options);
    double rq_m[3];
    for (options.row = 0; options.row < 3; options.row++) {
        surface = make_surface(scan, &options);
        rq_m[options.row] = roughcontact_surface_roughness(surface)->rq_m;
        roughcontact_surface_free(surface);
    }
    assert_true(rq_m[0] < 0.7 * rq_m[1] && rq_m[1] < 0.85 * rq_m[2]);
    assert_int_equal(roughcontact_surface_make(&surface, scan, &options, &status), ROUGHCONTACT_USAGE);
    roughcontact_scan_free(scan);
}

/** No reader knows these bytes: the program asks Gwyddion, where it is installed; the library starts no program. */
static void no_program_is_started(void **state)
{
    struct roughcontact_status status;
    struct roughcontact_scan *scan;
    char path[512], folder[512], *before = strdup(getenv("PATH"));
    workspace_write(*state, "bin/gwyddion", "#!/bin/sh\necho >>\"$MARK\"\nexit 1\n");
    workspace_write(*state, "foreign.bin", "\x01\x02\x80\xff\x03 binary \x01\x02\x80\xff");
    snprintf(path, sizeof path, "%s/bin/gwyddion", (const char *)*state);
    assert_int_equal(chmod(path, 0755), 0);
    snprintf(folder, sizeof folder, "%s/bin:%s", (const char *)*state, before);
    snprintf(path, sizeof path, "%s/mark", (const char *)*state);
    setenv("PATH", folder, 1);
    setenv("MARK", path, 1);
    snprintf(path, sizeof path, "%s/foreign.bin", (const char *)*state);
    assert_int_equal(roughcontact_scan_read_file(&scan, path, NULL, &status), ROUGHCONTACT_SCAN);
    assert_false(workspace_has(*state, "mark"));
    struct process process = process_run(*state, "inspect", "foreign.bin");
    assert_true(workspace_has(*state, "mark")); /* as it does where it may */
    process_free(&process);
    setenv("PATH", before, 1);
    unsetenv("MARK");
    free(before);
}

/** Loads in Pa are those over E' times E'. */
static void loads_may_be_pressures(void **state)
{
    workspace_scan(*state, "a.csv", 400, 2);
    struct roughcontact_scan *scan = read_scan(*state, "a.csv");
    struct roughcontact_surface *surface = make_surface(scan, NULL);
    struct roughcontact_material *tin = make_material("tin");
    struct roughcontact_run_options how;
    struct roughcontact_curve *one, *two;
    roughcontact_run_options_init(&how, sizeof how);
    how.material = tin;
    const double loads[] = {1e-5, 1e-4, 1e-3};
    assert_int_equal(roughcontact_run(&one, surface, "multiscale-elastic", loads, 3, &how, NULL), ROUGHCONTACT_OK);
    double modulus_Pa = roughcontact_curve_info(one)->effective_modulus_Pa;
    double nu = roughcontact_material_get(tin, "nu");
    assert_near(modulus_Pa, roughcontact_material_get(tin, "E_Pa") / (1 - nu * nu), 1e-14);
    const double pressures_Pa[] = {1e-5 * modulus_Pa, 1e-4 * modulus_Pa, 1e-3 * modulus_Pa};
    how.load = ROUGHCONTACT_LOAD_PRESSURE_PA;
    assert_int_equal(roughcontact_run(&two, surface, "multiscale-elastic", pressures_Pa, 3, &how, NULL),
                     ROUGHCONTACT_OK);
    for (size_t i = 0; i < 3; i++) {
        const struct roughcontact_point *a = roughcontact_curve_point(one, i), *b = roughcontact_curve_point(two, i);
        assert_near(b->load, loads[i], 1e-15);
        assert_near(a->pressure_Pa, pressures_Pa[i], 1e-15);
        assert_near(b->area_ratio, a->area_ratio, 1e-12);
        assert_true(isnan(a->adjusted_m)); /* which this model does not compute */
    }
    assert_null(roughcontact_curve_point(one, 3));
    roughcontact_curve_free(one);
    roughcontact_curve_free(two);
    roughcontact_material_free(tin);
    roughcontact_surface_free(surface);
    roughcontact_scan_free(scan);
}

/** Beyond the range that a model was made for its points exist but are not valid. */
static void validity_is_told(void **state)
{
    workspace_scan(*state, "a.csv", 400, 2);
    struct roughcontact_scan *scan = read_scan(*state, "a.csv");
    struct roughcontact_surface *surface = make_surface(scan, NULL);
    size_t bounded = 0;
    double loads[60];
    for (int i = 0; i < 60; i++)
        loads[i] = pow(10, -7 + 0.1 * i);
    for (size_t m = 0; roughcontact_model(m); m++) {
        const struct roughcontact_model *model = roughcontact_model(m);
        struct roughcontact_curve *curve;
        assert_ptr_equal(roughcontact_model_find(model->name), model);
        assert_true(model->label && model->family && model->equations && model->source && model->assumes);
        if (model->plastic)
            continue;
        assert_int_equal(roughcontact_run(&curve, surface, model->name, loads, 60, NULL, NULL), ROUGHCONTACT_OK);
        for (size_t i = 0; i < 60; i++) {
            const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
            bool touching = model->largest_area > 0 && point->area_ratio > model->largest_area;
            assert_true(!point->valid || (point->exists && !touching));
            if (point->exists && !touching && point->beyond_fit == 0 && i > 0 &&
                roughcontact_curve_point(curve, i - 1)->valid)
                assert_true(point->valid);
            bounded += point->exists && touching;
        }
        roughcontact_curve_free(curve);
    }
    assert_true(bounded > 0);
    assert_null(roughcontact_model_find("none such"));
    assert_null(roughcontact_model_find(NULL));
    roughcontact_surface_free(surface);
    roughcontact_scan_free(scan);
}

/** A program built with an older header knows shorter options; one with a newer one, longer. */
static void options_may_grow(void **state)
{
    struct roughcontact_status status;
    workspace_scan(*state, "a.csv", 300, 4);
    struct roughcontact_scan *scan = read_scan(*state, "a.csv");
    struct roughcontact_surface *surface;
    struct roughcontact_surface_options older, whole;
    const size_t known = offsetof(struct roughcontact_surface_options, fit);
    memset(&older, 0xaa, sizeof older); /* what lies behind is not the library's */
    roughcontact_surface_options_init(&older, known);
    assert_int_equal(older.size, known);
    assert_true(((const unsigned char *)&older)[known] == 0xaa);
    assert_int_equal(roughcontact_surface_make(&surface, scan, &older, &status), ROUGHCONTACT_OK);
    roughcontact_surface_free(surface);

    struct {
        struct roughcontact_surface_options known;
        double later;
    } newer;
    memset(&newer, 0xaa, sizeof newer);
    roughcontact_surface_options_init(&newer.known, sizeof newer);
    assert_true(newer.later == 0);
    roughcontact_surface_options_init(&whole, sizeof whole);
    assert_true(newer.known.max_missing == whole.max_missing && newer.known.row == ROUGHCONTACT_NO_ROW);
    assert_int_equal(roughcontact_surface_make(&surface, scan, &newer.known, &status), ROUGHCONTACT_OK);
    roughcontact_surface_free(surface);
    newer.later = 1;
    assert_int_equal(roughcontact_surface_make(&surface, scan, &newer.known, &status), ROUGHCONTACT_USAGE);
    expect_part(status.message, roughcontact_version());
    roughcontact_scan_free(scan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        workspace_test(report_and_library_agree),  workspace_test(inspect_and_library_agree),
        workspace_test(filtered_parameters_agree), workspace_test(bytes_are_as_the_file),
        workspace_test(units_are_not_guessed),     workspace_test(faults_are_errors),
        cmocka_unit_test(a_map_needs_a_row),       workspace_test(loads_may_be_pressures),
        workspace_test(validity_is_told),          workspace_test(no_program_is_started),
        workspace_test(options_may_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
