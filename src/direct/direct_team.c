/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "direct/direct_team.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

size_t direct_team_slab(size_t n, size_t size, size_t rank, size_t *first)
{
    size_t block = (n + size - 1) / size;
    *first = rank * block < n ? rank * block : n;
    return n - *first < block ? n - *first : block;
}

void direct_team_add(const struct direct_team *team, double *values, size_t count)
{
    if (!team)
        return;
    assert(count <= DIRECT_TEAM_VALUES);
    team->gather(team, team->scratch, values, count * sizeof *values);
    for (size_t k = 0; k < count; k++) {
        values[k] = team->scratch[k];
        for (size_t rank = 1; rank < team->size; rank++)
            values[k] += team->scratch[rank * count + k];
    }
}

void direct_team_most(const struct direct_team *team, double *values, size_t count)
{
    if (!team)
        return;
    assert(count <= DIRECT_TEAM_VALUES);
    team->gather(team, team->scratch, values, count * sizeof *values);
    for (size_t k = 0; k < count; k++)
        for (size_t rank = 0; rank < team->size; rank++)
            values[k] = fmax(values[k], team->scratch[rank * count + k]);
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
    struct status *all = malloc(team->size * sizeof *all), none = {0};
    /* whoever has no memory left cannot tell whose message comes first, but it has one of its own */
    bool told = !direct_team_any(team, all == NULL);
    if (told) {
        team->gather(team, all, status, sizeof *status);
        *status = none;
        for (size_t rank = 0; rank < team->size && status->code == STATUS_OK; rank++)
            *status = all[rank];
    }
    free(all);
    return told ? status->code : status_memory(status);
}
