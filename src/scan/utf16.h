/* Text in UTF-16, which some Windows programs export. */
#ifndef SCAN_UTF16_H
#define SCAN_UTF16_H

#include "base/text.h"
#include "scan/scan.h"

/** Does the file begin with a UTF-16 byte order mark, and have an even number of bytes? */
bool utf16_sniff(const struct scan_bytes *file);
/** Adds the file's text to `out` in UTF-8, without the mark; halves of surrogate pairs become '?'. */
void utf16_convert(struct text *out, const struct scan_bytes *file);

#endif
