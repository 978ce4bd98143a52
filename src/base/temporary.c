/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/temporary.h"
#include "base/leftover.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static const char prefix[] = "roughcontact-", letters[] = "XXXXXX";
enum { TRIES = 100 };

/** TMPDIR, or where such files go without it. */
static const char *base(void)
{
    const char *named = getenv("TMPDIR");
    return named && *named && strlen(named) < PATH_MAX / 2 ? named : P_tmpdir;
}

/** Locks the open file, which has to be the empty one that is there under this name. */
static bool take(int lock, int directory)
{
    struct stat own, there;
    return fstat(lock, &own) == 0 && S_ISREG(own.st_mode) && own.st_size == 0 && flock(lock, LOCK_EX | LOCK_NB) == 0 &&
           fstatat(directory, "lock", &there, AT_SYMLINK_NOFOLLOW) == 0 && own.st_dev == there.st_dev &&
           own.st_ino == there.st_ino;
}

/** Was it made by a process of this user that is no more? */
static bool is_stale(int parent, const char *name)
{
    struct stat info;
    int directory = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (directory < 0)
        return false;
    int lock = fstat(directory, &info) == 0 && info.st_uid == geteuid() && (info.st_mode & 0777) == 0700
                   ? openat(directory, "lock", O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)
                   : -1;
    bool stale = lock >= 0 && take(lock, directory);
    if (lock >= 0)
        close(lock);
    close(directory);
    return stale;
}

static void clear_stale(void)
{
    DIR *list = opendir(base());
    for (const struct dirent *entry; list && (entry = readdir(list));) {
        char path[PATH_MAX];
        if (strlen(entry->d_name) == strlen(prefix) + strlen(letters) &&
            memcmp(entry->d_name, prefix, strlen(prefix)) == 0 && is_stale(dirfd(list), entry->d_name) &&
            (size_t)snprintf(path, sizeof path, "%s/%s", base(), entry->d_name) < sizeof path)
            leftover_remove(path);
    }
    if (list)
        closedir(list);
}

/** Makes its lock. False: another run took it for what a dead one left, or it cannot be (errno). */
static bool claim(struct temporary *made)
{
    int directory = open(made->path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (directory < 0)
        return false;
    made->lock = openat(directory, "lock", O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    bool own = made->lock >= 0 && take(made->lock, directory);
    int error = errno;
    close(directory);
    errno = error;
    return own;
}

enum status_code temporary_make(struct temporary *out, struct status *status)
{
    clear_stale();
    for (int i = 0; i < TRIES; i++) {
        *out = (struct temporary){.lock = -1};
        snprintf(out->path, sizeof out->path, "%s/%s%s", base(), prefix, letters);
        if (!leftover_make(out->path, &out->number))
            break;
        if (claim(out))
            return STATUS_OK;
        int error = errno;
        temporary_remove(out);
        errno = error;
        if (error != EWOULDBLOCK && error != ENOENT)
            break;
    }
    return status_fail(status, STATUS_IO, "cannot make a directory in '%s': %s", base(), strerror(errno));
}

void temporary_remove(struct temporary *temporary)
{
    leftover_remove(temporary->path);
    leftover_forget(temporary->number);
    if (temporary->lock >= 0)
        close(temporary->lock); /* last: while it is locked nobody else removes it */
}
