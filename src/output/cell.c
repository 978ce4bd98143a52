/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/cell.h"

#include "base/number_digits.h"
#include <math.h>

/** Is there a number to write? */
static bool present(const struct cell_guard *guard, const char *quantity, double value)
{
    if (isinf(value))
        (void)status_fail(guard->status, STATUS_NUMBER, "%s%s%s%s came out infinite, a fault of the program; report it",
                          quantity, guard->surface ? " of surface '" : "", guard->surface ? guard->surface : "",
                          guard->surface ? "'" : "");
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
