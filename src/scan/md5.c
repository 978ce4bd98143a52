#include "scan/md5.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint32_t rotate(uint32_t value, unsigned by)
{
    return value << by | value >> (32 - by);
}

static void add_block(uint32_t state[4], const uint32_t sines[64], const unsigned char block[64])
{
    static const unsigned turns[4][4] = {{7, 12, 17, 22}, {5, 9, 14, 20}, {4, 11, 16, 23}, {6, 10, 15, 21}};
    uint32_t word[16], a = state[0], b = state[1], c = state[2], d = state[3];
    for (size_t i = 0; i < 16; i++)
        word[i] = (uint32_t)block[4 * i] | (uint32_t)block[4 * i + 1] << 8 | (uint32_t)block[4 * i + 2] << 16 |
                  (uint32_t)block[4 * i + 3] << 24;
    for (size_t i = 0; i < 64; i++) {
        const struct {
            uint32_t mix;
            size_t word;
        } rounds[4] = {
            {(b & c) | (~b & d), i}, {(d & b) | (~d & c), 5 * i + 1}, {b ^ c ^ d, 3 * i + 5}, {c ^ (b | ~d), 7 * i}};
        uint32_t sum = a + rounds[i / 16].mix + sines[i] + word[rounds[i / 16].word % 16];
        a = d, d = c, c = b;
        b += rotate(sum, turns[i / 16][i % 4]);
    }
    state[0] += a, state[1] += b, state[2] += c, state[3] += d;
}

struct md5_hex md5(const char *bytes, size_t length)
{
    uint32_t sines[64], state[4] = {0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476};
    for (size_t i = 0; i < 64; i++)
        sines[i] = (uint32_t)floor(fabs(sin((double)(i + 1))) * 0x1p32);
    size_t whole = length / 64 * 64, rest = length - whole;
    for (size_t at = 0; at < whole; at += 64)
        add_block(state, sines, (const unsigned char *)bytes + at);
    unsigned char tail[128] = {0};
    memcpy(tail, bytes + whole, rest);
    tail[rest] = 0x80;
    size_t size = rest < 56 ? 64 : 128;
    for (size_t i = 0; i < 8; i++)
        tail[size - 8 + i] = (unsigned char)((uint64_t)length * 8 >> 8 * i);
    for (size_t at = 0; at < size; at += 64)
        add_block(state, sines, tail + at);
    struct md5_hex hex;
    for (size_t i = 0; i < 16; i++)
        snprintf(hex.text + 2 * i, 3, "%02x", state[i / 4] >> 8 * (i % 4) & 0xff);
    return hex;
}
