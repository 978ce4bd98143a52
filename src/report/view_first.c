/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first page: the answer to what was asked, what stands beside it, and what limits it. */
#include "report/view.h"

#include "answers/direct_study.h"
#include "answers/shaped.h"
#include "base/number_format.h"
#include "certainty/sensitivity.h"
#include "results/accuracy.h"
#include <math.h>

enum { DIGITS = 2, NAMED_MOST = 3 };

static const struct answer *answer_to(const struct view_source *source, size_t target, size_t surface, size_t m)
{
    return &view_summary(source, surface)->answers[target * model_count + m];
}

/** May the first page print a model's number at this load: of the textbook none where its law does not hold. */
static bool textbook_holds(const struct view_source *source, size_t surface, size_t m, double load)
{
    return !model_rows[m]->textbook || curve_summary_is_valid(surface_model(view_summary(source, surface), m), load);
}

/** To the target that the first page is about. */
static const struct answer *answer_of(const struct view_source *source, size_t surface, size_t m)
{
    static const struct answer none = {.kind = ANSWER_NONE, .load = NAN, .low = NAN, .high = NAN};
    const struct answer *answer =
        answer_to(source, (size_t)(source->asked.target - source->results->scene->targets), surface, m);
    return textbook_holds(source, surface, m, answer->load) ? answer : &none;
}

/** The asked quantity of a model where the summary stands, as shown. */
static double value_of(const struct view_source *source, size_t m, size_t surface)
{
    const struct contact_point at = comparison_middle(source->results, m, surface);
    if (!textbook_holds(source, surface, m, results_operating_load(source->results, surface)))
        return NAN;
    return asked_shown(&source->asked, at.value[source->asked.quantity]);
}

/** What a surface is ranked by here: the load that the target takes, else the answer itself; less is better. */
static double cost_of(const struct view_source *source, size_t surface)
{
    if (source->asked.target) {
        const struct answer *answer = answer_of(source, surface, source->leading);
        bool met = answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST;
        return met ? answer->load * asked_load_of(source->results, surface).scale : INFINITY;
    }
    double value = value_of(source, source->leading, surface);
    return isnan(value) ? INFINITY : source->asked.more_is_better ? -value : value;
}

/** Does a filler's bond line keep the metals apart at the operating load? */
static bool nothing_touches(const struct view_source *source, size_t surface)
{
    return comparison_middle(source->results, source->leading, surface).value[QUANTITY_AREA] == 0;
}

/** One surface's answer to the target: flags say how the load is to be read. */
static void put_answer(json_t *out, const struct view_source *source, const struct answer *answer, size_t surface)
{
    double scale = asked_load_of(source->results, surface).scale;
    bool met = answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST;
    view_text(out, "surface", view_name(source, surface));
    view_flag(out, "met", met);
    view_flag(out, "at_most", answer->kind == ANSWER_LIGHTEST || (met && answer->full));
    view_flag(out, "not_reached", answer->kind == ANSWER_NOT_REACHED);
    view_flag(out, "no_number", answer->kind == ANSWER_NONE);
    view_flag(out, "held", answer->kind == ANSWER_NONE && answer->held);
    if (answer->kind != ANSWER_NONE)
        view_load(out, "load", source, surface, answer->load);
    view_interval(out, "interval", answer->low * scale, answer->high * scale, DIGITS);
    view_flag(out, "beyond", met && answer->wider && isnan(answer->low) && isnan(answer->high));
}

static void put_value(json_t *out, const struct view_source *source, size_t surface)
{
    double ends[2], value = value_of(source, source->leading, surface);
    view_text(out, "surface", view_name(source, surface));
    asked_interval(ends, &source->asked, source->results, source->leading, surface);
    view_number(out, "value", value, 3, source->asked.unit);
    view_flag(out, "no_number", !isfinite(value));
    view_flag(out, "held", !isfinite(value) && nothing_touches(source, surface));
    const struct model_row *row = model_rows[source->leading];
    const struct material_pair *pair = results_pair(source->results, surface);
    double pressure_Pa = material_pair_pressure(pair, results_operating_load(source->results, surface));
    if (!isfinite(value) && row->plastic && pressure_Pa >= pair->hardness_Pa)
        view_number(out, "exceeded_hardness", pair->hardness_Pa * 1e-6, 3, "MPa");
    else if (!isfinite(value) && !nothing_touches(source, surface) && row->ends &&
             (!row->uses_strip || view_summary(source, surface)->has_strips))
        view_number(out, "ends_at_percent", 100 * row->largest_area, 2, "");
    view_interval(out, "interval", ends[0], ends[1], DIGITS);
}

/** The surfaces that the first sentence names, the best first: all of three, else the best and the worst. */
static void put_answers(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    size_t named[NAMED_MOST], count = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        size_t i = results->by_roughness[k], at = count;
        if (count == 2 && results->usable_count > NAMED_MOST) {
            size_t place = cost_of(source, i) >= cost_of(source, named[1]);
            if (place == 1 || cost_of(source, i) < cost_of(source, named[0]))
                named[place] = i;
            continue;
        }
        for (count++; at > 0 && cost_of(source, i) < cost_of(source, named[at - 1]); at--)
            named[at] = named[at - 1];
        named[at] = i;
    }
    json_t *list = view_list(out, "answers");
    for (size_t i = 0; i < count; i++) {
        json_t *item = view_item(list);
        if (source->asked.target)
            put_answer(item, source, answer_of(source, named[i], source->leading), named[i]);
        else
            put_value(item, source, named[i]);
    }
    view_separate(list);
}

