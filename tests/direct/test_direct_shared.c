/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A grid shared by a team gives what one process gives, and an error or a stop on one rank ends all. */
#include "direct_points.h"
#include "direct_support.h"
#include "thread_team.h"

#include "direct/direct_shared.h"

static const double loads[] = {5e-3, 0.02, 0.08, 0.3, 0.6};
enum { LOADS = sizeof loads / sizeof loads[0], RANKS = 24, N = 64 };
static const size_t sizes[] = {1, 2, 3, 4, RANKS}; /* of 24 the last have no rows of 64 */
enum { SIZES = sizeof sizes / sizeof sizes[0] };

/** What every rank finds. */
struct found {
    const struct direct_ensemble_def *def;
    size_t times;
    const double *height; /* not NULL: of these N x N heights */
    uint8_t *touching;
    size_t stopped; /* the only rank that is asked to stop; RANKS: none */
    struct direct_point points[RANKS][LOADS];
    double rms_m[RANKS];
    struct status status[RANKS];
};

static void solve_one(const struct direct_team *team, void *context)
{
    static const atomic_bool stop = true;
    struct found *found = context;
    struct direct_ensemble_def def = *found->def;
    struct status *status = &found->status[team->rank];
    def.ladder.stop = team->rank == found->stopped ? &stop : NULL;
    enum status_code rc =
        found->height ? direct_shared_heights(found->points[team->rank], team->rank == 0 ? found->touching : NULL, team,
                                              team->rank == 0 ? found->height : NULL, N, 1.0 / N, &def.ladder, status)
                      : direct_shared_surface(found->points[team->rank], &found->rms_m[team->rank], team, &def, 0,
                                              found->times, status);
    if (rc != status->code)
        status->code = STATUS_NUMBER;
}

static struct direct_ensemble_def def_of(const double *scale, double hardness)
{
    return (struct direct_ensemble_def){.ladder = {loads, LOADS, hardness, 1e-9, true, NULL},
                                        .length_m = 1,
                                        .n = N,
                                        .variance = recipe_variance,
                                        .context = scale,
                                        .first_seed = 1,
                                        .seeds = 1,
                                        .threads = 1};
}

/** By teams of all sizes as by one process. */
static void compare(const struct direct_ensemble_def *def, size_t times)
{
    double *coarse = malloc(N * N * sizeof *coarse), *fine = malloc(times * times * N * N * sizeof *fine);
    struct direct_point expected[LOADS];
    struct status status = {0};
    assert_true(coarse && fine);
    assert_int_equal(def->given_m ? direct_surface_with_heights(coarse, N, def->variance, def->context, def->given_m,
                                                                def->given_count, 1, &status)
                                  : direct_surface_realise(coarse, N, def->variance, def->context, 1, &status),
                     STATUS_OK);
    assert_int_equal(direct_surface_refine(fine, times, coarse, N, &status), STATUS_OK);
    struct direct_contact contact = contact_of(fine, times * N, times * N);
    assert_int_equal(direct_ladder_run(expected, &contact, &def->ladder, &status), STATUS_OK);
    for (size_t s = 0; s < SIZES; s++) {
        struct found *found = calloc(1, sizeof *found);
        assert_non_null(found);
        found->def = def;
        found->times = times;
        found->stopped = RANKS;
        thread_team_run(sizes[s], solve_one, found);
        for (size_t rank = 0; rank < sizes[s]; rank++) {
            assert_int_equal(found->status[rank].code, STATUS_OK);
            assert_near(found->rms_m[rank], contact.rms_m, 1e-12);
            assert_memory_equal(&found->rms_m[rank], &found->rms_m[0], sizeof(double));
            expect_same(found->points[rank], expected, LOADS);
        }
        free(found);
    }
    direct_contact_free(&contact);
    free(coarse);
    free(fine);
}

static void elastic(void **state)
{
    (void)state;
    double scale = recipe_scale();
    struct direct_ensemble_def def = def_of(&scale, INFINITY);
    compare(&def, 1);
    compare(&def, 2);
}

static void with_a_hardness(void **state)
{
    (void)state;
    double scale = recipe_scale();
    struct direct_ensemble_def def = def_of(&scale, 0.5);
    compare(&def, 1);
}

static void with_given_heights(void **state)
{
    (void)state;
    double scale = recipe_scale(), given[200];
    for (size_t k = 0; k < 200; k++)
        given[k] = pow((double)k, 2);
    struct direct_ensemble_def def = def_of(&scale, INFINITY);
    def.given_m = given;
    def.given_count = 200;
    compare(&def, 1);
    compare(&def, 2);
}

