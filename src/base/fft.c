/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/fft.h"

#include "base/large.h"
#include <pthread.h>

enum {
    SMALL = 1 << 16, /* records up to it: planning a complex transform takes longer than many such transforms */
    KEPT = 32,       /* plans of small sizes; a set of scans has a few */
    HELD = 3         /* rooms and plans of large ones */
};

/** A transform of a small record: in its place, to or from FFTW's half-complex format (the real parts of harmonics 0
 * ... n/2, then the imaginary ones backwards), or from complex harmonics to another place. */
enum kind { TO_HALF_COMPLEX, FROM_HALF_COMPLEX, FROM_COMPLEX };

static struct kept {
    size_t n;
    enum kind kind;
    size_t users; /* threads that run it now */
    fftw_plan plan;
} kept[KEPT];
static size_t kept_count, kept_next;                        /* the next to make room for another size */
static pthread_mutex_t planner = PTHREAD_MUTEX_INITIALIZER; /* of `kept` too */

static fftw_plan plan_small(size_t n, enum kind kind, double *record, fftw_complex *wave)
{
    if (kind == FROM_COMPLEX)
        return fftw_plan_dft_c2r_1d((int)n, wave, record, FFTW_ESTIMATE);
    fftw_r2r_kind way = kind == TO_HALF_COMPLEX ? FFTW_R2HC : FFTW_HC2R;
    return fftw_plan_r2r_1d((int)n, record, record, way, FFTW_ESTIMATE);
}

/** A place for another plan, with the planner held: a free one, or one that nobody uses; NULL where all are in use. */
static struct kept *find_place(void)
{
    if (kept_count < KEPT)
        return &kept[kept_count++];
    for (size_t i = 0; i < KEPT; i++) {
        struct kept *place = &kept[kept_next++ % KEPT];
        if (place->users == 0) {
            fftw_destroy_plan(place->plan);
            return place;
        }
    }
    return NULL;
}

/** Transforms by the plan kept of this size, which serves any record: all come from fftw_alloc. */
static void run_small(double *record, fftw_complex *wave, size_t n, enum kind kind)
{
    struct kept *found = NULL, own = {.n = n, .kind = kind};
    pthread_mutex_lock(&planner);
    for (size_t i = 0; i < kept_count && !found; i++)
        if (kept[i].n == n && kept[i].kind == kind)
            found = &kept[i];
    if (!found) {
        own.plan = plan_small(n, kind, record, wave);
        found = find_place();
        if (found)
            *found = own;
        else
            found = &own;
    }
    found->users++;
    pthread_mutex_unlock(&planner);
    if (kind == FROM_COMPLEX)
        fftw_execute_dft_c2r(found->plan, wave, record);
    else
        fftw_execute_r2r(found->plan, record, record);
    pthread_mutex_lock(&planner);
    found->users--;
    if (found == &own)
        fftw_destroy_plan(own.plan);
    pthread_mutex_unlock(&planner);
}

/** What is kept of large transforms while someone holds it; the planner's lock guards it. */
static struct {
    size_t holders, most;
    struct fft_room room[HELD];
    fftw_plan plan[HELD]; /* of those done last; NULL: none */
    size_t next;          /* the place of the plan that goes first */
} held;

void fft_hold(size_t most)
{
    pthread_mutex_lock(&planner);
    held.holders++;
    held.most = most > held.most ? most : held.most;
    pthread_mutex_unlock(&planner);
}

void fft_release(void)
{
    pthread_mutex_lock(&planner);
    held.holders--;
    for (size_t i = 0; i < HELD && held.holders == 0; i++) {
        fftw_free(held.room[i].record);
        fftw_free(held.room[i].transform);
        held.room[i] = (struct fft_room){0};
        if (held.plan[i])
            fftw_destroy_plan(held.plan[i]);
        held.plan[i] = NULL;
    }
    if (held.holders == 0)
        held.most = 0;
    pthread_mutex_unlock(&planner);
}

/** The smallest room held that is large enough; none: all zero. */
static struct fft_room take_held(size_t n)
{
    struct fft_room out = {0}, *best = NULL;
    pthread_mutex_lock(&planner);
    for (size_t i = 0; i < HELD; i++)
        if (held.room[i].most >= n && (!best || held.room[i].most < best->most))
            best = &held.room[i];
    if (best) {
        out = *best;
        *best = (struct fft_room){0};
    }
    pthread_mutex_unlock(&planner);
    return out;
}

/** Keeps the room, which is all zero then, where someone holds it and there is a place. */
static void keep_room(struct fft_room *room)
{
    pthread_mutex_lock(&planner);
    for (size_t i = 0; i < HELD && room->most > 0 && room->most <= held.most; i++)
        if (held.room[i].most == 0) {
            held.room[i] = *room;
            *room = (struct fft_room){0};
        }
    pthread_mutex_unlock(&planner);
}

bool fft_room_make(struct fft_room *out, size_t n)
{
    *out = n > SMALL ? take_held(n) : (struct fft_room){0};
    if (out->most > 0)
        return true;
    out->most = n;
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
    if (room->most > SMALL && room->record && room->transform)
        keep_room(room);
    fftw_free(room->record);
    fftw_free(room->transform);
    *room = (struct fft_room){0};
}

/** Runs a plan of a large record of n, and ends it or keeps it. */
static void run(fftw_plan plan, size_t n)
{
    fftw_execute(plan);
    pthread_mutex_lock(&planner);
    if (n <= held.most) {
        fftw_plan oldest = held.plan[held.next];
        held.plan[held.next] = plan;
        held.next = (held.next + 1) % HELD;
        plan = oldest;
    }
    if (plan)
        fftw_destroy_plan(plan);
    pthread_mutex_unlock(&planner);
}

void fft_forward(fftw_complex *out, double *in, size_t n)
{
    if (n <= SMALL) {
        run_small(in, NULL, n, TO_HALF_COMPLEX);
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
    run(plan, n);
}

void fft_backward(double *out, fftw_complex *in, size_t n)
{
    if (n <= SMALL) {
        out[0] = in[0][0];
        for (size_t k = 1; k <= n / 2; k++) {
            out[n - k] = in[k][1];
            out[k] = in[k][0]; /* at n/2 there is no imaginary part */
        }
        run_small(out, NULL, n, FROM_HALF_COMPLEX);
        return;
    }
    pthread_mutex_lock(&planner);
    fftw_plan plan = fftw_plan_dft_c2r_1d((int)n, in, out, FFTW_ESTIMATE);
    pthread_mutex_unlock(&planner);
    run(plan, n);
}

void fft_backward_often(double *out, fftw_complex *in, size_t n)
{
    if (n <= SMALL)
        run_small(out, in, n, FROM_COMPLEX);
    else
        fft_backward(out, in, n);
}
