/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "directory.h"
#include "results/surface_bytes.h"
#include "results/surface_store.h"

enum { SURFACES = 7 };

/* `count` numbers from `first` on. */
static double *numbers(size_t count, size_t first)
{
    double *all = calloc(count, sizeof *all);
    assert_non_null(all);
    for (size_t i = 0; i < count; i++)
        all[i] = (double)(first + i);
    return all;
}

/* A scan whole and one in k pieces, to be run alone; a single surface has none. */
static void add_parts(struct repeat_set *set, size_t k)
{
    if (k == 0)
        return;
    *set = (struct repeat_set){.parts = calloc(k + 1, sizeof *set->parts),
                               .count = k + 1,
                               .capacity = k + 1,
                               .scans = calloc(2, sizeof *set->scans),
                               .scan_count = 2,
                               .no_intervals = k % 2};
    assert_true(set->parts && set->scans);
    set->scans[0] = (struct repeats_scan){.weight = 1, .point_count = 3};
    set->scans[1] = (struct repeats_scan){.weight = (double)k, .first_point = 3, .point_count = k};
    for (size_t p = 0; p <= k; p++)
        set->parts[p] = (struct repeat){.spectrum = {numbers(k + p, p), k + p, 1e-3, false},
                                        .roughness.rq_m = (double)p,
                                        .scan = p > 0,
                                        .points = 2 * (k + p)};
}

static void assert_same_spectrum(const struct spectrum *a, const struct spectrum *b)
{
    assert_int_equal(a->count, b->count);
    assert_int_equal(a->has_nyquist, b->has_nyquist);
    assert_near(a->length_m, b->length_m, 0);
    if (b->count > 0)
        assert_memory_equal(a->amplitude_m, b->amplitude_m, b->count * sizeof(double));
}

static void assert_same_parts(const struct repeat_set *a, const struct repeat_set *b)
{
    assert_int_equal(a->count, b->count);
    assert_int_equal(a->scan_count, b->scan_count);
    assert_int_equal(a->no_intervals, b->no_intervals);
    if (b->count == 0)
        return;
    assert_memory_equal(a->scans, b->scans, b->scan_count * sizeof *b->scans);
    for (size_t p = 0; p < b->count; p++) {
        const struct repeat *got = &a->parts[p], *expected = &b->parts[p];
        assert_same_spectrum(&got->spectrum, &expected->spectrum);
        assert_int_equal(got->scan, expected->scan);
        assert_int_equal(got->points, expected->points);
        assert_near(got->roughness.rq_m, expected->roughness.rq_m, 0);
        assert_null(got->height_m);
    }
}

/* A record whose every number follows from `k`, with arrays of lengths of its own. */
static struct surface_record *make(size_t k)
{
    struct surface_record *record = calloc(1, sizeof *record);
    assert_non_null(record);
    record->summary.usable = true;
    record->summary.points = 100 + k;
    record->summary.power_law.gamma = 1 + 0.1 * (double)k;
    record->summary.notes = strdup("a note\nand another");
    record->spectrum = (struct spectrum){.count = 50 * k + 1, .length_m = 1e-3 * (double)(k + 1), .has_nyquist = k % 2};
    record->spectrum.amplitude_m = calloc(record->spectrum.count, sizeof(double));
    for (size_t i = 0; i < record->spectrum.count; i++)
        record->spectrum.amplitude_m[i] = (double)(1000 * k + i);
    record->curves = calloc(model_count, sizeof *record->curves);
    record->bands = calloc(model_count, sizeof *record->bands);
    assert_true(record->curves && record->bands);
    record->band_count = 2 + k;
    for (size_t m = 0; m < model_count; m++) {
        struct model_curve *curve = &record->curves[m];
        curve->exists = (k + m) % 3 != 0;
        curve->count = curve->exists ? 3 * k + m : 0;
        curve->full_load = (double)(k + m);
        curve->points = curve->exists ? calloc(curve->count + 1, sizeof *curve->points) : NULL;
        for (size_t i = 0; i < curve->count; i++)
            curve->points[i] =
                (struct contact_point){.load = (double)i,
                                       .area_ratio = (double)(100 * k + m),
                                       .tcr_K_m2_per_W = NAN,
                                       .separation_m = i % 2 ? NAN : -0.0, /* bits that == does not tell apart */
                                       .ecr_ohm_m2 = i + 1 == curve->count ? -0.0 : 0,
                                       .radius_clamped = (double)(i * m)};
        record->bands[m] = (k + m) % 4 == 0 ? calloc(record->band_count, sizeof **record->bands) : NULL;
        for (size_t i = 0; record->bands[m] && i < record->band_count; i++)
            record->bands[m][i] = (struct repeats_band){
                .load = (double)(k + m + i), .mean = {{NAN, (double)i}}, .next = {{(double)k, NAN}}};
    }
    record->tapered = (struct spectrum){numbers(k + 3, k), k + 3, 1e-3, false};
    record->summary.heights = 2 * k;
    record->points = calloc(2 * k + 1, sizeof *record->points);
    assert_non_null(record->points);
    for (size_t i = 0; i < record->summary.heights; i++)
        record->points[i] = (struct slope_point){.height_m = (double)(k * i)};
    record->summary.single_points = 5;
    record->height_m = k % 2 ? numbers(5, k) : NULL;
    add_parts(&record->repeats, k);
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++)
        record->sensitivity.variants[v].spectrum = (struct spectrum){numbers(k + 1, 7 * k), k + 1, 1e-3, false};
    record->preview_points = 2;
    record->preview_z_m[1] = (double)k;
    return record;
}

