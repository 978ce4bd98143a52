/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transforms of every kind of size against their defining sum, back again, and by several threads at once. */
#include "base/fft.h"
#include "support.h"

#include <pthread.h>

static double value(size_t j, size_t n)
{
    return sin(3.7 * (double)j + (double)n) + (j % 5 == 0 ? 0.5 : 0) + 2;
}

/* There and back; what it is on the way is the defining sum, or of `periods` > 0 the one harmonic of that cosine. */
static void check(size_t n, size_t periods)
{
    struct fft_room room;
    assert_true(fft_room_make(&room, n));
    double *record = room.record, *before = support_room(n * sizeof *before);
    fftw_complex *transform = room.transform;
    for (size_t j = 0; j < n; j++)
        record[j] = before[j] = periods ? cos(2 * M_PI * (double)periods * (double)j / (double)n + 0.3) : value(j, n);
    assert_true(fft_forward(transform, record, n));
    for (size_t k = 0; k <= n / 2; k++) {
        double size = periods && k == periods ? (double)n / 2 : 0, real = size * cos(0.3), imaginary = size * sin(0.3);
        for (size_t j = 0; j < n && !periods; j++) {
            double angle = 2 * M_PI * (double)(j * k % n) / (double)n;
            real += before[j] * cos(angle);
            imaginary -= before[j] * sin(angle);
        }
        assert_true(fabs(transform[k][0] - real) < (periods ? 1e-8 : 1e-11 * (double)n));
        assert_true(fabs(transform[k][1] - imaginary) < (periods ? 1e-8 : 1e-11 * (double)n));
        assert_true(transform[k][1] == 0 || (k > 0 && 2 * k != n));
    }
    assert_true(fft_backward(record, transform, n));
    for (size_t j = 0; j < n; j++)
        assert_true(fabs(record[j] / (double)n - before[j]) < 1e-13);
    fft_room_free(&room);
}

/* Odd, even, prime and one. */
TEST_CASE(test_sizes)
{
    for (size_t n = 1; n < 70; n++)
        check(n, 0);
    check(1000, 0);
    check(1009, 0);
}

/* A cosine of 7 periods, about the size from which a record is transformed in its place. */
TEST_CASE(test_large_sizes)
{
    check(32768, 7);
    check(32769, 7);
    check(65536, 7);
    check(65537, 7);
    check(131072, 7);
}

enum { THREADS = 8, ROUNDS = 40, POINTS = 20000, SIZES = 20, APART = 32 };

/** There and back over and over, to `context`, in as many sizes as a set of scans may have. */
static void *transform_often(void *context)
{
    double *sums = context, *record = fftw_alloc_real(POINTS);
    fftw_complex *transform = fftw_alloc_complex(POINTS / 2 + 1);
    for (int round = 0; round < ROUNDS; round++) {
        size_t n = POINTS - APART * (size_t)(round % SIZES);
        for (size_t j = 0; j < POINTS; j++)
            record[j] = value(j, POINTS);
        bool done = fft_forward(transform, record, n);
        sums[round] = transform[5][0] + transform[700][1];
        done = done && fft_backward(record, transform, n);
        sums[round] += done ? record[n - 1] / (double)n : NAN;
    }
    fftw_free(record);
    fftw_free(transform);
    return NULL;
}

TEST_CASE(test_threads_transform_at_once)
{
    double sums[THREADS][ROUNDS];
    pthread_t threads[THREADS];
    for (int t = 0; t < THREADS; t++)
        assert_int_equal(pthread_create(&threads[t], NULL, transform_often, sums[t]), 0);
    for (int t = 0; t < THREADS; t++)
        pthread_join(threads[t], NULL);
    for (int t = 0; t < THREADS; t++)
        for (int round = 0; round < ROUNDS; round++)
            assert_true(sums[t][round] == sums[0][round % SIZES]);
}