/** The spots that the answers rest on, where they are too few for statistics: the model's that counts them at the load
 * that the target takes, else those of the joint where the summary stands. */
static void put_spots(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    size_t count = 0, last = 0;
    double least = INFINITY, most = -INFINITY;
    for (size_t k = 0; k < results->usable_count; k++) {
        size_t i = results->by_roughness[k];
        double per_m2 = source->asked.target
                            ? answer_of(source, i, source->leading)->spots_per_m2
                            : comparison_middle(results, source->leading, i).value[QUANTITY_SPOT_DENSITY];
        double spots = per_m2 * results->scene->nominal_area_m2;
        if (!(spots < answers_least_spots))
            continue;
        least = fmin(least, spots);
        most = fmax(most, spots);
        last = i;
        count++;
    }
    view_counted(out, "few_spots", count, view_name(source, last));
    json_t *item = json_object_get(out, "few_spots");
    if (count == 0)
        return;
    view_flag(item, "under_one", most < 1);
    view_flag(item, "up_to", least < 1); /* how far below one says nothing */
    view_range(item, "spots", least < 1 ? most : least, most, DIGITS, "");
    view_flag(item, "some", count < results->usable_count);
}

/** The other targets: the surface that each takes the least load on. */
static void put_other_targets(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    for (size_t t = 0; t < results->scene->target_count; t++) {
        const struct scene_asked *target = &results->scene->targets[t];
        char text[UNIT_LENGTH + 20];
        double least = INFINITY;
        size_t best = results->by_roughness[0];
        if (target == source->asked.target)
            continue;
        for (size_t k = 0; k < results->usable_count; k++) {
            size_t i = results->by_roughness[k];
            const struct answer *answer = answer_to(source, t, i, source->leading);
            double load = answer->load * asked_load_of(results, i).scale;
            if ((answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST) && load < least) {
                least = load;
                best = i;
            }
        }
        json_t *item = view_item(view_list(out, "other_targets"));
        asked_text(text, sizeof text, target->text);
        view_text(item, "symbol", target->symbol);
        view_text(item, "text", text);
        put_answer(item, source, answer_to(source, t, best, source->leading), best);
    }
}

/** What a quantity is called. */
static const char *name_of(const struct view_source *source, enum quantity quantity)
{
    char name[80];
    snprintf(name, sizeof name, "asked.%s", quantity_rows[quantity].name);
    return words_say(source->words, "%s", quantity == source->asked.quantity ? source->asked.name : name);
}

/** Do the surfaces that have a number have the same, to what the run resolves? */
static bool are_alike(const struct view_source *source, enum quantity quantity)
{
    const struct comparison_extent *extent = &source->comparison->extremes[quantity];
    return extent->count > 1 && extent->most - extent->least <= 2 * source->results->scene->tolerance * extent->least;
}

/** Is the area load over hardness on all surfaces, and the same? */
static bool area_is_pressed(const struct view_source *source)
{
    double first = NAN;
    for (size_t k = 0; k < source->results->usable_count; k++) {
        size_t surface = source->results->by_roughness[k];
        const struct contact_point at = comparison_middle(source->results, source->leading, surface);
        const struct material_pair *pair = results_pair(source->results, surface);
        double ratio = material_pair_pressure(pair, at.value[QUANTITY_LOAD]) / pair->hardness_Pa;
        first = k == 0 ? ratio : first;
        if (!model_area_is_pressed(model_rows[source->leading], &at, ratio) || fabs(ratio / first - 1) > 1e-9)
            return false;
    }
    return true;
}

/** Most over least of a model's answers in order of roughness; *rises: each is above the one before. 0: one has none.
 */
static double spread_of(const struct view_source *source, size_t m, bool *rises)
{
    double least = INFINITY, most = 0, before = -INFINITY;
    *rises = true;
    for (size_t k = 0; k < source->results->usable_count; k++) {
        double value = value_of(source, m, source->results->by_roughness[k]);
        if (!(value > 0 && isfinite(value)))
            return 0;
        *rises = *rises && value > before * (1 + source->results->scene->tolerance);
        least = fmin(least, value);
        most = fmax(most, value);
        before = value;
    }
    return most / least;
}

/** A model's answers from the smoothest surface to the roughest: all of four, else the two ends. */
static void put_in_order(json_t *item, const struct view_source *source, size_t m)
{
    struct text text = {0};
    const size_t count = source->results->usable_count;
    const size_t step = count > 4 ? count - 1 : 1;
    for (size_t k = 0; k < count; k += step) {
        text_add(&text, k == 0 ? "" : count > 4 ? "\u00a0…\u00a0" : ", ");
        number_format(&text, value_of(source, m, source->results->by_roughness[k]), 3);
    }
    text_add(&text, source->asked.unit[0] ? "\u00a0%s" : "%s", source->asked.unit);
    view_text(item, "values", text_string(&text));
    text_free(&text);
}

/** Is the roughest surface rougher than the smoothest one by more than chance: the mean square of w longest waves has
 * the relative standard deviation 1/sqrt(w), so ln Rq half of it; two of them? */
static bool differ_in_roughness(const struct results *results)
{
    const size_t ends[] = {results->by_roughness[0], results->by_roughness[results->usable_count - 1]};
    double ln_rq[2], variance = 0;
    for (int k = 0; k < 2; k++) {
        const struct surface_summary *summary = &results->surfaces[ends[k]].summary;
        ln_rq[k] = log(summary->roughness.rq_m);
        variance += 0.25 / (fmax(summary->longest_waves, 1) * fmax(summary->independent, 1));
    }
    return ln_rq[1] - ln_rq[0] > 2 * sqrt(variance);
}