static void assert_same(const struct surface_record *got, size_t k)
{
    struct surface_record *expected = make(k);
    assert_true(got->summary.usable);
    assert_int_equal(got->summary.points, expected->summary.points);
    assert_near(got->summary.power_law.gamma, expected->summary.power_law.gamma, 0);
    assert_string_equal(got->summary.notes, expected->summary.notes);
    assert_same_spectrum(&got->spectrum, &expected->spectrum);
    assert_same_spectrum(&got->tapered, &expected->tapered);
    assert_same_parts(&got->repeats, &expected->repeats);
    for (int v = 0; v < SENSITIVITY_VARIANTS; v++)
        assert_same_spectrum(&got->sensitivity.variants[v].spectrum, &expected->sensitivity.variants[v].spectrum);
    assert_int_equal(got->points != NULL, k > 0);
    if (got->points)
        assert_memory_equal(got->points, expected->points, 2 * k * sizeof *got->points);
    assert_int_equal(got->height_m != NULL, k % 2);
    if (got->height_m)
        assert_memory_equal(got->height_m, expected->height_m, 5 * sizeof *got->height_m);
    for (size_t m = 0; m < model_count; m++) {
        const struct model_curve *a = &got->curves[m], *b = &expected->curves[m];
        assert_true(a->exists == b->exists && a->count == b->count && a->full_load == b->full_load);
        if (a->count > 0)
            assert_memory_equal(a->points, b->points, a->count * sizeof *a->points);
        assert_int_equal(got->bands[m] != NULL, expected->bands[m] != NULL);
        if (got->bands[m])
            assert_memory_equal(got->bands[m], expected->bands[m], got->band_count * sizeof **got->bands);
    }
    assert_int_equal(got->band_count, expected->band_count);
    assert_int_equal(got->preview_points, 2);
    assert_near(got->preview_z_m[1], (double)k, 0);
    surface_record_free(expected, true);
    free(expected);
}

static void put(struct surface_store *store, size_t k)
{
    struct surface_record *record = make(k);
    struct status status = {0};
    assert_int_equal(surface_store_put(store, k, record, &status), STATUS_OK);
    surface_record_free(record, false);
    free(record);
}

/* Reads surface `index`, which is to be that of `k`. */
static void get_as(struct surface_store *store, size_t index, size_t k)
{
    struct surface_record *record = malloc(sizeof *record);
    struct status status = {0};
    assert_non_null(record);
    assert_int_equal(surface_store_get(record, store, index, &status), STATUS_OK);
    assert_same(record, k);
    surface_record_free(record, false);
    free(record);
}

static void get(struct surface_store *store, size_t k)
{
    get_as(store, k, k);
}

