#include "base/hash.h"

#include <stdint.h>
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

void hash_finish(struct hash *hash, char digits[65])
{
    uint8_t digest[SHA256_DIGEST_LENGTH];
    SHA256Final(digest, &hash->context);
    for (size_t i = 0; i < sizeof digest; i++)
        snprintf(digits + 2 * i, 3, "%02x", digest[i]);
}
