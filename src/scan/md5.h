/* MD5 (RFC 1321), which X3P archives use to tell whether they were changed. */
#ifndef SCAN_MD5_H
#define SCAN_MD5_H

#include <stddef.h>

struct md5_hex {
    char text[33];
};

/** The digest of `length` bytes as 32 lower-case hexadecimal digits. */
struct md5_hex md5(const char *bytes, size_t length);

#endif
