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
    pthread_mutex_t lock;
    pthread_cond_t changed;
    const void *post[MOST][MOST]; /* from, to; NULL: taken */
};

struct member {
    struct direct_team team;
    struct crowd *crowd;
    void (*work)(const struct direct_team *, void *);
    void *context;
    double scratch[MOST * DIRECT_TEAM_VALUES];
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

static void exchange(const struct direct_team *team, size_t to, const void *out, size_t from, void *in, size_t bytes)
{
    struct crowd *crowd = team->context;
    pthread_mutex_lock(&crowd->lock);
    if (to < team->size)
        crowd->post[team->rank][to] = out;
    pthread_cond_broadcast(&crowd->changed);
    while (from < team->size && !crowd->post[from][team->rank])
        pthread_cond_wait(&crowd->changed, &crowd->lock);
    if (from < team->size) {
        memcpy(in, crowd->post[from][team->rank], bytes);
        crowd->post[from][team->rank] = NULL;
        pthread_cond_broadcast(&crowd->changed);
    }
    while (to < team->size && crowd->post[team->rank][to])
        pthread_cond_wait(&crowd->changed, &crowd->lock);
    pthread_mutex_unlock(&crowd->lock);
}

struct transposition {
    const struct direct_team *team;
    size_t ny, nx;
    double *rows, *columns;
};

static void *transposition_make(const struct direct_team *team, size_t ny, size_t nx, double *rows, double *columns)
{
    struct transposition *out = malloc(sizeof *out);
    if (out)
        *out = (struct transposition){team, ny, nx, rows, columns};
    return out;
}

static void transposition_free(void *transposition)
{
    free(transposition);
}

/** Each thread fetches its own slab from all others'. */
static void transpose(void *transposition, bool back)
{
    const struct transposition *own = transposition;
    const struct direct_team *team = own->team;
    struct crowd *crowd = team->context;
    size_t n = back ? own->nx : own->ny, across = back ? own->ny : own->nx, first;
    size_t count = direct_team_slab(across, team->size, team->rank, &first);
    double *to = back ? own->rows : own->columns;
    crowd->shown[team->rank] = back ? own->columns : own->rows;
    pthread_barrier_wait(&crowd->barrier);
    for (size_t rank = 0; rank < team->size; rank++) {
        const double *from = crowd->shown[rank];
        size_t start, lines = direct_team_slab(n, team->size, rank, &start);
        for (size_t j = 0; j < lines; j++)
            for (size_t i = 0; i < count; i++)
                memcpy(to + 2 * (i * n + start + j), from + 2 * (j * across + first + i), 2 * sizeof *to);
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
    struct crowd crowd = {.size = size, .lock = PTHREAD_MUTEX_INITIALIZER, .changed = PTHREAD_COND_INITIALIZER};
    struct member *members = calloc(size, sizeof *members);
    pthread_t threads[MOST];
    if (!members || size > MOST)
        abort();
    pthread_barrier_init(&crowd.barrier, NULL, (unsigned)size);
    for (size_t rank = 0; rank < size; rank++) {
        members[rank].team = (struct direct_team){rank,
                                                  size,
                                                  members[rank].scratch,
                                                  &crowd,
                                                  gather,
                                                  exchange,
                                                  transposition_make,
                                                  transpose,
                                                  transposition_free};
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
