/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the parts of the public interface share. Every public function that computes puts the host's settings aside,
 * does its work with a `struct status`, and ends with library_end(). */
#ifndef LIBRARY_LIBRARY_H
#define LIBRARY_LIBRARY_H

#include "base/status.h"
#include "library/host.h"
#include "library/roughcontact.h"
#include "material/material.h"
#include "profile/profile.h"
#include "scan/scan.h"
#include "spectrum/power_law_scans.h"
#include "spectrum/roughness.h"

struct roughcontact_scan {
    struct scan scan;
};

struct roughcontact_surface {
    struct profile profile;
    struct spectrum spectrum;
    struct asperities asperities;
    bool has_asperities;
    struct status problem; /* why there are none */
    struct roughcontact_roughness roughness;
    struct roughcontact_spectrum shown_spectrum;
    struct roughcontact_power_law power_law;
};

struct roughcontact_material {
    struct material material;
};

/** Gives the host its settings back; `problem` goes to the caller's status (NULL: nowhere). The public code of it. */
int library_end(const struct host *host, const struct status *problem, struct roughcontact_status *status);

/** Fills options of the `size` bytes that the caller knows from the `own_size` bytes of `defaults`; the first member of
 * both is the size. */
void library_init(void *options, size_t size, const void *defaults, size_t own_size);
/** The caller's options over the defaults in `own`; what the caller does not know stays as it is. `given` NULL: all of
 * it. Error: STATUS_USAGE: not set up by `name`, or something set that this library does not know. */
MUST_CHECK enum status_code library_take(void *own, size_t own_size, const void *given, const char *name,
                                         struct status *status);

#endif
