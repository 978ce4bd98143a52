/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What lies in and around the spots: gas or grease in the gaps, a film, a plating, a current. */
#include "report/section.h"

#include "joint/heating.h"
#include <math.h>

static bool runs(const struct section_context *context, enum effect effect)
{
    return plan_runs(context->results->plan, effect);
}

static bool called_for(const struct section_context *context)
{
    return runs(context, EFFECT_GAP) || runs(context, EFFECT_FILM) || runs(context, EFFECT_PLATING) ||
           runs(context, EFFECT_HEATING);
}

/** Numbers of the joint that a model has at the middle load, over all surfaces. */
static size_t numbers_of(const struct section_context *context, size_t m)
{
    size_t count = 0;
    for (size_t i = 0; i < context->results->surface_count; i++) {
        const struct contact_point point = comparison_middle(context->results, m, i);
        for (int q = 0; q < QUANTITY_COUNT; q++)
            count += quantity_rows[q].from && section_surface(context, i)->usable && isfinite(point.value[q]);
    }
    return count;
}

/** The model that the section speaks of: the leading one, unless others have more of these numbers at the middle load;
 * then the one of them that has most, of the greatest precedence. */
static size_t speaking_model(const struct section_context *context)
{
    size_t speaking = plan_leading_model(context->results->plan), most = numbers_of(context, speaking);
    for (size_t m = 0; m < model_count; m++) {
        bool fit =
            plan_runs_model(context->results->plan, m) && !section_is_unfit(context, context->results->baseline, m);
        size_t count = fit ? numbers_of(context, m) : 0;
        if (count > most ||
            (count == most && count > 0 && model_rows[m]->precedence > model_rows[speaking]->precedence)) {
            most = count;
            speaking = m;
        }
    }
    return speaking;
}

/** What model `m` says of a surface at the middle load; all NaN where it says nothing. */
static struct contact_point middle_of(const struct section_context *context, size_t m, size_t index)
{
    return comparison_middle(context->results, m, index);
}

static double gap_share(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return p->value[QUANTITY_GAP] / p->value[QUANTITY_JOINT];
}

static double film_share(const struct contact_point *p, const struct joint *joint)
{
    return joint->film_ohm_m2 / p->value[QUANTITY_AREA] / p->value[QUANTITY_JOINT_ECR];
}

static double plating_of(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return p->value[QUANTITY_PLATING_FACTOR];
}

static double voltage_of(const struct contact_point *p, const struct joint *joint)
{
    (void)joint;
    return p->value[QUANTITY_VOLTAGE];
}

/** The body that yields first, whose metal softens first. */
static const struct material *softer_body(const struct section_context *context, size_t index)
{
    const struct scene_bodies *bodies = section_surface(context, index)->scene->bodies;
    bool other = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
                 bodies->counterface.yield_strength_Pa < bodies->material.yield_strength_Pa;
    return other ? &bodies->counterface : &bodies->material;
}

enum state { STATE_UNKNOWN, STATE_HARD, STATE_SOLID, STATE_SOFT, STATE_MELTED };
static const char *const state_words[] = {"–", "stays hard", "does not melt", "softens", "melts"};

/** What the softer body's metal does at a voltage; of one without a softening voltage only whether it melts. */
static enum state state_at(const struct section_context *context, size_t index, double voltage_V)
{
    const struct heating_metal *metal = heating_metal_find(softer_body(context, index)->name);
    if (!metal || isnan(voltage_V))
        return STATE_UNKNOWN;
    if (voltage_V >= heating_voltage(metal->melting_K, context->results->scene->joint.temperature_K))
        return STATE_MELTED;
    return isnan(metal->softening_voltage_V)         ? STATE_SOLID
           : voltage_V >= metal->softening_voltage_V ? STATE_SOFT
                                                     : STATE_HARD;
}

