/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program's version, as the build system has it. */
#ifndef BASE_VERSION_H
#define BASE_VERSION_H

const char *version_string(void);

/** Compiler and kind of build: "GCC 12.2.0, Release". */
const char *version_build(void);

#endif