/** Where all models of the thesis run: by which the answer rises from the smoothest surface to the roughest, and by how
 * much by the one that spreads it most, and by the leading one. */
static void put_by_roughness(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    bool rises, all = results->usable_count > 1 && differ_in_roughness(results);
    size_t widest = model_count;
    double most = 0;
    for (size_t m = 0; m < model_count; m++)
        all = all && (model_rows[m]->thesis_place == 0 || plan_runs_model(results->plan, m));
    if (!all)
        return;
    for (size_t m = 0; m < model_count; m++)
        if (model_rows[m]->thesis_place > 0 && model_rows[m]->plastic == model_rows[source->leading]->plastic &&
            spread_of(source, m, &rises) > most && rises) {
            most = spread_of(source, m, &rises);
            widest = m;
        }
    json_t *item = view_part(out, "by_roughness"), *rising = view_list(item, "rising"),
           *others = view_list(item, "others");
    for (size_t m = 0; m < model_count; m++)
        if ((model_rows[m]->thesis_place > 0 || m == source->leading) && spread_of(source, m, &rises) > 0) {
            json_t *row = view_item(rises ? rising : others);
            view_text(row, "label", model_rows[m]->label);
            if (m == widest || m == source->leading)
                put_in_order(row, source, m);
        }
    view_flag(item, "has_rising", json_array_size(rising) > 0);
    view_flag(item, "steps", results->usable_count > 2);
    view_separate(rising);
    view_separate(others);
}

/** What `accuracy` chose, and whether it is as good as that. */
static void put_chosen(json_t *out, const struct view_source *source)
{
    const struct scene *scene = source->results->scene;
    if (!(scene->chosen_rms > 0))
        return;
    json_t *item = view_part(out, "chosen");
    view_number(item, "percent", 100 * scene->accuracy, DIGITS, "");
    view_number(item, "factor", exp(scene->chosen_rms), DIGITS, "");
    view_flag(item, "met", expm1(scene->chosen_rms) <= scene->accuracy);
    view_flag(item, "one_scan", scene->one_scan);
    double few_waves = 0;
    for (size_t k = 0; k < source->results->usable_count; k++)
        few_waves = fmax(few_waves, accuracy_few_waves_sd(source->results, source->results->by_roughness[k]));
    if (few_waves > log(1.05))
        view_number(item, "in_all", exp(hypot(scene->chosen_rms, few_waves)), DIGITS, "");
}

/** The surfaces that have no place in the ranking: some by name, the others counted. */
static void put_untested(json_t *out, const struct view_source *source)
{
    const struct comparison_ranking *ranking = &source->comparison->ranking;
    size_t count = 0;
    for (size_t i = 0; i < source->results->surface_count; i++) {
        size_t place = 0;
        while (place < ranking->count && ranking->surface[place] != i)
            place++;
        if (place < ranking->count || !view_summary(source, i)->usable)
            continue;
        if (count++ < NAMED_MOST)
            view_text(view_item(view_list(out, "not_tested")), "surface", view_name(source, i));
    }
    view_separate(json_object_get(out, "not_tested"));
    if (count > NAMED_MOST)
        view_count(out, "more_not_tested", count - NAMED_MOST);
}

/** How the surfaces compare where the summary stands: alike in what is asked, else in what they are ranked by, else by
 * the ranking's test. */
static void put_ranking(json_t *out, const struct view_source *source)
{
    const struct comparison_ranking *ranking = &source->comparison->ranking;
    const struct comparison_extent *extremes = source->comparison->extremes;
    const enum quantity asked = source->asked.quantity;
    bool pressed = asked == QUANTITY_AREA && area_is_pressed(source), alike = pressed || are_alike(source, asked);
    const enum quantity quantity = alike ? asked : ranking->criterion;
    alike = alike || are_alike(source, quantity);
    size_t like = 0, next = 1, usable = source->results->usable_count;
    if (usable < 2 || extremes[quantity].count < 2)
        return;
    json_t *item = view_part(out, "ranking");
    view_text(item, "symbol", name_of(source, quantity));
    view_flag(item, "bare", quantity == QUANTITY_ECR && asked == QUANTITY_JOINT_ECR);
    view_flag(item, "alike", alike);
    view_flag(item, "area_is_load_over_hardness", pressed);
    if (alike && extremes[quantity].count < usable)
        view_count(item, "with_value", extremes[quantity].count);
    if (!alike && extremes[quantity].count > COMPARISON_RANKED_MOST)
        view_count(item, "too_many", COMPARISON_RANKED_MOST);
    else
        view_flag(item, "untested", !alike && ranking->count < 2);
    if (ranking->count < 2 || alike)
        return;
    for (size_t j = 1; j < ranking->count; j++) { /* the first that is alike, else the one told apart least clearly */
        const struct comparison_pair *pair = comparison_pair_of(ranking, 0, j);
        if (!comparison_told_apart(pair))
            next = like++ == 0 ? j : next;
        else if (like == 0 && pair->p > comparison_pair_of(ranking, 0, next)->p)
            next = j;
    }
    view_text(item, "best", view_name(source, ranking->surface[0]));
    view_text(item, "next", view_name(source, ranking->surface[next]));
    view_flag(item, "two", ranking->count == 2);
    view_flag(item, "all_tested", ranking->count == usable);
    view_flag(item, "significant", like == 0);
    view_flag(item, "undecided", like > 0);
    if (like > 1)
        view_count(item, "others", like - 1);
    char p[40];
    double least_clear = comparison_pair_of(ranking, 0, next)->p;
    snprintf(p, sizeof p, least_clear < 1e-4 ? "p < 0.0001" : "p = %.2g", least_clear);
    view_text(item, "p", p);
    put_untested(item, source);
}

