/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include <pthread.h>

enum {
    SMALL = 1 << 16, /* records up to it */
    KEPT = 64        /* plans of small sizes; a set of scans has a few */
};

/** A transform of a small record in its place, to or from FFTW's half-complex format: the real parts of harmonics 0
 * ... n/2, then the imaginary ones backwards. A plan, once made, serves every record of fftw_alloc to the end. */
static struct kept {
    size_t n;
    fftw_r2r_kind kind;
    fftw_plan plan;
} kept[KEPT];
static size_t kept_count;
static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER; /* of `kept` too */

static fftw_plan find_kept(size_t n, fftw_r2r_kind kind)
{
    for (size_t i = 0; i < kept_count; i++)
        if (kept[i].n == n && kept[i].kind == kind)
            return kept[i].plan;
    return NULL;
}

/** Runs a plan once. */
static void run(fftw_plan plan)
{
    fftw_execute(plan);
    pthread_mutex_lock(&planner);
    fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planner);
}

static void run_small(double *record, size_t n, fftw_r2r_kind kind)
{
    pthread_mutex_lock(&planner);
    bool keep = kept_count < KEPT;
    fftw_plan own = NULL, plan = find_kept(n, kind);
    if (!plan) {
        own = fftw_plan_r2r_1d((int)n, record, record, kind, FFTW_ESTIMATE);
        if (keep) {
            kept[kept_count++] = (struct kept){n, kind, own};
            plan = own;
        }
    }
    pthread_mutex_unlock(&planner);
    if (plan)
        fftw_execute_r2r(plan, record, record);
    else
        run(own);
}

bool fft_room_make(struct fft_room *out, size_t n)
{
    *out = (struct fft_room){fftw_alloc_real(n), fftw_alloc_complex(n / 2 + 1)};
    if (out->record && out->transform)
        return true;
    fft_room_free(out);
    return false;
}

void fft_room_free(struct fft_room *room)
{
    fftw_free(room->record);
    fftw_free(room->transform);
    *room = (struct fft_room){0};
}

void fft_forward(fftw_complex *out, double *in, size_t n)
{
    if (n <= SMALL) {
        run_small(in, n, FFTW_R2HC);
        out[0][0] = in[0];
        for (size_t k = 1; k <= n / 2; k++) {
            out[k][0] = in[k];
            out[k][1] = in[n - k];
        }
        out[0][1] = 0;
        if (n % 2 == 0)
            out[n / 2][1] = 0;
        return;
    }
    pthread_mutex_lock(&planner);
    fftw_plan plan = fftw_plan_dft_r2c_1d((int)n, in, out, FFTW_ESTIMATE);
    pthread_mutex_unlock(&planner);
    run(plan);
}

void fft_backward(double *out, fftw_complex *in, size_t n)
{
    if (n <= SMALL) {
        out[0] = in[0][0];
        for (size_t k = 1; k <= n / 2; k++) {
            out[n - k] = in[k][1];
            out[k] = in[k][0]; /* at n/2 there is no imaginary part */
        }
        run_small(out, n, FFTW_HC2R);
        return;
    }
    pthread_mutex_lock(&planner);
    fftw_plan plan = fftw_plan_dft_c2r_1d((int)n, in, out, FFTW_ESTIMATE);
    pthread_mutex_unlock(&planner);
    run(plan);
}