/** Heights that only the first rank has; where they touch comes back to it. */
static void of_heights(void **state)
{
    (void)state;
    double scale = recipe_scale(), *height = recipe_surface(N);
    struct direct_ensemble_def def = def_of(&scale, INFINITY);
    struct direct_point expected[LOADS];
    uint8_t touching[N * N], there[N * N];
    struct status status = {0};
    def.ladder.loads = 3; /* the last of them touches in parts */
    assert_int_equal(direct_ladder_of_heights(expected, touching, height, N, 1.0 / N, &def.ladder, NULL, &status),
                     STATUS_OK);
    expected[3] = expected[4] = (struct direct_point){0};
    for (size_t s = 0; s < SIZES; s++) {
        struct found *found = calloc(1, sizeof *found);
        assert_non_null(found);
        *found = (struct found){.def = &def, .height = height, .touching = there, .stopped = RANKS};
        memset(there, 2, sizeof there);
        thread_team_run(sizes[s], solve_one, found);
        assert_int_equal(found->status[0].code, STATUS_OK);
        expect_same(found->points[0], expected, LOADS);
        assert_memory_equal(there, touching, sizeof there);
        free(found);
    }
    free(height);
}

/** Patches across the slabs and round the cell: a comb, a ring, points; and nothing on some ranks. */
struct drawing {
    const char *rows[8];
    size_t count, points[4];
};

struct drawn {
    const struct drawing *drawing;
    struct direct_patches found[8];
    size_t faces[8];
};

static void find_patches(const struct direct_team *team, void *context)
{
    struct drawn *drawn = context;
    struct direct_contact contact;
    struct status status = {0};
    struct direct_contact_load load = {0.1, INFINITY, 1e-6, 0, false, NULL};
    if (direct_contact_begin(&contact, team, 8, 8, 1, &status) != STATUS_OK)
        return;
    for (size_t j = 0; j < contact.kernel.rows; j++)
        for (size_t i = 0; i < 8; i++)
            contact.pressure[j * contact.kernel.stride + i] =
                drawn->drawing->rows[contact.kernel.first_row + j][i] == '#';
    drawn->faces[team->rank] = direct_quantities_of(&contact, &load).perimeter_faces;
    if (direct_patches_find(&drawn->found[team->rank], &contact, &status) != STATUS_OK)
        drawn->faces[team->rank] = 0;
    direct_contact_free(&contact);
}

static void patches(void **state)
{
    (void)state;
    static const struct drawing drawings[] = {
        {{"#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#######.", "........"}, 1, {31}},
        {{"..#.....", "........", ".####...", ".#..#.#.", ".####...", "........", "........", "..#....#"},
         4,
         {10, 2, 1, 1}},
        {{"########", "........", "#......#", "........", "........", "........", "........", "########"}, 2, {16, 2}},
        {{"........", "........", "........", "...#....", "...#....", "........", "........", "........"}, 1, {2}},
    };
    for (size_t d = 0; d < sizeof drawings / sizeof *drawings; d++) {
        size_t faces = 0;
        for (size_t j = 0; j < 8; j++)
            for (size_t i = 0; i < 8; i++) {
                char here = drawings[d].rows[j][i];
                faces += here != drawings[d].rows[(j + 1) % 8][i];
                faces += here != drawings[d].rows[j][(i + 1) % 8];
            }
        for (size_t size = 1; size <= 8; size++) {
            struct drawn drawn = {.drawing = &drawings[d]};
            thread_team_run(size, find_patches, &drawn);
            for (size_t rank = 0; rank < size; rank++) {
                assert_int_equal(drawn.faces[rank], faces);
                assert_int_equal(drawn.found[rank].count, drawings[d].count);
                for (size_t k = 0; k < drawings[d].count; k++)
                    assert_int_equal(drawn.found[rank].points[k], drawings[d].points[k]);
                direct_patches_free(&drawn.found[rank]);
            }
        }
    }
}

static double negative_beyond(double r, const void *context)
{
    return r < *(const double *)context ? 1e-6 : -1; /* no rank but the one with these columns sees it */
}

/** What happens on one rank happens on all, with its message. */
static void errors_and_stop(void **state)
{
    (void)state;
    double scale = recipe_scale(), beyond = 31.5, *height = recipe_surface(N);
    for (int what = 0; what < 4; what++) {
        struct direct_ensemble_def def = def_of(&scale, INFINITY);
        struct found *found = calloc(1, sizeof *found);
        assert_non_null(found);
        found->def = &def;
        found->times = 1;
        found->stopped = what == 0 ? 2 : RANKS;
        if (what == 1) {
            def.variance = negative_beyond;
            def.context = &beyond;
        }
        if (what == 2)
            def.n = DIRECT_KERNEL_MOST_SHARED + 2;
        if (what == 3) {
            height[60 * N + 7] = NAN;
            found->height = height;
        }
        thread_team_run(4, solve_one, found);
        static const enum status_code codes[] = {STATUS_INTERRUPTED, STATUS_MODEL, STATUS_USAGE, STATUS_MODEL};
        for (size_t rank = 0; rank < 4; rank++) {
            assert_int_equal(found->status[rank].code, codes[what]);
            assert_string_equal(found->status[rank].message, found->status[0].message);
        }
        if (what == 3)
            assert_non_null(strstr(found->status[0].message, "height 3847 of"));
        free(found);
    }
    free(height);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elastic),    cmocka_unit_test(with_a_hardness), cmocka_unit_test(with_given_heights),
        cmocka_unit_test(of_heights), cmocka_unit_test(patches),         cmocka_unit_test(errors_and_stop),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
