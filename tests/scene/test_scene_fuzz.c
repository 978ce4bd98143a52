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

static void splice(struct text *text, size_t at, size_t removed, const char *bytes, size_t length)
{
    struct text spliced = {0};
    text_add_bytes(&spliced, text->data, at);
    text_add_bytes(&spliced, bytes, length);
    text_add_bytes(&spliced, text->data + at + removed, text->length - at - removed);
    text_free(text);
    *text = spliced;
}

/* A stretch of the text, by start and length: a word (between blanks and punctuation) or a line with its end. */
struct stretch {
    size_t start, length;
};

static struct stretch pick(const struct text *text, uint64_t *seed, const char *separators, size_t end)
{
    size_t at = below(seed, text->length), start = at;
    while (start > 0 && !strchr(separators, text->data[start - 1]))
        start--;
    while (at < text->length && !strchr(separators, text->data[at]))
        at++;
    at = at + end < text->length ? at + end : text->length;
    return (struct stretch){start, at - start};
}

static struct stretch pick_word(const struct text *text, uint64_t *seed)
{
    return pick(text, seed, " \n,:[]{}\"", 0);
}

static struct stretch pick_line(const struct text *text, uint64_t *seed)
{
    return pick(text, seed, "\n", 1);
}

/* One change, half of them blind to what YAML is, half of words and lines, so that the checks behind it are met. */
static void mutate(struct text *text, uint64_t *seed)
{
    static const char *const pieces[] = {"[",     "]",   "{",  "}",  ": ", "- ", "\n", "\t",  "&a ", "*a", "<<: ",
                                         "---\n", "|\n", "!!", "\"", "'",  "#",  "%",  "\\0", "\\n", "? ", ", "};
    static const char *const words[] = {
        "1",      "0",     "-1",      "1e999",   ".inf",     "nan",    "1e-9",  "12",         "~",  "null",
        "same",   "auto",  "rigid",   "tin",     "gold",     "thesis", "name",  "file",       "Pa", "unit",
        "values", "E_Pa",  "load",    "thermal", "all",      "[1, 2]", "{}",    "a.csv",      "mm", "4 mm2",
        "10 N",   "3 MPa", "20 degC", "a*",      "electron", "title",  "level", "statistical"};
    const char *piece = pieces[below(seed, sizeof pieces / sizeof *pieces)];
    const char *fresh = words[below(seed, sizeof words / sizeof *words)];
    struct stretch word = pick_word(text, seed), line = pick_line(text, seed);
    struct stretch other = below(seed, 2) ? pick_word(text, seed) : pick_line(text, seed);
    char copy[256];
    other.length = other.length < sizeof copy ? other.length : sizeof copy;
    memcpy(copy, text->data + other.start, other.length);
    switch (below(seed, 7)) {
    case 0:
        text->data[below(seed, text->length)] = (char)(below(seed, 4) ? 0x20 + below(seed, 0x5f) : below(seed, 256));
        break;
    case 1:
        splice(text, below(seed, text->length), 0, piece, strlen(piece));
        break;
    case 2:
        splice(text, word.start, word.length, copy, other.length);
        break;
    case 3:
        splice(text, line.start, line.length, "", 0);
        break;
    case 4:
        splice(text, line.start, 0, copy, other.length);
        break;
    default:
        splice(text, word.start, word.length, fresh, strlen(fresh));
    }
}

static void check_valid(const struct scene *scene)
{
    double *loads;
    size_t count, operating;
    struct status status = {0};
    assert_true(scene->tolerance >= 1e-14 && scene->tolerance <= 0.1);
    const struct material *material = &scene->surfaces[0].bodies->material;
    assert_true(isnan(material->youngs_modulus_Pa) ||
                (material->youngs_modulus_Pa > 0 && material->poisson_ratio >= 0));
    assert_true(strlen(scene->title) > 0 && scene->surface_count > 0);
    assert_true(scene->models != 0 && scene->convergence.scales > 0);
    assert_int_equal(
        scene_loads(&loads, &count, &operating, scene, &(struct material_pair){.effective_modulus_Pa = 1e10}, &status),
        STATUS_OK);
    assert_true(count > 0 && loads[0] > 0 && isfinite(loads[count - 1]));
    for (size_t i = 1; i < count; i++)
        assert_true(loads[i] > loads[i - 1]);
    free(loads);
}

static void check_message(const char *directory, const struct status *status)
{
    assert_true(status->code == STATUS_SCENE || status->code == STATUS_IO);
    assert_memory_equal(status->message, directory, strlen(directory));
    assert_true(strlen(status->message) < sizeof status->message - 1); /* not cut off */
    for (const char *c = status->message; *c; c++)
        assert_true((unsigned char)*c >= 0x20 && *c != 0x7f);
}

static void test_mutations(void **state)
{
    (void)state;
    struct scene_directory directory = scene_directory_make();
    scene_directory_add(&directory, "surface-1.csv");
    scene_directory_add(&directory, "a.csv");
    struct text original = {0};
    struct status status = {0};
    assert_int_equal(text_read_file(&original, TEST_DATA "/scene/full/scene.yaml", &status), STATUS_OK);
    splice(&original, (size_t)(strstr(original.data, "../full/b.csv") - original.data), strlen("../full/b.csv"),
           "a.csv", 5);
    size_t valid = 0;
    uint64_t seed = 20240229;
    for (int i = 0; i < MUTATIONS; i++) {
        struct text text = {0};
        text_add_bytes(&text, original.data, original.length);
        for (size_t changes = 1 + below(&seed, 3); changes > 0; changes--)
            mutate(&text, &seed);
        scene_directory_write(&directory, "scene.yaml", text.data, text.length);
        struct scene scene;
        status = (struct status){0};
        if (scene_read(&scene, directory.path, NULL, &status) == STATUS_OK) {
            check_valid(&scene);
            valid++;
        } else
            check_message(directory.path, &status);
        scene_free(&scene);
        text_free(&text);
    }
    assert_true(valid > MUTATIONS / 40 && valid < MUTATIONS / 2); /* both ways were taken often */
    text_free(&original);
    scene_directory_remove(&directory);
}

static void test_random_bytes(void **state)
{
    (void)state;
    struct scene_directory directory = scene_directory_make();
    uint64_t seed = 7;
    for (int i = 0; i < 500; i++) {
        char bytes[64];
        size_t length = 1 + below(&seed, sizeof bytes);
        for (size_t j = 0; j < length; j++) /* half of them printable */
            bytes[j] = (char)(i % 2 ? below(&seed, 256) : 0x20 + below(&seed, 0x5f));
        scene_directory_write(&directory, "scene.yaml", bytes, length);
        struct scene scene;
        struct status status = {0};
        if (scene_read(&scene, directory.path, NULL, &status) != STATUS_OK)
            check_message(directory.path, &status);
        scene_free(&scene);
    }
    scene_directory_remove(&directory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_mutations), cmocka_unit_test(test_random_bytes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
