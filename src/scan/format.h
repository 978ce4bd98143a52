/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the bytes of a file are, those that no reader reads among them, and reading any that is not packed. */
#ifndef SCAN_FORMAT_H
#define SCAN_FORMAT_H

#include "scan/reader.h"

enum format_kind {
    FORMAT_UNKNOWN, /* empty, or binary of no known format */
    FORMAT_SCAN,    /* a reader knows its bytes, or a text that may be a scan */
    FORMAT_PACKED,  /* "zip", an archive that may hold scans, or "gz" */
    FORMAT_FOREIGN, /* a measurement in a format that is not read */
    FORMAT_OTHER    /* certainly no scan: pictures, documents, programs */
};

struct format {
    const char *name; /* of one that is not read: to follow "is a" */
    enum format_kind kind;
    scan_reading *read;
    scan_sniffer *sniff; /* where its first bytes alone do not tell; or NULL, and: */
    const char *magic;   /* its first bytes, of one that is read their case ignored; NULL: only the ending says so */
    size_t magic_length, offset; /* how many, and where they are */
    const char *endings;         /* ".a .b": one of these has to end its name; NULL: any name */
    const char *entry;           /* of a zip archive: the name of an entry; NULL: no archive */
    const char *remedy;          /* how to get a scan out of one that is not read; NULL: the usual one */
};

/** Every format. The first that fits counts: those that look like others stand before them. */
extern const struct format format_rows[];
extern const size_t format_count;

/** What these bytes, all of the file (`whole`) or its first, are by themselves and by its name. */
struct format format_of(const struct scan_file *file, bool whole);

/** Reads a file, or what was within a packed one; packed it may not be. */
MUST_CHECK enum status_code format_read(struct scan *out, const struct scan_file *file);

/** STATUS_SCAN: what the file is, and how to get a scan out of it. */
enum status_code format_refuse(const struct scan_file *file, const struct format *format);

/** Reads a zip archive with scans of any other format in it, one scan packed by gzip, or a file as it is. */
MUST_CHECK enum status_code scan_packed_read(struct scan *out, const struct scan_file *file);

#endif
