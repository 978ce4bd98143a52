/* SPDX-License-Identifier: GPL-3.0-or-later */
/* manifest.txt in OUT names the files of the report, one a line; only these are ever replaced or removed. */
#ifndef OUTPUT_MANIFEST_H
#define OUTPUT_MANIFEST_H

#include <stdbool.h>
#include <stddef.h>

#define MANIFEST_NAME "manifest.txt"
/** Its first line, by which it is told from a file of the user's. */
#define MANIFEST_HEADER "# the files of this report by roughcontact, which its next run replaces; no others\n"

/** A report's directories, open: itself, data and figures; -1: none. What fails below leaves errno. */
enum { FOLDERS = 3 };
struct folders {
    int at[FOLDERS];
};
extern const char *const folder_names[FOLDERS];

/** Opens the report `path` in the open directory `parent`, through no link. To be closed whatever comes back. */
bool folders_open(struct folders *out, int parent, const char *path);
void folders_close(const struct folders *folders);
/** Of "data/contact.csv": the descriptor of data, and in *base the rest. */
int folders_in(const struct folders *folders, const char *name, const char **base);

/** Names of files of a report, sorted. */
struct names {
    char **at;
    size_t count;
};

/** Adds all that lies in the folders, but themselves. */
bool names_list(struct names *out, const struct folders *folders);
/** Adds what the manifest there says; nothing when there is none or it is not the program's. */
bool names_read(struct names *out, const struct folders *folders);
bool names_have(const struct names *names, const char *name);
void names_free(struct names *names);

/** Writes the manifest of all that lies in the folders, itself included, and waits until the disk has it all. */
bool manifest_write(const struct folders *folders);

#endif
