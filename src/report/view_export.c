/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The leading model's conductances over pressure, raw SI numbers for other programs; only where the scene asks. */
#include "report/view.h"

#include "base/version.h"
#include "contact/cmy.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

enum { LAWS = 2, NUMBER = 32, NAME_MOST = 100, FEW = 20 };

/** Units of a table, and one of each in SI. */
static const struct units {
    const char *all, *pressure, *of[LAWS], *column[LAWS];
    double pressure_Pa, of_SI[LAWS];
} units[] = {{"N, m, s, J, K", "Pa", {"W/(m2 K)", "S/m2"}, {"W_per_m2K", "S_per_m2"}, 1, {1, 1}},
             {"N, mm, s, mJ, K", "MPa", {"mW/(mm2 K)", "S/mm2"}, {"mW_per_mm2K", "S_per_mm2"}, 1e6, {1e3, 1e6}}};

/** h and g of the templates: 1/(TCR Aₙ), or h_j of the joint where something fills its gaps; 1/(ECR Aₙ), with film and
 * plating where there are such. */
struct law {
    const char *name, *ends_name, *value, *low, *high, *unit, *column;
    enum quantity whole, contact;
    struct asked asked, apart; /* apart: where nothing touches; of scale 0: nothing conducts */
    bool exists, ends;
};

const char view_export_mm[] = ":mm";

static void put_si(json_t *out, const char *name, double value)
{
    char number[NUMBER];
    snprintf(number, sizeof number, "%.9g", value);
    if (isfinite(value))
        json_object_set_new(out, name, json_string(number));
}

/** A name of a file from that of a surface, neither hidden nor like an option; where characters gave way, its number
 * tells it from all others. */
static void put_file(json_t *out, const char *surface, size_t number)
{
    char name[NAME_MOST + NUMBER];
    size_t length = 0;
    bool same = true;
    for (const char *s = surface; *s && length < NAME_MOST; s++, length++) {
        name[length] = isalnum((unsigned char)*s) || (strchr("-.", *s) && length > 0) ? *s : '_';
        same = same && name[length] == *s && (length + 1 < NAME_MOST || !s[1]);
    }
    snprintf(name + length, NUMBER, same ? "" : "~%zu", number);
    json_object_set_new(out, "file", json_string(name));
}

static void put_ends(json_t *row, const struct law *law, double value, const double ends[2])
{
    put_si(row, law->value, value);
    put_si(row, law->low, ends[0]);
    put_si(row, law->high, ends[1]);
}

/** The first row, at zero pressure, so that no program extrapolates the next one's numbers: only what fills the gaps
 * conducts, as at the lightest load. */
static void put_apart(json_t *row, const struct law *law, const struct contact_point *point,
                      const struct ensemble_band *band)
{
    const enum quantity quantity = law->apart.quantity;
    double value = 0, ends[2] = {0, 0};
    if (law->apart.scale > 0) {
        value = ends[0] = ends[1] = asked_shown(&law->apart, point->value[quantity]);
        if (band && isfinite(band->mean[quantity][0]) && isfinite(band->mean[quantity][1]))
            asked_ends(ends, &law->apart, band->mean[quantity]);
    }
    put_ends(row, law, value, ends);
}

/** The points at which each law that exists has a number, by rising pressure from none on. */
static void put_rows(json_t *rows, struct law laws[LAWS], const struct surface_record *record, size_t m,
                     double pressure_unit_Pa)
{
    const struct model_curve *curve = &record->curves[m];
    const struct ensemble_band *bands = record->bands ? record->bands[m] : NULL;
    double last = 0;
    for (size_t i = 0; i < curve->count && (!bands || i < record->band_count) &&
                       model_curve_bears(curve, curve->points[i].value[QUANTITY_LOAD]);
         i++) {
        const struct contact_point *point = &curve->points[i];
        double pressure_Pa = material_pair_pressure(&record->summary.pair, point->value[QUANTITY_LOAD]);
        bool whole = (laws[0].exists || laws[1].exists) && pressure_Pa > last * (1 + 1e-8);
        for (int k = 0; k < LAWS; k++)
            whole = whole && (!laws[k].exists || point->value[laws[k].asked.quantity] > 0);
        if (!whole)
            continue;
        json_t *none = last > 0 ? NULL : view_item(rows), *row = view_item(rows);
        put_si(none, "pressure", 0);
        put_si(row, "pressure", pressure_Pa / pressure_unit_Pa);
        last = pressure_Pa;
        for (int k = 0; k < LAWS; k++) {
            const enum quantity quantity = laws[k].asked.quantity;
            double ends[2] = {NAN, NAN};
            if (bands)
                asked_ends(ends, &laws[k].asked, bands[i].mean[quantity]);
            laws[k].ends = laws[k].ends && ends[0] < ends[1] && isfinite(ends[1] - ends[0]);
            put_ends(row, &laws[k], asked_shown(&laws[k].asked, point->value[quantity]), ends);
            if (none)
                put_apart(none, &laws[k], point, bands ? &bands[i] : NULL);
        }
    }
    size_t j, count = json_array_size(rows);
    json_t *row;
    json_array_foreach (rows, j, row) {
        json_set_count(row, "number", j + 1);
        view_flag(row, "few", /* evenly; faces in contact hold no more in CalculiX (2.20: springforc_f2f_th.f) */
                  count <= FEW || j < 2 || (j - 1) * (FEW - 2) / (count - 2) > (j - 2) * (FEW - 2) / (count - 2));
    }
}

