/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_team.h"

#include <assert.h>
#include <math.h>

size_t direct_team_slab(size_t n, size_t size, size_t rank, size_t *first)
{
    size_t block = (n + size - 1) / size;
    *first = rank * block < n ? rank * block : n;
    return n - *first < block ? n - *first : block;
}

static void combine(const struct direct_team *team, double *values, size_t count, bool most)
{
    if (!team)
        return;
    double *all = (double *)team->scratch;
    assert(count * sizeof *values <= sizeof *team->scratch);
    team->gather(team, all, values, count * sizeof *values);
    for (size_t k = 0; k < count; k++) {
        values[k] = all[k];
        for (size_t rank = 1; rank < team->size; rank++)
            values[k] = most ? fmax(values[k], all[rank * count + k]) : values[k] + all[rank * count + k];
    }
}

void direct_team_add(const struct direct_team *team, double *values, size_t count)
{
    combine(team, values, count, false);
}

void direct_team_most(const struct direct_team *team, double *values, size_t count)
{
    combine(team, values, count, true);
}

double direct_team_sum(const struct direct_team *team, double value)
{
    direct_team_add(team, &value, 1);
    return value;
}

bool direct_team_any(const struct direct_team *team, bool value)
{
    return team ? direct_team_sum(team, value) > 0 : value;
}

enum status_code direct_team_agree(const struct direct_team *team, struct status *status)
{
    if (!team || !direct_team_any(team, status->code != STATUS_OK))
        return status->code;
    team->gather(team, team->scratch, status, sizeof *status);
    size_t rank = 0;
    while (team->scratch[rank].code == STATUS_OK)
        rank++;
    *status = team->scratch[rank];
    return status->code;
}
