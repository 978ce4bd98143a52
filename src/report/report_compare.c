/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finished reports side by side, from their results.json. That may be anything: what is not there is NaN or "". */
#include "base/limits.h"
#include "base/number_format.h"
#include "base/words.h"
#include "output/tables.h"
#include "report/report.h"
#include "report/view.h"
#include "results/asked.h"
#include "scene/scene_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct compared {
    json_t *results[REPORTS_COMPARED], *surfaces[REPORTS_COMPARED]; /* these by name */
    size_t count;          /* of those: all; where there are more reports, the first and the one being read */
    size_t reports;        /* read so far */
    struct ranked *ranked; /* the surfaces that have an answer, of all */
    size_t ranked_count;
    enum quantity criterion;        /* what they are ranked by, once ranked_count > 0 */
    size_t values;                  /* that those kept may have, by LIMIT_RESULTS_VALUES */
    size_t items;                   /* of the view, by LIMIT_COMPARED */
    const char *leading;            /* the first one's model */
    double area_m2;                 /* nominal, of all; NaN: not known, or not the same */
    double tie;                     /* relative difference that is none */
    json_t *without;                /* the first surfaces that have no number to be ranked by */
    size_t without_count;           /* of all such */
    json_t *models;                 /* by which the reports are compared, once each */
    bool beside;                    /* few enough to stand side by side */
    bool any, differ, loads_differ; /* any: a number is in two reports; differ: anything */
    bool carried;                   /* a report shows what was measured */
    unsigned wholes;                /* QUANTITY_BITs of the ECR that surfaces are ranked by: of spots, joint, shape */
};

enum { TEXT_MOST = 60, STRING_MOST = 1000, PATH_MOST = 400, MADE = 5, NAMED_MOST = 10 };

static double real(const json_t *value)
{
    return json_is_number(value) ? json_number_value(value) : NAN;
}

static const char *string(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    return json_is_string(value) && json_string_length(value) <= STRING_MOST ? json_string_value(value) : "";
}

static json_t *get(const json_t *object, const char *key, const char *below)
{
    return json_object_get(json_object_get(object, key), below);
}

/** NULL: no model is called so. */
static const struct model_row *model_row_of(const char *name)
{
    size_t m = 0;
    while (m < model_count && strcmp(model_rows[m]->name, name) != 0)
        m++;
    return m < model_count ? model_rows[m] : NULL;
}

static const char *label_of(const char *name)
{
    const struct model_row *row = model_row_of(name);
    return row ? row->label : name;
}

/** The model whose numbers a report is compared by: its own leading one where that is the first report's but for the
 * hardness, else the first's. */
static const char *model_of(const struct compared *all, size_t k)
{
    const char *own = string(all->results[k], "leading");
    const struct model_row *row = model_row_of(own), *first = model_row_of(all->leading);
    bool same = row && first && (row->elastic ? row->elastic : row) == (first->elastic ? first->elastic : first);
    return same ? own : all->leading;
}

/** A number that the reports have of each surface: of its record, else of the models. */
struct number {
    const struct record_field *field; /* NULL: the quantity */
    enum quantity quantity;
};

/** It in a report. */
struct side {
    const char *scans;     /* their hash */
    double pressure_Pa;    /* P/A_n of the report's operating load; P/(A_n E') where no material is known */
    bool elsewhere;        /* the number is not there, but at the other's */
    enum quantity of;      /* of the whole contact as the report has it: flat parts have no shape, bare ones no joint */
    double value, ends[2]; /* of its 95 % interval; NaN: not known */
    struct estimate known; /* of ln value */
};

/** Where among the loads of a curve one lies: in the logarithm, which share of the way from load *before to the next;
 * NaN: beyond them. */
static double place_of(const json_t *loads, double load, size_t *before)
{
    for (*before = 0; *before + 1 < json_array_size(loads); ++*before) {
        double from = real(json_array_get(loads, *before)), to = real(json_array_get(loads, *before + 1));
        if (from <= load * (1 + 1e-9) && load <= to * (1 + 1e-9))
            return log(load / from) / log(to / from);
    }
    return NAN;
}

/** A curve's value there, straight in the logarithms; NaN: none. */
static double on_curve(const json_t *values, size_t before, double share)
{
    double value = real(json_array_get(values, before)), next = real(json_array_get(values, before + 1));
    return value * pow(next / value, share);
}