/** Columns of the table: those of the effects that run. */
static const struct column {
    const char *head;
    unsigned effects; /* any of them */
    enum quantity quantity;
    double scale;
    double (*number)(const struct contact_point *p, const struct joint *joint); /* NULL: the quantity */
} columns[] = {
    {"h_c (W/(m²·K))", EFFECT_BIT(EFFECT_GAP), QUANTITY_TCR, -1, NULL},
    {"h_g (W/(m²·K))", EFFECT_BIT(EFFECT_GAP), QUANTITY_GAP, 1, NULL},
    {"h_j (W/(m²·K))", EFFECT_BIT(EFFECT_GAP), QUANTITY_JOINT, 1, NULL},
    {"h_g/h_j (%)", EFFECT_BIT(EFFECT_GAP), QUANTITY_GAP, 100, gap_share},
    {"n (1/mm²)", EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) | EFFECT_BIT(EFFECT_HEATING),
     QUANTITY_SPOT_DENSITY, 1e-6, NULL},
    {"a (µm)", EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) | EFFECT_BIT(EFFECT_HEATING), QUANTITY_SPOT_RADIUS,
     1e6, NULL},
    {"ECR·Aₙ (Ω·m²)", EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING), QUANTITY_ECR, 1, NULL},
    {"plating factor", EFFECT_BIT(EFFECT_PLATING), QUANTITY_PLATING_FACTOR, 1, NULL},
    {"ECR·Aₙ with film and plating (Ω·m²)", EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING), QUANTITY_JOINT_ECR, 1,
     NULL},
    {"film's share (%)", EFFECT_BIT(EFFECT_FILM), QUANTITY_JOINT_ECR, 100, film_share},
    {"V (mV)", EFFECT_BIT(EFFECT_HEATING), QUANTITY_VOLTAGE, 1e3, NULL},
    {"T_max (K)", EFFECT_BIT(EFFECT_HEATING), QUANTITY_TEMPERATURE, 1, NULL},
};
enum { COLUMNS = sizeof columns / sizeof *columns };

static bool has_column(const struct section_context *context, const struct column *column)
{
    return context->results->plan->running & column->effects;
}

/** The cells of one model on one surface. */
static void cells(struct text *out, const struct section_context *context, size_t m, size_t index)
{
    const struct contact_point own = middle_of(context, m, index), *p = &own;
    const struct joint *joint = &context->results->scene->joint;
    for (int c = 0; c < COLUMNS; c++) {
        const struct column *column = &columns[c];
        if (!has_column(context, column))
            continue;
        double value = column->number ? column->number(p, joint) : p->value[column->quantity];
        section_cell(out, column->scale < 0 ? 1 / value : column->scale * value, 3);
    }
    if (runs(context, EFFECT_HEATING))
        text_add(out, " | %s", state_words[state_at(context, index, p->value[QUANTITY_VOLTAGE])]);
}

static void row(struct text *out, const struct section_context *context, size_t index)
{
    size_t m = speaking_model(context);
    cells(out, context, m, index);
}

static void head(struct text *out, const struct section_context *context, const char *first)
{
    struct text rule = {0};
    text_add(out, "| %s", first);
    text_add(&rule, "|---|");
    for (int c = 0; c < COLUMNS; c++)
        if (has_column(context, &columns[c])) {
            text_add(out, " | %s", columns[c].head);
            text_add(&rule, "---:|");
        }
    if (runs(context, EFFECT_HEATING)) {
        text_add(out, " | the metal");
        text_add(&rule, "---|");
    }
    text_add(out, " |\n%s\n", text_string(&rule));
    text_free(&rule);
}

/** The baseline in every model. */
static void models_table(struct text *out, const struct section_context *context)
{
    size_t index = context->results->baseline;
    section_named(out, "Surface ", context->results, index);
    text_add(out, " at that load in every model:\n\n");
    head(out, context, "model");
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(context->results->plan, m) && isfinite(middle_of(context, m, index).value[QUANTITY_LOAD])) {
            text_add(out, "| %s", model_rows[m]->label);
            cells(out, context, m, index);
            text_add(out, " |\n");
        }
    text_add(out, "\n");
}

