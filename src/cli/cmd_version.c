/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `--version` says: the program, and the libraries that it computes with here, whatever it was built with. */
#include "base/program.h"
#include "base/version.h"
#include "cli/command.h"

#include <dlfcn.h>
#include <expat.h>
#include <fftw3.h>
#include <gnu/libc-version.h>
#include <gsl/gsl_version.h>
#include <jansson.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>
#include <zip.h>
#include <zlib.h>

/** Of one that does not: the file that `symbol` is in, by its own name behind its links: libmd4c.so.0.4.8. */
static void add_file(struct text *out, const char *name, const char *symbol)
{
    Dl_info info;
    char path[PATH_MAX];
    const char *slash;
    void *address = dlsym(RTLD_DEFAULT, symbol);
    text_add(out, "%s ", name);
    if (!address || dladdr(address, &info) == 0 || !realpath(info.dli_fname, path) || !(slash = strrchr(path, '/')))
        text_add(out, "version not known");
    else
        text_add_shown(out, slash + 1);
    text_add(out, "\n");
}

/** Of a library that says its version, as "fftw-3.3.10" or "expat_2.5.0" does. */
static void add_number(struct text *out, const char *name, const char *version)
{
    text_add(out, "%s ", name);
    text_add_shown(out, version + strcspn(version, "0123456789"));
    text_add(out, "\n");
}

void command_version(struct text *out)
{
    char gnuplot[PATH_MAX];
    text_add(out, "roughcontact %s\n", version_string());
    text_add(out, "built by %s\n", version_build());
    add_number(out, "FFTW", fftw_version);
    add_number(out, "GSL", gsl_version);
    add_number(out, "libyaml", yaml_get_version_string());
    add_number(out, "jansson", jansson_version_str());
    add_number(out, "expat", XML_ExpatVersion());
    add_number(out, "zlib", zlibVersion());
    add_number(out, "libzip", zip_libzip_version());
    add_file(out, "md4c", "md_parse");
    add_file(out, "libmd", "SHA256Init");
    add_number(out, "glibc", gnu_get_libc_version());
    text_add(out, "gnuplot ");
    text_add_shown(out, program_find(gnuplot, sizeof gnuplot, "gnuplot") ? gnuplot : "not found: a report needs it");
    text_add(out, "\n");
}