/** E' of a surface: its own, else the scene's; NaN: no material is known. */
static double modulus_of(const struct compared *all, size_t k, const char *name)
{
    const double own_Pa = real(get(all->surfaces[k], name, "effective_modulus_Pa"));
    return own_Pa > 0 ? own_Pa : real(get(all->results[k], "scene", "effective_modulus_Pa"));
}

/** At the pressure of `reference`; NULL: at its own operating load. */
static struct side side_of(const struct compared *all, size_t k, const char *name, const struct number *number,
                           const struct side *reference)
{
    const json_t *surface = json_object_get(all->surfaces[k], name), *model = get(surface, "models", model_of(all, k));
    const json_t *operating = json_object_get(model, "operating");
    enum quantity quantity = number->quantity;
    while ((quantity == QUANTITY_SHAPE_ECR || quantity == QUANTITY_JOINT_ECR) &&
           !json_object_get(operating, quantity_rows[quantity].name))
        quantity = quantity == QUANTITY_SHAPE_ECR ? QUANTITY_JOINT_ECR : QUANTITY_ECR;
    const double known_Pa = modulus_of(all, k, name), modulus_Pa = known_Pa > 0 ? known_Pa : 1;
    struct contact_point at;
    struct side out = {.scans = string(surface, "sha256"), .of = quantity, .ends = {NAN, NAN}, .known = estimate_none};
    if (number->field) {
        out.value = real(json_object_get(surface, number->field->key));
        return out;
    }
    out.pressure_Pa = real(json_object_get(operating, quantity_rows[QUANTITY_LOAD].name)) * modulus_Pa;
    out.elsewhere = reference && !(fabs(out.pressure_Pa / reference->pressure_Pa - 1) < 1e-9);
    size_t before = 0;
    double share = NAN;
    if (out.elsewhere)
        share = place_of(json_object_get(model, "load_over_AnEp"), reference->pressure_Pa / modulus_Pa, &before);
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        at.value[q] = out.elsewhere ? on_curve(json_object_get(model, quantity_rows[q].name), before, share)
                                    : real(json_object_get(operating, quantity_shown_name(q)));
    bool gap = quantity == QUANTITY_SEPARATION, adjusts = gap && isfinite(at.value[QUANTITY_ADJUSTED]);
    out.value = at.value[adjusts ? QUANTITY_ADJUSTED : quantity];
    out.value /= gap && out.elsewhere ? sqrt(real(json_object_get(surface, "m0_m2"))) : 1;
    const json_t *known = out.elsewhere ? NULL : get(model, "at_middle_load", quantity_shown_name(quantity));
    double s = real(json_object_get(known, "standard_error"));
    double degrees = real(json_object_get(known, "degrees_of_freedom"));
    for (size_t end = 0; end < 2; end++)
        out.ends[end] = real(json_array_get(json_object_get(known, "mean_95"), end));
    if (!json_is_true(json_object_get(known, "geometric")) || !(s >= 0) || !(degrees >= 1))
        return out;
    const size_t scans = real(json_object_get(known, "scans")) > 1 ? 2 : 1; /* several or one, as the test asks */
    out.known = (struct estimate){.count = scans, .mean = log(out.value), .s = s, .degrees = degrees};
    return out;
}

/** A surface in the ranking of all. */
struct ranked {
    json_t *line;
    struct side side;
    double cost;  /* less is better */
    size_t order; /* as given */
};