struct range {
    double least, most;
    size_t count;
};

/** Of a number over the surfaces that have it. */
static struct range range_of(const struct section_context *context, size_t m,
                             double (*number)(const struct contact_point *p, const struct joint *joint))
{
    struct range range = {INFINITY, -INFINITY, 0};
    for (size_t i = 0; i < context->results->surface_count; i++) {
        const struct contact_point point = middle_of(context, m, i);
        double value = section_surface(context, i)->usable ? number(&point, &context->results->scene->joint) : NAN;
        if (!isfinite(value))
            continue;
        range.least = fmin(range.least, value);
        range.most = fmax(range.most, value);
        range.count++;
    }
    return range;
}

static void introduction(struct text *out, const struct section_context *context)
{
    const struct joint *joint = &context->results->scene->joint;
    bool heats = runs(context, EFFECT_HEATING);
    if (runs(context, EFFECT_GAP)) {
        text_add(out, "Between the spots, ");
        if (joint->fill == JOINT_MEDIUM) {
            section_given(out, "a medium of ", joint->conductivity_W_per_mK, " W/(m·K) fills the gaps to the walls");
        } else if (joint->fill == JOINT_VACUUM) {
            text_add(out, "vacuum: the gaps carry no heat");
        } else {
            text_add(out, "%s", joint->gas->name);
            section_given(out, " at ", joint->pressure_Pa * 1e-3, " kPa");
            section_given(out, " and ", joint->temperature_K, " K");
            section_given(out, ", accommodation ", joint->accommodation, "");
        }
        text_add(out, ". h_c = 1/TCR, h_j = h_c + h_g; radiation, at most 6 W/(m²·K) at 300 K, is left out. ");
    }
    if (runs(context, EFFECT_FILM))
        section_given(out, "A film of ", joint->film_ohm_m2, " Ω·m² lies on the spots. ");
    if (runs(context, EFFECT_PLATING)) {
        section_given(out, joint->both_plated ? "Both sides are plated, " : "The surface's side is plated, ",
                      joint->plating_thickness_m * 1e6, " µm of ");
        section_given(out, "", joint->plating_ohm_m,
                      " Ω·m; the factor is an upper bound, and the plating changes neither hardness nor TCR. ");
    }
    if (heats) {
        section_given(out, "The joint carries ", joint->current_A, " A");
        section_given(out, " between bodies at ", joint->temperature_K, " K. ");
    }
    if (heats || runs(context, EFFECT_FILM) || runs(context, EFFECT_PLATING))
        text_add(out,
                 "n spots of radius a: the model's own%s, else equal ones that have its area and ECR; they depend "
                 "on how finely the surface was measured. ",
                 surface_repeats(&context->baseline->summary)->count > 0 ? ", of the mean over the scans" : "");
    size_t leading = plan_leading_model(context->results->plan), speaking = speaking_model(context);
    text_add(out, "In **%s**", model_rows[speaking]->label);
    if (speaking != leading)
        text_add(out, " (%s, which leads elsewhere, has fewer of these numbers there)", model_rows[leading]->label);
    text_add(out, ", ");
    section_at_load(out, context->results, context->results->baseline, context->comparison->middle_load);
    text_add(out, ":\n\n");
}

static void gap_sentence(struct text *out, const struct section_context *context, size_t m)
{
    struct range share = range_of(context, m, gap_share);
    if (!runs(context, EFFECT_GAP) || context->results->scene->joint.fill == JOINT_VACUUM)
        return;
    if (share.count == 0) {
        text_add(out, "- This model has no separation there, and so no gap conductance.\n");
        return;
    }
    text_add(out, "- What fills the gaps carries ");
    number_format_range(out, 100 * share.least, 100 * share.most, 2);
    text_add(out, " %% of the heat: %s.\n",
             share.least > 0.5  ? "**the finish matters more than the load**"
             : share.most < 0.5 ? "**the load matters more than what fills the gaps**"
                                : "on some surfaces the finish, on others the load matters more");
}

