/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the program that uses the library may have set for its threads, put aside while a call lasts. */
#ifndef LIBRARY_HOST_H
#define LIBRARY_HOST_H

#include <fenv.h>
#include <locale.h>

struct host {
    locale_t locale;
    fenv_t environment;
};

/** Locale C and round to nearest without traps in this thread, no GSL error handler in any: decimal points stay points,
 * numbers come out to the last bit as they do in the program, and an error of GSL's does not end the host. May be
 * nested. */
void host_put_aside(struct host *out);
/** Gives back what was put aside. */
void host_give_back(const struct host *host);

#endif