/** Takes what a report's surfaces are ranked by at the pressure of the very first: ECR of the whole, TCR or area. */
static enum status_code take_ranked(struct compared *all, size_t k, const char *path, struct status *status)
{
    static const enum quantity criteria[] = {QUANTITY_SHAPE_ECR, QUANTITY_TCR, QUANTITY_AREA};
    const char *name;
    json_t *ignored;
    json_object_foreach (all->surfaces[k], name, ignored) {
        struct side side = {.value = NAN};
        bool begun = all->ranked_count > 0;
        for (size_t c = begun ? 2 : 0; !(side.value > 0) && c < 3; c++) {
            all->criterion = begun ? all->criterion : criteria[c];
            side = side_of(all, k, name, &(struct number){.quantity = all->criterion},
                           begun ? &all->ranked[0].side : NULL);
        }
        if (!(side.value > 0) || !isfinite(side.value)) {
            if (all->without_count++ < NAMED_MOST) {
                json_t *line = view_item(all->without);
                json_set_count(line, "report", all->reports);
                view_text(line, "surface", name);
            }
            continue;
        }
        if (all->ranked_count == limit_most(LIMIT_RANKED))
            return status_fail(status, STATUS_SCAN, "too many surfaces%s", limit_words(LIMIT_RANKED).text);
        struct ranked *more = realloc(all->ranked, (all->ranked_count + 1) * sizeof *more);
        if (!more)
            return status_memory(status);
        bool rises = quantity_rows[all->criterion].is & QUANTITY_RISES;
        json_t *line = json_object();
        json_set_count(line, "report", all->reports);
        view_text(line, "path", path);
        view_text(line, "surface", name);
        all->ranked = more;
        all->ranked[all->ranked_count] =
            (struct ranked){line, side, rises ? -side.value : side.value, all->ranked_count};
        all->ranked_count++;
        all->loads_differ = all->loads_differ || side.elsewhere;
        all->wholes |= QUANTITY_BIT(side.of);
    }
    return STATUS_OK;
}

static int best_first(const void *a, const void *b)
{
    const struct ranked *first = a, *second = b;
    int by_cost = (first->cost > second->cost) - (first->cost < second->cost);
    return by_cost ? by_cost : first->order > second->order ? 1 : -1;
}

/** What the reports' numbers of a quantity are shown in: those of the whole contact where the nominal area is one. */
static double shown_in(char unit[UNIT_LENGTH + 20], const struct compared *all, enum quantity quantity, double value)
{
    const struct quantity_row *row = &quantity_rows[quantity];
    char whole[UNIT_LENGTH];
    if (!row->asked[0].total || row->asked[0].reciprocal || !(all->area_m2 > 0)) {
        snprintf(unit, UNIT_LENGTH, "%s", row->handy.unit);
        return row->handy.scale;
    }
    asked_unit(whole, sizeof whole, unit_si(row->asked[0].total));
    return 1 / all->area_m2 / asked_prefix(unit, UNIT_LENGTH + 20, whole, value / all->area_m2);
}

/** A load as the first report's scene has it. */
static void put_load(json_t *out, const struct compared *all, double pressure_Pa)
{
    const json_t *scene = json_object_get(all->results[0], "scene");
    const char *own = string(scene, "load_unit"), *text = own[0] ? own : string(scene, "operating_load_unit");
    char shown[UNIT_LENGTH + 20];
    struct unit unit;
    enum unit_quantity kind = UNIT_NUMBER;
    if (strlen(text) < UNIT_LENGTH && unit_read(&unit, text, strlen(text)))
        kind = (enum unit_quantity)unit_of(&unit, UNIT_LOADS);
    if (kind == UNIT_PRESSURE || (kind == UNIT_FORCE && all->area_m2 > 0)) {
        asked_unit(shown, sizeof shown, text);
        view_number(out, "load", pressure_Pa * (kind == UNIT_FORCE ? all->area_m2 : 1) / unit.factor, 3, shown);
    } else
        view_number(out, "load", pressure_Pa * (all->area_m2 > 0 ? all->area_m2 : 1e-6), 3,
                    all->area_m2 > 0 ? "N" : "MPa");
}

/** A line's value with its interval, in SI and as shown. */
static void put_side(json_t *line, const struct side *side, double scale)
{
    json_t *shown = json_object_get(line, "shown");
    json_set(line, "value", side->value);
    json_set(line, "low_95", side->ends[0]);
    json_set(line, "high_95", side->ends[1]);
    view_number(shown, "value", side->value * scale, 3, "");
    const struct known as = {.kind = KNOWN_VALUE, .value = side->value, .low = side->ends[0], .high = side->ends[1]};
    (void)view_interval(shown, side->ends[0] * scale, side->ends[1] * scale, known_digits(&as), "\u00a0…\u00a0");
}

/** What a test of a line against another found. */
static void put_p(json_t *line, double p)
{
    if (isfinite(p))
        json_set(line, "p", p);
    view_number(json_object_get(line, "shown"), "p", p, 2, "");
}

