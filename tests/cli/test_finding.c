/* What `inspect` says of the real scans, against the figures computed beside them (reference.json). */
#include "cli/finding.h"
#include "scan/scan_support.h"

/* Units of the files that name none, as reference.json takes them. */
static const struct {
    const char *file, *x_unit, *z_unit;
} units[] = {
    {"WAAM Profile.txt", "um", "um"},
    {"dektakxt_opdx-3.txt", "m", "m"},
    {"nanovea_st400_test1.txt", "mm", "um"},
    {"stylus_nounits_xy-4.txt", "mm", "mm"},
};

static struct finding find(const char *file, const struct profile_options *options)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", REAL_SCANS, file);
    struct scan_options known = no_units;
    for (size_t u = 0; u < sizeof units / sizeof *units; u++)
        if (strcmp(file, units[u].file) == 0)
            known = (struct scan_options){units[u].x_unit, units[u].z_unit};
    struct finding finding;
    struct status status = {0};
    if (finding_make(&finding, path, &known, options, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    return finding;
}

static double number(json_t *object, const char *key)
{
    json_t *value = json_object_get(object, key);
    assert_true(json_is_number(value));
    return json_number_value(value);
}

static void check_map(const struct finding *f, json_t *expected)
{
    assert_int_equal(f->scan.kind, SCAN_AREAL);
    assert_int_equal(f->scan.nx, (size_t)number(expected, "nx"));
    assert_int_equal(f->scan.ny, (size_t)number(expected, "ny"));
    assert_int_equal(f->scan.missing, (size_t)number(expected, "nmiss"));
    assert_near(f->scan.dx_m, number(expected, "dx_um") * 1e-6, 1e-12);
    assert_near(f->scan.dy_m, number(expected, "dy_um") * 1e-6, 1e-12);
    assert_near(f->areal.sq_m, number(expected, "Sq_um") * 1e-6, 1e-9);
    assert_near(f->areal.sa_m, number(expected, "Sa_um") * 1e-6, 1e-9);
    assert_near(f->areal.sz_m, number(expected, "Sz_um") * 1e-6, 1e-9);
    assert_near(f->roughness.rq_m, number(expected, "Rq_rows_um") * 1e-6, 1e-9);
    assert_near(f->roughness.m2, number(expected, "M2x_rows"), 1e-6);
    assert_near(f->roughness.m4_per_m2, number(expected, "M4x_rows_um_2") * 1e12, 1e-6);
}

static void check_profile(const struct finding *f, json_t *expected)
{
    assert_int_equal(f->scan.kind, SCAN_PROFILE);
    assert_int_equal(f->scan.nx, (size_t)number(expected, "n"));
    assert_int_equal(f->scan.missing, (size_t)number(expected, "nmiss"));
    assert_near(finding_spacing_m(f), number(expected, "dx_mean_um") * 1e-6, 1e-12);
    assert_near(finding_length_m(f), number(expected, "len_um") * 1e-6, 1e-12);
    assert_near(f->roughness.rq_m, number(expected, "Rq_um") * 1e-6, 1e-9);
    assert_near(f->roughness.ra_m, number(expected, "Ra_um") * 1e-6, 1e-9);
    assert_near(f->roughness.pv_m, number(expected, "PV_um") * 1e-6, 1e-9);
    assert_near(f->roughness.m2, number(expected, "M2c"), 1e-6);
    assert_near(f->roughness.m4_per_m2, number(expected, "M4_um_2") * 1e12, 1e-6);
    if (!f->profile.measured_x_m) { /* the parameters are of the uniform profile */
        assert_near(parameters_value(&f->primary, "sk"), number(expected, "Sk"), 1e-6);
        assert_near(parameters_value(&f->primary, "ku"), number(expected, "Ku"), 1e-9);
        assert_near(parameters_value(&f->primary, "dq"), sqrt(number(expected, "M2_7")), 1e-6);
    }
}

/* Positions that are rounded: the reference's "as_uniform"; all others, the truly uneven ones too: "actual_x". */
static void test_every_reference_figure(void **state)
{
    (void)state;
    NEED_REAL_SCANS();
    json_error_t error;
    json_t *all = json_load_file(REAL_SCANS "/reference.json", 0, &error), *entry;
    const char *file;
    assert_non_null(all);
    assert_true(json_object_size(all) >= 24);
    json_object_foreach(all, file, entry)
    {
        print_message("%s\n", file);
        struct finding finding = find(file, &profile_defaults);
        json_t *map = json_object_get(entry, "areal"), *uniform = json_object_get(entry, "as_uniform");
        bool measured = finding.profile.measured_x_m != NULL;
        if (map)
            check_map(&finding, map);
        else
            check_profile(&finding, uniform && !measured ? uniform : json_object_get(entry, "actual_x"));
        assert_true(isfinite(finding.law.gamma) || finding.scan.nx < 10);
        finding_free(&finding);
    }
    json_decref(all);
}

/* With lambda_c there are R parameters beside those of the profile before. */
static void test_roughness_profile(void **state)
{
    (void)state;
    NEED_REAL_SCANS();
    struct profile_options options = profile_defaults;
    struct finding without = find("nist_npl_edm.xml", &options);
    options.lambda_c_m = 8e-4;
    struct finding with = find("nist_npl_edm.xml", &options);
    assert_false(without.has_filtered);
    assert_true(with.has_filtered);
    assert_int_equal(with.filtered.sampling_lengths, 7);
    assert_memory_equal(with.primary.value, without.primary.value, sizeof with.primary.value);
    assert_true(parameters_value(&with.filtered, "q") < parameters_value(&with.primary, "q"));
    json_t *object = json_object(), *parameters;
    finding_add_json(object, &with);
    parameters = json_object_get(object, "parameters");
    assert_near(number(parameters, "lambda_c_m"), 8e-4, 1e-12);
    assert_true(json_is_null(json_object_get(parameters, "lambda_s_m")));
    assert_near(number(parameters, "Rq"), parameters_value(&with.filtered, "q"), 0);
    assert_near(number(parameters, "Pq"), 0.55994e-6, 1e-5);
    assert_int_equal(json_array_size(json_object_get(parameters, "P_material_ratio_m")), PARAMETERS_CURVE);
    assert_string_equal(json_string_value(json_object_get(parameters, "slope")), "7-point");
    json_decref(object);
    finding_free(&without);
    finding_free(&with);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_reference_figure),
        cmocka_unit_test(test_roughness_profile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
