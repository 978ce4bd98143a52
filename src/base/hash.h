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

struct hash hash_start(void);
void hash_add(struct hash *hash, const void *bytes, size_t length);
void hash_finish_bytes(struct hash *hash, unsigned char digest[HASH_BYTES]);
/** Writes 64 lower-case hexadecimal digits and a NUL. */
void hash_finish(struct hash *hash, char digits[65]);

#endif
