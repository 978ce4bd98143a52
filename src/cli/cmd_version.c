/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `--version` says: the program, and the libraries that it computes with here, whatever it was built with. */
#include "base/program.h"
#include "base/version.h"
#include "cli/command.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/** Where a library has its version. */
enum library_version {
    LIBRARY_FUNCTION, /* const char *symbol(void) */
    LIBRARY_POINTER,  /* const char *symbol */
    LIBRARY_ARRAY,    /* char symbol[] */
    LIBRARY_FILE,     /* nowhere: the file that `symbol` is in tells what it can */
};

static const struct {
    const char *name;
    const char *symbol;
    enum library_version how;
} libraries[] = {
    {"FFTW", "fftw_version", LIBRARY_ARRAY},
    {"GSL", "gsl_version", LIBRARY_POINTER},
    {"libyaml", "yaml_get_version_string", LIBRARY_FUNCTION},
    {"jansson", "jansson_version_str", LIBRARY_FUNCTION},
    {"expat", "XML_ExpatVersion", LIBRARY_FUNCTION},
    {"zlib", "zlibVersion", LIBRARY_FUNCTION},
    {"md4c", "md_parse", LIBRARY_FILE},
    {"libmd", "SHA256Init", LIBRARY_FILE},
    {"glibc", "gnu_get_libc_version", LIBRARY_FUNCTION},
};

/** The file's own name behind its links: libmd4c.so.0.4.8. */
static void add_file(struct text *out, void *address)
{
    Dl_info info;
    char path[PATH_MAX];
    const char *slash;
    if (dladdr(address, &info) == 0 || !realpath(info.dli_fname, path) || !(slash = strrchr(path, '/')))
        text_add(out, "version not known");
    else
        text_add_shown(out, slash + 1);
}

static void add_library(struct text *out, size_t i)
{
    void *address = dlsym(RTLD_DEFAULT, libraries[i].symbol);
    text_add(out, "%s ", libraries[i].name);
    if (!address) {
        text_add(out, "not found\n");
        return;
    }
    const char *version = address;
    const char *(*function)(void);
    if (libraries[i].how == LIBRARY_FUNCTION) {
        memcpy(&function, &address, sizeof function);
        version = function();
    } else if (libraries[i].how == LIBRARY_POINTER)
        memcpy(&version, address, sizeof version);
    if (libraries[i].how == LIBRARY_FILE)
        add_file(out, address);
    else
        text_add_shown(out, version + strcspn(version, "0123456789")); /* "fftw-3.3.10", "expat_2.5.0" */
    text_add(out, "\n");
}

void command_version(struct text *out)
{
    char gnuplot[PATH_MAX];
    text_add(out, "roughcontact %s\n", version_string());
    text_add(out, "built by %s\n", version_build());
    for (size_t i = 0; i < sizeof libraries / sizeof libraries[0]; i++)
        add_library(out, i);
    text_add(out, "gnuplot ");
    text_add_shown(out, program_find(gnuplot, sizeof gnuplot, "gnuplot") ? gnuplot : "not found: a report needs it");
    text_add(out, "\n");
}