/** "half", "twice", "0.7 times". */
static void put_ratio(json_t *out, const struct view_source *source, const char *name, double ratio)
{
    static const struct {
        double ratio;
        const char *word;
    } words[] = {
        {0.25, "ratio.quarter"}, {1 / 3.0, "ratio.third"}, {0.5, "ratio.half"}, {2, "ratio.twice"}, {3, "ratio.three"}};
    const char *word = "ratio.times";
    if (!(ratio > 0) || !isfinite(ratio))
        return;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (fabs(log(ratio / words[i].ratio)) < 0.13)
            word = words[i].word;
    view_text(out, name, words_say(source->words, "%s\nnumber %.2g", word, ratio));
    view_flag(out, "alike", fabs(ratio - 1) < 0.1);
}

/** Where the branches of a measurement pass a value, straight in the logarithms, on average over the runs that do; of
 * how many where not all do. */
static void put_meeting(json_t *out, const struct view_source *source, size_t surface, bool falls, double target)
{
    const struct measured *measured = results_measured(source->results, surface);
    const double *load = measured->load, *value = measured->resistance;
    double sum = 0;
    size_t count = 0, branches = 0;
    for (size_t r = 0; r < measured->run_count; r++) {
        const struct measured_run *run = &measured->runs[r];
        size_t i = falls ? run->turn : run->first, last = falls ? run->end - 1 : run->turn;
        branches += i < last;
        while (i < last && ((value[i] - target) * (value[i + 1] - target) > 0 || value[i] == value[i + 1]))
            i++;
        if (i == last)
            continue;
        sum += log(load[i]) + log(load[i + 1] / load[i]) * log(target / value[i]) / log(value[i + 1] / value[i]);
        count++;
    }
    if (count == 0)
        return;
    json_t *item = view_part(out, falls ? "unloading" : "loading");
    view_load(item, "load", source, surface, exp(sum / (double)count));
    if (count < branches) {
        view_count(item, "runs", count);
        view_count(item, "of_runs", branches);
    }
}

/** Is a measured load beyond those that the models ran at? */
static bool reaches_past(const struct measured *measured, const struct results *results, size_t surface)
{
    const double *loads = results_loads(results, surface);
    for (size_t i = 0; i < measured->count; i++)
        if (measured->load[i] < loads[0] || measured->load[i] > loads[results->load_count - 1])
            return true;
    return false;
}

/** Where the measurement on a surface meets the target, and how the leading model fares against it. */
static void put_measured_on(json_t *item, const struct view_source *source, size_t surface)
{
    const struct measured *measured = results_measured(source->results, surface);
    const struct measured_answers *answers = &source->results->answers[surface];
    const struct scene_asked *target = source->asked.target;
    const double times = exp(answers->fit.half_width);
    if (view_summary(source, surface)->scene->measured.files.count > 0 || source->results->usable_count > 1)
        view_text(item, "of", view_name(source, surface));
    if (target && source->asked.quantity == results_measured_quantity(source->results)) {
        put_meeting(item, source, surface, false, target->value);
        put_meeting(item, source, surface, true, target->value);
    }
    view_flag(item, "reaches", json_object_get(item, "loading") || json_object_get(item, "unloading"));
    view_flag(item, "both", json_object_get(item, "loading") && json_object_get(item, "unloading"));
    struct measured_distance distance = measured_compare(measured, answers, source->leading);
    view_flag(item, "beyond", distance.points == 0);
    view_flag(item, "wider", distance.points == 0 && reaches_past(measured, source->results, surface));
    put_ratio(item, source, "ratio", pow(10, distance.bias_decades));
    view_number(item, "carries", estimate_value(&answers->fit), DIGITS, "");
    view_number(item, "carries_times", times >= 1.005 ? times : NAN, times < 1.095 ? 3 : DIGITS, "");
    view_flag(item, "carried", answers->carried);
}

/** What handbooks say, and the direct solution, of the baseline. */
static void put_beside(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    size_t textbook = asked_textbook(results), baseline = results->baseline;
    if (textbook < model_count && textbook != source->leading) {
        json_t *item = view_part(out, "textbook");
        view_text(item, "label", model_rows[textbook]->label);
        if (source->asked.target)
            put_answer(item, source, answer_of(source, baseline, textbook), baseline);
        else
            view_number(item, "value", value_of(source, textbook, baseline), 3, source->asked.unit);
    }
    enum quantity quantity =
        quantity_rows[source->asked.quantity].from ? results_criterion(results) : source->asked.quantity;
    const struct asked_solved solved = asked_direct(results, quantity, results_operating_load(results, baseline));
    if (solved.value > 0 && !nothing_touches(source, baseline)) {
        json_t *item = view_part(out, "direct_answer");
        bool own = quantity == source->asked.quantity,
             bare = quantity == QUANTITY_ECR && source->asked.quantity == QUANTITY_JOINT_ECR;
        view_number(item, "value", own || bare ? asked_shown(&source->asked, solved.value) : solved.value, 3,
                    own || bare ? source->asked.unit : quantity_rows[quantity].unit);
        put_ratio(item, source, "ratio", own && source->asked.reciprocal ? 1 / solved.ratio : solved.ratio);
        view_flag(item, "bare", bare);
        if (!own && !bare)
            view_text(item, "symbol", name_of(source, quantity));
        view_text(item, "surface", view_name(source, baseline));
        view_load(item, "load", source, baseline, solved.load);
    }
}

