/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library.h"

#include "base/text.h"
#include <stdlib.h>
#include <string.h>

static const struct roughcontact_scan_options defaults = {.size = sizeof defaults};

void roughcontact_scan_options_init(struct roughcontact_scan_options *options, size_t size)
{
    library_init(options, size, &defaults, sizeof defaults);
}

/** The options as the readers want them. */
static enum status_code take_options(struct scan_options *out, const struct roughcontact_scan_options *given,
                                     struct status *status)
{
    struct roughcontact_scan_options own = defaults;
    if (library_take(&own, sizeof own, given, "roughcontact_scan_options_init", status) != STATUS_OK)
        return status->code;
    const char *const units[2] = {own.x_unit, own.z_unit};
    for (int axis = 0; axis < 2; axis++) {
        const char *unit = units[axis];
        if (unit && *unit && !(scan_unit_m(unit) > 0))
            return status_fail(status, STATUS_USAGE, "%c_unit is '%.60s'; give a unit of length such as mm or um",
                               "xz"[axis], unit);
    }
    *out = (struct scan_options){.x_unit = own.x_unit, .z_unit = own.z_unit, .no_programs = true};
    return STATUS_OK;
}

/** Reads the file at `path`, or with `path` NULL the bytes of `name`. */
static enum status_code read_scan(struct roughcontact_scan **out, const char *path, const struct scan_bytes *given,
                                  const struct roughcontact_scan_options *options, struct status *status)
{
    struct scan_options how;
    struct text copy = {0};
    if (take_options(&how, options, status) != STATUS_OK)
        return status->code;
    struct roughcontact_scan *made = calloc(1, sizeof *made);
    if (!made)
        return status_memory(status);
    if (!path)
        text_add_bytes(&copy, given->bytes, given->length); /* readers want a NUL behind the last byte */
    struct scan_bytes bytes = {text_string(&copy), copy.length, given->path};
    enum status_code code = path          ? scan_read(&made->scan, path, &how, status)
                            : copy.failed ? status_memory(status)
                                          : scan_read_bytes(&made->scan, &bytes, &how, status);
    text_free(&copy);
    if (code != STATUS_OK) {
        roughcontact_scan_free(made);
        return code;
    }
    if (made->scan.next_entry > 0)
        scan_warn(&made->scan, "the archive holds several scans; '%.60s', the first, is read", made->scan.part);
    *out = made;
    return STATUS_OK;
}

int roughcontact_scan_read_file(struct roughcontact_scan **out, const char *path,
                                const struct roughcontact_scan_options *options, struct roughcontact_status *status)
{
    struct host host;
    struct status problem = {0};
    host_put_aside(&host);
    *out = NULL;
    if (!path)
        (void)status_fail(&problem, STATUS_USAGE, "no file is named");
    else
        (void)read_scan(out, path, &(struct scan_bytes){.path = path}, options, &problem);
    return library_end(&host, &problem, status);
}

int roughcontact_scan_read_bytes(struct roughcontact_scan **out, const void *bytes, size_t length, const char *name,
                                 const struct roughcontact_scan_options *options, struct roughcontact_status *status)
{
    struct host host;
    struct status problem = {0};
    const struct scan_bytes given = {bytes, length, name ? name : "scan"};
    host_put_aside(&host);
    *out = NULL;
    if (!bytes && length > 0)
        (void)status_fail(&problem, STATUS_USAGE, "there are no bytes");
    else
        (void)read_scan(out, NULL, &given, options, &problem);
    return library_end(&host, &problem, status);
}

const char *roughcontact_scan_warning(const struct roughcontact_scan *scan, size_t i)
{
    return i < scan->scan.warning_count ? scan->scan.warnings[i] : NULL;
}

void roughcontact_scan_free(struct roughcontact_scan *scan)
{
    if (scan)
        scan_free(&scan->scan);
    free(scan);
}
