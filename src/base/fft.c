/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include <pthread.h>

enum {
    SMALL = 1 << 15, /* records up to it go as complex numbers: FFTW plans those in a tenth of the instructions */
    KEPT = 16        /* plans of small sizes; a folder of scans has a few */
};

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER; /* of `kept` too */
static struct {
    size_t n;
    int sign;
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

struct once {
    double *record; /* NULL: from one transform to the other */
    fftw_complex *transform, *out;
    size_t n;
    int sign;
    bool kept;
    fftw_plan plan;
};

static void make_plan(void *context)
{
    struct once *once = context;
    int n = (int)once->n;
    once->plan = !once->record ? fftw_plan_dft_1d(n, once->transform, once->out, once->sign, FFTW_ESTIMATE)
                 : once->sign == FFTW_BACKWARD ? fftw_plan_dft_c2r_1d(n, once->transform, once->record, FFTW_ESTIMATE)
                                               : fftw_plan_dft_r2c_1d(n, once->record, once->transform, FFTW_ESTIMATE);
}

static void find_plan(void *context)
{
    struct once *once = context;
    size_t k = 0;
    while (k < KEPT && kept[k].plan && (kept[k].n != once->n || kept[k].sign != once->sign))
        k++;
    once->kept = k < KEPT;
    once->plan = once->kept ? kept[k].plan : NULL;
    if (!once->plan)
        make_plan(once);
    if (once->kept)
        kept[k].n = once->n, kept[k].sign = once->sign, kept[k].plan = once->plan;
}

static bool transform(struct once once)
{
    fft_plan(once.record ? make_plan : find_plan, &once);
    if (once.plan && once.record)
        fftw_execute(once.plan);
    else if (once.plan)
        fftw_execute_dft(once.plan, once.transform, once.out);
    if (!once.kept)
        fft_plan_free(once.plan);
    return once.plan;
}

/* A small record, as complex heights with all harmonics. */
static bool transform_small(double *record, fftw_complex *transformed, size_t n, int sign)
{
    size_t apart = (n + 3) / 4 * 4; /* both places aligned alike */
    bool back = sign == FFTW_BACKWARD;
    fftw_complex *in = fftw_alloc_complex(2 * apart), *out = in + apart;
    for (size_t j = 0; in && j < n; j++) {
        size_t k = j <= n / 2 ? j : n - j;
        bool real = !back || j == 0 || 2 * j == n;
        in[j][0] = back ? transformed[k][0] : record[j];
        in[j][1] = real ? 0 : j == k ? transformed[k][1] : -transformed[k][1];
    }
    bool done = in && transform((struct once){.transform = in, .out = out, .n = n, .sign = sign});
    for (size_t j = 0; done && back && j < n; j++)
        record[j] = out[j][0];
    for (size_t k = 0; done && !back && k <= n / 2; k++) {
        transformed[k][0] = out[k][0];
        transformed[k][1] = k > 0 && 2 * k < n ? out[k][1] : 0;
    }
    fftw_free(in);
    return done;
}

bool fft_forward(fftw_complex *out, double *in, size_t n)
{
    return n > SMALL ? transform((struct once){.record = in, .transform = out, .n = n, .sign = FFTW_FORWARD})
                     : transform_small(in, out, n, FFTW_FORWARD);
}

bool fft_backward(double *out, fftw_complex *in, size_t n)
{
    return n > SMALL ? transform((struct once){.record = out, .transform = in, .n = n, .sign = FFTW_BACKWARD})
                     : transform_small(out, in, n, FFTW_BACKWARD);
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
