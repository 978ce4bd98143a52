/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SHA-256 of the input files, so that a report names exactly what it was made from. libcrypto's, by the processor's own
 * instructions where it has them; its low-level calls, which need no memory and read no configuration. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#define OPENSSL_SUPPRESS_DEPRECATED
#include <openssl/sha.h>
#include <stddef.h>
#include <stdio.h>

enum { HASH_BYTES = SHA256_DIGEST_LENGTH };

struct hash {
    SHA256_CTX context;
};

static inline struct hash hash_start(void)
{
    struct hash hash;
    SHA256_Init(&hash.context);
    return hash;
}

static inline void hash_add(struct hash *hash, const void *bytes, size_t length)
{
    SHA256_Update(&hash->context, bytes, length);
}

/** Writes 64 lower-case hexadecimal digits and a NUL. */
static inline void hash_finish(struct hash *hash, char digits[2 * HASH_BYTES + 1])
{
    unsigned char bytes[HASH_BYTES];
    SHA256_Final(bytes, &hash->context);
    for (int i = 0; i < HASH_BYTES; i++)
        snprintf(digits + 2 * i, 3, "%02x", bytes[i]);
}

#endif