/** Ranks the surfaces of all reports, by the test that a report has for its own. */
static enum status_code add_ranking(json_t *view, struct compared *all, struct status *status)
{
    char unit[UNIT_LENGTH + 20];
    OWNED(memory_free) const struct estimate **known = malloc((all->ranked_count + 1) * sizeof *known);
    OWNED(comparison_free) struct comparison ranking = {.count = 0};
    json_t *out = view_part(view, "ranking");
    if (!known)
        return status_memory(status);
    qsort(all->ranked, all->ranked_count, sizeof *all->ranked, best_first);
    const double scale = shown_in(unit, all, all->criterion, all->ranked[0].side.value);
    for (size_t i = 0; i < all->ranked_count; i++)
        if (all->ranked[i].side.known.count > 0)
            known[ranking.count++] = &all->ranked[i].side.known;
    if (comparison_test(&ranking, known, status) != STATUS_OK)
        return status->code;
    enum quantity by = all->criterion;
    while (!(all->wholes & QUANTITY_BIT(by))) /* of the whole contact, as far as a report has it */
        by--;
    view_text(out, "quantity", quantity_shown_name(by));
    view_text(out, "symbol", quantity_rows[by].short_symbol);
    view_text(out, "unit", unit);
    view_some(out, "untested", all->ranked_count - ranking.count);
    view_some(out, "too_many", ranking.count > COMPARISON_RANKED_MOST ? COMPARISON_RANKED_MOST : 0);
    for (size_t i = 0, place = 0; i < all->ranked_count; i++) {
        const struct side *side = &all->ranked[i].side;
        json_t *line = all->ranked[i].line, *shown = view_part(line, "shown");
        char letters[RANKING_LETTERS + 1] = "";
        bool tested = side->known.count > 0;
        json_set_count(line, "rank", i + 1);
        put_side(line, side, scale);
        view_number(shown, "ratio", side->value / all->ranked[0].side.value, 3, "");
        if (tested && place > 0) { /* against the best of those tested */
            const struct comparison_pair *pair = comparison_pair_of(&ranking, 0, place);
            put_p(line, pair->p);
            view_flag(line, "worse", comparison_told_apart(pair));
        }
        if (tested && ranking.groups.surfaces > 0)
            ranking_groups_letters(letters, &ranking.groups, place);
        view_text(line, "letters", letters);
        json_array_append(view_list(out, "lines"), line);
        place += tested;
    }
    return STATUS_OK;
}

/** Adds a number of a surface, a line for each report that has it; nothing where only one has, and of the record
 * nothing where all are the same. */
static void add_number(json_t *view, struct compared *all, const char *name, const struct number *number)
{
    const struct record_field *field = number->field;
    char unit[UNIT_LENGTH + 20] = "";
    double scale = 1;
    bool differ = false;
    json_auto_t *lines = json_array();
    struct side first;
    for (size_t k = 0; k < all->count; k++) {
        bool begun = json_array_size(lines) > 0;
        struct side side = side_of(all, k, name, number, begun ? &first : NULL);
        first = begun ? first : side;
        double ratio = side.value / first.value, apart = fabs(ratio - 1);
        if (!(side.value > 0) || !isfinite(ratio))
            continue;
        json_t *line = view_item(lines), *shown = view_part(line, "shown");
        if (!begun && field)
            asked_unit(unit, sizeof unit, field->unit);
        if (!begun)
            scale = field ? 1 / record_unit(field) : shown_in(unit, all, number->quantity, side.value);
        json_set_count(line, "report", k + 1);
        put_side(line, &side, scale);
        if (!begun)
            continue;
        bool same = apart <= all->tie, same_scans = side.scans[0] && strcmp(side.scans, first.scans) == 0;
        struct comparison_pair pair = {.p = NAN};
        if (!same && !same_scans && side.known.count > 0 && first.known.count > 0)
            pair = comparison_of_two(&side.known, &first.known);
        json_set(line, "ratio", ratio);
        view_number(shown, "ratio", same ? 1 : ratio, same ? 3 : (int)fmax(3, 1 - floor(log10(apart))), "");
        put_p(line, pair.p);
        const char *tested = comparison_told_apart(&pair) ? "significant" : "not_significant";
        tested = isnan(pair.p) ? "undecided" : tested;
        view_flag(line, same ? "same" : same_scans ? "same_scans" : tested, true);
        differ = differ || !same;
        all->loads_differ = all->loads_differ || side.elsewhere;
    }
    if (differ || !field)
        all->items += json_array_size(lines);
    if (json_array_size(lines) > 1 && (differ || !field)) {
        const char *key = field ? field->key : quantity_shown_name(number->quantity);
        json_array_append_new(view_list(view, "numbers"),
                              json_pack("{s:s, s:s, s:s, s:O}", "quantity", key, "symbol",
                                        field ? key : quantity_rows[number->quantity].short_symbol, "unit", unit,
                                        "lines", lines));
        all->any = true;
    }
    all->differ = all->differ || differ;
}

