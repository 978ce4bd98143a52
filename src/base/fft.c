/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include <math.h>
#include <pthread.h>
#include <string.h>

enum {
    SMALL = 1 << 14, /* complex numbers whose plans are kept */
    KEPT = 16        /* of them; a folder of scans has a few */
};

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER; /* of `kept` too */
static struct {
    size_t numbers;
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
    *out = (struct fft_room){record, (fftw_complex *)record};
    return record;
}

void fft_room_free(struct fft_room *room)
{
    fftw_free(room->record);
    *room = (struct fft_room){0};
}

struct once {
    fftw_complex *from, *to;
    size_t numbers;
    int sign;
    bool kept;
    fftw_plan plan;
};

static void find_plan(void *context)
{
    struct once *once = context;
    size_t k = once->from == once->to ? KEPT : 0;
    while (k < KEPT && kept[k].plan && (kept[k].numbers != once->numbers || kept[k].sign != once->sign))
        k++;
    once->kept = k < KEPT;
    once->plan = once->kept ? kept[k].plan : NULL;
    if (!once->plan)
        once->plan = fftw_plan_dft_1d((int)once->numbers, once->from, once->to, once->sign, FFTW_ESTIMATE);
    if (once->kept)
        kept[k].numbers = once->numbers, kept[k].sign = once->sign, kept[k].plan = once->plan;
}

/** Transforms complex numbers in their place; a few by way of another, where plans take two thirds as long. */
static bool transform(fftw_complex *place, size_t numbers, int sign)
{
    struct once once = {place, numbers > SMALL ? place : fftw_alloc_complex(numbers), numbers, sign, false, NULL};
    if (once.to)
        fft_plan(find_plan, &once);
    if (once.plan)
        fftw_execute_dft(once.plan, place, once.to);
    if (!once.kept)
        fft_plan_free(once.plan);
    if (once.to != place) {
        if (once.plan)
            memcpy(place, once.to, numbers * sizeof *place);
        fftw_free(once.to);
    }
    return once.plan;
}

/** An odd number of heights, as complex ones with all harmonics. */
static bool transform_odd(double *record, fftw_complex *transformed, size_t n, int sign)
{
    bool back = sign == FFTW_BACKWARD;
    fftw_complex *all = fftw_alloc_complex(n);
    for (size_t j = 0; all && j < n; j++) {
        size_t k = j <= n / 2 ? j : n - j;
        all[j][0] = back ? transformed[k][0] : record[j];
        all[j][1] = !back || j == 0 ? 0 : j == k ? transformed[k][1] : -transformed[k][1];
    }
    bool done = all && transform(all, n, sign);
    for (size_t j = 0; done && back && j < n; j++)
        record[j] = all[j][0];
    for (size_t k = 0; done && !back && k <= n / 2; k++) {
        transformed[k][0] = all[k][0];
        transformed[k][1] = k > 0 ? all[k][1] : 0;
    }
    fftw_free(all);
    return done;
}

/** Harmonics k = 0 ... h of n = 2 h heights from the transform of the complex numbers that hold two of them each, or
 * (`back`) those numbers' transform, times 2, from the harmonics; `in` and `out` may be the same. Z[k] = E + i O is of
 * the even and the odd heights, X[k] = E + exp(-2 pi i k/n) O of all, and those of h - k are the conjugates of the
 * differences (Cooley, Lewis and Welch, J. Sound Vib. 12 (1970) 315). */
static void part(fftw_complex *out, const fftw_complex *in, size_t n, bool back)
{
    const size_t h = n / 2;
    const double first = in[0][0], second = in[back ? h : 0][back ? 0 : 1], share = back ? 1 : 0.5;
    for (size_t k = 1; k <= h / 2; k++) {
        const double angle = 2 * M_PI * (double)k / (double)n, re = -sin(angle), im = back ? cos(angle) : -cos(angle);
        const double sum[2] = {in[k][0] + in[h - k][0], in[k][1] - in[h - k][1]};
        const double difference[2] = {in[k][0] - in[h - k][0], in[k][1] + in[h - k][1]};
        const double turned[2] = {re * difference[0] - im * difference[1], re * difference[1] + im * difference[0]};
        out[k][0] = share * (sum[0] + turned[0]);
        out[k][1] = share * (sum[1] + turned[1]);
        out[h - k][0] = share * (sum[0] - turned[0]);
        out[h - k][1] = share * (turned[1] - sum[1]);
    }
    out[0][0] = first + second;
    out[0][1] = back ? first - second : 0;
    if (back)
        return;
    out[h][0] = first - second;
    out[h][1] = 0;
}

bool fft_forward(fftw_complex *out, double *in, size_t n)
{
    if (n % 2)
        return transform_odd(in, out, n, FFTW_FORWARD);
    bool done = transform((fftw_complex *)in, n / 2, FFTW_FORWARD);
    if (done)
        part(out, (fftw_complex *)in, n, false);
    return done;
}

bool fft_backward(double *out, fftw_complex *in, size_t n)
{
    if (n % 2)
        return transform_odd(out, in, n, FFTW_BACKWARD);
    part((fftw_complex *)out, in, n, true);
    return transform((fftw_complex *)out, n / 2, FFTW_BACKWARD);
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
