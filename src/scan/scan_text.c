/* Text scans: x and z, perhaps with an index or other columns beside them; heights below a line that names the spacing;
 * and maps (text_grid.h). */
#include "scan/number.h"
#include "scan/reader.h"
#include "scan/sidecar.h"
#include "scan/text_grid.h"
#include "scan/text_header.h"
#include "scan/text_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_SNIFF = 4096, TEXT_POINTS = 3, TEXT_MOST_COLUMNS = 8 };

/* Values instruments write where they measured nothing (-25400 um is one inch below). They count as missing only where
 * every other height is far smaller. */
static const double sentinels[] = {-25400, -32768, -99999, -9999};
static const double sentinel_distance = 4;

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

static bool is_mark(double height, double mark)
{
    return fabs(height - mark) <= 1e-12 * fabs(mark);
}

static void mark_sentinels(struct scan *out)
{
    double z_m = out->quantity == SCAN_SLOPE ? scan_unit_slope(out->z_unit, strlen(out->z_unit))
                                             : scan_unit_m(out->z_unit, strlen(out->z_unit));
    for (size_t k = 0; k < sizeof sentinels / sizeof *sentinels; k++) {
        double mark = sentinels[k] * z_m;
        size_t found = 0, near = 0, points = out->nx * out->ny;
        for (size_t i = 0; i < points; i++) {
            found += is_mark(out->z_m[i], mark) ? 1 : 0;
            near += !is_mark(out->z_m[i], mark) && fabs(out->z_m[i]) * sentinel_distance > fabs(mark) ? 1 : 0;
        }
        if (found == 0 || near > 0)
            continue;
        for (size_t i = 0; i < points; i++)
            out->z_m[i] = is_mark(out->z_m[i], mark) ? NAN : out->z_m[i];
        scan_warn(out, "a %s of %g %s stands for a missing point, %zu times", scan_quantity_names[out->quantity],
                  sentinels[k], out->z_unit, found);
    }
}

/* Hands the table's first `rows` numbers, the heights by now, over to the scan. */
static void keep_heights(struct scan *out, struct text_table *table, size_t rows)
{
    out->z_m = table->cell;
    out->nx = rows;
    table->cell = NULL;
    double *fitted = realloc(out->z_m, rows * sizeof *fitted);
    if (fitted)
        out->z_m = fitted;
}

/* Accretech and Surfcom write the length in mm and the number of heights above the heights in um. */
static bool is_accretech(const struct text_table *table)
{
    return table->rows >= TEXT_POINTS + 2 && table->cell[0] > 0 && table->cell[1] == (double)(table->rows - 2);
}

static bool is_given(const char *text)
{
    return text && *text;
}

static enum status_code take_accretech(struct scan *out, struct text_table *table, const struct scan_bytes *file,
                                       const struct scan_options *options, struct status *status)
{
    double x_m, z_m;
    bool said = is_given(options->x_unit) && is_given(options->z_unit);
    if (scan_units(out, is_given(options->x_unit) ? "" : "mm", is_given(options->z_unit) ? "" : "um", &x_m, &z_m, file,
                   options, status) != STATUS_OK)
        return status->code;
    size_t n = table->rows - 2;
    out->format = "accretech";
    out->dx_m = table->cell[0] / (double)(n - 1) * x_m;
    for (size_t i = 0; i < n; i++)
        table->cell[i] = table->cell[i + 2] * z_m;
    keep_heights(out, table, n);
    if (!said)
        scan_warn(out, "the file names no units: length taken as %s and heights as %s, as Accretech writes them",
                  out->x_unit, out->z_unit);
    return STATUS_OK;
}

/* Column `z` alone, at the spacing that the header names. */
static enum status_code take_heights(struct scan *out, struct text_table *table, const struct text_header *header,
                                     size_t z, const struct scan_bytes *file, const struct scan_options *options,
                                     struct status *status)
{
    double x_m, z_m;
    out->z_column = z + 1;
    if (table->columns == 1 && header->spacing.value <= 0 && is_accretech(table))
        return take_accretech(out, table, file, options, status);
    if (header->spacing.value <= 0)
        return scan_fail(status, file, table->first_line,
                         "one column is heights only: no spacing; add a line `spacing 0.5 um` above the numbers, or a "
                         "column x");
    if (text_header_units(out, header, header->spacing.unit, &x_m, &z_m, file, options, status) != STATUS_OK)
        return status->code;
    out->dx_m = header->spacing.value * x_m;
    for (size_t i = 0; i < table->rows; i++)
        table->cell[i] = table->cell[i * table->columns + z] * z_m;
    keep_heights(out, table, table->rows);
    return STATUS_OK;
}