/** All keys of the objects, in their order; new. */
static json_t *keys_of(json_t *const *objects, size_t count)
{
    json_t *keys = json_object();
    for (size_t k = 0; k < count; k++)
        json_object_update_missing(keys, objects[k]);
    return keys;
}

/** Lists `key` of `of`, one a report, or what is below it, where it differs; but what is made of the rest. */
static void add_input(json_t *view, struct compared *all, json_t *const *of, const char *path, const char *key)
{
    static const char *const made[MADE] = {"operating_load_over_AnEp", "effective_modulus_Pa", "reason", "source",
                                           "curves"};
    json_t *values[REPORTS_COMPARED], *ignored;
    OWNED(text_free) struct text whole = {0};
    char *dumped[REPORTS_COMPARED] = {NULL};
    const char *below;
    bool objects = true, differ = false;
    if (scene_words_find(string_view_of(key), made, MADE) < MADE || all->items > limit_most(LIMIT_COMPARED))
        return;
    text_add(&whole, "%s%s%.*s", path, path[0] ? "." : "", (int)text_fit(key, PATH_MOST), key);
    for (size_t k = 0; k < all->count; k++) {
        values[k] = json_object_get(of[k], key);
        objects = json_is_object(values[k]) && objects && whole.length < PATH_MOST;
    }
    json_auto_t *keys = keys_of(values, objects ? all->count : 0);
    json_object_foreach (keys, below, ignored) {
        add_input(view, all, values, text_string(&whole), below);
    }
    for (size_t k = 0; k < all->count && !objects; k++) {
        dumped[k] = json_dumps(values[k], JSON_ENCODE_ANY | JSON_COMPACT | JSON_REAL_PRECISION(10));
        differ = differ || strcmp(dumped[k] ? dumped[k] : "", dumped[0] ? dumped[0] : "") != 0;
    }
    json_t *item = differ ? view_item(view_list(view, "inputs")) : NULL;
    for (size_t k = 0; k < all->count && item; k++) {
        json_t *value = view_item(view_list(item, "values"));
        OWNED(text_free) struct text cut = {0};
        words_cut(&cut, dumped[k] ? dumped[k] : "", dumped[k] ? strlen(dumped[k]) : 0,
                  TEXT_MOST); /* of nothing: none */
        json_set_count(value, "report", k + 1);
        view_text(value, "value", text_string(&cut));
    }
    for (size_t k = 0; k < all->count; k++)
        free(dumped[k]);
    view_text(item, "key", text_string(&whole)); /* of NULL nothing is set */
    all->items += item ? all->count : 0;
    all->differ = all->differ || item;
}

static void add_surface(json_t *view, struct compared *all, const char *name)
{
    static const char *const keys[] = {"files",       "sha256",      "units",   "material",
                                       "counterface", "hardness_Pa", "measured"};
    json_t *item = view_item(view_list(view, "surfaces")), *of[REPORTS_COMPARED];
    bool alone = false;
    view_text(item, "surface", name);
    all->items++;
    for (size_t k = 0; k < all->count; k++)
        if (!(of[k] = json_object_get(all->surfaces[k], name))) {
            json_set_count(view_item(view_list(item, "not_in")), "report", k + 1);
            all->differ = alone = true;
            all->items++;
        }
    for (size_t i = 0; i < sizeof keys / sizeof *keys && !alone; i++)
        add_input(view, all, of, name, keys[i]);
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        if (quantity_rows[q].handy.scale > 0 &&
            ((q != QUANTITY_JOINT_ECR && q != QUANTITY_SHAPE_ECR) || (all->wholes & QUANTITY_BIT(q))))
            add_number(item, all, name, &(struct number){.quantity = q});
    for (const struct record_field *field = surface_fields; field->key; field++)
        if (field->digits > 0)
            add_number(item, all, name, &(struct number){.field = field});
}

