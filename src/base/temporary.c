/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/temporary.h"
#include "base/clock.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

enum { TRIES = 100, NAME = 128, PAUSE_US = 200 };
static const double end_seconds = 0.3; /* for what is held, and for the removal; the rest is left to the next run */

/* Of the process, as its end is. */
static pthread_mutex_t lock = PTHREAD_RECURSIVE_MUTEX_INITIALIZER_NP; /* guards what follows */
static struct temporary *all;
static char note[PATH_MAX + 64];
static _Atomic double until = INFINITY; /* when there is no more time to remove anything */

static int open_directory(int parent, const char *name)
{
    return openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/** What its lock is called. Where it lies on no disk of this machine, others may use it whose locks are not seen here:
 * there the name holds this start of the system too or, where that is not told, this process. */
static void name_lock(char out[static NAME], int directory)
{
    struct stat info = {0};
    char boot[40] = "";
    (void)!fstat(directory, &info);
    if (major(info.st_dev) == 0) {
        int file = open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC);
        if (file < 0 || read(file, boot, 36) != 36)
            snprintf(boot, sizeof boot, "%ld", (long)getpid());
        if (file >= 0)
            close(file);
    }
    snprintf(out, NAME, "lock-%jx-%jx-%s", (uintmax_t)info.st_ino, (uintmax_t)info.st_dev, boot);
}

/** Locks a new directory, perhaps on a file system without locks, or one whose process is no more. Returns the lock's
 * descriptor; -1: it is another's, or has none. */
static int take(int directory, bool new)
{
    char name[NAME];
    struct stat info;
    name_lock(name, directory);
    int own =
        openat(directory, name, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | (new ? O_CREAT | O_EXCL : 0), 0600);
    if (own < 0 || ((flock(own, LOCK_EX | LOCK_NB) == 0 || (new &&errno != EWOULDBLOCK)) && fstat(own, &info) == 0 &&
                    info.st_nlink > 0)) /* else another run removed it before it was locked */
        return own;
    close(own);
    errno = EWOULDBLOCK;
    return -1;
}

/** Removes all in it but its lock. */
static void empty(int directory)
{
    char spared[NAME];
    int again = open_directory(directory, ".");
    DIR *list = again >= 0 ? fdopendir(again) : NULL;
    name_lock(spared, directory);
    for (const struct dirent *entry; list && clock_seconds() < until && (entry = readdir(list));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0 && strcmp(entry->d_name, spared) != 0)
            temporary_remove_entry(directory, entry->d_name);
    if (list)
        closedir(list);
}

void temporary_remove_entry(int directory, const char *name)
{
    if (unlinkat(directory, name, 0) == 0)
        return;
    int inner = open_directory(directory, name);
    if (inner >= 0) {
        empty(inner);
        close(inner);
    }
    unlinkat(directory, name, AT_REMOVEDIR);
}

/** Removes the lock, and the directory if that was all. */
static bool remove_frame(int directory, int parent, const char *name)
{
    char own[NAME];
    name_lock(own, directory);
    unlinkat(directory, own, 0);
    return unlinkat(parent, name, AT_REMOVEDIR) == 0;
}

static void clear_stale(int parent, const char *name, void (*clear)(int directory))
{
    struct stat info;
    int directory = open_directory(parent, name), taken = -1;
    if (directory >= 0 && fstat(directory, &info) == 0 && info.st_uid == geteuid() && (info.st_mode & 0777) == 0700) {
        if ((taken = take(directory, false)) >= 0) {
            clear(directory);
            if (!remove_frame(directory, parent, name) && *name == '.') /* somebody's: to be seen */
                (void)!renameat(parent, name, parent, name + 1);
            close(taken);
        } else {
            unlinkat(parent, name, AT_REMOVEDIR); /* killed before it held anything, or after */
        }
    }
    if (directory >= 0)
        close(directory);
}

enum status_code temporary_make(struct temporary *out, const char *parent, void (*clear)(int directory),
                                struct status *status)
{
    static const char letters[] = "XXXXXX";
    const char *named = getenv("TMPDIR"), *prefix = parent ? ".roughcontact-" : "roughcontact-";
    if (!parent)
        parent = named && *named && strlen(named) < PATH_MAX / 2 ? named : P_tmpdir;
    DIR *list = opendir(parent);
    for (const struct dirent *entry; list && (entry = readdir(list));)
        if (strlen(entry->d_name) == strlen(prefix) + strlen(letters) &&
            strncmp(entry->d_name, prefix, strlen(prefix)) == 0)
            clear_stale(dirfd(list), entry->d_name, clear ? clear : empty);
    if (list)
        closedir(list);
    for (int i = 0; i < TRIES; i++) {
        *out = (struct temporary){.directory = -1, .lock = -1};
        snprintf(out->path, sizeof out->path, "%s/%s%s", parent, prefix, letters);
        temporary_hold();
        if (mkdtemp(out->path)) {
            out->directory = open_directory(AT_FDCWD, out->path);
            out->lock = out->directory >= 0 ? take(out->directory, true) : -1;
            out->next = all;
            all = out;
        }
        temporary_release();
        if (out->lock >= 0)
            return STATUS_OK;
        int reason = errno;
        temporary_close(out);
        errno = reason;
        if (reason != EWOULDBLOCK && reason != ENOENT) /* which say that another run took it for a dead one's */
            break;
    }
    return status_fail(status, STATUS_IO, "cannot make a directory in '%s': %s", parent, strerror(errno));
}

void temporary_forget(struct temporary *temporary)
{
    temporary_hold();
    for (struct temporary **one = &all; *one; one = *one ? &(*one)->next : one)
        if (*one == temporary)
            *one = temporary->next;
    temporary_release();
}

void temporary_close(struct temporary *temporary)
{
    temporary_hold();
    if (temporary->directory >= 0) {
        remove_frame(temporary->directory, AT_FDCWD, temporary->path);
        close(temporary->directory);
    }
    if (temporary->lock >= 0)
        close(temporary->lock); /* last: while it is locked nobody else removes it */
    temporary_forget(temporary);
    temporary->path[0] = '\0';
    temporary_release();
}

void temporary_remove(struct temporary *temporary)
{
    empty(temporary->directory);
    temporary_close(temporary);
}

void temporary_note(const char *text)
{
    temporary_hold();
    snprintf(note, sizeof note, "%s", text);
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
        while (clock_seconds() < until && !remove_frame(one->directory, AT_FDCWD, one->path));
    return note;
}
