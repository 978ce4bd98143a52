/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include <pthread.h>

enum {
    SMALL = 1 << 15, /* records up to it: planning a complex transform takes a quarter of `inspect` */
    KEPT = 16        /* plans of small sizes; a folder of scans has a few */
};

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER; /* of `kept` too */
static struct {
    size_t n;
    fftw_plan plan;
} kept[KEPT];

/** Runs a plan once. */
static void run(fftw_plan plan)
{
    fftw_execute(plan);
    pthread_mutex_lock(&planner);
    fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planner);
}

bool fft_room_make(struct fft_room *out, size_t n)
{
    double *record = fftw_alloc_real(2 * (n / 2 + 1));
    *out = (struct fft_room){record, n > SMALL ? (fftw_complex *)record : fftw_alloc_complex(n / 2 + 1)};
    if (out->record && out->transform)
        return true;
    fft_room_free(out);
    return false;
}

void fft_room_free(struct fft_room *room)
{
    if (room->transform != (fftw_complex *)room->record)
        fftw_free(room->transform);
    fftw_free(room->record);
    *room = (struct fft_room){0};
}

/** In its place, to the real parts of harmonics 0 ... n/2 and, backwards, the imaginary ones. */
static void forward_small(double *record, size_t n)
{
    size_t k = 0;
    pthread_mutex_lock(&planner);
    while (k < KEPT && kept[k].plan && kept[k].n != n)
        k++;
    fftw_plan plan = k < KEPT ? kept[k].plan : NULL;
    if (!plan)
        plan = fftw_plan_r2r_1d((int)n, record, record, FFTW_R2HC, FFTW_ESTIMATE);
    if (k < KEPT)
        kept[k].n = n, kept[k].plan = plan;
    pthread_mutex_unlock(&planner);
    if (k == KEPT) {
        run(plan);
        return;
    }
    fftw_execute_r2r(plan, record, record);
}

void fft_forward(fftw_complex *out, double *in, size_t n)
{
    if (n <= SMALL) {
        forward_small(in, n);
        for (size_t k = 0; k <= n / 2; k++) {
            out[k][0] = in[k];
            out[k][1] = k > 0 && 2 * k < n ? in[n - k] : 0;
        }
        return;
    }
    pthread_mutex_lock(&planner);
    fftw_plan plan = fftw_plan_dft_r2c_1d((int)n, in, out, FFTW_ESTIMATE);
    pthread_mutex_unlock(&planner);
    run(plan);
}

void fft_backward(double *out, fftw_complex *in, size_t n)
{
    pthread_mutex_lock(&planner);
    fftw_plan plan = fftw_plan_dft_c2r_1d((int)n, in, out, FFTW_ESTIMATE);
    pthread_mutex_unlock(&planner);
    run(plan);
}