static void test_surfaces_come_back_in_any_order(void **state)
{
    (void)state;
    static const size_t in[SURFACES] = {3, 0, 6, 1, 5, 2, 4}, out[] = {6, 0, 0, 5, 1, 4, 2, 3, 6};
    struct directory place = directory_make();
    struct surface_store store;
    struct status status = {0};
    assert_int_equal(surface_store_open(&store, place.path, SURFACES, &status), STATUS_OK);
    assert_int_equal(directory_entries(&place, ""), 0); /* the file has no name */
    for (size_t i = 0; i < SURFACES; i++) {
        put(&store, in[i]);
        get(&store, in[i / 2]); /* reading in between disturbs nothing */
    }
    for (size_t i = 0; i < sizeof out / sizeof *out; i++)
        get(&store, out[i]);
    surface_store_close(&store);
    assert_null(store.file);
    directory_remove(&place);
}

struct writer {
    struct surface_store *store;
    size_t first, step;
    pthread_t thread;
};

static void *write_some(void *context)
{
    const struct writer *writer = context;
    for (size_t k = writer->first; k < writer->store->count; k += writer->step)
        put(writer->store, k);
    return NULL;
}

static void test_several_threads_may_put(void **state)
{
    (void)state;
    enum { THREADS = 4, MANY = 200 };
    struct directory place = directory_make();
    struct surface_store store;
    struct writer writers[THREADS];
    struct status status = {0};
    assert_int_equal(surface_store_open(&store, place.path, MANY, &status), STATUS_OK);
    for (size_t t = 0; t < THREADS; t++) {
        writers[t] = (struct writer){.store = &store, .first = t, .step = THREADS};
        assert_int_equal(pthread_create(&writers[t].thread, NULL, write_some, &writers[t]), 0);
    }
    for (size_t t = 0; t < THREADS; t++)
        pthread_join(writers[t].thread, NULL);
    for (size_t k = 0; k < MANY; k++)
        get(&store, k);
    surface_store_close(&store);
    directory_remove(&place);
}

/* A surface that was described has no curves yet; once its models ran these are stored as well. */
static void test_a_surface_is_put_again_with_its_curves(void **state)
{
    (void)state;
    struct directory place = directory_make();
    struct surface_store store;
    struct status status = {0};
    assert_int_equal(surface_store_open(&store, place.path, 2, &status), STATUS_OK);
    struct surface_record *record = make(2), got;
    struct model_curve *curves = record->curves;
    struct repeats_band **bands = record->bands;
    record->curves = NULL;
    record->bands = NULL;
    assert_int_equal(surface_store_put(&store, 0, record, &status), STATUS_OK);
    put(&store, 1);
    assert_int_equal(surface_store_get(&got, &store, 0, &status), STATUS_OK);
    assert_true(got.curves == NULL && got.bands == NULL);
    assert_memory_equal(got.spectrum.amplitude_m, record->spectrum.amplitude_m, got.spectrum.count * sizeof(double));
    surface_record_free(&got, false);
    record->curves = curves;
    record->bands = bands;
    assert_int_equal(surface_store_update(&store, 0, record, &status), STATUS_OK);
    get_as(&store, 0, 2);
    get(&store, 1);
    surface_drop_scans(record); /* they stay in the file, but not in the record */
    assert_int_equal(surface_store_update(&store, 0, record, &status), STATUS_OK);
    assert_int_equal(surface_store_get(&got, &store, 0, &status), STATUS_OK);
    assert_true(got.repeats.count == 0 && !got.repeats.parts && !got.height_m);
    assert_memory_equal(got.direct_m, record->direct_m, got.direct_count * sizeof(double));
    surface_record_free(&got, false);
    assert_int_equal(store.summaries[0].points, 102);
    surface_record_free(record, false);
    free(record);
    surface_store_close(&store);
    directory_remove(&place);
}