/* ---- What limits the answer ---- */

/* As flags of the view name them. */
static const char *const limit_names[] = {"scanned", "model", "lay", "length", "spacing", "hardness"};
enum { SCANNED, MODEL, LAY, LENGTH, SPACING, HARDNESS, LIMITS, LIMITS_SAID = 3 };

struct limit {
    const char *name;
    double factor; /* 1 and up */
};

/** What is known of the asked quantity of a surface. */
static const struct estimate *known_of(const struct view_source *source, size_t surface)
{
    return curve_summary_estimate(surface_model(view_summary(source, surface), source->leading),
                                  (int)source->asked.quantity);
}

static double of_scanned(const struct view_source *source, size_t surface)
{
    const struct estimate *known = known_of(source, surface);
    return estimate_has_width(known, known->half_width) ? exp(known->half_width) : NAN;
}

/** By how much the asked quantity changes where area, gap and ECR do so by these factors (NaN: not known): film and
 * plating are by the area, the heat in the gaps stays, and so does the way to the spots. */
static double change_of(const struct view_source *source, size_t surface, double area, double gap, double ecr)
{
    const double factors[FOLLOWS_COUNT] = {NAN, area, gap, ecr};
    const struct contact_point at = comparison_middle(source->results, source->leading, surface);
    double spots = 1 / (at.value[QUANTITY_TCR] * at.value[QUANTITY_JOINT]);
    double bare = at.value[QUANTITY_ECR] / at.value[QUANTITY_JOINT_ECR];
    enum quantity asked = source->asked.quantity;
    double heat = isfinite(spots) ? spots / ecr + 1 - spots : 1 / ecr;
    double current = isfinite(bare) ? bare * ecr + (1 - bare) / area : ecr;
    const struct joint_shape *shapes = source->results->surfaces[surface].shapes,
                             *shape = shapes ? &shapes[source->leading] : NULL;
    double load = at.value[QUANTITY_LOAD];
    return asked == QUANTITY_JOINT         ? heat
           : asked == QUANTITY_JOINT_ECR   ? current
           : asked == QUANTITY_SHAPE_JOINT ? 1 / joint_shape_change(shape, load, JOINT_HEAT, 1 / heat)
           : asked == QUANTITY_SHAPE_ECR   ? joint_shape_change(shape, load, JOINT_CURRENT, current)
                                           : factors[quantity_rows[asked].follows];
}

/** The direct solution where there is one, else 95 % of what the model says of itself, else the one that stands beside
 * the leading one, else the farthest valid one of its material law. */
static double of_model(const struct view_source *source, size_t surface)
{
    const struct results *results = source->results;
    const struct model_row *row = model_rows[source->leading];
    enum quantity quantity = source->asked.quantity;
    const struct contact_point own = comparison_middle(results, source->leading, surface);
    double factor = NAN, load = results_operating_load(results, surface);
    const struct estimate *known = known_of(source, surface);
    double direct = asked_direct(results, quantity, load).ratio;
    if (!isfinite(own.value[quantity]))
        return NAN;
    if (surface == results->baseline && direct > 0)
        return direct;
    if (known->count > 0 && model_sd(row, QUANTITY_AREA) > 0)
        return exp(1.96 * known->model_sd);
    if (model_sd(row, QUANTITY_AREA) > 0)
        return change_of(source, surface, exp(-1.96 * model_sd(row, QUANTITY_AREA)),
                         exp(1.96 * model_sd(row, QUANTITY_SEPARATION)), exp(1.96 * model_sd(row, QUANTITY_ECR)));
    size_t beside = model_index(row->gaussian);
    bool alone = plan_runs_model(results->plan, beside);
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point at = comparison_middle(results, m, surface);
        double ratio = at.value[quantity] / own.value[quantity];
        if (m == source->leading || (alone && m != beside) || model_rows[m]->plastic != row->plastic || !(ratio > 0) ||
            !isfinite(ratio) || !curve_summary_is_valid(surface_model(view_summary(source, surface), m), load))
            continue;
        if (!(fabs(log(ratio)) <= fabs(log(factor))))
            factor = ratio;
    }
    return factor;
}

/** Where none is known, scans across a perfect one. */
static double of_lay(const struct view_source *source, size_t surface)
{
    const struct surface_summary *summary = view_summary(source, surface);
    const double *lay = summary->perfect_lay;
    return !summary->has_lay && lay[0] > 0 ? change_of(source, surface, lay[0], NAN, lay[1]) : NAN;
}

static double of_change(const struct view_source *source, size_t surface, enum sensitivity_change change)
{
    const struct curve_summary *model = surface_model(view_summary(source, surface), source->leading);
    const struct sensitivity_factors *factors = &model->sensitivity;
    if (!model->exists || (sensitivity_changes[change].plastic && !model_rows[source->leading]->plastic))
        return NAN;
    return change_of(source, surface, factors->area[change], NAN, factors->ecr[change]);
}