static void film_sentence(struct text *out, const struct section_context *context, size_t m)
{
    struct range share = range_of(context, m, film_share);
    if (!runs(context, EFFECT_FILM) || share.count == 0)
        return;
    text_add(out, "- The film is ");
    number_format_range(out, 100 * share.least, 100 * share.most, 2);
    text_add(out, " %% of the resistance.\n");
}

static void plating_sentence(struct text *out, const struct section_context *context, size_t m)
{
    struct range factor = range_of(context, m, plating_of);
    if (!runs(context, EFFECT_PLATING))
        return;
    if (factor.count == 0) {
        text_add(out, "- No surface has spots small enough apart there (A/Aₙ below 0.1) for the plating's factor.\n");
        return;
    }
    text_add(out, "- The plating %s: it multiplies the constriction resistance by ",
             factor.most < 1    ? "**helps**"
             : factor.least > 1 ? "**does not help**"
                                : "makes little odds");
    number_format_range(out, factor.least, factor.most, 3);
    text_add(out, ".\n");
}

static void heating_sentence(struct text *out, const struct section_context *context, size_t m)
{
    struct range voltage = range_of(context, m, voltage_of);
    size_t soft = 0, unknown = 0, first = 0;
    if (!runs(context, EFFECT_HEATING) || voltage.count == 0)
        return;
    for (size_t i = context->results->surface_count; i-- > 0;) {
        double voltage_V = section_surface(context, i)->usable ? middle_of(context, m, i).value[QUANTITY_VOLTAGE] : NAN;
        enum state state = state_at(context, i, voltage_V);
        soft += state >= STATE_SOFT;
        first = state >= STATE_SOFT ? i : first;
        unknown += isfinite(voltage_V) && state == STATE_UNKNOWN;
    }
    text_add(out, "- The contact drops ");
    number_format_range(out, 1e3 * voltage.least, 1e3 * voltage.most, 3);
    text_add(out, " mV");
    if (soft > 0) {
        text_add(out, "; **its metal softens or melts** on %zu of %zu surface%s, ", soft, voltage.count,
                 voltage.count == 1 ? "" : "s");
        section_named(out, "surface ", context->results, first);
        text_add(out, soft > 1 ? " first among them" : "");
    } else if (unknown < voltage.count) {
        text_add(out, ", below what its metal softens or melts at");
    }
    text_add(out, ".%s\n",
             unknown > 0 ? " Softening and melting voltages are known of tin, gold, silver, copper and nickel, of "
                           "aluminium the melting voltage; not of this metal."
                         : "");
}

static void caption(struct text *out, const struct section_context *context, const struct figure *figure)
{
    struct comparison_extremes models = section_models(context, figure->row->y, false);
    if (models.count == 0)
        return;
    section_at_middle(out, context, figure->row->y, models.least);
    if (models.count > 1) {
        text_add(out, " (%s)", model_rows[models.least_at]->label);
        section_to(out, figure->row->y, models.most);
        text_add(out, " (%s)", model_rows[models.most_at]->label);
    }
    text_add(out, ".");
}

static void write_joint(struct text *out, const struct section_context *context)
{
    size_t m = speaking_model(context);
    text_add(out, "## The joint\n\n");
    introduction(out, context);
    head(out, context, "surface");
    section_each_surface(out, context, row);
    text_add(out, "\n");
    gap_sentence(out, context, m);
    film_sentence(out, context, m);
    plating_sentence(out, context, m);
    heating_sentence(out, context, m);
    text_add(out, "\n");
    models_table(out, context);
    section_figures(out, context, "joint", caption);
}

const struct section section_joint = {"joint", called_for, write_joint};