static enum status_code fail_disorder(const struct text_table *table, const double *x, size_t bad,
                                      const struct scan_bytes *file, struct status *status)
{
    bool repeated = bad > 0 && x[bad] == x[bad - 1];
    return scan_fail(status, file, text_table_line(table, bad), "x %s; x has to go one way: sort or remove points%s",
                     repeated ? "is that of the point before" : "turns back",
                     table->delimiter == ',' ? ", or separate the columns by semicolons if the commas are decimal signs"
                                             : "");
}

/* The scan in columns `x` and `z`, without the points that the header's column `valid` marks by 0. */
static enum status_code take_points(struct scan *out, struct text_table *table, const struct text_header *header,
                                    size_t x, size_t z, const struct scan_bytes *file,
                                    const struct scan_options *options, struct status *status)
{
    double x_m, z_m;
    size_t rows = table->rows, columns = table->columns;
    if (z >= columns)
        return scan_fail(status, file, table->first_line, "no column of heights beside x");
    out->x_column = x + 1;
    out->z_column = z + 1;
    if (text_header_units(out, header, NULL, &x_m, &z_m, file, options, status) != STATUS_OK)
        return status->code;
    out->x_m = malloc(rows * sizeof *out->x_m);
    if (!out->x_m)
        return status_memory(status);
    for (size_t i = 0; i < rows; i++) {
        const double *row = table->cell + i * columns;
        bool valid = header->valid >= columns || row[header->valid] != 0;
        out->x_m[i] = row[x] * x_m;
        table->cell[i] = valid ? row[z] * z_m : NAN; /* never beyond row i itself */
    }
    size_t bad = scan_disorder(out->x_m, rows);
    if (bad < rows)
        return fail_disorder(table, out->x_m, bad, file, status);
    keep_heights(out, table, rows);
    const char *unit = header->spacing.unit ? header->spacing.unit : out->x_unit;
    if (header->spacing.value > 0)
        out->nominal_dx_m = header->spacing.value * scan_unit_m(unit, strlen(unit));
    if (columns > (header->valid < columns ? 3 : 2) && !is_given(options->z_column))
        scan_warn(out, "%zu columns: column %zu read as x, column %zu as z, the others ignored", columns, x + 1, z + 1);
    return STATUS_OK;
}

static bool goes_one_way(const struct text_table *table, size_t column)
{
    bool up = table->cell[table->columns + column] > table->cell[column];
    for (size_t i = 1; i < table->rows; i++) {
        const double *row = table->cell + i * table->columns + column, *before = row - table->columns;
        if (!(up ? *row > *before : *row < *before))
            return false;
    }
    return true;
}

static bool counts_up(const struct text_table *table)
{
    double first = table->cell[0];
    for (size_t i = 0; i < table->rows; i++)
        if (table->cell[i * table->columns] != first + (double)i)
            return false;
    return first == 0 || first == 1;
}

/* Does the first column have even steps, or what rounding to the last digit leaves of them? */
static bool has_even_steps(const struct text_table *table)
{
    double first = table->cell[0], last = table->cell[(table->rows - 1) * table->columns];
    double step = (last - first) / (double)(table->rows - 1);
    for (size_t i = 1; i < table->rows; i++)
        if (!(fabs(table->cell[i * table->columns] - (first + (double)i * step)) <= 0.5 * fabs(step)))
            return false;
    return step != 0;
}

/* The column that is x: the first, unless that counts the points, or is the only one of three without a unit. */
static size_t find_x(const struct text_table *table, const struct text_header *header,
                     const struct scan_options *options)
{
    bool first_named = header->unit[0] || (options->sidecar && options->sidecar->header.unit[0]);
    if (table->columns < 3 || header->valid <= 2 || first_named || !goes_one_way(table, 1))
        return 0;
    return (header->unit[1] && header->unit[2]) || counts_up(table) ? 1 : 0;
}

/* Rows of heights? Where the header does not say so, only where the first column cannot be x. */
static bool is_matrix(const struct text_table *table, const struct text_header *header)
{
    bool said = header->pixel.value > 0 || (header->width.value > 0 && header->height.value > 0);
    if (table->columns < 4 || table->rows < 2 || header->unit[0])
        return false;
    return said || (!has_even_steps(table) && (table->columns > TEXT_MOST_COLUMNS || !goes_one_way(table, 0)));
}