static void put_surface(json_t *item, const struct view_source *source, size_t surface, const struct units *in)
{
    const struct results *results = source->results;
    const struct surface_record *record = &results->surfaces[surface];
    const struct model_row *model = model_rows[source->leading];
    const struct model_curve *curve = &record->curves[source->leading];
    const unsigned computed = plan_quantities(results->plan);
    struct law laws[LAWS] = {{"thermal", "thermal_ends", "h", "h_low", "h_high", "h_unit", "h_column", QUANTITY_JOINT,
                              QUANTITY_TCR, .ends = true},
                             {"electrical", "electrical_ends", "g", "g_low", "g_high", "g_unit", "g_column",
                              QUANTITY_JOINT_ECR, QUANTITY_ECR, .ends = true}};
    for (int k = 0; k < LAWS; k++) {
        struct law *law = &laws[k];
        bool whole = computed & QUANTITY_BIT(law->whole);
        law->asked.quantity = whole ? law->whole : law->contact;
        law->asked.reciprocal = law->asked.quantity != QUANTITY_JOINT;
        law->asked.scale = 1 / in->of_SI[k];
        if (law->asked.quantity == QUANTITY_JOINT)
            law->apart = (struct asked){.quantity = QUANTITY_GAP, .scale = law->asked.scale};
        for (size_t i = 0; i < curve->count; i++)
            law->exists = law->exists || isfinite(curve->points[i].value[law->asked.quantity]);
    }
    json_t *rows = view_list(item, "rows");
    put_rows(rows, laws, record, source->leading, in->pressure_Pa);
    view_text(item, "units", in->all);
    view_text(item, "pressure_unit", in->pressure);
    view_flag(item, "mm", in != units);
    for (int k = 0; k < LAWS; k++) {
        view_text(item, laws[k].unit, in->of[k]);
        view_text(item, laws[k].column, in->column[k]);
        view_flag(item, laws[k].name, laws[k].exists);
        view_flag(item, laws[k].ends_name, laws[k].exists && laws[k].ends);
    }
    const struct curve_validity valid = curve_summary_validity(curve, model);
    for (int end = 0; end < 2 && valid.end > valid.first; end++) {
        const struct contact_point *point = &curve->points[end == 0 ? valid.first : valid.end - 1];
        put_si(item, end == 0 ? "valid_from" : "valid_to",
               material_pair_pressure(&record->summary.pair, point->value[QUANTITY_LOAD]) / in->pressure_Pa);
    }
    json_set_count(item, "count", json_array_size(rows));
    json_set_count(item, "surface_number", surface + 1);
    put_file(item, view_name(source, surface), surface + 1);
    view_text(item, "surface", view_name(source, surface));
    view_text(item, "model", model->label);
    view_text(item, "version", version_string());
    view_flag(item, "gap", laws[0].asked.quantity == QUANTITY_JOINT);
    view_flag(item, "film_or_plating", laws[1].asked.quantity == QUANTITY_JOINT_ECR);
    view_flag(item, "shape", plan_runs(results->plan, EFFECT_SHAPE));
    put_si(item, "sigma", record->summary.rough.sigma_m);
    put_si(item, "slope", record->summary.rough.slope);
    put_si(item, "hardness", record->summary.pair.hardness_Pa);
}

void view_export(json_t *out, const struct view_source *source)
{
    const char *exports = source->results->scene->exports;
    for (size_t u = 0; u < sizeof units / sizeof *units && exports && (u == 0 || strstr(exports, view_export_mm)); u++)
        for (size_t i = 0; i < source->results->surface_count; i++) {
            const struct surface_record *record = &source->results->surfaces[i];
            json_auto_t *item = json_object();
            if (record->summary.usable && record->curves && record->curves[source->leading].exists)
                put_surface(item, source, i, &units[u]);
            if (json_array_size(json_object_get(item, "rows")) > 0)
                json_array_append(view_list(out, "exports"), item);
        }
}
