/* Bruker Dektak CSV: `Scan Parameters`, keys and values, `Scan Data`, titles with units, x and z. The text reader knows
 * all of that; only the name is its own. */
#include "scan/reader.h"

bool scan_dektak_sniff(const struct scan_bytes *file)
{
    return string_view_starts(scan_span(file), "Scan Parameters");
}