/* A column that the scene names by its number or its title, `key` being what it is to hold. */
static enum status_code choose_column(size_t *column, const char *name, const struct text_table *table,
                                      const struct scan_bytes *file, struct status *status)
{
    size_t columns = table->columns, number = 0;
    const char *s = columns == 1 ? "" : "s";
    if (!number_read_size((struct span){name, name + strlen(name)}, &number)) {
        number = text_header_find(table->preamble, table->delimiter, columns, name);
        if (number == 0)
            return scan_fail(status, file, 0, "no column is titled '%.60s'; there %s %zu column%s: give a number", name,
                             columns == 1 ? "is" : "are", columns, s);
        if (number == SIZE_MAX)
            return scan_fail(status, file, 0, "more than one column is titled '%.60s'; give its number, 1 to %zu", name,
                             columns);
    }
    if (number < 1 || number > columns)
        return scan_fail(status, file, table->first_line, "there is no column %zu: there %s %zu column%s", number,
                         columns == 1 ? "is" : "are", columns, s);
    *column = number - 1;
    return STATUS_OK;
}

/* The line of the first row with nothing measured in one of two columns, 0: none. */
static size_t missing_line(const struct text_table *table, size_t x, size_t z)
{
    for (size_t i = 0; table->missing_line > 0 && i < table->rows; i++)
        if (isnan(table->cell[i * table->columns + x]) || isnan(table->cell[i * table->columns + z]))
            return text_table_line(table, i);
    return 0;
}

/* The columns that the scene chooses: z, and perhaps x. Where the header's x is z itself or no x at all, its spacing
 * will do. */
static enum status_code take_chosen(struct scan *out, struct text_table *table, const struct text_header *header,
                                    const struct scan_bytes *file, const struct scan_options *options,
                                    struct status *status)
{
    size_t z, x = table->columns > 1 ? find_x(table, header, options) : 0;
    bool x_given = is_given(options->x_column);
    if (choose_column(&z, options->z_column, table, file, status) != STATUS_OK ||
        (x_given && choose_column(&x, options->x_column, table, file, status) != STATUS_OK))
        return status->code;
    size_t line = missing_line(table, x_given ? x : z, z);
    if (line > 0)
        return scan_fail(status, file, line, "'%s' in a column of numbers; correct or remove this line",
                         scan_quote(table->missing).text);
    bool no_x = x == z || (header->spacing.value > 0 && !goes_one_way(table, x));
    if (!x_given && no_x && (table->columns == 1 || header->spacing.value > 0))
        return take_heights(out, table, header, z, file, options, status);
    if (x == z)
        return scan_fail(status, file, table->first_line,
                         "column %zu cannot be x and z; choose both, as in `column: [1, 2]`", z + 1);
    return take_points(out, table, header, x, z, file, options, status);
}

static enum status_code take_table(struct scan *out, struct text_table *table, const struct scan_bytes *file,
                                   const struct scan_options *options, struct status *status)
{
    struct text_header header = text_header_read(table->preamble, table->delimiter, table->columns);
    enum status_code code = STATUS_OK;
    size_t x = 0;
    if (is_given(options->z_column) && table->rows >= TEXT_POINTS) {
        code = take_chosen(out, table, &header, file, options, status);
    } else if (text_grid_is_list(table)) {
        code = text_grid_read_list(out, table, &header, file, options, status);
    } else if (is_matrix(table, &header)) {
        code = text_grid_read_matrix(out, table, &header, file, options, status);
    } else if (table->missing_line > 0) {
        code = scan_fail(status, file, table->missing_line, "'%s' in a column of numbers; correct or remove this line",
                         scan_quote(table->missing).text);
    } else if (table->rows < TEXT_POINTS) {
        code = scan_fail(status, file, table->last_line, "only %zu points; a scan needs at least %d", table->rows,
                         TEXT_POINTS);
    } else if (table->columns == 1) {
        code = take_heights(out, table, &header, 0, file, options, status);
    } else {
        x = find_x(table, &header, options);
        code = take_points(out, table, &header, x, header.valid == x + 1 ? x + 2 : x + 1, file, options, status);
    }
    if (code == STATUS_OK)
        mark_sentinels(out);
    return code;
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
