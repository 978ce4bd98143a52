/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Golden Software Surfer's text grids, DSAA. They name no units; rows begin at the lowest y. Heights from the blanking
 * value on are missing. */
#include "scan/reader.h"

static const double surfer_blank = 1.70141e38;

enum status_code scan_surfer_read(struct scan *out, const struct scan_file *file)
{
    struct string_view text = {file->bytes + 4, file->bytes + file->length}, word;
    double head[8], x_m, z_m; /* nx ny xlo xhi ylo yhi zlo zhi */
    for (size_t i = 0; i < 8; i++)
        if (!scan_word(&text, &word) || !number_read(word, &head[i]))
            return scan_fail(file, scan_line(file, text.start), "'%s' in the header of the grid",
                             scan_quote(word).text);
    if (scan_units(out, NULL, NULL, &x_m, &z_m, file) != STATUS_OK ||
        scan_take_text(out, head[0], head[1], text, z_m, surfer_blank * (1 - 1e-6), NULL, file) != STATUS_OK)
        return file->status->code;
    out->dx_m = out->nx > 1 ? (head[3] - head[2]) / (double)(out->nx - 1) * x_m : 0;
    out->dy_m = out->ny > 1 ? (head[5] - head[4]) / (double)(out->ny - 1) * x_m : 0;
    return STATUS_OK;
}
