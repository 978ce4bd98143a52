/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/staging.h"

#include "base/leftover.h"
#include "output/manifest.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/magic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

static const char prefix[] = ".roughcontact-", letters[] = "XXXXXX", word[] = "roughcontact";
static const char *const folders[] = {"", "data", "figures"};
enum { BOOT = 64, FOLDERS = 3, TRIES = 100 };

static int open_directory(int at, const char *path)
{
    return openat(at, path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

static bool same_file(const struct stat *a, const struct stat *b)
{
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/** What tells this start of the system from others of it and of other machines; "-": it cannot be known. */
static void read_boot(char out[static BOOT])
{
    int file = open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC);
    ssize_t length = file >= 0 ? read(file, out, BOOT - 1) : -1;
    if (file >= 0)
        close(file);
    out[length > 0 ? length : 0] = '\0';
    out[strcspn(out, " \n")] = '\0';
    if (!*out)
        strcpy(out, "-");
}

/** The directory that `target` lies in. */
static void parent_of(char out[static PATH_MAX], const char *target)
{
    const char *slash = strrchr(target, '/');
    snprintf(out, PATH_MAX, "%.*s", slash ? (int)(slash - target) + 1 : 1, slash ? target : ".");
}

void staging_part(char out[static PATH_MAX], const struct staging *staging, const char *name)
{
    snprintf(out, PATH_MAX, "%.*s/%s", PATH_MAX - 16, staging->path, name);
}

/** Takes the lock of the directory just made, before it says what it is. Another run may take it for what a dead one
 * left and have removed it: false then. On a file system without locks or links it says nothing and is never cleared
 * away by others. */
static bool claim(struct staging *staging, int directory, const char *name)
{
    char boot[BOOT], text[BOOT + NAME_MAX + 32];
    struct stat locked, there;
    staging->lock = openat(directory, "lock", O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (staging->lock < 0)
        return errno != ENOENT;
    if (flock(staging->lock, LOCK_EX | LOCK_NB) != 0)
        return errno != EWOULDBLOCK;
    if (fstat(staging->lock, &locked) != 0 || fstatat(directory, "lock", &there, AT_SYMLINK_NOFOLLOW) != 0 ||
        !same_file(&locked, &there))
        return false;
    read_boot(boot);
    snprintf(text, sizeof text, "%s %s %s", word, boot, name);
    (void)!symlinkat(text, directory, "run");
    return true;
}

/** Makes `aside`, if it is not there. False: errno. */
static bool make_aside(const char *staging)
{
    for (int i = 0; i < FOLDERS; i++) {
        char folder[PATH_MAX + 32];
        snprintf(folder, sizeof folder, "%s/aside/%s", staging, folders[i]);
        if (mkdir(folder, 0700) != 0 && errno != EEXIST)
            return false;
    }
    return true;
}

enum status_code staging_make(struct staging *out, const char *target, struct status *status)
{
    const char *slash = strrchr(target, '/'), *name = slash ? slash + 1 : target;
    char made[PATH_MAX + 32];
    *out = (struct staging){.lock = -1};
    for (int i = 0; i < TRIES; i++) {
        snprintf(made, sizeof made, "%.*s%s%s", (int)(name - target), target, prefix, letters);
        if (!mkdtemp(made))
            break;
        snprintf(out->path, sizeof out->path, "%.*s", PATH_MAX - 1, made);
        int directory = open_directory(AT_FDCWD, made);
        bool own = directory >= 0 && claim(out, directory, name);
        if (directory >= 0)
            close(directory);
        if (own && make_aside(out->path)) /* now: the disk may be full in the end */
            return STATUS_OK;
        int reason = errno;
        staging_remove(out, false);
        errno = reason;
        if (own)
            break;
    }
    out->path[0] = '\0';
    return status_fail(status, STATUS_IO, "cannot write beside '%s': %s", target, strerror(errno));
}

/** Takes apart what is not a report's, in an order that staging_clear_stale() understands at any instant. */
static bool remove_frame(int directory, int parent, const char *name)
{
    for (int i = FOLDERS - 1; i >= 0; i--) {
        char path[32];
        snprintf(path, sizeof path, "aside/%s", folders[i]);
        unlinkat(directory, path, AT_REMOVEDIR);
    }
    DIR *open = fdopendir(openat(directory, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    bool empty = open != NULL;
    for (const struct dirent *entry; open && (entry = readdir(open));)
        empty = empty && (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0 ||
                          strcmp(entry->d_name, "run") == 0 || strcmp(entry->d_name, "lock") == 0);
    if (open)
        closedir(open);
    if (!empty)
        return false;
    unlinkat(directory, "run", 0);
    unlinkat(directory, "lock", 0);
    return unlinkat(parent, name, AT_REMOVEDIR) == 0;
}

void staging_leave(struct staging *staging)
{
    if (staging->path[0] && staging->lock >= 0) /* else it was never made */
        close(staging->lock);
    *staging = (struct staging){.lock = -1};
}

void staging_remove(struct staging *staging, bool whole)
{
    if (whole && staging->path[0])
        leftover_remove(staging->path);
    int directory = staging->path[0] ? open_directory(AT_FDCWD, staging->path) : -1;
    if (directory >= 0) {
        remove_frame(directory, AT_FDCWD, staging->path);
        close(directory);
    }
    staging_leave(staging);
}

/** The report before, the new one, and where an entry of the former is looked at, where nobody replaces it meanwhile.
 */
struct clearing {
    int old, new, aside;
    const struct text *manifest;
};

/** Removes an entry of the report before when it is the program's or the new report holds it too; else (it came during
 * the exchange) moves it there, in the place of nothing. False when it had to stay aside. */
static bool clear_aside(const struct clearing *c, const char *name)
{
    struct stat before, after;
    if (fstatat(c->aside, name, &before, AT_SYMLINK_NOFOLLOW) != 0)
        return true;
    if (S_ISDIR(before.st_mode))
        return renameat(c->aside, name, c->new, name) == 0 || renameat(c->aside, name, c->old, name) == 0;
    if ((manifest_lists(c->manifest, name) && S_ISREG(before.st_mode)) ||
        linkat(c->aside, name, c->new, name, 0) == 0 ||
        (fstatat(c->new, name, &after, AT_SYMLINK_NOFOLLOW) == 0 && same_file(&before, &after)) ||
        linkat(c->aside, name, c->old, name, 0) == 0)
        return unlinkat(c->aside, name, 0) == 0;
    return false;
}

/** Clears all entries of the report before, its manifest last: killed halfway, the next run still has it. `aside`:
 * those that a killed run was looking at. False: one is stuck. */
static bool clear_entries(const struct clearing *c, const char *path, bool aside, struct status *status)
{
    struct manifest_entries entries;
    bool ok = manifest_entries(&entries, path, status) == STATUS_OK;
    for (size_t i = 0; i < 2 * entries.count && ok; i++) {
        const char *name = entries.names[i % entries.count];
        if ((strcmp(name, MANIFEST_NAME) == 0) == (i >= entries.count) &&
            (aside || renameat(c->old, name, c->aside, name) == 0))
            ok = clear_aside(c, name);
    }
    manifest_entries_free(&entries);
    return ok;
}

/** The manifest of the report before, which may itself be aside. */
static bool read_manifest(struct text *out, const char *path, const char *aside)
{
    struct status status = {0};
    return manifest_read(out, path, &status) == STATUS_OK &&
           (out->length > 0 || manifest_read(out, aside, &status) == STATUS_OK);
}

bool staging_clear_before(const char *staging, const char *part, const char *target)
{
    enum { PASSES = 3 }; /* a file may come between the list and the end of its directory */
    struct status status = {0};
    struct text manifest = {0};
    char path[PATH_MAX], aside[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", staging, part);
    snprintf(aside, sizeof aside, "%s/aside", staging);
    (void)make_aside(staging);
    struct clearing c = {open_directory(AT_FDCWD, path), open_directory(AT_FDCWD, target),
                         open_directory(AT_FDCWD, aside), &manifest};
    bool gone = false;
    if (c.old >= 0 && c.aside >= 0 && read_manifest(&manifest, path, aside)) {
        bool free = clear_entries(&c, aside, true, &status);
        for (int pass = 0; pass < PASSES && !gone && free; pass++) {
            free = clear_entries(&c, path, false, &status);
            for (int i = 1; i < FOLDERS; i++)
                unlinkat(c.old, folders[i], AT_REMOVEDIR);
            gone = free && rmdir(path) == 0;
        }
    }
    text_free(&manifest);
    const int opened[] = {c.old, c.new, c.aside};
    for (int i = 0; i < 3; i++)
        if (opened[i] >= 0)
            close(opened[i]);
    return gone;
}

/** Does the kernel of this machine know of all who use the file system? */
static bool is_local(int directory)
{
    static const long local[] = {EXT4_SUPER_MAGIC,      XFS_SUPER_MAGIC,  BTRFS_SUPER_MAGIC, TMPFS_MAGIC,
                                 OVERLAYFS_SUPER_MAGIC, F2FS_SUPER_MAGIC, 0x2fc12fc1 /* ZFS */};
    struct statfs info;
    for (size_t i = 0; fstatfs(directory, &info) == 0 && i < sizeof local / sizeof *local; i++)
        if ((unsigned long)info.f_type == (unsigned long)local[i])
            return true;
    return false;
}

/** Reads the link `run`: the name of OUT, in `out`. False: it is not the program's, or may live on another machine. */
static bool read_run(char out[static PATH_MAX], int directory)
{
    char boot[BOOT], text[PATH_MAX];
    ssize_t length = readlinkat(directory, "run", text, sizeof text - 1);
    if (length < 0)
        return false;
    text[length] = '\0';
    char *start = strchr(text, ' '), *name = start ? strchr(start + 1, ' ') : NULL;
    if (!name || (size_t)(start - text) != strlen(word) || memcmp(text, word, strlen(word)) != 0)
        return false;
    *name++ = '\0';
    read_boot(boot);
    if (!*name || strchr(name, '/') || strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return false;
    strcpy(out, name);
    return is_local(directory) || (strcmp(boot, "-") != 0 && strcmp(boot, start + 1) == 0);
}

/** Locks it, unless its process lives. Returns the lock's descriptor; -1. */
static int take_lock(int directory)
{
    struct stat info, there;
    int lock = openat(directory, "lock", O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (lock < 0)
        return -1;
    if (fstat(lock, &info) == 0 && S_ISREG(info.st_mode) && info.st_size == 0 && flock(lock, LOCK_EX | LOCK_NB) == 0 &&
        fstatat(directory, "lock", &there, AT_SYMLINK_NOFOLLOW) == 0 && same_file(&info, &there))
        return lock;
    close(lock);
    return -1;
}

/** Removes the files of a report that did not come to its end: in its folders, files, and links of others' in OUT. */
static void clear_unfinished(int directory, const char *staging)
{
    struct status status = {0};
    struct manifest_entries entries;
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/report", staging);
    int report = open_directory(directory, "report");
    if (report >= 0 && manifest_entries(&entries, path, &status) == STATUS_OK) {
        for (size_t i = 0; i < entries.count; i++) {
            struct stat info;
            if (fstatat(report, entries.names[i], &info, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISDIR(info.st_mode) &&
                (S_ISREG(info.st_mode) || info.st_nlink > 1))
                unlinkat(report, entries.names[i], 0);
        }
        manifest_entries_free(&entries);
        for (int i = 1; i < FOLDERS; i++)
            unlinkat(report, folders[i], AT_REMOVEDIR);
        unlinkat(directory, "report", AT_REMOVEDIR);
    }
    if (report >= 0)
        close(report);
}

/** Clears away what the killed run has left in it: as far as that came. */
static void clear_parts(int directory, int parent, const char *name)
{
    char staging[64], target[PATH_MAX + 64];
    snprintf(staging, sizeof staging, "/proc/self/fd/%d", directory); /* whatever is put in its place meanwhile */
    snprintf(target, sizeof target, "/proc/self/fd/%d/%s", parent, name);
    if (faccessat(directory, "before", F_OK, AT_SYMLINK_NOFOLLOW) == 0 &&
        (faccessat(parent, name, F_OK, AT_SYMLINK_NOFOLLOW) == 0 ||
         renameat(directory, "before", parent, name) != 0)) /* killed between two renames: it comes back */
        staging_clear_before(staging, "before", target);
    if (faccessat(directory, "done", F_OK, AT_SYMLINK_NOFOLLOW) == 0)
        staging_clear_before(staging, "done", target);
    clear_unfinished(directory, staging);
}

static void clear_one(int parent, const char *name)
{
    char target[PATH_MAX];
    struct stat info;
    int directory = open_directory(parent, name);
    if (directory < 0)
        return;
    if (fstat(directory, &info) == 0 && info.st_uid == geteuid() &&
        (info.st_mode & 07777 & ~(mode_t)S_ISGID) == 0700) /* which it has of the one around it */ {
        bool begun = faccessat(directory, "run", F_OK, AT_SYMLINK_NOFOLLOW) == 0;
        int lock = take_lock(directory);
        if (lock >= 0 && begun && read_run(target, directory)) {
            clear_parts(directory, parent, target);
            remove_frame(directory, parent, name);
        } else if (lock >= 0 && !begun && is_local(directory)) { /* killed before it held anything, or after */
            remove_frame(directory, parent, name);
        } else if (lock < 0 && !begun) {
            unlinkat(parent, name, AT_REMOVEDIR); /* of nothing at all */
        }
        if (lock >= 0)
            close(lock);
    }
    close(directory);
}

void staging_clear_stale(const char *target)
{
    char path[PATH_MAX];
    parent_of(path, target);
    int parent = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = parent >= 0 ? fdopendir(openat(parent, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)) : NULL;
    for (const struct dirent *entry; list && (entry = readdir(list));)
        if (strlen(entry->d_name) == strlen(prefix) + strlen(letters) &&
            memcmp(entry->d_name, prefix, strlen(prefix)) == 0)
            clear_one(parent, entry->d_name);
    if (list)
        closedir(list);
    if (parent >= 0)
        close(parent);
}
