/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/record.h"

#include "base/number_format.h"
#include "base/unit.h"
#include <math.h>
#include <string.h>

static int keep(const char *bytes, size_t length, void *text)
{
    text_add_bytes(text, bytes, length);
    return 0;
}

static void begin_line(struct text *out, const char *after, int depth)
{
    text_add_bytes(out, after, strlen(after));
    text_add_bytes(out, "\n", 1);
    for (int i = 0; i < depth; i++)
        text_add_bytes(out, " ", 1);
}

/** Its exponent has no plus and no zero in front, and 2 is 2.0. */
static void put_real(struct text *out, double value)
{
    size_t start = out->length;
    number_digits(out, value, 17);
    if (out->failed)
        return;
    char *number = out->data + start, *to = strchr(number, 'e');
    if (to) {
        to += to[1] == '-' ? 2 : 1;
        size_t passed = strspn(to, "+0");
        memmove(to, to + passed, strlen(to + passed) + 1);
        out->length -= passed;
    } else if (!strchr(number, '.')) {
        text_add_bytes(out, ".0", 2);
    }
}

/** False without memory. */
static bool put(struct text *out, const json_t *json, int depth)
{
    bool ok = json != NULL;
    size_t i, count = 0;
    const char *key;
    json_t *part;
    if (json_is_real(json)) {
        put_real(out, json_real_value(json));
    } else if (json_array_size(json) > 0) {
        text_add_bytes(out, "[", 1);
        json_array_foreach (json, i, part) {
            begin_line(out, i > 0 ? "," : "", depth + 1);
            ok = put(out, part, depth + 1) && ok;
        }
        begin_line(out, "", depth);
        text_add_bytes(out, "]", 1);
    } else if (json_object_size(json) > 0) {
        text_add_bytes(out, "{", 1);
        json_object_foreach ((json_t *)json, key, part) {
            json_auto_t *name = json_string(key);
            begin_line(out, count++ > 0 ? "," : "", depth + 1);
            ok = put(out, name, 0) && ok;
            text_add_bytes(out, ": ", 2);
            ok = put(out, part, depth + 1) && ok;
        }
        begin_line(out, "", depth);
        text_add_bytes(out, "}", 1);
    } else {
        ok = ok && json_dump_callback(json, keep, out, JSON_ENCODE_ANY) == 0;
    }
    return ok;
}

bool json_text(struct text *out, const json_t *json)
{
    return put(out, json, 0) && !out->failed;
}

json_t *json_shown(const char *hostile)
{
    OWNED(text_free) struct text shown = {0};
    text_add_shown(&shown, hostile ? hostile : "");
    return hostile ? json_string(text_string(&shown)) : json_null();
}

json_t *json_lines(const char *lines)
{
    json_t *array = json_array();
    for (size_t length; *lines; lines += length + (lines[length] == '\n')) {
        OWNED(text_free) struct text line = {0};
        length = strcspn(lines, "\n");
        text_add_bytes(&line, lines, length);
        json_array_append_new(array, json_shown(text_string(&line)));
    }
    return array;
}

json_t *json_finite(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

void json_set(json_t *object, const char *key, double value)
{
    json_object_set_new(object, key, json_finite(value));
}

void json_set_count(json_t *object, const char *key, size_t count)
{
    json_object_set_new(object, key, json_integer((json_int_t)count));
}

json_t *json_numbers(const double *values, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, json_finite(values[i]));
    return array;
}

void json_set_all(json_t *object, const char *key, const double *values, size_t count)
{
    json_object_set_new(object, key, json_numbers(values, count));
}

double record_unit(const struct record_field *field)
{
    struct unit unit;
    return unit_read(&unit, field->unit, strlen(field->unit)) ? unit.factor : 1;
}

json_t *record_value_json(enum record_kind kind, const void *at)
{
    switch (kind) {
    case RECORD_COUNT:
        return json_integer((json_int_t) * (const size_t *)at);
    case RECORD_TEXT:
        return json_shown(*(const char *const *)at);
    case RECORD_CHARACTERS:
        return json_shown(at);
    case RECORD_PAIR:
        return json_numbers(at, 2);
    case RECORD_FLAG:
        return json_boolean(*(const bool *)at);
    case RECORD_ESTIMATE:
        return record_estimate_json(at);
    default:
        return json_finite(*(const double *)at);
    }
}

json_t *record_json(const struct record_field *fields, const void *of)
{
    json_t *json = json_object();
    for (const struct record_field *field = fields; field->key; field++)
        if (field->when & RECORD_JSON)
            json_object_set_new(json, field->key, record_value_json(field->kind, (const char *)of + field->offset));
    return json;
}

#define FIELD(...) RECORD_FIELD(struct record_estimate, __VA_ARGS__)
const struct record_field record_estimate_fields[] = {FIELD(COUNT, "scans", estimate.count, ALWAYS),
                                                      FIELD(FLAG, "geometric", estimate.logarithmic, JSON),
                                                      FIELD(NUMBER, "effective", estimate.effective, CSV),
                                                      FIELD(NUMBER, "mean", value, ALWAYS),
                                                      FIELD(NUMBER, "standard_deviation", estimate.sd, ALWAYS),
                                                      FIELD(NUMBER, "standard_error", estimate.s, JSON),
                                                      FIELD(NUMBER, "degrees_of_freedom", estimate.degrees, JSON),
                                                      FIELD(NUMBER, "effective", estimate.effective, JSON),
                                                      FIELD(PAIR, "mean_95", mean_95, JSON),
                                                      FIELD(PAIR, "next_scan_95", next_95, JSON),
                                                      FIELD(NUMBER, "mean_low_95", mean_95[0], CSV),
                                                      FIELD(NUMBER, "mean_high_95", mean_95[1], CSV),
                                                      FIELD(NUMBER, "next_scan_low_95", next_95[0], CSV),
                                                      FIELD(NUMBER, "next_scan_high_95", next_95[1], CSV),
                                                      {0}};

struct record_estimate record_estimate(const struct estimate *estimate)
{
    return (struct record_estimate){.estimate = *estimate,
                                    .value = estimate_value(estimate),
                                    .mean_95 = {estimate_end(estimate, 0), estimate_end(estimate, 1)},
                                    .next_95 = {estimate_next_end(estimate, 0), estimate_next_end(estimate, 1)}};
}

json_t *record_estimate_json(const struct estimate *estimate)
{
    const struct record_estimate record = record_estimate(estimate);
    return record_json(record_estimate_fields, &record);
}
