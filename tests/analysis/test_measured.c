#include "analysis/measured.h"
#include "results/directory.h"

static struct directory place;

/* Reads `csv` under a scene that says `quantity`, `unit` and perhaps an area. */
static enum status_code read_csv(struct measured *out, struct plan *plan, const char *csv,
                                 enum scene_measured_quantity quantity, enum scene_load_unit unit, double area_m2,
                                 struct status *status)
{
    static char name[] = "ecr.csv";
    struct scene scene = {.directory = place.path, .nominal_area_m2 = area_m2};
    scene.measured = (struct scene_measured){name, quantity, unit};
    plan->running = EFFECT_BIT(EFFECT_ELECTRICAL);
    plan->pair.effective_modulus_Pa = 1e10;
    directory_write(&place, name, csv);
    *status = (struct status){0};
    return measured_read(out, &scene, plan, status);
}

static void units_are_the_models(void **state)
{
    (void)state;
    static const struct {
        enum scene_load_unit unit;
        double area_m2, load, resistance;
    } cases[] = {{SCENE_LOAD_DIMENSIONLESS, NAN, 20, 3e-3},
                 {SCENE_LOAD_PASCAL, NAN, 2e-9, 3e-3},
                 {SCENE_LOAD_PASCAL, 1e-6, 2e-9, 3e-9},
                 {SCENE_LOAD_NEWTON, 1e-6, 2e-3, 3e-9}};
    static const char *const dialects[] = {"load,ecr,error\n20,3e-3,1e-4\n10,6e-3,2e-4\n",
                                           "# mine\r\n10;6e-3;2e-4\r\n20;3e-3;1e-4\r\n",
                                           "10\t6e-3\t2e-4\n\n20 3e-3 1e-4",
                                           "\xEF\xBB\xBF"
                                           "10,6e-3,2e-4 # run 3\n20 , 3e-3 , 1e-4,,\n"};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
        for (size_t d = 0; d < sizeof dialects / sizeof *dialects; d++) {
            struct measured measured;
            struct plan plan = {0};
            struct status status;
            assert_int_equal(
                read_csv(&measured, &plan, dialects[d], SCENE_MEASURED_ECR, cases[c].unit, cases[c].area_m2, &status),
                STATUS_OK);
            assert_int_equal(measured.count, 2);
            assert_near(measured.load[1], cases[c].load, 1e-14); /* ascending, whatever the file's order */
            assert_near(measured.resistance[1], cases[c].resistance, 1e-14);
            assert_near(measured.error[1] / measured.resistance[1], 1.0 / 30, 1e-12);
            measured_free(&measured);
        }
}

static void what_is_wrong_is_named(void **state)
{
    (void)state;
    static const struct {
        const char *csv;
        enum scene_measured_quantity quantity;
        enum scene_load_unit unit;
        const char *message;
    } cases[] = {
        {"load,ecr\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv: no row"},
        {"load,ecr\n1\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:2: a row is load, resistance"},
        {"1,2,3,4\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:1: a row is load, resistance"},
        {"1,2\n0,2\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:2: load and resistance must be positive"},
        {"1,-2\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:1: load and resistance must be positive"},
        {"load,ecr\n\n\n1,2\n\n1,-1\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:6: load and resistance"},
        {"1,2,3\n1,,3\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:2: a row is load, resistance"},
        {"1,5;2\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:1: both ',' and ';' in a row"},
        {"1,2\n-.5,2\n", SCENE_MEASURED_ECR, SCENE_LOAD_PASCAL, "ecr.csv:2: load and resistance must be positive"},
        {"1,2\n", SCENE_MEASURED_ECR, SCENE_LOAD_NEWTON, "add nominal_area_m2"},
        {"1,2\n", SCENE_MEASURED_TCR, SCENE_LOAD_PASCAL, "the effect thermal does not run"},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct measured measured;
        struct plan plan = {0};
        struct status status;
        assert_int_equal(read_csv(&measured, &plan, cases[c].csv, cases[c].quantity, cases[c].unit, NAN, &status),
                         STATUS_SCENE);
        if (!strstr(status.message, cases[c].message))
            fail_msg("'%s' without '%s'", status.message, cases[c].message);
        measured_free(&measured);
    }
}

/** Measurements that are the curve times a factor: the distance is its logarithm; what the curve does not cover is not
 * compared. */
static void distance_is_in_decades(void **state)
{
    (void)state;
    struct contact_point points[9];
    struct model_curve curve = {.exists = true, .points = points, .count = 9};
    for (int i = 0; i < 9; i++)
        points[i] = (struct contact_point){.load = 1e-6 * pow(10, 0.5 * i), .ecr_ohm_m2 = 1e-8 * pow(10, -0.45 * i)};
    double loads[] = {1e-7, 2e-6, 3e-5, 4e-4, 1}, resistances[5], errors[5];
    for (int i = 0; i < 5; i++) {
        resistances[i] = 4 * 1e-8 * pow(loads[i] / 1e-6, -0.9); /* the curve is a power law, so is its interpolation */
        errors[i] = NAN;
    }
    struct measured measured = {5, loads, resistances, errors, false};
    struct measured_distance distance = measured_compare(&measured, &curve);
    assert_int_equal(distance.points, 3);
    assert_near(distance.rms_decades, log10(4), 1e-12);
    assert_near(distance.bias_decades, -log10(4), 1e-12);
    assert_near(distance.load[0], 2e-6, 0);
    assert_near(distance.load[1], 4e-4, 0);
    measured.count = 1;
    assert_true(isnan(measured_compare(&measured, &curve).rms_decades));
}

static int set_up(void **state)
{
    (void)state;
    place = directory_make();
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    directory_remove(&place);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(units_are_the_models),
        cmocka_unit_test(what_is_wrong_is_named),
        cmocka_unit_test(distance_is_in_decades),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
