#include "base/rank.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS = 8, VALUES = 256 };

struct ranked {
    uint64_t key;
    size_t index;
};

/** A key whose order as an unsigned number is that of the values, turned round. */
static uint64_t descending_key(double value)
{
    uint64_t bits;
    value += 0.0; /* -0 is 0 */
    memcpy(&bits, &value, sizeof bits);
    return bits >> 63 ? bits : ~bits & INT64_MAX;
}

static unsigned digit(uint64_t key, int place)
{
    return (unsigned)(key >> (8 * place)) % VALUES;
}

enum status_code rank_descending(size_t *order, const double *value, size_t count, struct status *status)
{
    struct ranked *room = malloc((2 * count + 1) * sizeof *room), *from = room;
    size_t(*start)[VALUES] = calloc(DIGITS, sizeof *start);
    if (!room || !start) {
        free(room);
        free(start);
        return status_memory(status);
    }
    struct ranked *to = room + count;
    for (size_t i = 0; i < count; i++) {
        from[i] = (struct ranked){descending_key(value[i]), i};
        for (int place = 0; place < DIGITS; place++)
            start[place][digit(from[i].key, place)]++;
    }
    for (int place = 0; place < DIGITS; place++) { /* lowest digit first; each pass keeps the order of the last */
        if (count == 0 || start[place][digit(from[0].key, place)] == count)
            continue; /* all have the same */
        size_t sum = 0;
        for (size_t d = 0; d < VALUES; d++) {
            size_t here = start[place][d];
            start[place][d] = sum;
            sum += here;
        }
        for (size_t i = 0; i < count; i++)
            to[start[place][digit(from[i].key, place)]++] = from[i];
        struct ranked *swap = from;
        from = to;
        to = swap;
    }
    for (size_t i = 0; i < count; i++)
        order[i] = from[i].index;
    free(room);
    free(start);
    return STATUS_OK;
}
