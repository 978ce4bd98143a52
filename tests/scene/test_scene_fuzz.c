/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hostile scenes: whatever the bytes, the answer is a valid scene or one line that says what is wrong. */
#include "scene_directory.h"

enum { MUTATIONS = 2000 };

/* xorshift64*: the same mutations on every machine. */
static uint64_t next_random(uint64_t *seed)
{
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    return *seed * 2685821657736338717u;
}

static size_t below(uint64_t *seed, size_t limit)
{
    return (size_t)((next_random(seed) >> 16) % limit);
}

/* A stretch of the text, `length` bytes from `start`: nothing, a character, a word between blanks and punctuation, or a
 * line with its end. */
struct stretch {
    size_t start, length;
};

static struct stretch pick(const struct text *text, uint64_t *seed)
{
    static const char *const separators[] = {" \n,:[]{}\"", "\n"};
    size_t kind = below(seed, 4), start = below(seed, text->length), end = start + (kind == 1);
    for (; kind >= 2 && start > 0 && !strchr(separators[kind - 2], text->data[start - 1]); start--)
        ;
    for (; kind >= 2 && end < text->length && !strchr(separators[kind - 2], text->data[end]); end++)
        ;
    return (struct stretch){start, end - start + (kind == 3 && end < text->length)};
}

/* Puts something else in the place of one stretch: a sign of YAML, a word of scenes, a byte, or another stretch. */
static void mutate(struct text *text, uint64_t *seed)
{
    static const char *const pieces[] = {
        "[",    "]",     "{",    "}",     ": ",     "- ",    "\n",    "\t",      "&a ",   "*a",     "<<: ", "---\n",
        "|\n",  "!!",    "\"",   "'",     "#",      "%",     "\\0",   "? ",      "1",     "0",      "-1",   "1e999",
        ".inf", "nan",   "1e-9", "12",    "~",      "null",  "same",  "auto",    "rigid", "tin",    "gold", "thesis",
        "name", "file",  "Pa",   "unit",  "values", "E_Pa",  "load",  "thermal", "all",   "[1, 2]", "{}",   "a.csv",
        "mm",   "4 mm2", "10 N", "3 MPa", "a*",     "title", "level", "20 degC"};
    struct stretch old = pick(text, seed), other = pick(text, seed);
    const char *piece = pieces[below(seed, sizeof pieces / sizeof *pieces)], byte = (char)below(seed, 256);
    struct text mutated = {0};
    text_add_bytes(&mutated, text->data, old.start);
    switch (below(seed, 4)) {
    case 0:
        text_add_bytes(&mutated, text->data + other.start, other.length);
        break;
    case 1:
        text_add_bytes(&mutated, &byte, 1);
        break;
    default:
        text_add_bytes(&mutated, piece, strlen(piece));
    }
    text_add_bytes(&mutated, text->data + old.start + old.length, text->length - old.start - old.length);
    text_free(text);
    *text = mutated;
}

static void check_valid(const struct scene *scene)
{
    size_t count;
    const struct material *material = &scene->surfaces[0].bodies->material;
    assert_true(scene->tolerance >= 1e-14 && scene->tolerance <= 0.1);
    assert_true(isnan(material->youngs_modulus_Pa) ||
                (material->youngs_modulus_Pa > 0 && material->poisson_ratio >= 0));
    assert_true(strlen(scene->title) > 0 && scene->surface_count > 0);
    assert_true(scene->models != 0 && scene->convergence.scales > 0);
    free(scene_loads_of(scene, 1e10, &count));
}

static void check_message(const char *directory, const struct status *status)
{
    assert_true(status->code == STATUS_SCENE || status->code == STATUS_IO);
    assert_memory_equal(status->message, directory, strlen(directory));
    assert_true(strlen(status->message) < sizeof status->message - 1); /* not cut off */
    for (const char *c = status->message; *c; c++)
        assert_true((unsigned char)*c >= 0x20 && *c != 0x7f);
}

/* Is what the text says a valid scene? */
static bool check(const struct scene_directory *directory, const struct text *text)
{
    struct scene scene;
    struct status status = {0};
    scene_directory_write(directory, "scene.yaml", text_string(text), text->length);
    bool valid = scene_read(&scene, directory->path, NULL, &status) == STATUS_OK;
    if (valid)
        check_valid(&scene);
    else
        check_message(directory->path, &status);
    scene_free(&scene);
    return valid;
}

TEST_CASE(test_mutations)
{
    struct scene_directory directory = scene_directory_make();
    struct text original = {0};
    struct status status = {0};
    scene_directory_add(&directory, "surface-1.csv");
    scene_directory_add(&directory, "a.csv");
    scene_directory_add(&directory, "b.csv");
    assert_int_equal(text_read_file(&original, TEST_DATA "/scene/full/scene.yaml", &status), STATUS_OK);
    memcpy(strstr(original.data, "../full/b.csv"), "././././b.csv", strlen("../full/b.csv"));
    size_t valid = 0;
    uint64_t seed = 20240229;
    for (int i = 0; i < MUTATIONS; i++) {
        struct text text = {0};
        text_add_bytes(&text, original.data, original.length);
        for (size_t changes = 1 + below(&seed, 3); changes > 0; changes--)
            mutate(&text, &seed);
        valid += check(&directory, &text);
        text_free(&text);
    }
    assert_true(valid > MUTATIONS / 40 && valid < MUTATIONS / 2); /* both ways were taken often */
    text_free(&original);
    scene_directory_remove(&directory);
}

TEST_CASE(test_random_bytes)
{
    struct scene_directory directory = scene_directory_make();
    uint64_t seed = 7;
    scene_directory_add(&directory, "a.csv");
    for (int i = 0; i < 500; i++) {
        struct text text = {0};
        for (size_t left = 1 + below(&seed, 64); left > 0; left--) { /* half of the texts are printable */
            char byte = (char)(i % 2 ? below(&seed, 256) : 0x20 + below(&seed, 0x5f));
            text_add_bytes(&text, &byte, 1);
        }
        (void)check(&directory, &text);
        text_free(&text);
    }
    scene_directory_remove(&directory);
}
