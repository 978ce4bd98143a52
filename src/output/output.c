#include "output/output.h"

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

/** What a report consists of; anything else in OUT is the user's. A name that begins with a dot is an ending. */
static const char *const report_entries[] = {"report.md", "report.html", "results.json", "data", "figures", NULL};
static const char *const data_entries[] = {"surfaces.csv", "spectrum.csv", "contact.csv", "convergence.csv",
                                           "cost.csv",     "spread.csv",   "bands.csv",   NULL};
static const char *const figure_entries[] = {".svg", ".gp", ".csv", NULL};

static bool is_own(const char *name, const char *const *entries)
{
    for (; *entries; entries++) {
        size_t length = strlen(name), own = strlen(*entries);
        if (length >= own && strcmp(name + length - own, *entries) == 0 && (length == own || **entries == '.'))
            return true;
    }
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0 || strcmp(name, ".gitkeep") == 0;
}

/** Refuses a directory that holds anything but `entries`; there may be no such directory. `count` (NULL: not wanted)
 * gets how many of them there are. */
static enum status_code check_entries(const char *path, const char *const *entries, size_t *count,
                                      struct status *status)
{
    DIR *directory = opendir(path);
    if (!directory) {
        if (errno == ENOENT)
            return STATUS_OK;
        return status_fail(status, STATUS_IO, "cannot write the report to '%s': %s", path, strerror(errno));
    }
    enum status_code rc = STATUS_OK;
    for (struct dirent *entry; rc == STATUS_OK && (entry = readdir(directory));) {
        if (!is_own(entry->d_name, entries))
            rc = status_fail(status, STATUS_IO,
                             "'%s' holds '%s', which is not part of a report; choose another directory with -o", path,
                             entry->d_name);
        if (count && entry->d_name[0] != '.')
            ++*count;
    }
    closedir(directory);
    return rc;
}

/** Refuses to replace anything but a report, an empty directory or nothing. */
static enum status_code check_target(const char *target, struct status *status)
{
    char path[PATH_MAX + 16];
    size_t count = 0;
    if (check_entries(target, report_entries, &count, status) != STATUS_OK || count == 0)
        return status->code;
    snprintf(path, sizeof path, "%s/results.json", target);
    if (access(path, F_OK) != 0)
        return status_fail(status, STATUS_IO, "'%s' is not empty and no report; choose another directory with -o",
                           target);
    snprintf(path, sizeof path, "%s/data", target);
    if (check_entries(path, data_entries, NULL, status) != STATUS_OK)
        return status->code;
    snprintf(path, sizeof path, "%s/figures", target);
    return check_entries(path, figure_entries, NULL, status);
}

/** Makes every directory on the way to the target, itself excluded, and notes the first that was missing. */
static enum status_code make_parents(struct output *out, struct status *status)
{
    char part[PATH_MAX];
    snprintf(part, sizeof part, "%s", out->target);
    for (char *slash = strchr(part + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(part, 0777) == 0)
            out->made = out->made ? out->made : strlen(part);
        else if (errno != EEXIST)
            return status_fail(status, STATUS_IO, "cannot make directory '%s': %s", part, strerror(errno));
        *slash = '/';
    }
    return STATUS_OK;
}

/** Stores the path of OUT without slashes at its end; of a link, where it leads. */
static enum status_code set_target(struct output *out, const char *target, struct status *status)
{
    struct stat info;
    size_t length = strlen(target);
    while (length > 1 && target[length - 1] == '/')
        length--;
    if (length + 32 >= sizeof out->target)
        return status_fail(status, STATUS_IO, "the name of the report directory is too long");
    memcpy(out->target, target, length);
    const char *slash = strrchr(out->target, '/'), *name = slash ? slash + 1 : out->target;
    if (*name == '\0' || strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return status_fail(status, STATUS_USAGE, "'%s' is no name for a report's directory; name one, such as ./report",
                           target);
    if (lstat(out->target, &info) == 0 && S_ISLNK(info.st_mode)) {
        char *real = realpath(out->target, NULL);
        if (!real || strlen(real) + 32 >= sizeof out->target) {
            free(real);
            return status_fail(status, STATUS_IO, "'%s' is a link that leads nowhere; remove it", out->target);
        }
        strcpy(out->target, real);
        free(real);
    }
    return STATUS_OK;
}

enum status_code output_begin(struct output *out, const char *target, struct status *status)
{
    *out = (struct output){0};
    if (set_target(out, target, status) != STATUS_OK || check_target(out->target, status) != STATUS_OK ||
        make_parents(out, status) != STATUS_OK)
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
    for (char *slash; out->made && (slash = strrchr(out->target, '/')) && (size_t)(slash - out->target) >= out->made;) {
        *slash = '\0'; /* the parents made for it: those that are empty go */
        if (rmdir(out->target) != 0)
            break;
    }
    out->made = 0;
}
