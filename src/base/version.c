/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/version.h"

const char *version_string(void)
{
    return ROUGHCONTACT_VERSION;
}

#ifdef __clang__
#define COMPILER __VERSION__ /* which names itself */
#else
#define COMPILER "GCC " __VERSION__
#endif

const char *version_build(void)
{
    return COMPILER ", " ROUGHCONTACT_BUILD;
}
