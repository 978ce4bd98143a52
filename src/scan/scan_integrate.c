#include "scan/reader.h"

#include <math.h>

enum status_code scan_integrate(struct scan *scan, const struct scan_bytes *file, struct status *status)
{
    if (scan->kind != SCAN_PROFILE)
        return scan_fail(status, file, 0, "a map of slopes; only profiles can be integrated to heights");
    double z_m = 0, slope = NAN;
    size_t last = 0; /* the measured point before */
    for (size_t i = 0; i < scan->nx; i++) {
        double next = scan->z_m[i];
        if (isnan(next))
            continue;
        double step_m = scan->x_m ? scan->x_m[i] - scan->x_m[last] : (double)(i - last) * scan->dx_m;
        if (!isnan(slope))
            z_m += 0.5 * (slope + next) * step_m;
        scan->z_m[i] = z_m;
        slope = next;
        last = i;
    }
    scan_warn(scan, "slopes in %s, integrated to heights by the trapezoidal rule", scan->z_unit);
    return STATUS_OK;
}
