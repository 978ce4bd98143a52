/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/scan.h"

#include <stdlib.h>

const char *const scan_direction_names[SCAN_DIRECTION_COUNT] = {"x", "y"};

enum status_code scan_transpose(struct scan *scan, struct status *status)
{
    double *z_m = malloc(scan->nx * scan->ny * sizeof *z_m);
    if (!z_m)
        return status_memory(status);
    for (size_t row = 0; row < scan->ny; row++)
        for (size_t i = 0; i < scan->nx; i++)
            z_m[i * scan->ny + row] = scan->z_m[row * scan->nx + i];
    free(scan->z_m);
    free(scan->x_m);
    double dx_m = scan->dx_m;
    size_t nx = scan->nx;
    scan->z_m = z_m;
    scan->x_m = NULL;
    scan->nx = scan->ny;
    scan->ny = nx;
    scan->dx_m = scan->dy_m;
    scan->dy_m = dx_m;
    return STATUS_OK;
}
