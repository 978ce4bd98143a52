/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SHA-256 of the input files, so that a report names exactly what it was made from. Nettle's, by the processor's own
 * instructions where it has them. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <nettle/sha2.h>
#include <stddef.h>
#include <stdio.h>

enum { HASH_BYTES = SHA256_DIGEST_SIZE };

struct hash {
    struct sha256_ctx context;
};

static inline struct hash hash_start(void)
{
    struct hash hash;
    sha256_init(&hash.context);
    return hash;
}

static inline void hash_add(struct hash *hash, const void *bytes, size_t length)
{
    sha256_update(&hash->context, length, bytes);
}

/** Writes 64 lower-case hexadecimal digits and a NUL. */
static inline void hash_finish(struct hash *hash, char digits[2 * HASH_BYTES + 1])
{
    unsigned char bytes[HASH_BYTES];
    sha256_digest(&hash->context, sizeof bytes, bytes);
    for (int i = 0; i < HASH_BYTES; i++)
        snprintf(digits + 2 * i, 3, "%02x", bytes[i]);
}

#endif