/** The factor by which a limit may change the answer, the farthest from 1 over all usable surfaces. */
static double farthest(const struct view_source *source, int limit)
{
    double most = NAN;
    for (size_t k = 0; k < source->results->usable_count; k++) {
        size_t surface = source->results->by_roughness[k];
        double own = limit == SCANNED   ? of_scanned(source, surface)
                     : limit == MODEL   ? of_model(source, surface)
                     : limit == LAY     ? of_lay(source, surface)
                     : limit == LENGTH  ? of_change(source, surface, SENSITIVITY_SCAN_HALVED)
                     : limit == SPACING ? of_change(source, surface, SENSITIVITY_CUTOFF_DOUBLED)
                                        : of_change(source, surface, SENSITIVITY_HARDNESS_RAISED);
        own = own > 0 && own < 1 ? 1 / own : own;
        if (isfinite(own) && !(own <= most))
            most = own;
    }
    return most;
}

/** Those that change the answer most, and what a longer or finer scan would do. */
static void put_limits(json_t *out, const struct view_source *source, bool few_waves)
{
    struct limit limits[LIMITS] = {{NULL, 0}};
    size_t count = 0;
    json_t *list = view_list(out, "limits");
    for (int r = 0; r < LIMITS; r++) {
        struct limit limit = {limit_names[r], farthest(source, r)};
        char key[40];
        snprintf(key, sizeof key, "%s_factor", limit.name);
        view_number(out, key, limit.factor, DIGITS, "");
        if (!(limit.factor >= (r == LENGTH && few_waves ? 2 : 1.05))) /* "×÷ 1.0" says nothing; few waves say 2 */
            continue;
        size_t at = count++;
        for (; at > 0 && limit.factor > limits[at - 1].factor; at--)
            limits[at] = limits[at - 1];
        limits[at] = limit;
    }
    for (size_t i = 0; i < count && i < LIMITS_SAID; i++) {
        json_t *item = view_item(list);
        view_flag(item, limits[i].name, true);
        view_number(item, "factor", limits[i].factor, DIGITS, "");
    }
    view_separate(list);
}

/** What the parts' shape may do where the scene does not say how flat they are: on the baseline. */
static void put_flatness(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    const struct surface_record *record = source->baseline;
    const enum quantity asked = source->asked.quantity;
    const int way = asked == QUANTITY_ECR || asked == QUANTITY_JOINT_ECR ? JOINT_CURRENT : JOINT_HEAT;
    const struct joint_task joint = {&results->scene->joint, &record->summary.pair,
                                     .nominal_area_m2 = results->scene->nominal_area_m2,
                                     .effects = results->plan->running};
    if (plan_runs(results->plan, EFFECT_SHAPE) || !(joint.nominal_area_m2 > 0) || record->summary.pair.unknown ||
        !record->curves || !record->curves[source->leading].exists ||
        (way == JOINT_HEAT && asked != QUANTITY_TCR && asked != QUANTITY_JOINT))
        return;
    const double factor = shaped_usual_factor(&record->curves[source->leading], model_rows[source->leading], &joint,
                                              results_operating_load(results, results->baseline), way);
    if (!(factor >= 1.05))
        return;
    json_t *item = view_part(out, "flatness");
    const double side_m = sqrt(joint.nominal_area_m2);
    view_number(item, "factor", factor, DIGITS, "");
    view_number(item, "bulge", shaped_usual_flatness * side_m * 1e6, DIGITS, "µm");
    view_number(item, "over", side_m * 1e3, DIGITS, "mm");
    view_flag(item, "current", way == JOINT_CURRENT);
}

/* ---- The table ---- */

/** A verdict's name as a flag of the view. */
static const char *verdict_flag(int verdict)
{
    return verdict == LIMIT_NO_VALUE ? "no_value" : limit_verdict_words[verdict];
}

/** Of several limits the worst verdict counts. */
static enum limit_verdict worst_verdict(const struct view_source *source, size_t surface)
{
    static const int order[] = {[LIMIT_MET] = 0, [LIMIT_NO_VALUE] = 1, [LIMIT_UNDECIDED] = 2, [LIMIT_MISSED] = 3};
    enum limit_verdict worst = LIMIT_MET;
    for (size_t l = 0; l < source->results->scene->limit_count; l++) {
        enum limit_verdict own = view_summary(source, surface)->limits[l].verdict;
        worst = order[own] > order[worst] ? own : worst;
    }
    return worst;
}

/** A row of the table of all surfaces. */
static void put_row(json_t *row, const struct view_source *source, size_t surface, bool lettered)
{
    const struct comparison_ranking *ranking = &source->comparison->ranking;
    const struct contact_point at = comparison_middle(source->results, source->leading, surface);
    view_text(row, "surface", view_name(source, surface));
    view_number(row, "rq_um", view_summary(source, surface)->roughness.rq_m * 1e6, 3, "");
    view_law(row, &view_summary(source, surface)->power_law);
    view_number(row, "area_percent", 100 * at.value[QUANTITY_AREA], DIGITS, "");
    const struct quantity_unit gap = quantity_unit(QUANTITY_MEAN_GAP);
    const struct estimate *known =
        curve_summary_estimate(surface_model(view_summary(source, surface), source->leading), QUANTITY_MEAN_GAP);
    view_number(row, "gap", gap.scale * at.value[QUANTITY_MEAN_GAP], DIGITS, "");
    view_interval(row, "gap_interval", gap.scale * estimate_end(known, 0), gap.scale * estimate_end(known, 1), DIGITS);
    put_value(view_part(row, "value"), source, surface);
    if (source->asked.target)
        put_answer(view_part(row, "answer"), source, answer_of(source, surface, source->leading), surface);
    if (source->results->scene->limit_count > 0)
        view_flag(row, verdict_flag(worst_verdict(source, surface)), true);
    for (size_t p = 0; lettered && p < ranking->count; p++)
        if (ranking->surface[p] == surface) {
            char letters[RANKING_LETTERS + 1];
            ranking_groups_letters(letters, &ranking->groups, p);
            view_text(row, "letters", letters);
        }
}

