/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which format a file has, also of those that are not read, and reading a file that is not packed. */
#ifndef SCAN_FORMAT_H
#define SCAN_FORMAT_H

#include "scan/reader.h"

enum format_kind {
    FORMAT_UNKNOWN, /* empty, or binary of no known format */
    FORMAT_SCAN,    /* a reader knows its bytes, or it is text that may be a scan */
    FORMAT_PACKED,  /* "zip", an archive that may hold scans, or "gz" */
    FORMAT_FOREIGN, /* a measurement in a format that is not read */
    FORMAT_OTHER    /* certainly no scan: pictures, documents, programs */
};

struct format {
    const char *name; /* as printed */
    enum format_kind kind;
    scan_reading *read;
    scan_sniffer *sniff;         /* where the first bytes alone do not tell; or NULL, and: */
    const char *magic;           /* the first bytes, their case ignored if the format is read; NULL: any */
    size_t magic_length, offset; /* how many, and where they are */
    const char *endings;         /* ".a .b", of the file's name; NULL: any */
    const char *entry;           /* name of an entry, if it is a zip archive; else NULL */
    const char *remedy;          /* how to get a scan out of a format that is not read; NULL: the usual one */
};

/** Every format. The first that fits counts. */
extern const struct format format_rows[];
extern const size_t format_count;

/** The format of the file, by its bytes (`whole`: all of them, else the first) and its name. */
struct format format_of(const struct scan_file *file, bool whole);

/** Reads a file that is not packed, or what a packed one holds. */
MUST_CHECK enum status_code format_read(struct scan *out, const struct scan_file *file);

/** STATUS_SCAN: the file is of a format that is not read; how to get a scan out of it. */
enum status_code format_refuse(const struct scan_file *file, const struct format *format);

/** Reads a zip archive of scans, a scan packed by gzip, or a file that is not packed. */
MUST_CHECK enum status_code scan_packed_read(struct scan *out, const struct scan_file *file);

#endif
