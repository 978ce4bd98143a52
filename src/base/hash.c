/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/hash.h"

#include <stdio.h>

struct hash hash_start(void)
{
    struct hash hash;
    SHA256Init(&hash.context);
    return hash;
}

void hash_add(struct hash *hash, const void *bytes, size_t length)
{
    SHA256Update(&hash->context, bytes, length);
}

void hash_finish_bytes(struct hash *hash, unsigned char digest[HASH_BYTES])
{
    SHA256Final(digest, &hash->context);
}

void hash_finish(struct hash *hash, char digits[65])
{
    unsigned char digest[HASH_BYTES];
    hash_finish_bytes(hash, digest);
    for (size_t i = 0; i < sizeof digest; i++)
        snprintf(digits + 2 * i, 3, "%02x", digest[i]);
}
