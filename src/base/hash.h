/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SHA-256 of the input files, so that a report names exactly what it was made from. */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <sha2.h>
#include <stddef.h>

enum { HASH_BYTES = SHA256_DIGEST_LENGTH };

struct hash {
    SHA2_CTX context;
};

static inline struct hash hash_start(void)
{
    struct hash hash;
    SHA256Init(&hash.context);
    return hash;
}

static inline void hash_add(struct hash *hash, const void *bytes, size_t length)
{
    SHA256Update(&hash->context, bytes, length);
}

/** Writes 64 lower-case hexadecimal digits and a NUL. */
static inline void hash_finish(struct hash *hash, char digits[SHA256_DIGEST_STRING_LENGTH])
{
    SHA256End(&hash->context, digits);
}

#endif
