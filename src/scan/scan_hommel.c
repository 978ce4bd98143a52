/* Hommel text: `X;Y;valid`, `[mm];[mm];[1/0]`, then x, z and 1 where the point is valid. The text reader knows such
 * columns; only the name is its own. */
#include "scan/reader.h"

bool scan_hommel_sniff(const struct scan_bytes *file)
{
    return string_view_starts(scan_span(file), "X;Y;valid");
}
