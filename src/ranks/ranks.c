/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "ranks/ranks.h"

#include "base/hash.h"
#include "direct/direct_ladder.h"

#include <assert.h>
#include <fftw3-mpi.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/** What the first rank calls for. Ranks run the same program, so it goes as it lies in memory. */
struct order {
    size_t n; /* points a side; 0: go */
    double spacing_m;
    struct direct_ladder_def ladder; /* its pointers mean nothing to others */
    double load[DIRECT_LADDER_SHARED];
};

static MPI_Comm world;
static struct direct_team team;

/** Waits for a request. What takes longer than a while leaves the processor to others. */
static void wait_for(MPI_Request request)
{
    static const struct timespec nap = {0, 200000};
    double begun = MPI_Wtime();
    int done = 0;
    while (MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done)
        if (MPI_Wtime() - begun > 1e-3)
            nanosleep(&nap, NULL);
}

static void spread(const struct direct_team *unused, void *data, size_t bytes)
{
    MPI_Request request;
    (void)unused;
    MPI_Ibcast(data, (int)bytes, MPI_BYTE, 0, world, &request);
    wait_for(request);
}

static void gather(const struct direct_team *unused, void *all, const void *mine, size_t bytes)
{
    MPI_Request request;
    (void)unused;
    MPI_Iallgather(mine, (int)bytes, MPI_BYTE, all, (int)bytes, MPI_BYTE, world, &request);
    wait_for(request);
}

static void *transposition_make(const struct direct_team *unused, size_t ny, size_t nx, double *from, double *to)
{
    ptrdiff_t y = (ptrdiff_t)ny, x = (ptrdiff_t)nx, size = (ptrdiff_t)team.size; /* slabs are direct_team_slab()'s */
    (void)unused;
    return fftw_mpi_plan_many_transpose(y, x, 2, (y + size - 1) / size, (x + size - 1) / size, from, to, world,
                                        FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
}

static void transpose(void *plan)
{
    fftw_execute(plan);
}

static void transposition_free(void *plan)
{
    fftw_destroy_plan(plan);
}

static void call(const struct direct_team *unused, size_t n, double spacing_m, const struct direct_ladder_def *def)
{
    struct order order = {n, spacing_m, *def, {0}};
    (void)unused;
    assert(def->loads <= DIRECT_LADDER_SHARED);
    memcpy(order.load, def->load, def->loads * sizeof *def->load);
    spread(&team, &order, sizeof order);
}

const struct direct_team *ranks_begin(int *argc, char ***argv)
{
    int provided, rank, size;
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
    fftw_mpi_init();
    MPI_Comm_dup(MPI_COMM_WORLD, &world);
    MPI_Comm_rank(world, &rank);
    MPI_Comm_size(world, &size);
    team = (struct direct_team){.rank = (size_t)rank,
                                .size = (size_t)size,
                                .scratch = malloc((size_t)size * sizeof(struct status)),
                                .call = call,
                                .spread = spread,
                                .gather = gather,
                                .transposition_make = transposition_make,
                                .transpose = transpose,
                                .transposition_free = transposition_free};
    if (!team.scratch)
        MPI_Abort(world, EXIT_FAILURE); /* not even some bytes: nobody could say so */
    return size > 1 ? &team : NULL;
}

bool ranks_agree(int argc, char **argv)
{
    struct hash hash = hash_start();
    unsigned char own[HASH_BYTES], first[HASH_BYTES];
    for (int i = 1; i < argc; i++)
        hash_add(&hash, argv[i], strlen(argv[i]) + 1);
    SHA256Final(own, &hash.context);
    memcpy(first, own, sizeof own);
    spread(&team, first, sizeof first);
    return !direct_team_any(&team, memcmp(own, first, sizeof own) != 0);
}

/** Solves an order with the first rank, which says what goes wrong. */
static void follow(struct order *order, const atomic_bool *stop)
{
    struct status status = {0};
    struct direct_point points[DIRECT_LADDER_SHARED];
    order->ladder.load = order->load;
    order->ladder.stop = stop;
    (void)!direct_ladder_of_heights(points, NULL, order->n, order->spacing_m, &order->ladder, &team, &status);
}

static void end(void)
{
    free(team.scratch);
    MPI_Comm_free(&world);
    MPI_Finalize();
}

void ranks_serve(const atomic_bool *stop)
{
    struct order order;
    while (spread(&team, &order, sizeof order), order.n > 0)
        follow(&order, stop);
    end();
}

void ranks_end(void)
{
    struct order order = {0};
    spread(&team, &order, sizeof order);
    end();
}
