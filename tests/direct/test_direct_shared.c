/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A grid shared by a team gives what one process gives, and an error or a stop on one rank ends all. */
#include "direct_points.h"
#include "direct_support.h"
#include "thread_team.h"

static const double loads[] = {5e-3, 0.02, 0.08, 0.3, 0.6};
enum { LOADS = sizeof loads / sizeof loads[0], RANKS = 24, N = 128 }; /* with a coarse grid of 64 */
static const size_t sizes[] = {1, 2, 3, RANKS};                       /* of 24 the last have no rows */
enum { SIZES = sizeof sizes / sizeof sizes[0] };

/** What every rank is given and finds. */
struct found {
    struct direct_ladder_def ladder;
    const double *height;
    size_t n;
    size_t stopped; /* the only rank that is asked to stop; RANKS: none */
    struct direct_point points[RANKS][LOADS];
    struct status status[RANKS];
};

static double *copy_of(const double *height, size_t n)
{
    double *copy = malloc(n * n * sizeof *copy);
    assert_non_null(copy);
    return memcpy(copy, height, n * n * sizeof *copy);
}

static void solve_one(const struct direct_team *team, void *context)
{
    static const atomic_bool stop = true;
    struct found *found = context;
    struct direct_ladder_def ladder = found->ladder;
    size_t rank = team ? team->rank : 0;
    double *height = rank == 0 ? copy_of(found->height, N) : NULL;
    ladder.stop = rank == found->stopped ? &stop : NULL;
    enum status_code rc = direct_ladder_of_heights(found->points[rank], height, found->n, 1 / (double)found->n, &ladder,
                                                   team, &found->status[rank]);
    if (rc != found->status[rank].code)
        found->status[rank].code = STATUS_NUMBER;
}

static struct found *found_of(const double *height, double hardness)
{
    struct found *found = calloc(1, sizeof *found);
    assert_non_null(found);
    *found = (struct found){
        .ladder = {loads, LOADS, hardness, 1e-9, true, NULL}, .height = height, .n = N, .stopped = RANKS};
    return found;
}

/** By teams of all sizes as by one process: elastic; with a hardness below the last load; under one load that touches
 * in parts. */
TEST_CASE(as_by_one_process)
{
    static const struct {
        double hardness;
        size_t loads;
    } cases[] = {{INFINITY, LOADS}, {0.5, LOADS}, {INFINITY, 3}};
    double *height = recipe_surface(N);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        struct found *expected = found_of(height, cases[c].hardness);
        expected->ladder.loads = cases[c].loads;
        solve_one(NULL, expected);
        assert_int_equal(expected->status[0].code, STATUS_OK);
        for (size_t s = 0; s < SIZES; s++) {
            struct found *found = found_of(height, cases[c].hardness);
            found->ladder.loads = cases[c].loads;
            thread_team_run(sizes[s], solve_one, found);
            for (size_t rank = 0; rank < sizes[s]; rank++)
                assert_int_equal(found->status[rank].code, STATUS_OK);
            expect_same(found->points[0], expected->points[0], cases[c].loads);
            free(found);
        }
        free(expected);
    }
    free(height);
}

/** Patches across the slabs and round the cell: a comb, a ring, the corners, points; and nothing on some ranks. */
struct drawing {
    const char *rows[8];
    size_t count, points;
};

struct drawn {
    const struct drawing *drawing;
    size_t count;
    struct direct_quantities quantities;
};

static void find_patches(const struct direct_team *team, void *context)
{
    static const double height[64] = {1};
    struct drawn *drawn = context, found = {0};
    struct direct_contact contact;
    struct status status = {0};
    struct direct_contact_load load = {0.1, INFINITY, 1e-6, false, NULL};
    bool first = !team || team->rank == 0;
    if (direct_contact_make(&contact, team, first ? height : NULL, 8, 8, 1, &status) != STATUS_OK)
        return;
    for (size_t j = 0; j < contact.kernel.rows; j++)
        for (size_t i = 0; i < 8; i++)
            contact.pressure[j * contact.kernel.stride + i] =
                drawn->drawing->rows[contact.kernel.first_row + j][i] == '#';
    found.quantities = direct_quantities_of(&contact, &load);
    if (direct_patches(&found.count, &contact, &status) == STATUS_OK && first) {
        drawn->quantities = found.quantities;
        drawn->count = found.count;
    }
    direct_contact_free(&contact);
}

TEST_CASE(patches)
{
    static const struct drawing drawings[] = {
        {{"#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#.#.#.#.", "#######.", "........"}, 1, 31},
        {{"..#.....", "........", ".####...", ".#..#.#.", ".####...", "........", "........", "..#....#"}, 4, 14},
        {{"########", "........", "#......#", "........", "........", "........", "........", "########"}, 2, 18},
        {{"........", "........", "........", "...#....", "...#....", "........", "........", "........"}, 1, 2},
        {{"#......#", "........", "........", "...#....", "...##...", ".....#..", "........", "#......#"}, 3, 8},
    };
    for (size_t d = 0; d < sizeof drawings / sizeof *drawings; d++) {
        size_t faces = 0;
        for (size_t j = 0; j < 8; j++)
            for (size_t i = 0; i < 8; i++) {
                char here = drawings[d].rows[j][i];
                faces += here != drawings[d].rows[(j + 1) % 8][i];
                faces += here != drawings[d].rows[j][(i + 1) % 8];
            }
        for (size_t size = 0; size <= 8; size++) { /* 0: no team */
            struct drawn drawn = {.drawing = &drawings[d]};
            if (size > 0)
                thread_team_run(size, find_patches, &drawn);
            else
                find_patches(NULL, &drawn);
            assert_int_equal(drawn.quantities.perimeter_faces, faces);
            assert_int_equal(drawn.quantities.contact_points, drawings[d].points);
            assert_near(drawn.quantities.area_ratio, ((double)drawings[d].points - 0.1 * (double)faces) / 64, 1e-15);
            assert_int_equal(drawn.count, drawings[d].count);
        }
    }
}

/** What happens on one rank happens on all, with its message. */
TEST_CASE(errors_and_stop)
{
    static const struct {
        enum status_code code;
        const char *says;
        size_t stopped, n, gap; /* a height that is missing */
    } cases[] = {{STATUS_INTERRUPTED, "stopped", 2, N, N * N},
                 {STATUS_USAGE, "cannot be solved", RANKS, DIRECT_KERNEL_MOST + 2, N * N},
                 {STATUS_MODEL, "height 7687 of", RANKS, N, 60 * N + 7}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        double *height = recipe_surface(N);
        struct found *found = found_of(height, INFINITY);
        found->stopped = cases[c].stopped;
        found->n = cases[c].n;
        if (cases[c].gap < N * N)
            height[cases[c].gap] = NAN;
        thread_team_run(4, solve_one, found);
        for (size_t rank = 0; rank < 4; rank++) {
            assert_int_equal(found->status[rank].code, cases[c].code);
            assert_string_equal(found->status[rank].message, found->status[0].message);
        }
        assert_non_null(strstr(found->status[0].message, cases[c].says));
        free(found);
        free(height);
    }
}
