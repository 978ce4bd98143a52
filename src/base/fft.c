/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include <pthread.h>
#include <setjmp.h>

static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER;
static bool ready, left; /* it has all its solvers, and plans may live; it was left at work */
/* Of the call of FFTW under way; of initial-exec, as glibc else may allocate at its first use, and aborts when it
 * cannot. */
static __attribute__((tls_model("initial-exec"))) _Thread_local jmp_buf *way_out;

/** FFTW calls this where malloc() gives it nothing, and wants it not to return. Its own prints a line and aborts; this
 * one stands in its place, as what is linked finds it before FFTW's archive. */
__attribute__((noreturn, visibility("default"))) void fftw_assertion_failed(void)
{
    if (way_out)
        longjmp(*way_out, 1);
    __builtin_trap();
}

bool fft_try(void (*work)(void *context), void *context)
{
    jmp_buf here;
    if (setjmp(here) != 0) {
        way_out = NULL;
        return false;
    }
    way_out = &here;
    work(context);
    way_out = NULL;
    return true;
}

/** Of a planner that was left at work: a table that it forgets may be gone; with a part of its solvers only, it would
 * plan otherwise from here on. */
static void mend(void *unused)
{
    (void)unused;
    if (ready)
        fftw_forget_wisdom();
    else
        fftw_cleanup();
}

bool fft_plan(void (*work)(void *context), void *context)
{
    pthread_mutex_lock(&planner);
    bool done = (!left || fft_try(mend, NULL)) && fft_try(work, context);
    left = !done;
    ready = ready || done;
    pthread_mutex_unlock(&planner);
    return done;
}

static void execute(void *plan)
{
    fftw_execute(plan);
}

bool fft_run(fftw_plan plan)
{
    return fft_try(execute, plan);
}

void fft_plan_free(fftw_plan plan)
{
    pthread_mutex_lock(&planner);
    fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planner);
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

/** One transform, and its plan. */
struct once {
    double *record;
    fftw_complex *transform;
    int n;
    bool back;
    fftw_plan plan;
};

static void make_plan(void *context)
{
    struct once *once = context;
    once->plan = once->back ? fftw_plan_dft_c2r_1d(once->n, once->transform, once->record, FFTW_ESTIMATE)
                            : fftw_plan_dft_r2c_1d(once->n, once->record, once->transform, FFTW_ESTIMATE);
}

static bool transform(struct once once)
{
    bool done = fft_plan(make_plan, &once) && fft_run(once.plan);
    fft_plan_free(once.plan);
    return done;
}

bool fft_forward(fftw_complex *out, double *in, size_t n)
{
    return transform((struct once){in, out, (int)n, false, NULL});
}

bool fft_backward(double *out, fftw_complex *in, size_t n)
{
    return transform((struct once){out, in, (int)n, true, NULL});
}
