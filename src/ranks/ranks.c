/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "ranks/ranks.h"

#include "direct/direct_shared.h"
#include "ranks/ranks_surfaces.h"
#include "ranks/ranks_team.h"

#include <assert.h>
#include <fftw3-mpi.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Rows that a rank must have of a grid it shares: with fewer, it would do little but wait for the others. */
enum { ROWS_LEAST = 32 };

/** What the first rank asks for. Ranks run the same program, so it goes as it lies in memory; arrays follow. */
struct order {
    enum { ORDER_END, ORDER_SURFACES, ORDER_FINE, ORDER_HEIGHTS, ORDER_TASK } kind;
    struct direct_ensemble_def def; /* its pointers mean nothing to others; of heights: n, length_m and ladder */
    struct direct_spectrum spectrum;
    size_t first, count; /* surfaces */
    size_t ranks_per_grid;
    struct ranks_task task; /* of ORDER_TASK, which needs nothing else */
};

/** The arrays of an order. */
struct arrays {
    double *load, *weight_m2, *given_m;
};

static MPI_Comm world;
static struct direct_team everyone; /* a team of all ranks; scratch NULL: not made yet */
static size_t ranks_per_grid;

void ranks_begin(int *argc, char ***argv)
{
    int provided;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
    fftw_mpi_init();
    MPI_Comm_dup(MPI_COMM_WORLD, &world);
}

bool ranks_is_first(void)
{
    int rank;
    MPI_Comm_rank(world, &rank);
    return rank == 0;
}

/** Whom a rank solves with, and which surfaces. */
struct share {
    struct direct_team team;
    MPI_Comm communicator; /* MPI_COMM_NULL: nothing to do */
    size_t first, count;   /* of all that are asked for */
};

/** Deals `count` surfaces of n points a side to groups of ranks, consecutive ones to each. */
static enum status_code share_make(struct share *out, size_t count, size_t n, size_t each, struct status *status)
{
    size_t rank = everyone.rank, size = everyone.size, groups = each ? size / each : count;
    groups = groups < 1 ? 1 : groups < size ? groups : size;
    groups = groups < count ? groups : count;
    size_t group = rank * groups / size, leader = (group * size + groups - 1) / groups;
    size_t useful = n / ROWS_LEAST > 1 ? n / ROWS_LEAST : 1;
    int color = rank - leader < useful ? (int)group : MPI_UNDEFINED;
    *out = (struct share){.first = group * count / groups};
    out->count = (group + 1) * count / groups - out->first;
    MPI_Comm_split(world, color, (int)rank, &out->communicator);
    if (color != MPI_UNDEFINED && ranks_team_make(&out->team, &out->communicator, status) != STATUS_OK)
        return status->code;
    return STATUS_OK;
}

static void share_free(struct share *share)
{
    ranks_team_free(&share->team);
    if (share->communicator != MPI_COMM_NULL)
        MPI_Comm_free(&share->communicator);
}

/** Some surfaces in this process alone, one after another or in threads. */
static enum status_code solve_alone(struct direct_point *out, double *rms_m, const struct direct_ensemble_def *def,
                                    size_t first, size_t count, struct status *status)
{
    struct direct_ensemble_def own = *def;
    struct direct_ensemble ensemble;
    own.crew = NULL;
    own.first_seed += first;
    own.seeds = count;
    own.enough = 0;
    own.fine_times = 0;
    own.threads = def->threads ? def->threads : 1; /* ranks are what it is parallel by */
    if (direct_ensemble_run(&ensemble, &own, status) != STATUS_OK)
        return status->code;
    memcpy(out, ensemble.seed_point, count * ensemble.loads * sizeof *out);
    *rms_m = ensemble.rms_m;
    direct_ensemble_free(&ensemble);
    return STATUS_OK;
}

/** The part of this rank: count x loads points, and Sq of the first surface. */
static enum status_code solve_share(struct direct_point *out, double *rms_m, const struct share *share,
                                    const struct direct_ensemble_def *def, size_t first, struct status *status)
{
    if (share->team.size == 1)
        return solve_alone(out, rms_m, def, first + share->first, share->count, status);
    for (size_t k = 0; k < share->count; k++) {
        double rms;
        if (direct_shared_surface(out + k * def->ladder.loads, &rms, &share->team, def, first + share->first + k, 1,
                                  status) != STATUS_OK)
            return status->code;
        *rms_m = k == 0 ? rms : *rms_m;
    }
    return STATUS_OK;
}