static void put_table(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    json_t *rows = view_list(out, "rows");
    bool lettered = json_object_get(json_object_get(out, "ranking"), "best"); /* else there is nothing to tell apart */
    for (size_t i = 0; i < results->surface_count; i++)
        if (results->surfaces[i].summary.usable && json_array_size(rows) < VIEW_ROWS)
            put_row(view_item(rows), source, i, lettered);
    view_flag(out, "has_limits", results->scene->limit_count > 0);
    view_flag(out, "has_letters", lettered);
    view_flag(out, "has_area", !source->asked.target && source->asked.quantity != QUANTITY_AREA);
    view_flag(out, "has_gap",
              results->scene->limit_count == 0 && source->asked.quantity != QUANTITY_MEAN_GAP &&
                  (plan_quantities(results->plan) & QUANTITY_BIT(QUANTITY_MEAN_GAP)));
    if (results->usable_count > VIEW_ROWS)
        view_count(out, "rows_left_out", results->usable_count - VIEW_ROWS);
    view_some(out, "refused_count", results->surface_count - results->usable_count);
}

/** A limit's sentence: how many surfaces meet it. */
static void put_asked_limits(json_t *out, const struct view_source *source)
{
    const struct scene *scene = source->results->scene;
    for (size_t l = 0; l < scene->limit_count; l++) {
        json_t *item = view_item(view_list(out, "asked_limits"));
        size_t counts[LIMIT_UNDECIDED + 1] = {0}, last[LIMIT_UNDECIDED + 1], all = source->results->usable_count;
        char text[2 * UNIT_LENGTH], unit[UNIT_LENGTH + 20];
        asked_text(unit, sizeof unit, scene->limits[l].text);
        snprintf(text, sizeof text, "%s %s", scene->limits[l].is_most ? "≤" : "≥", unit);
        view_text(item, "text", text);
        view_text(item, "symbol", scene->limits[l].symbol);
        for (size_t k = 0; k < all; k++) {
            size_t i = source->results->by_roughness[k];
            enum limit_verdict verdict = view_summary(source, i)->limits[l].verdict;
            counts[verdict]++;
            last[verdict] = i;
        }
        view_flag(item, "all_meet", counts[LIMIT_MET] == all);
        view_flag(item, "one", all == 1);
        for (int v = LIMIT_NO_VALUE; v <= LIMIT_UNDECIDED; v++)
            if (counts[v] > 0 && counts[LIMIT_MET] < all)
                view_counted(view_item(view_list(item, "verdicts")), verdict_flag(v), counts[v],
                             all > 1 ? view_name(source, last[v]) : NULL);
        view_separate(json_object_get(item, "verdicts"));
    }
}

/** Which hardness it took, where there is a plating that may have one: on the baseline. */
static void put_hardness(json_t *out, const struct view_source *source)
{
    const struct joint *joint = &source->results->scene->joint;
    const struct surface_summary *summary = &source->baseline->summary;
    size_t apart = 0;
    if (!(joint->plating_thickness_m > 0) || !plan_runs(source->results->plan, EFFECT_PLASTICITY))
        return;
    json_t *item = view_part(out, "plating_hardness");
    view_number(item, "value", summary->pair.hardness_Pa * 1e-6, 3, "MPa");
    view_number(item, "thickness", joint->plating_thickness_m * 1e6, 3, "µm");
    view_number(item, "indent", summary->indent_m * 1e6, DIGITS, "µm");
    view_text(item, "metal", joint->plating ? joint_plating_names[joint->plating] : "");
    view_flag(item, "of_scene", summary->hardness == SURFACE_HARDNESS_SCENE);
    view_flag(item, "of_plating", summary->hardness == SURFACE_HARDNESS_PLATING);
    view_flag(item, "of_bodies", summary->hardness == SURFACE_HARDNESS_BODIES);
    view_flag(item, "too_thin", summary->indents_through && isfinite(summary->indent_m));
    view_flag(item, "through", summary->indent_m >= joint->plating_thickness_m);
    for (size_t k = 0; k < source->results->usable_count; k++) {
        const struct surface_summary *other = view_summary(source, source->results->by_roughness[k]);
        apart += other->hardness != summary->hardness || other->pair.hardness_Pa != summary->pair.hardness_Pa;
    }
    view_some(item, "apart", apart);
}

/** What of the maps the leading model has not: others stand in the same report, or the count of work was enough for
 * some squares only, or for none. */
static void put_maps(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    size_t maps = 0, squares = 0, all = 0, dear = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *summary = view_summary(source, results->by_roughness[k]);
        maps += summary->has_tiles;
        squares += summary->has_tiles ? summary->squares : 0;
        all += summary->has_tiles ? summary->all_squares : 0;
        dear += !summary->has_tiles && summary->tile_cost > 0;
    }
    if (maps > 0 && maps < results->usable_count && dear == 0)
        view_count(out, "without_map", results->usable_count - maps);
    view_flag(out, "one_without_map", results->usable_count - maps == 1);
    view_some(out, "dear_maps", dear);
    if (dear == 0 && squares < all && model_rows[source->leading]->uses_map) {
        view_count(out, "squares", squares);
        view_count(out, "all_squares", all);
    }
}

