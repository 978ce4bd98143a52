/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/cell.h"

#include "base/number_digits.h"
#include <math.h>
#include <stdio.h>

static void lose(const struct cell_guard *guard, const char *quantity)
{
    struct results_lost *lost = guard->lost;
    pthread_mutex_lock(&lost->lock);
    if (lost->count++ == 0) {
        struct text line = {0};
        text_add(&line, "%s", quantity);
        if (guard->surface) {
            text_add(&line, " of surface '");
            text_add_shown(&line, guard->surface);
            text_add(&line, "'");
        }
        text_add(&line, " came out infinite and was left empty, a fault of the program; report it");
        snprintf(lost->first, sizeof lost->first, "%s", text_string(&line));
        text_free(&line);
    }
    pthread_mutex_unlock(&lost->lock);
}

/** Is there a number to write? */
static bool present(const struct cell_guard *guard, const char *quantity, double value)
{
    if (isinf(value) && guard->lost)
        lose(guard, quantity);
    return isfinite(value);
}

void cell_number(struct text *row, const struct cell_guard *guard, const char *quantity, double value)
{
    char number[1 + NUMBER_DIGITS_SIZE] = ",";
    text_add_bytes(row, number, 1 + (present(guard, quantity, value) ? number_digits(number + 1, value) : 0));
}

json_t *cell_json(const struct cell_guard *guard, const char *quantity, double value)
{
    return present(guard, quantity, value) ? json_real(value) : json_null();
}
