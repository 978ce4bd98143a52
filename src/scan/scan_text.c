/* Text scans: two columns (x, z), or one column of heights below a line that names the spacing. */
#include "scan/number.h"
#include "scan/reader.h"
#include "scan/text_header.h"
#include "scan/text_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_SNIFF = 4096 };

bool scan_text_sniff(const struct scan_bytes *file)
{
    size_t length = file->length < TEXT_SNIFF ? file->length : TEXT_SNIFF;
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)file->bytes[i];
        if (c == '\0' || (c < 0x20 && !strchr("\t\n\v\f\r\x1a", c)))
            return false;
    }
    return true;
}

static enum status_code take_heights(struct scan *out, struct text_table *table, const struct text_header *header,
                                     const struct scan_bytes *file, const struct scan_options *options,
                                     struct status *status)
{
    double x_unit, z_unit;
    if (header->spacing <= 0)
        return scan_fail(status, file, table->first_line,
                         "one column is heights only: no spacing; add a line `spacing 0.5 um` above the numbers, or a "
                         "column x");
    if (scan_units(out, header->spacing_unit, header->unit[0], &x_unit, &z_unit, file, options, status) != STATUS_OK)
        return status->code;
    out->dx_m = header->spacing * x_unit;
    for (size_t i = 0; i < table->rows; i++)
        table->cell[i] *= z_unit;
    return STATUS_OK;
}

static enum status_code take_points(struct scan *out, struct text_table *table, const struct text_header *header,
                                    const struct scan_bytes *file, const struct scan_options *options,
                                    struct status *status)
{
    double x_unit, z_unit;
    if (scan_units(out, header->unit[0], header->unit[1], &x_unit, &z_unit, file, options, status) != STATUS_OK)
        return status->code;
    out->x_m = malloc(table->rows * sizeof *out->x_m);
    if (!out->x_m)
        return status_memory(status);
    for (size_t i = 0; i < table->rows; i++) {
        out->x_m[i] = table->cell[2 * i] * x_unit;
        table->cell[i] = table->cell[2 * i + 1] * z_unit;
    }
    size_t bad = scan_disorder(out->x_m, table->rows);
    if (bad < table->rows) {
        bool repeated = bad > 0 && out->x_m[bad] == out->x_m[bad - 1];
        return scan_fail(
            status, file, text_table_line(table, bad), "x %s; x has to go one way: sort or remove points%s",
            repeated ? "is that of the point before" : "turns back",
            table->delimiter == ',' ? ", or separate the columns by semicolons if the commas are decimal signs" : "");
    }
    return STATUS_OK;
}

static enum status_code take_table(struct scan *out, struct text_table *table, const struct scan_bytes *file,
                                   const struct scan_options *options, struct status *status)
{
    if (table->columns > 2)
        return scan_fail(status, file, table->first_line, "%zu columns; keep two, x and z", table->columns);
    if (table->rows < 3)
        return scan_fail(status, file, table->last_line, "only %zu points; a scan needs at least 3", table->rows);
    struct text_header header = text_header_read(table->preamble, table->delimiter, table->columns);
    enum status_code code = table->columns == 1 ? take_heights(out, table, &header, file, options, status)
                                                : take_points(out, table, &header, file, options, status);
    if (code != STATUS_OK)
        return code;
    double *heights = realloc(table->cell, table->rows * sizeof *heights);
    out->z_m = heights ? heights : table->cell;
    table->cell = NULL;
    out->nx = table->rows;
    return STATUS_OK;
}

enum status_code scan_text_read(struct scan *out, const struct scan_bytes *file, const struct scan_options *options,
                                struct status *status)
{
    struct text_table table;
    enum status_code code = text_table_read(&table, file, status);
    if (code == STATUS_OK)
        code = take_table(out, &table, file, options, status);
    text_table_free(&table);
    return code;
}
