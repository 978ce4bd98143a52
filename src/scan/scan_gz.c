/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any other format, packed by gzip (RFC 1952). */
#include "base/limits.h"
#include "base/text.h"
#include "scan/format.h"

#include <stdlib.h>
#include <zlib.h>

/* Unpacks every member of the file, which are one after another, into `text`. */
enum status_code scan_gz_unpack(struct text *text, const struct scan_file *file)
{
    z_stream stream = {.next_in = (Bytef *)file->bytes};
    const char *end = file->bytes + file->length;
    int code = inflateInit2(&stream, 16 + MAX_WBITS); /* gzip's header */
    bool ended = false;
    size_t most = limit_most(LIMIT_UNPACKED_BYTES);
    if (code != Z_OK)
        return status_memory(file->status);
    enum { PIECE = 65536 };
    unsigned char *piece = malloc(PIECE);
    text->failed = text->failed || !piece;
    while (piece && (code == Z_OK || (code == Z_STREAM_END && (const char *)stream.next_in < end))) {
        size_t left = (size_t)(end - (const char *)stream.next_in);
        if (code == Z_STREAM_END && inflateReset(&stream) != Z_OK)
            break;
        stream.avail_in = left < PIECE ? (uInt)left : PIECE;
        stream.next_out = piece;
        stream.avail_out = PIECE;
        code = inflate(&stream, Z_NO_FLUSH);
        text_add_bytes(text, (const char *)piece, PIECE - stream.avail_out);
        ended = code == Z_STREAM_END;
        if (text->failed || text->length > most || (left == 0 && stream.avail_out > 0))
            break;
    }
    free(piece);
    inflateEnd(&stream);
    if (text->failed || code == Z_MEM_ERROR)
        return status_memory(file->status);
    if (text->length > most)
        return scan_fail(file, 0, "it unpacks to more than %zu bytes%s", most, limit_words(LIMIT_UNPACKED_BYTES).text);
    if (!ended)
        return scan_fail(file, 0, "damaged or cut off within the gzip data; copy the file again");
    return STATUS_OK;
}