/** What the groups have found, to the first rank: the leader of each sends. */
static void collect(struct direct_point *out, const struct direct_point *own, const struct share *share, size_t loads)
{
    bool leads = share->communicator != MPI_COMM_NULL && share->team.rank == 0;
    size_t mine[2] = {share->first, leads ? share->count : 0};
    if (everyone.rank > 0) {
        ranks_send(mine, sizeof mine, 0, world);
        ranks_send(own, mine[1] * loads * sizeof *own, 0, world);
        return;
    }
    memcpy(out + mine[0] * loads, own, mine[1] * loads * sizeof *own);
    for (size_t rank = 1; rank < everyone.size; rank++) {
        size_t theirs[2];
        ranks_receive(theirs, sizeof theirs, (int)rank, world);
        ranks_receive(out + theirs[0] * loads, theirs[1] * loads * sizeof *out, (int)rank, world);
    }
}

/** What the first rank alone brings and takes. */
struct desk {
    struct direct_point *out;
    double *rms_m;          /* NULL: not wanted */
    const double *height_m; /* of ORDER_HEIGHTS */
    uint8_t *touching;
};

/** The part of this rank in an order. */
static enum status_code solve_order(struct direct_point *own, double *rms_m, const struct desk *desk,
                                    const struct share *share, const struct order *order, struct status *status)
{
    const struct direct_ensemble_def *def = &order->def;
    if (share->communicator == MPI_COMM_NULL)
        return STATUS_OK;
    if (order->kind == ORDER_HEIGHTS)
        return direct_shared_heights(own, desk->touching, &share->team, desk->height_m, def->n, def->length_m,
                                     &def->ladder, status);
    if (order->kind == ORDER_FINE)
        return direct_shared_surface(own, rms_m, &share->team, def, 0, def->fine_times, status);
    return solve_share(own, rms_m, share, def, order->first, status);
}

/** Carries out an order, together with all other ranks. */
static enum status_code carry_out(const struct order *order, const struct desk *desk, struct status *status)
{
    size_t loads = order->def.ladder.loads, times = order->kind == ORDER_FINE ? order->def.fine_times : 1;
    struct share share;
    double rms_m = NAN;
    (void)share_make(&share, order->count, order->def.n * times,
                     order->kind == ORDER_SURFACES ? order->ranks_per_grid : 0, status);
    struct direct_point *own = calloc(share.count * loads, sizeof *own);
    if (!own)
        (void)status_memory(status);
    if (direct_team_agree(&everyone, status) == STATUS_OK)
        (void)solve_order(own, &rms_m, desk, &share, order, status);
    ranks_wait_for_all(world);
    if (direct_team_agree(&everyone, status) == STATUS_OK)
        collect(desk->out, own, &share, loads);
    if (desk->rms_m)
        *desk->rms_m = rms_m; /* the first surface is the first rank's */
    free(own);
    share_free(&share);
    return status->code;
}

/** Tells the other ranks what to do; the first rank's own order keeps its pointers. */
static enum status_code give(struct order *order, struct status *status)
{
    const struct direct_ensemble_def *def = &order->def;
    MPI_Request request;
    order->ranks_per_grid = ranks_per_grid;
    if (order->kind != ORDER_HEIGHTS) {
        assert(def->variance == direct_spectrum_variance);
        order->spectrum = *(const struct direct_spectrum *)def->context;
    }
    MPI_Ibcast(order, sizeof *order, MPI_BYTE, 0, world, &request);
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    if (direct_team_agree(&everyone, status) != STATUS_OK) /* have all got memory? */
        return status->code;
    ranks_spread((void *)def->ladder.load, def->ladder.loads * sizeof(double), 0, world);
    if (order->kind == ORDER_HEIGHTS)
        return STATUS_OK;
    ranks_spread(order->spectrum.weight_m2, (order->spectrum.count + 2) * sizeof(double), 0, world);
    if (def->given_m)
        ranks_spread((void *)def->given_m, def->given_count * sizeof(double), 0, world);
    return STATUS_OK;
}

/** Receives the arrays of an order, and sets its pointers to them. */
static enum status_code take_arrays(struct arrays *out, struct order *order, const atomic_bool *stop,
                                    struct status *status)
{
    struct direct_ensemble_def *def = &order->def;
    size_t weights = order->kind != ORDER_HEIGHTS ? order->spectrum.count + 2 : 0;
    size_t given = weights && def->given_m ? def->given_count : 0;
    *out = (struct arrays){malloc(def->ladder.loads * sizeof(double)), malloc((weights + 1) * sizeof(double)),
                           malloc((given + 1) * sizeof(double))};
    if (!out->load || !out->weight_m2 || !out->given_m)
        (void)status_memory(status);
    if (direct_team_agree(&everyone, status) != STATUS_OK)
        return status->code;
    ranks_spread(out->load, def->ladder.loads * sizeof(double), 0, world);
    ranks_spread(out->weight_m2, weights * sizeof(double), 0, world);
    ranks_spread(out->given_m, given * sizeof(double), 0, world);
    order->spectrum.weight_m2 = out->weight_m2;
    def->ladder.load = out->load;
    def->ladder.stop = stop;
    def->variance = direct_spectrum_variance;
    def->context = &order->spectrum;
    def->given_m = given ? out->given_m : NULL;
    return STATUS_OK;
}

