/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "thread_team.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 32 };

/** What the threads of a team share. */
struct crowd {
    size_t size;
    pthread_barrier_t barrier;
    const void *shown[MOST]; /* by each rank, for all to copy */
};

struct member {
    struct direct_team team;
    struct crowd *crowd;
    void (*work)(const struct direct_team *, void *);
    void *context;
    struct status scratch[MOST];
};

static void gather(const struct direct_team *team, void *all, const void *mine, size_t bytes)
{
    struct crowd *crowd = team->context;
    crowd->shown[team->rank] = mine;
    pthread_barrier_wait(&crowd->barrier);
    for (size_t rank = 0; rank < team->size; rank++)
        memcpy((char *)all + rank * bytes, crowd->shown[rank], bytes);
    pthread_barrier_wait(&crowd->barrier);
}

static void spread(const struct direct_team *team, void *data, size_t bytes)
{
    struct crowd *crowd = team->context;
    crowd->shown[team->rank] = data;
    pthread_barrier_wait(&crowd->barrier);
    if (team->rank > 0)
        memcpy(data, crowd->shown[0], bytes);
    pthread_barrier_wait(&crowd->barrier);
}

/** The others are there already. */
static void call(const struct direct_team *team, size_t n, double spacing_m, const struct direct_ladder_def *def)
{
    (void)team, (void)n, (void)spacing_m, (void)def;
}

struct transposition {
    const struct direct_team *team;
    size_t ny, nx;
    double *from, *to;
};

static void *transposition_make(const struct direct_team *team, size_t ny, size_t nx, double *from, double *to)
{
    struct transposition *out = malloc(sizeof *out);
    if (out)
        *out = (struct transposition){team, ny, nx, from, to};
    return out;
}

/** Each thread fetches its own slab from all others'. */
static void transpose(void *transposition)
{
    const struct transposition *own = transposition;
    const struct direct_team *team = own->team;
    struct crowd *crowd = team->context;
    size_t first, count = direct_team_slab(own->nx, team->size, team->rank, &first);
    crowd->shown[team->rank] = own->from;
    pthread_barrier_wait(&crowd->barrier);
    for (size_t rank = 0; rank < team->size; rank++) {
        const double *from = crowd->shown[rank];
        size_t start, lines = direct_team_slab(own->ny, team->size, rank, &start);
        for (size_t j = 0; j < lines; j++)
            for (size_t i = 0; i < count; i++)
                memcpy(own->to + 2 * (i * own->ny + start + j), from + 2 * (j * own->nx + first + i), 2 * sizeof *from);
    }
    pthread_barrier_wait(&crowd->barrier);
}

static void *run(void *context)
{
    struct member *member = context;
    member->work(&member->team, member->context);
    return NULL;
}

void thread_team_run(size_t size, void (*work)(const struct direct_team *team, void *context), void *context)
{
    struct crowd crowd = {.size = size};
    struct member *members = calloc(size, sizeof *members);
    pthread_t threads[MOST];
    if (!members || size > MOST)
        abort();
    pthread_barrier_init(&crowd.barrier, NULL, (unsigned)size);
    for (size_t rank = 0; rank < size; rank++) {
        members[rank].team = (struct direct_team){.rank = rank,
                                                  .size = size,
                                                  .scratch = members[rank].scratch,
                                                  .context = &crowd,
                                                  .call = call,
                                                  .spread = spread,
                                                  .gather = gather,
                                                  .transposition_make = transposition_make,
                                                  .transpose = transpose,
                                                  .transposition_free = free};
        members[rank].crowd = &crowd;
        members[rank].work = work;
        members[rank].context = context;
        if (pthread_create(&threads[rank], NULL, run, &members[rank]) != 0)
            abort(); /* the others would wait for it */
    }
    for (size_t rank = 0; rank < size; rank++)
        pthread_join(threads[rank], NULL);
    pthread_barrier_destroy(&crowd.barrier);
    free(members);
}
