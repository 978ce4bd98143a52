/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/host.h"

#include <fftw3.h>
#include <gsl/gsl_errno.h>
#include <pthread.h>

static pthread_once_t once = PTHREAD_ONCE_INIT;
static locale_t plain;

/* GSL has one handler for the process: while calls last, in however many threads, it is `handle`. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static unsigned calls;
static gsl_error_handler_t *hosts;
static _Thread_local unsigned depth; /* of calls in this thread */

static void prepare(void)
{
    plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    fftw_make_planner_thread_safe();
}

/** GSL's functions return their error too: in the library's own calls that is enough. */
static void handle(const char *reason, const char *file, int line, int number)
{
    if (depth > 0)
        return;
    pthread_mutex_lock(&lock);
    gsl_error_handler_t *theirs = hosts;
    pthread_mutex_unlock(&lock);
    if (theirs) {
        theirs(reason, file, line, number);
        return;
    }
    gsl_set_error_handler(NULL); /* GSL's own, which ends the program: the host left it so */
    gsl_error(reason, file, line, number);
}

void host_put_aside(struct host *out)
{
    pthread_once(&once, prepare);
    out->locale = uselocale(plain);
    fegetenv(&out->environment);
    fesetenv(FE_DFL_ENV);
    pthread_mutex_lock(&lock);
    if (calls++ == 0) {
        gsl_error_handler_t *before = gsl_set_error_handler(handle);
        hosts = before == handle ? hosts : before;
    }
    pthread_mutex_unlock(&lock);
    depth++;
}

void host_give_back(const struct host *host)
{
    depth--;
    pthread_mutex_lock(&lock);
    if (--calls == 0) {
        gsl_error_handler_t *before = gsl_set_error_handler(hosts);
        if (before != handle) /* set by the host meanwhile */
            gsl_set_error_handler(before);
    }
    pthread_mutex_unlock(&lock);
    fesetenv(&host->environment);
    uselocale(host->locale);
}
