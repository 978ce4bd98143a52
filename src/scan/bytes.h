/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers in binary files: a cursor that never leaves the file. */
#ifndef SCAN_BYTES_H
#define SCAN_BYTES_H

#include "scan/reader.h"
#include "scan/string_view.h"

#include <stdint.h>

/** Kinds of numbers, in the order of ISO 25178-71's data types. */
#define BYTES_TYPES(X)                                                                                                 \
    X(U8, u8, uint8_t)                                                                                                 \
    X(U16, u16, uint16_t)                                                                                              \
    X(U32, u32, uint32_t)                                                                                              \
    X(F32, f32, float)                                                                                                 \
    X(I8, i8, int8_t)                                                                                                  \
    X(I16, i16, int16_t)                                                                                               \
    X(I32, i32, int32_t)                                                                                               \
    X(F64, f64, double)
#define BYTES_ENUM(NAME, name, ctype) BYTES_##NAME,
enum bytes_type { BYTES_TYPES(BYTES_ENUM) BYTES_COUNT };
#undef BYTES_ENUM

/** Reads forward, little-endian. Past the end every number is 0 and `overrun` stays set, so that a header can be read
 * in one go and checked once. */
struct bytes {
    const char *at, *end;
    bool overrun;
};

struct bytes bytes_begin(const struct scan_file *file, size_t offset);
size_t bytes_left(const struct bytes *bytes);
void bytes_skip(struct bytes *bytes, size_t count);

double bytes_number(struct bytes *bytes, enum bytes_type type);
/* uint16_t bytes_u16(struct bytes *bytes) and so on */
#define BYTES_DECLARE(NAME, name, ctype) ctype bytes_##name(struct bytes *bytes);
BYTES_TYPES(BYTES_DECLARE)
#undef BYTES_DECLARE
/** A text field of `count` bytes, without what follows a NUL and without blanks around it. */
struct string_view bytes_text(struct bytes *bytes, size_t count);

/** Bytes a number takes. */
size_t bytes_size(enum bytes_type type);

#endif