static void make_everyone(void)
{
    struct status status = {0};
    if (!everyone.scratch && ranks_team_make(&everyone, &world, &status) != STATUS_OK)
        MPI_Abort(world, EXIT_FAILURE); /* not even some bytes: nobody could say so */
}

void ranks_serve(const atomic_bool *stop)
{
    struct ranks_surfaces surfaces = {0};
    make_everyone();
    for (;;) {
        static const struct desk nothing;
        struct order order;
        struct arrays arrays;
        struct status status = {0}; /* the first rank has the same, and says it */
        MPI_Request request;
        MPI_Ibcast(&order, sizeof order, MPI_BYTE, 0, world, &request);
        ranks_wait(&request);
        if (order.kind == ORDER_END)
            break;
        if (order.kind == ORDER_TASK) {
            ranks_surfaces_follow(&surfaces, &everyone, world, &order.task, stop);
            continue;
        }
        if (take_arrays(&arrays, &order, stop, &status) == STATUS_OK)
            (void)carry_out(&order, &nothing, &status);
        free(arrays.load);
        free(arrays.weight_m2);
        free(arrays.given_m);
    }
    ranks_surfaces_free(&surfaces);
    ranks_team_free(&everyone);
    MPI_Comm_free(&world);
    MPI_Finalize();
}

void ranks_end(void)
{
    struct order order = {.kind = ORDER_END};
    MPI_Request request;
    make_everyone(); /* the others have, and wait */
    MPI_Ibcast(&order, sizeof order, MPI_BYTE, 0, world, &request);
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    ranks_team_free(&everyone);
    MPI_Comm_free(&world);
    MPI_Finalize();
}

/** Has all ranks carry out an order. */
static enum status_code ask(struct order *order, const struct desk *desk, struct status *status)
{
    return give(order, status) == STATUS_OK ? carry_out(order, desk, status) : status->code;
}

static enum status_code surfaces(const struct direct_crew *crew, struct direct_point *out, double *rms_m,
                                 const struct direct_ensemble_def *def, size_t first, size_t count,
                                 struct status *status)
{
    struct order order = {.kind = ORDER_SURFACES, .def = *def, .first = first, .count = count};
    struct desk desk = {.out = out, .rms_m = rms_m};
    (void)crew;
    return ask(&order, &desk, status);
}

static enum status_code fine(const struct direct_crew *crew, struct direct_point *out,
                             const struct direct_ensemble_def *def, struct status *status)
{
    struct order order = {.kind = ORDER_FINE, .def = *def, .count = 1};
    struct desk desk = {.out = out};
    (void)crew;
    return ask(&order, &desk, status);
}

static enum status_code heights(const struct direct_crew *crew, struct direct_point *out, uint8_t *touching,
                                const double *height_m, size_t n, double spacing_m, const struct direct_ladder_def *def,
                                struct status *status)
{
    struct order order = {.kind = ORDER_HEIGHTS, .def = {.ladder = *def, .n = n, .length_m = spacing_m}, .count = 1};
    struct desk desk = {.out = out, .height_m = height_m, .touching = touching};
    (void)crew;
    return ask(&order, &desk, status);
}

const struct direct_crew *ranks_crew(const struct ranks_options *options)
{
    static const struct direct_crew crew = {NULL, surfaces, fine, heights};
    make_everyone();
    ranks_per_grid = options->ranks_per_grid;
    return everyone.size > 1 ? &crew : NULL;
}

static enum status_code run_task(const struct workers_crew *crew, const struct results *results, enum workers_task task,
                                 const struct run_options *options, struct status *status)
{
    struct order order = {.kind = ORDER_TASK, .task = ranks_surfaces_task(results, task, options)};
    MPI_Request request;
    (void)crew;
    MPI_Ibcast(&order, sizeof order, MPI_BYTE, 0, world, &request);
    MPI_Wait(&request, MPI_STATUS_IGNORE);
    return ranks_surfaces_lead(&everyone, world, &order.task, results, options, status);
}

const struct workers_crew *ranks_workers(void)
{
    static const struct workers_crew crew = {run_task};
    make_everyone();
    return everyone.size > 1 ? &crew : NULL;
}
