#include "scene/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int compare_doubles(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/* `points` loads in equal steps of their logarithm; by powers of ten, so that whole decades come out exactly. */
static void fill_decades(double *loads, const struct scene_load *load)
{
    double first = log10(load->from), last = log10(load->to);
    for (size_t i = 1; i + 1 < load->points; i++) {
        double step = (last - first) * (double)i / (double)(load->points - 1);
        loads[i] = fmin(fmax(pow(10.0, first + step), load->from), load->to);
    }
    loads[load->points - 1] = load->to;
    loads[0] = load->from;
}

enum status_code scene_loads(double **loads, size_t *count, const struct scene *scene, double effective_modulus_Pa,
                             struct status *status)
{
    const struct scene_load *load = &scene->load;
    double *all = malloc(load->points * sizeof *all);
    *loads = all;
    *count = 0;
    if (!all)
        return status_memory(status);
    if (load->values)
        memcpy(all, load->values, load->points * sizeof *all);
    else
        fill_decades(all, load);
    for (size_t i = 0; load->in_pascal && i < load->points; i++)
        all[i] /= effective_modulus_Pa;
    qsort(all, load->points, sizeof *all, compare_doubles);
    for (size_t i = 0; i < load->points; i++)
        if (i == 0 || all[i] != all[*count - 1])
            all[(*count)++] = all[i];
    return STATUS_OK;
}
