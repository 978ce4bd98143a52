/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "ranks/ranks_team.h"

#include <fftw3-mpi.h>
#include <stdlib.h>
#include <time.h>

/* MPI counts with an int: what is longer goes in pieces. */
enum { PIECE = 1 << 30 };

static int piece_of(size_t bytes)
{
    return bytes < PIECE ? (int)bytes : PIECE;
}

void ranks_spread(void *data, size_t bytes, int root, MPI_Comm communicator)
{
    for (size_t done = 0; done < bytes; done += PIECE)
        MPI_Bcast((char *)data + done, piece_of(bytes - done), MPI_BYTE, root, communicator);
}

void ranks_send(const void *data, size_t bytes, int to, MPI_Comm communicator)
{
    for (size_t done = 0; done < bytes; done += PIECE)
        MPI_Send((const char *)data + done, piece_of(bytes - done), MPI_BYTE, to, 0, communicator);
}

void ranks_receive(void *data, size_t bytes, int from, MPI_Comm communicator)
{
    for (size_t done = 0; done < bytes; done += PIECE)
        MPI_Recv((char *)data + done, piece_of(bytes - done), MPI_BYTE, from, 0, communicator, MPI_STATUS_IGNORE);
}

void ranks_wait(MPI_Request *request)
{
    static const struct timespec nap = {0, 500000};
    int done = 0;
    while (MPI_Test(request, &done, MPI_STATUS_IGNORE), !done)
        nanosleep(&nap, NULL);
}

void ranks_wait_for_all(MPI_Comm communicator)
{
    MPI_Request request;
    MPI_Ibarrier(communicator, &request);
    ranks_wait(&request);
}

static MPI_Comm communicator_of(const struct direct_team *team)
{
    return *(MPI_Comm *)team->context;
}

static void gather(const struct direct_team *team, void *all, const void *mine, size_t bytes)
{
    MPI_Datatype block;
    MPI_Type_contiguous((int)bytes, MPI_BYTE, &block); /* the whole may have more bytes than an int counts */
    MPI_Type_commit(&block);
    MPI_Allgather(mine, 1, block, all, 1, block, communicator_of(team));
    MPI_Type_free(&block);
}

static void exchange(const struct direct_team *team, size_t to, const void *out, size_t from, void *in, size_t bytes)
{
    bool sends = to < team->size, receives = from < team->size;
    MPI_Sendrecv(out, sends ? (int)bytes : 0, MPI_BYTE, sends ? (int)to : MPI_PROC_NULL, 0, in,
                 receives ? (int)bytes : 0, MPI_BYTE, receives ? (int)from : MPI_PROC_NULL, 0, communicator_of(team),
                 MPI_STATUS_IGNORE);
}

struct transposition {
    fftw_plan forward, back;
};

static void transposition_free(void *transposition)
{
    struct transposition *pair = transposition;
    fftw_destroy_plan(pair->forward);
    fftw_destroy_plan(pair->back);
    free(pair);
}

static void *transposition_make(const struct direct_team *team, size_t ny, size_t nx, double *rows, double *columns)
{
    ptrdiff_t y = (ptrdiff_t)ny, x = (ptrdiff_t)nx, size = (ptrdiff_t)team->size;
    ptrdiff_t rows_each = (y + size - 1) / size, columns_each = (x + size - 1) / size; /* direct_team_slab()'s */
    struct transposition *pair = malloc(sizeof *pair);
    fftw_plan forward = fftw_mpi_plan_many_transpose(y, x, 2, rows_each, columns_each, rows, columns,
                                                     communicator_of(team), FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
    fftw_plan back = fftw_mpi_plan_many_transpose(x, y, 2, columns_each, rows_each, columns, rows,
                                                  communicator_of(team), FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
    if (pair && forward && back) {
        *pair = (struct transposition){forward, back};
        return pair;
    }
    fftw_destroy_plan(forward);
    fftw_destroy_plan(back);
    free(pair);
    return NULL;
}

static void transpose(void *transposition, bool back)
{
    const struct transposition *pair = transposition;
    fftw_execute(back ? pair->back : pair->forward);
}

enum status_code ranks_team_make(struct direct_team *out, MPI_Comm *communicator, struct status *status)
{
    int rank, size, missing;
    MPI_Comm_rank(*communicator, &rank);
    MPI_Comm_size(*communicator, &size);
    *out = (struct direct_team){.rank = (size_t)rank,
                                .size = (size_t)size,
                                .scratch = malloc((size_t)size * DIRECT_TEAM_VALUES * sizeof(double)),
                                .context = communicator,
                                .gather = gather,
                                .exchange = exchange,
                                .transposition_make = transposition_make,
                                .transpose = transpose,
                                .transposition_free = transposition_free};
    missing = !out->scratch;
    MPI_Allreduce(MPI_IN_PLACE, &missing, 1, MPI_INT, MPI_MAX, *communicator);
    if (!missing)
        return STATUS_OK;
    ranks_team_free(out);
    return status_memory(status);
}

void ranks_team_free(struct direct_team *team)
{
    free(team->scratch);
    *team = (struct direct_team){0};
}