/** Puts loads that were given as forces or pressures back into newtons: over E' they change with the material. */
static void give_back_loads(json_t *scene, double modulus_Pa)
{
    json_t *loads = json_object_get(scene, "loads_over_AnEp"), *load;
    double scale_N = modulus_Pa * real(json_object_get(scene, "nominal_area_m2"));
    char digits[32];
    size_t i;
    json_array_foreach (loads, i, load) {
        snprintf(digits, sizeof digits, "%.12g", real(load) * scale_N); /* without rounding's last digits */
        json_array_set_new(loads, i, json_finite(strtod(digits, NULL)));
    }
    json_object_set(scene, "loads_N", loads);
    json_object_del(scene, "loads_over_AnEp");
}

/** How many values a results.json has, as LIMIT_RESULTS_VALUES counts them: jansson takes at most 48 bytes for one. */
static size_t count_values(const struct text *json)
{
    size_t count = json->length / 48;
    bool quoted = false;
    for (size_t i = 0; i < json->length; i++) {
        char c = json->data[i];
        count += quoted ? 0 : c == '{' ? 4 : c == '[' ? 2 : c == ',' || c == ':' || c == '"';
        i += quoted && c == '\\';
        quoted ^= c == '"';
    }
    return count;
}

static void add_model(json_t *models, const char *label)
{
    json_auto_t *own = json_object();
    view_text(own, "label", label);
    if (!view_alike(models, NULL, own))
        json_array_append(models, own);
}

/** Puts what targets or limits say, which stands in their answers, into the scene. */
static void put_asked(json_t *results, const char *answers, const char *key, const char *asked)
{
    json_t *texts = json_object(), *answer;
    size_t i;
    json_array_foreach (json_object_get(results, answers), i, answer) {
        json_object_set_new(texts, string(answer, key), json_true());
    }
    json_object_set_new(json_object_get(results, "scene"), asked, texts);
}

/** Leaves of what was measured on a surface only what went in. */
static void keep_measured(struct compared *all, json_t *surface)
{
    const json_t *measured = json_object_get(surface, "measured");
    json_t *kept = json_object();
    all->carried = all->carried || json_is_true(json_object_get(measured, "carried"));
    json_object_set(kept, "files", json_object_get(measured, "files"));
    json_object_set(kept, "values", json_object_get(measured, string(measured, "quantity")));
    json_object_set_new(surface, "measured", kept);
}

static enum status_code add_report(json_t *view, struct compared *all, const char *path, struct status *status)
{
    OWNED(text_free) struct text name = {0}, bytes = {0};
    json_error_t error = {.line = 1};
    json_t *surface, *item = view_item(view_list(view, "reports")), *results = NULL, *surfaces = json_object();
    struct stat info = {0};
    size_t i;
    if (!all->beside && all->count > 1) { /* of many only the first stays */
        json_decref(all->results[--all->count]);
        json_decref(all->surfaces[all->count]);
        all->values = 0;
    }
    text_add(&name, "%s/results.json", path);
    if (stat(text_string(&name), &info) == 0 && (size_t)info.st_size > limit_most(LIMIT_RESULTS_BYTES))
        (void)status_fail(status, STATUS_IO, "'%s' has %zu bytes%s", name.data, (size_t)info.st_size,
                          limit_words(LIMIT_RESULTS_BYTES).text);
    enum status_code rc = status->code == STATUS_OK ? text_read_file(&bytes, text_string(&name), status) : status->code;
    all->values += count_values(&bytes);
    if (rc == STATUS_OK && all->values > limit_most(LIMIT_RESULTS_VALUES))
        rc = status_fail(status, STATUS_IO, "too much to compare in '%s'%s", name.data,
                         limit_words(LIMIT_RESULTS_VALUES).text);
    if (rc == STATUS_OK)
        results = json_loadb(text_string(&bytes), bytes.length, 0, &error);
    if (rc == STATUS_OK && strcmp(string(results, "program"), "roughcontact") != 0)
        rc = status_fail(status, STATUS_IO, "'%s' is damaged, or not of roughcontact (line %d); report again",
                         name.data, results ? 1 : error.line);
    json_array_foreach (json_object_get(results, "surfaces"), i, surface) {
        keep_measured(all, surface);
        json_object_set(surfaces, string(surface, "surface"), surface);
    }
    put_asked(results, "answers", "target", "targets");
    put_asked(results, "limits", "limit", "limits");
    double load = real(get(results, "scene", "operating_load_over_AnEp")), tolerance, area_m2;
    all->results[all->count] = results;
    all->surfaces[all->count] = surfaces;
    const double modulus_Pa = modulus_of(all, all->count++, string(json_object_get(results, "scene"), "baseline"));
    if (get(results, "scene", "load_unit"))
        give_back_loads(json_object_get(results, "scene"), modulus_Pa);
    json_set_count(item, "report", ++all->reports);
    view_text(item, "path", path);
    view_text(item, "leading", string(results, "leading"));
    view_text(item, "label", label_of(string(results, "leading")));
    view_text(item, "version", string(results, "version"));
    all->leading = string(all->results[0], "leading");
    area_m2 = real(get(results, "scene", "nominal_area_m2"));
    all->area_m2 = all->reports == 1 || fabs(area_m2 / all->area_m2 - 1) < 1e-9 ? area_m2 : NAN;
    tolerance = real(get(results, "scene", "tolerance"));
    if (tolerance > 0 && tolerance <= 0.1)
        all->tie = fmax(all->tie, 2 * tolerance); /* each side has its own error */
    json_set(item, "pressure_Pa", load * modulus_Pa);
    if (isnan(modulus_Pa))
        view_number(item, "load", load, 3, "P/(Aₙ E′)");
    add_model(all->models, label_of(model_of(all, all->count - 1)));
    return rc == STATUS_OK ? take_ranked(all, all->count - 1, path, status) : rc;
}

