/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include "base/large.h"
#include <pthread.h>

enum {
    SMALL = 1 << 16, /* records up to it: planning a complex transform takes longer than many such transforms */
    KEPT = 32        /* plans of small sizes; a set of scans has a few */
};

/** A transform of a small record in its place, to or from FFTW's half-complex format: the real parts of harmonics 0 ...
 * n/2, then the imaginary ones backwards. */
static struct kept {
    size_t n;
    bool forward;
    fftw_plan plan;
} kept[KEPT];
static size_t kept_count;
static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER; /* of `kept` too */

static fftw_plan plan_small(size_t n, bool forward, double *record)
{
    return fftw_plan_r2r_1d((int)n, record, record, forward ? FFTW_R2HC : FFTW_HC2R, FFTW_ESTIMATE);
}

/** Transforms in place by the plan kept of this size, which serves any record: all come from fftw_alloc. */
static void run_small(double *record, size_t n, bool forward)
{
    fftw_plan plan = NULL;
    pthread_mutex_lock(&planner);
    for (size_t i = 0; i < kept_count && !plan; i++)
        if (kept[i].n == n && kept[i].forward == forward)
            plan = kept[i].plan;
    bool known = plan != NULL, keep = known || kept_count < KEPT;
    if (!known)
        plan = plan_small(n, forward, record);
    if (!known && keep)
        kept[kept_count++] = (struct kept){n, forward, plan};
    pthread_mutex_unlock(&planner);
    fftw_execute_r2r(plan, record, record);
    if (keep)
        return;
    pthread_mutex_lock(&planner);
    fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planner);
}

bool fft_room_make(struct fft_room *out, size_t n)
{
    out->record = fftw_alloc_real(n);
    out->transform = fftw_alloc_complex(n / 2 + 1);
    large_pages(out->record, n * sizeof *out->record);
    large_pages(out->transform, (n / 2 + 1) * sizeof *out->transform);
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

static void run(fftw_plan plan)
{
    fftw_execute(plan);
    pthread_mutex_lock(&planner);
    fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planner);
}

void fft_forward(fftw_complex *out, double *in, size_t n)
{
    if (n <= SMALL) {
        run_small(in, n, true);
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
        run_small(out, n, false);
        return;
    }
    pthread_mutex_lock(&planner);
    fftw_plan plan = fftw_plan_dft_c2r_1d((int)n, in, out, FFTW_ESTIMATE);
    pthread_mutex_unlock(&planner);
    run(plan);
}
