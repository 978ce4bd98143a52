/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/hash.h"
#include "support.h"

/* Examples of FIPS 180-4 (NIST "SHA256.pdf") and the well-known hash of nothing; each in pieces of `piece` bytes. */
TEST_CASE(test_published_examples)
{
    static const struct {
        const char *text;
        size_t times, piece;
        const char *digits;
    } examples[] = {
        {"", 1, 1, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", 1, 3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 1, 5,
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        {"aaaaaaaaaa", 100000, 7, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"},
    };
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char digits[65];
        size_t length = strlen(examples[i].text), piece = examples[i].piece;
        struct hash hash = hash_start();
        for (size_t n = 0; n < examples[i].times; n++)
            for (size_t at = 0; at < length; at += piece)
                hash_add(&hash, examples[i].text + at, piece < length - at ? piece : length - at);
        hash_finish(&hash, digits);
        assert_string_equal(digits, examples[i].digits);
    }
}
