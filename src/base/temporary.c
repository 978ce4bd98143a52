/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/temporary.h"
#include "base/clock.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum { NAME = 192, LETTERS = 6, PAUSE_US = 200 };
static const double end_seconds = 0.3; /* of waiting, and of removal; the rest is left to the next run */

/* Of the process, as its end is. */
static pthread_mutex_t lock = PTHREAD_RECURSIVE_MUTEX_INITIALIZER_NP; /* guards what follows */
static struct temporary *all;
static char note[PATH_MAX + 64];
static _Atomic double until = INFINITY; /* when there is no more time to remove anything */

int temporary_open(int parent, const char *name)
{
    return openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/** The name that says where this directory was made; it ends as its name so far. With the host, since locks are not
 * seen from other machines on every file system. */
static void name_of(char out[static NAME], const char *prefix, int directory, const char *so_far)
{
    struct stat info = {0};
    char host[HOST_NAME_MAX + 1] = "";
    (void)!fstat(directory, &info);
    (void)!gethostname(host, sizeof host - 1);
    snprintf(out, NAME, "%s%jx-%jx-%s-%s", prefix, (uintmax_t)info.st_ino, (uintmax_t)info.st_dev, host,
             so_far + strlen(so_far) - LETTERS);
}

static void empty(int directory)
{
    int again = temporary_open(directory, ".");
    DIR *list = again >= 0 ? fdopendir(again) : NULL;
    for (const struct dirent *entry; list && clock_seconds() < until && (entry = readdir(list));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            temporary_remove_entry(directory, entry->d_name);
    if (list)
        closedir(list);
}

void temporary_remove_entry(int directory, const char *name)
{
    if (unlinkat(directory, name, 0) == 0)
        return;
    int inner = temporary_open(directory, name);
    if (inner >= 0) {
        empty(inner);
        close(inner);
    }
    unlinkat(directory, name, AT_REMOVEDIR);
}

/** Clears the directory `name` if it is this user's and its process is dead. */
static void clear_stale(int parent, const char *name, const char *prefix, void (*clear)(int directory))
{
    struct stat info;
    char own[NAME];
    int directory = temporary_open(parent, name);
    if (directory < 0)
        return;
    name_of(own, prefix, directory, name);
    if (fstat(directory, &info) == 0 && info.st_uid == geteuid() && (info.st_mode & 0777) == 0700 &&
        strcmp(name, own) == 0 && flock(directory, LOCK_EX | LOCK_NB) == 0 && fstat(directory, &info) == 0 &&
        info.st_nlink > 0) {
        clear(directory);
        if (unlinkat(parent, name, AT_REMOVEDIR) != 0 && *name == '.') /* holds a user's files: show it */
            (void)!renameat(parent, name, parent, name + 1);
    }
    close(directory);
}

/** Makes, locks and names one. False: errno says why not. */
static bool make(struct temporary *out, const char *parent, const char *prefix)
{
    char name[NAME], named[PATH_MAX];
    snprintf(out->path, sizeof out->path, "%s/%sXXXXXX", parent, prefix);
    if (!mkdtemp(out->path) || (out->directory = temporary_open(AT_FDCWD, out->path)) < 0)
        return false;
    name_of(name, prefix, out->directory, out->path);
    snprintf(named, sizeof named, "%s/%s", parent, name);
    (void)!flock(out->directory, LOCK_EX | LOCK_NB); /* not every file system has locks */
    if (rename(out->path, named) != 0)
        return false;
    strcpy(out->path, named);
    return true;
}

enum status_code temporary_make(struct temporary *out, const char *parent, void (*clear)(int directory),
                                struct status *status)
{
    const char *named = getenv("TMPDIR"), *prefix = parent ? ".roughcontact-" : "roughcontact-";
    if (!parent)
        parent = named && *named && strlen(named) < PATH_MAX / 2 ? named : P_tmpdir;
    DIR *list = opendir(parent);
    for (const struct dirent *entry; list && (entry = readdir(list));)
        if (strncmp(entry->d_name, prefix, strlen(prefix)) == 0)
            clear_stale(dirfd(list), entry->d_name, prefix, clear ? clear : empty);
    if (list)
        closedir(list);
    *out = (struct temporary){.directory = -1};
    temporary_hold();
    bool made = make(out, parent, prefix);
    int reason = errno;
    out->next = all;
    all = out;
    temporary_release();
    if (made)
        return STATUS_OK;
    temporary_close(out);
    (void)status_fail(status, STATUS_IO, "cannot make a directory in '%s': %s", parent, strerror(reason));
    errno = reason;
    return STATUS_IO;
}

void temporary_close(struct temporary *temporary)
{
    temporary_hold();
    rmdir(temporary->path);
    if (temporary->directory >= 0)
        close(temporary->directory); /* last: while it is locked nobody else removes it */
    struct temporary **one = &all;
    while (*one != temporary)
        one = &(*one)->next;
    *one = temporary->next;
    *temporary = (struct temporary){.directory = -1};
    temporary_release();
}

void temporary_remove(struct temporary *temporary)
{
    empty(temporary->directory);
    temporary_close(temporary);
}

void temporary_note(const char *before, const char *what, const char *after)
{
    temporary_hold();
    snprintf(note, sizeof note, "%s'%s'%s", before, what, after);
    temporary_release();
}

void temporary_hold(void)
{
    pthread_mutex_lock(&lock);
}

void temporary_release(void)
{
    pthread_mutex_unlock(&lock);
}

const char *temporary_end(void)
{
    double most = clock_seconds() + end_seconds;
    while (pthread_mutex_trylock(&lock) != 0) {
        if (clock_seconds() > most)
            return note;
        usleep(PAUSE_US);
    }
    until = clock_seconds() + end_seconds;
    for (const struct temporary *one = all; one; one = one->next)
        do /* again where a file came meanwhile */
            empty(one->directory);
        while (clock_seconds() < until && rmdir(one->path) != 0);
    return note;
}
