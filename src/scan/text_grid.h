/* Text scans of areas: x y z lists on a grid, and matrices of heights with their pixel size. */
#ifndef SCAN_TEXT_GRID_H
#define SCAN_TEXT_GRID_H

#include "scan/text_header.h"
#include "scan/text_table.h"

/** Do the three columns look like x, y, z point by point: does one of x and y stay while the other steps? */
bool text_grid_is_list(const struct text_table *table);

/** Reads such a list. Errors: STATUS_SCAN with the line of the first point that is not on the grid. */
MUST_CHECK enum status_code text_grid_read_list(struct scan *out, const struct text_table *table,
                                                const struct text_header *header, const struct scan_bytes *file,
                                                const struct scan_options *options, struct status *status);

/** Reads a matrix, one row a line. Errors: STATUS_SCAN: no pixel size, or another number of points than the header
 * says.
 */
MUST_CHECK enum status_code text_grid_read_matrix(struct scan *out, const struct text_table *table,
                                                  const struct text_header *header, const struct scan_bytes *file,
                                                  const struct scan_options *options, struct status *status);

#endif
