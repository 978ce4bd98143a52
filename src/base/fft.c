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
    bool back;
    fftw_plan plan;
} kept[KEPT];

void fft_plan(void (*work)(void *context), void *context)
{
    pthread_mutex_lock(&planner);
    work(context);
    pthread_mutex_unlock(&planner);
}

void fft_plan_free(fftw_plan plan)
{
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

/** One transform, and its plan; without `transform` in its place, to the real parts of harmonics 0 ... n/2 and,
 * backwards, the imaginary ones. */
struct once {
    double *record;
    fftw_complex *transform;
    size_t n;
    bool back, kept;
    fftw_plan plan;
};

static void make_plan(void *context)
{
    struct once *once = context;
    once->plan = once->back ? fftw_plan_dft_c2r_1d((int)once->n, once->transform, once->record, FFTW_ESTIMATE)
                            : fftw_plan_dft_r2c_1d((int)once->n, once->record, once->transform, FFTW_ESTIMATE);
}

static void make_small_plan(void *context)
{
    struct once *once = context;
    size_t k = 0;
    while (k < KEPT && kept[k].plan && (kept[k].n != once->n || kept[k].back != once->back))
        k++;
    once->kept = k < KEPT;
    once->plan = once->kept ? kept[k].plan : NULL;
    if (!once->plan && once->back)
        make_plan(once);
    else if (!once->plan)
        once->plan = fftw_plan_r2r_1d((int)once->n, once->record, once->record, FFTW_R2HC, FFTW_ESTIMATE);
    if (once->kept)
        kept[k].n = once->n, kept[k].back = once->back, kept[k].plan = once->plan;
}

static void run_once(const struct once *once)
{
    if (once->back)
        fftw_execute_dft_c2r(once->plan, once->transform, once->record);
    else if (once->transform)
        fftw_execute(once->plan);
    else
        fftw_execute_r2r(once->plan, once->record, once->record);
}

static bool transform(struct once once)
{
    fft_plan(once.n > SMALL ? make_plan : make_small_plan, &once);
    if (!once.plan)
        return false;
    run_once(&once);
    if (!once.kept)
        fft_plan_free(once.plan);
    return true;
}

bool fft_forward(fftw_complex *out, double *in, size_t n)
{
    if (n > SMALL)
        return transform((struct once){.record = in, .transform = out, .n = n});
    bool done = transform((struct once){.record = in, .n = n});
    for (size_t k = 0; k <= n / 2; k++) {
        out[k][0] = in[k];
        out[k][1] = k > 0 && 2 * k < n ? in[n - k] : 0;
    }
    return done;
}

bool fft_backward(double *out, fftw_complex *in, size_t n)
{
    return transform((struct once){.record = out, .transform = in, .n = n, .back = true});
}

size_t fft_quick(size_t most, size_t factor)
{
    for (size_t n = most; n > 1; n--) {
        size_t rest = n;
        for (size_t f = 2; f <= factor; f++)
            while (rest % f == 0)
                rest /= f;
        if (rest == 1)
            return n;
    }
    return most;
}
