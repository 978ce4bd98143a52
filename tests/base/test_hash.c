/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/hash.h"
#include "support.h"

/* Examples of FIPS 180-4 (NIST "SHA256.pdf") and the well-known hash of nothing. */
static const struct example {
    const char *text, *digits;
} examples[] = {
    {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
    {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
    {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
     "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
};

TEST_CASE(test_published_examples)
{
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++) {
        char digits[65];
        struct hash hash = hash_start();
        hash_add(&hash, examples[i].text, strlen(examples[i].text));
        hash_finish(&hash, digits);
        assert_string_equal(digits, examples[i].digits);
    }
}

TEST_CASE(test_a_million_letters_in_pieces)
{
    char piece[1000], digits[65];
    memset(piece, 'a', sizeof piece);
    struct hash hash = hash_start();
    for (size_t done = 0, length = 1; done < 1000000; done += length) {
        length = done % sizeof piece + 1; /* pieces of every size */
        if (length > 1000000 - done)
            length = 1000000 - done;
        hash_add(&hash, piece, length);
    }
    hash_finish(&hash, digits);
    assert_string_equal(digits, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE(test_nul_bytes_count)
{
    char one[65], two[65];
    struct hash hash = hash_start();
    hash_add(&hash, "a\0b", 3);
    hash_finish(&hash, one);
    hash = hash_start();
    hash_add(&hash, "a\0c", 3);
    hash_finish(&hash, two);
    assert_string_not_equal(one, two);
}
