#include "results/output.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** What a report consists of; anything else in OUT is the user's. */
static const char *const own_entries[] = {"report.md", "report.html", "results.json", "data", "figures"};

static bool is_own(const char *name)
{
    for (size_t i = 0; i < sizeof own_entries / sizeof own_entries[0]; i++)
        if (strcmp(name, own_entries[i]) == 0)
            return true;
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

/** Refuses to replace a directory that holds anything but a report. */
static enum status_code check_target(const char *target, struct status *status)
{
    DIR *directory = opendir(target);
    if (!directory) {
        if (errno == ENOENT)
            return STATUS_OK;
        return status_fail(status, STATUS_IO, "cannot write the report to '%s': %s", target, strerror(errno));
    }
    enum status_code rc = STATUS_OK;
    for (struct dirent *entry; rc == STATUS_OK && (entry = readdir(directory));)
        if (!is_own(entry->d_name) && strcmp(entry->d_name, ".gitkeep") != 0)
            rc = status_fail(status, STATUS_IO,
                             "'%s' holds '%s', which is not part of a report; choose another "
                             "directory with -o",
                             target, entry->d_name);
    closedir(directory);
    return rc;
}

/** Makes every directory on the way to `path`, itself excluded. */
static enum status_code make_parents(const char *path, struct status *status)
{
    char part[PATH_MAX];
    snprintf(part, sizeof part, "%s", path);
    for (char *slash = strchr(part + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(part, 0777) != 0 && errno != EEXIST)
            return status_fail(status, STATUS_IO, "cannot make directory '%s': %s", part, strerror(errno));
        *slash = '/';
    }
    return STATUS_OK;
}

enum status_code output_begin(struct output *out, const char *target, struct status *status)
{
    *out = (struct output){0};
    size_t length = strlen(target);
    while (length > 1 && target[length - 1] == '/')
        length--;
    if (length + 32 >= sizeof out->target)
        return status_fail(status, STATUS_IO, "the name of the report directory is too long");
    memcpy(out->target, target, length);
    if (check_target(out->target, status) != STATUS_OK || make_parents(out->target, status) != STATUS_OK)
        return status->code;

    char *slash = strrchr(out->target, '/');
    size_t parent = slash ? (size_t)(slash - out->target) + 1 : 0;
    char name[PATH_MAX + 32], part[PATH_MAX + 40];
    snprintf(name, sizeof name, "%.*s.roughcontact-XXXXXX", (int)parent, out->target);
    if (!mkdtemp(name))
        return status_fail(status, STATUS_IO, "cannot write beside '%s': %s", out->target, strerror(errno));
    snprintf(out->staging, sizeof out->staging, "%.*s", PATH_MAX - 1, name);
    mode_t mask = umask(0);
    umask(mask);
    if (chmod(name, 0777 & ~mask) != 0)
        return status_fail(status, STATUS_IO, "cannot set up '%s': %s", name, strerror(errno));
    static const char *const parts[] = {"data", "figures"};
    for (int i = 0; i < 2; i++) {
        snprintf(part, sizeof part, "%s/%s", name, parts[i]);
        if (mkdir(part, 0777) != 0)
            return status_fail(status, STATUS_IO, "cannot make '%s': %s", part, strerror(errno));
    }
    return STATUS_OK;
}

static int remove_entry(const char *path, const struct stat *info, int type, struct FTW *level)
{
    (void)info;
    (void)type;
    (void)level;
    return remove(path);
}

static void remove_tree(const char *path)
{
    nftw(path, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

enum status_code output_commit(struct output *out, struct status *status)
{
    /* exchange in one step where there is something to exchange with; the old report is then in `staging` */
    if (renameat2(AT_FDCWD, out->staging, AT_FDCWD, out->target, RENAME_EXCHANGE) == 0) {
        remove_tree(out->staging);
        out->staging[0] = '\0';
        return STATUS_OK;
    }
    if (errno == EINVAL) { /* a file system that cannot exchange: clear the way, then rename */
        char old[PATH_MAX + 8];
        snprintf(old, sizeof old, "%s.old", out->staging);
        if (rename(out->target, old) == 0) {
            if (rename(out->staging, out->target) != 0) {
                int reason = errno;
                if (rename(old, out->target) != 0)
                    return status_fail(status, STATUS_IO,
                                       "cannot put the report at '%s' (%s); the one before is in '%s'", out->target,
                                       strerror(reason), old);
                return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target,
                                   strerror(reason));
            }
            remove_tree(old);
            out->staging[0] = '\0';
            return STATUS_OK;
        }
    }
    if (rename(out->staging, out->target) != 0)
        return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target, strerror(errno));
    out->staging[0] = '\0';
    return STATUS_OK;
}

void output_abandon(struct output *out)
{
    if (out->staging[0])
        remove_tree(out->staging);
    out->staging[0] = '\0';
}
