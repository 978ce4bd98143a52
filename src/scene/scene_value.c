#include "scene/scene_value.h"
#include "scene/scene_words.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Decimal digits with an optional point and exponent, and nothing else: no inf, nan, hexadecimal or 1_000. */
static bool is_decimal(const char *text)
{
    text += *text == '+' || *text == '-';
    size_t whole = strspn(text, "0123456789");
    text += whole;
    size_t fraction = 0;
    if (*text == '.') {
        fraction = strspn(++text, "0123456789");
        text += fraction;
    }
    if (whole + fraction == 0)
        return false;
    if (*text == 'e' || *text == 'E') {
        text++;
        text += *text == '+' || *text == '-';
        size_t exponent = strspn(text, "0123456789");
        if (exponent == 0)
            return false;
        text += exponent;
    }
    return *text == '\0';
}

/* strtod() of the C locale whatever the program's: a German one would stop at the point. */
static double decimal_value(const char *text)
{
    locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (plain == (locale_t)0)
        return NAN;
    double value = strtod_l(text, NULL, plain);
    freelocale(plain);
    return value;
}

static enum status_code read_number(struct scene_source *source, const struct scene_key *key, const yaml_node_t *node,
                                    const char *expected, double *number)
{
    const char *text = (const char *)node->data.scalar.value;
    if (node->type != YAML_SCALAR_NODE || strlen(text) != node->data.scalar.length || !is_decimal(text))
        return scene_source_wrong_type(source, node, key->name, expected);
    *number = decimal_value(text);
    if (!(*number >= key->least && *number <= key->most))
        return scene_source_fail(source, scene_source_line(node), "'%s' is %s; allowed is %g to %g", key->name,
                                 scene_words_show(text, strlen(text)).text, key->least, key->most);
    return STATUS_OK;
}

enum status_code scene_value_number(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    void *field)
{
    if (key->word && scene_source_is(value, key->word))
        return STATUS_OK;
    return read_number(source, key, value, "a number such as 1.5e-6", field);
}

enum status_code scene_value_count(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                   void *field)
{
    static const char expected[] = "a whole number";
    double number = 0.0;
    enum status_code code = read_number(source, key, value, expected, &number);
    if (code != STATUS_OK)
        return code;
    if (number != floor(number))
        return scene_source_wrong_type(source, value, key->name, expected);
    *(size_t *)field = (size_t)number;
    return STATUS_OK;
}

enum status_code scene_value_choice(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                    void *field)
{
    if (value->type != YAML_SCALAR_NODE)
        return scene_source_wrong_type(source, value, key->name, "one word");
    size_t choice = scene_words_find((const char *)value->data.scalar.value, value->data.scalar.length, key->choices,
                                     key->choice_count);
    if (choice == key->choice_count)
        return scene_source_unknown(source, value, key->name, key->choices, key->choice_count);
    *(unsigned *)field = (unsigned)choice; /* an enum of small constants is unsigned in gcc and clang */
    return STATUS_OK;
}

/* The scalar as a string of printable characters, one at least. */
static enum status_code read_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *node,
                                  const char **text)
{
    if (node->type != YAML_SCALAR_NODE)
        return scene_source_wrong_type(source, node, key->name, "text");
    *text = (const char *)node->data.scalar.value;
    size_t line = scene_source_line(node), length = node->data.scalar.length;
    if (length == 0)
        return scene_source_fail(source, line, "'%s' is empty; give a text or remove the line", key->name);
    for (size_t i = 0; i < length; i++)
        if ((unsigned char)(*text)[i] < 0x20 || (*text)[i] == 0x7f)
            return scene_source_fail(source, line, "'%s' has a line end or control character inside; remove it",
                                     key->name);
    return STATUS_OK;
}

enum status_code scene_value_text(struct scene_source *source, const struct scene_key *key, const yaml_node_t *value,
                                  void *field)
{
    const char *text = NULL;
    enum status_code code = read_text(source, key, value, &text);
    if (code != STATUS_OK)
        return code;
    char **copy = field;
    *copy = strdup(text);
    return *copy ? STATUS_OK : status_memory(source->status);
}

enum status_code scene_value_short_text(struct scene_source *source, const struct scene_key *key,
                                        const yaml_node_t *value, void *field)
{
    const char *text = NULL;
    enum status_code code = read_text(source, key, value, &text);
    if (code != STATUS_OK)
        return code;
    size_t size = (size_t)key->most;
    if (strlen(text) >= size)
        return scene_source_fail(source, scene_source_line(value), "'%s' is longer than %zu bytes; shorten it",
                                 key->name, size - 1);
    memcpy(field, text, strlen(text) + 1);
    return STATUS_OK;
}
