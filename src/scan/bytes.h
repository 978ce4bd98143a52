/* Numbers in binary files: a cursor that never leaves the file. */
#ifndef SCAN_BYTES_H
#define SCAN_BYTES_H

#include "scan/scan.h"
#include "scan/string_view.h"

#include <stdint.h>

/** Kinds of numbers, in the order of ISO 25178-71's data types. */
enum bytes_type { BYTES_U8, BYTES_U16, BYTES_U32, BYTES_F32, BYTES_I8, BYTES_I16, BYTES_I32, BYTES_F64, BYTES_TYPES };

/** Reads forward, little-endian. Past the end every number is 0 and `overrun` stays set, so that a header can be read
 * in one go and checked once. */
struct bytes {
    const char *at, *end;
    bool overrun;
};

struct bytes bytes_begin(const struct scan_bytes *file, size_t offset);
size_t bytes_left(const struct bytes *bytes);
void bytes_skip(struct bytes *bytes, size_t count);

double bytes_number(struct bytes *bytes, enum bytes_type type);
uint16_t bytes_u16(struct bytes *bytes);
int16_t bytes_i16(struct bytes *bytes);
uint32_t bytes_u32(struct bytes *bytes);
int32_t bytes_i32(struct bytes *bytes);
float bytes_f32(struct bytes *bytes);
double bytes_f64(struct bytes *bytes);
/** A text field of `count` bytes, without what follows a NUL and without blanks around it. */
struct string_view bytes_text(struct bytes *bytes, size_t count);

/** Bytes a number takes. */
size_t bytes_size(enum bytes_type type);

#endif
