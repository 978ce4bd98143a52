/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/host.h"

#include <gsl/gsl_errno.h>
#include <pthread.h>

static pthread_once_t once = PTHREAD_ONCE_INIT;
static locale_t plain;

/* GSL has one handler for the process: it is off while calls last, in however many threads. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static unsigned calls;
static gsl_error_handler_t *hosts;

static void prepare(void)
{
    plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

void host_put_aside(struct host *out)
{
    pthread_once(&once, prepare);
    out->locale = uselocale(plain);
    fegetenv(&out->environment);
    fesetenv(FE_DFL_ENV);
    pthread_mutex_lock(&lock);
    if (calls++ == 0)
        hosts = gsl_set_error_handler_off();
    pthread_mutex_unlock(&lock);
}

void host_give_back(const struct host *host)
{
    pthread_mutex_lock(&lock);
    if (--calls == 0)
        gsl_set_error_handler(hosts);
    pthread_mutex_unlock(&lock);
    fesetenv(&host->environment);
    uselocale(host->locale);
}