void view_first_page(json_t *out, const struct view_source *source)
{
    const struct results *results = source->results;
    const struct asked *asked = &source->asked;
    double load = results_operating_load(results, results->baseline);
    char unit[UNIT_LENGTH + 20];
    view_flag(out, "several", results->usable_count > 1);
    view_flag(out, "has_intervals", results_intervals(results));
    view_text(out, "leading", model_rows[source->leading]->label);
    view_text(out, "baseline", view_name(source, results->baseline));
    view_load(out, "operating_load", source, results->baseline, load);
    json_t *item = view_part(out, "asked");
    view_text(item, "symbol", words_say(source->words, "%s", asked->name));
    view_text(item, "unit", asked->unit);
    if (asked->target) {
        asked_text(unit, sizeof unit, asked->target->text);
        view_text(out, "target", unit);
        view_flag(out, "share", asked->quantity == QUANTITY_AREA);
    }
    const struct asked_load as = asked_load_of(results, results->baseline);
    view_text(out, "load_unit", as.unit[0] ? as.unit : "P/(Aₙ E′)");
    bool film = plan_runs(results->plan, EFFECT_FILM), plating = plan_runs(results->plan, EFFECT_PLATING);
    if (asked->quantity == QUANTITY_JOINT_ECR)
        view_text(out, "layers",
                  words_say(source->words, "layers\n%s\n%s\n%s", film ? "film" : "", plating ? "plating" : "",
                            film && plating ? "both" : ""));
    view_flag(out, "no_material", !results_has_material(results));
    view_flag(out, "no_scene", !results->scene->path);
    put_answers(out, source);
    put_other_targets(out, source);
    put_spots(out, source);
    put_ranking(out, source);
    put_by_roughness(out, source);
    put_chosen(out, source);
    for (size_t i = 0; i < results->surface_count; i++)
        if (results_measured(results, i) && json_array_size(view_list(out, "measured")) < VIEW_ROWS)
            put_measured_on(view_item(view_list(out, "measured")), source, i);
    put_beside(out, source);
    put_hardness(out, source);
    double waves = INFINITY;
    bool in_part = false, touching = false;
    size_t silent = 0, unyielding = 0, last = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        size_t i = results->by_roughness[k];
        const struct surface_summary *summary = view_summary(source, i);
        waves = fmin(waves, summary->longest_waves);
        in_part = in_part || summary->strips_in_part;
        touching = touching || !nothing_touches(source, i);
        if (!summary->pair.unknown && !(summary->pair.hardness_Pa > 0) && ++unyielding)
            last = i;
        if (asked->target && !isfinite(value_of(source, source->leading, i)) && silent++ == 0)
            put_value(view_part(out, "not_at_operating"), source, i);
    }
    if (silent > 1)
        view_count(json_object_get(out, "not_at_operating"), "others", silent - 1);
    view_counted(out, "no_hardness", unyielding, view_name(source, last));
    if (unyielding > 0)
        view_flag(json_object_get(out, "no_hardness"), "some", unyielding < results->usable_count);
    view_flag(out, "strips_in_part", in_part && model_rows[source->leading]->uses_strip);
    bool few_waves =
        touching && waves < SURFACE_LONGEST_WAVES && !model_rows[source->leading]->uses_map; /* which is no scan */
    if (touching)
        put_limits(out, source, few_waves);
    put_flatness(out, source);
    if (few_waves)
        view_number(out, "longest_waves", waves, DIGITS, "");
    put_maps(out, source);
    put_asked_limits(out, source);
    put_table(out, source);
}

/** A value of a limit in its unit. */
static void add_limit_value(struct text *out, const struct scene_asked *limit, const char *before, double value)
{
    text_add(out, "%s", before);
    number_format(out, scene_asked_shown(limit, value), 3);
}

size_t view_limits_of(struct text *out, const struct results *results, bool missed)
{
    size_t count = 0;
    for (size_t i = 0; i < results->surface_count; i++)
        for (size_t l = 0; l < results->scene->limit_count && results->surfaces[i].summary.usable; l++) {
            const struct scene_asked *limit = &results->scene->limits[l];
            const struct limit_check *check = &results->surfaces[i].summary.limits[l];
            bool swapped = limit->is_upper != limit->is_most; /* a reciprocal's ends */
            if (check->verdict == LIMIT_MET || (check->verdict == LIMIT_MISSED) != missed)
                continue;
            text_add(out, "surface '");
            text_add_shown(out, results->surfaces[i].summary.scene->name);
            text_add(out, "' %s the limit %s %s ", missed ? "misses" : "leaves undecided", limit->symbol,
                     limit->is_most ? "≤" : "≥");
            text_add_shown(out, limit->text);
            if (isfinite(check->value))
                add_limit_value(out, limit, ": ", check->value);
            else
                text_add(out, missed ? ": from a lighter load on" : ": no value");
            if (!missed && isfinite(check->low) && isfinite(check->high)) {
                add_limit_value(out, limit, " (95 % ", swapped ? check->high : check->low);
                add_limit_value(out, limit, " to ", swapped ? check->low : check->high);
                text_add(out, ")");
            }
            if (isfinite(check->value)) {
                text_add(out, " ");
                text_add_shown(out, limit->unit_text);
            }
            text_add(out, "\n");
            count++;
        }
    return count;
}