enum status_code report_compare(json_t **out, char *const *paths, size_t count, struct status *status)
{
    struct compared all = {.beside = count <= REPORTS_COMPARED, .tie = 1e-9};
    json_t *view = *out = json_object(), *ignored, *item;
    const char *name;
    size_t i;
    all.models = view_list(view, "models");
    all.without = view_list(view, "without");
    while (all.reports < count && add_report(view, &all, paths[all.reports], status) == STATUS_OK)
        ;
    if (status->code == STATUS_OK && all.beside) {
        add_input(view, &all, all.results, "", "version");
        add_input(view, &all, all.results, "", "leading");
        add_input(view, &all, all.results, "", "scene");
        json_auto_t *names = keys_of(all.surfaces, all.count);
        json_object_foreach (names, name, ignored) {
            if (all.items <= limit_most(LIMIT_COMPARED))
                add_surface(view, &all, name);
        }
        view_flag(view, "nothing_differs", !all.differ);
        view_flag(view, "beside", all.any);
    }
    json_array_foreach (json_object_get(view, "reports"), i, item) {
        if (json_is_number(json_object_get(item, "pressure_Pa")))
            put_load(item, &all, real(json_object_get(item, "pressure_Pa")));
    }
    for (int part = 0; part < 2; part++) /* of more than two reports the ranking comes first */
        view_flag(view_item(view_list(view, "parts")), (part == 0) == (count > 2) ? "of_all" : "side_by_side", true);
    view_flag(view, "beside_few", all.beside);
    view_text(view, "model", all.leading);
    view_text(view, "label", label_of(all.leading));
    view_text(view, "load", string(json_array_get(json_object_get(view, "reports"), 0), "load"));
    view_some(view, "more_without", all.without_count - json_array_size(all.without));
    view_flag(view, "loads_differ", all.loads_differ);
    view_flag(view, "carried", all.carried);
    if (status->code == STATUS_OK && all.items > limit_most(LIMIT_COMPARED))
        (void)status_fail(status, STATUS_SCAN, "too much differs%s", limit_words(LIMIT_COMPARED).text);
    if (status->code == STATUS_OK && all.ranked_count < 2 && !all.any)
        (void)status_fail(status, STATUS_SCAN, "nothing to compare: no two surfaces have a number of '%s'",
                          all.leading);
    if (all.ranked_count < 2) /* none is ranked: their numbers stand side by side */
        json_object_del(view, "without");
    else if (status->code == STATUS_OK)
        (void)add_ranking(view, &all, status);
    while (all.count > 0) {
        json_decref(all.results[--all.count]);
        json_decref(all.surfaces[all.count]);
    }
    while (all.ranked_count > 0)
        json_decref(all.ranked[--all.ranked_count].line);
    free(all.ranked);
    return status->code;
}