/* Parts of a record: the curves as they were, what is left out without a trace. */
static void test_parts(void **state)
{
    (void)state;
    struct directory place = directory_make();
    struct surface_store store;
    struct status status = {0};
    assert_int_equal(surface_store_open(&store, place.path, SURFACES, &status), STATUS_OK);
    for (size_t k = 0; k < SURFACES; k++)
        put(&store, k);
    for (size_t k = 0; k < SURFACES; k++)
        for (int part = SURFACE_BYTES_CURVES; part < SURFACE_BYTES_ALL; part++) {
            struct surface_record *whole = make(k), *got = malloc(sizeof *got);
            assert_non_null(got);
            assert_int_equal(surface_store_get_part(got, &store, k, (enum surface_bytes_part)part, &status), STATUS_OK);
            for (size_t m = 0; m < model_count; m++) {
                assert_int_equal(got->curves[m].count, whole->curves[m].count);
                if (got->curves[m].count > 0)
                    assert_memory_equal(got->curves[m].points, whole->curves[m].points,
                                        got->curves[m].count * sizeof(struct contact_point));
                assert_int_equal(got->bands[m] == NULL, whole->bands[m] == NULL);
                if (got->bands[m])
                    assert_memory_equal(got->bands[m], whole->bands[m], got->band_count * sizeof **got->bands);
            }
            assert_int_equal(got->preview_points, 2);
            assert_near(got->preview_z_m[1], (double)k, 0);
            if (part == SURFACE_BYTES_SPECTRUM)
                assert_memory_equal(got->spectrum.amplitude_m, whole->spectrum.amplitude_m,
                                    whole->spectrum.count * sizeof(double));
            assert_int_equal(got->spectrum.count, part == SURFACE_BYTES_SPECTRUM ? whole->spectrum.count : 0);
            assert_true(part == SURFACE_BYTES_SPECTRUM || !got->spectrum.amplitude_m);
            assert_true(!got->tapered.amplitude_m && got->tapered.count == 0);
            assert_true(!got->points && !got->height_m && !got->direct_m && got->direct_count == 0);
            assert_true(!got->repeats.parts && got->repeats.count == 0);
            for (int v = 0; v < SENSITIVITY_VARIANTS; v++)
                assert_null(got->sensitivity.variants[v].spectrum.amplitude_m);
            surface_record_free(got, false);
            surface_record_free(whole, true);
            free(got);
            free(whole);
        }
    surface_store_close(&store);
    directory_remove(&place);
}

/* A refused surface has a summary only. */
static void test_refusals_are_kept(void **state)
{
    (void)state;
    struct directory place = directory_make();
    struct surface_store store;
    struct status status = {0};
    struct surface_record *record = calloc(1, sizeof *record);
    assert_non_null(record);
    record->summary.refusal = strdup("a.csv: the scan is flat");
    assert_int_equal(surface_store_open(&store, place.path, 2, &status), STATUS_OK);
    assert_int_equal(surface_store_put(&store, 0, record, &status), STATUS_OK);
    put(&store, 1);
    assert_string_equal(store.summaries[0].refusal, "a.csv: the scan is flat");
    assert_false(store.summaries[0].usable);
    get(&store, 1);
    surface_store_close(&store);
    surface_record_free(record, false);
    free(record);
    directory_remove(&place);
}

static void test_a_directory_that_cannot_be_written_is_named(void **state)
{
    (void)state;
    struct directory place = directory_make();
    struct surface_store store;
    struct status status = {0};
    directory_write(&place, "file", "");
    assert_int_equal(surface_store_open(&store, directory_path(&place, "file"), 2, &status), STATUS_IO);
    assert_non_null(strstr(status.message, directory_path(&place, "file")));
    surface_store_close(&store);
    directory_remove(&place);
}

/* After a failed put the record is still the caller's: nothing of it is freed twice. */
static void test_a_full_disk_leaves_the_record_to_the_caller(void **state)
{
    (void)state;
    struct directory place = directory_make();
    struct surface_store store;
    struct status status = {0};
    assert_int_equal(surface_store_open(&store, place.path, 1, &status), STATUS_OK);
    fclose(store.file);
    store.file = fopen("/dev/full", "w+b");
    assert_non_null(store.file);
    struct surface_record *record = make(3);
    assert_int_equal(surface_store_put(&store, 0, record, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "No space left"));
    assert_null(store.summaries[0].notes);
    surface_record_free(record, true);
    free(record);
    surface_store_close(&store);
    directory_remove(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_surfaces_come_back_in_any_order),
        cmocka_unit_test(test_several_threads_may_put),
        cmocka_unit_test(test_a_surface_is_put_again_with_its_curves),
        cmocka_unit_test(test_parts),
        cmocka_unit_test(test_refusals_are_kept),
        cmocka_unit_test(test_a_directory_that_cannot_be_written_is_named),
        cmocka_unit_test(test_a_full_disk_leaves_the_record_to_the_caller),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
