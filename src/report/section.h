/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sections of a report: one file each, which holds its prose, tables and captions. */
#ifndef REPORT_SECTION_H
#define REPORT_SECTION_H

#include "base/number_format.h"
#include "chart/figure.h"
#include "results/comparison.h"

/** What the sections are written from. */
struct section_context {
    const struct results *results;
    const struct comparison *comparison;
    const struct surface_record *baseline;
    const struct figure_list *figures;
    bool brief; /* the first page alone */
};

struct section {
    const char *name;
    /** Is there anything to say? NULL: always. */
    bool (*called_for)(const struct section_context *context);
    /** Writes heading, text, tables and figures as Markdown. */
    void (*write)(struct text *out, const struct section_context *context);
};

extern const struct section section_summary, section_surfaces, section_material, section_convergence, section_baseline,
    section_beyond_thesis, section_joint, section_direct, section_all_surfaces, section_checks, section_sensitivity,
    section_deciding, section_limits, section_repeats, section_measured, section_validity, section_cost,
    section_computed, section_methods, section_sources, section_answers;

/** A list item a target and a limit of the scene, in one sentence each: what the report says first. */
void section_answers_lead(struct text *out, const struct section_context *context);

/** Surfaces that a table or list of the report shows at most; data/ and results.json have all. */
enum { SECTION_ROWS = 100 };

/** What a figure shows, in one sentence with its numbers, behind its title. */
typedef void section_caption(struct text *out, const struct section_context *context, const struct figure *figure);
/** Places of the figures that decide, on the first page: of all surfaces, and against the direct solution. */
enum section_first_page { SECTION_FIRST_SURFACES, SECTION_FIRST_DIRECT, SECTION_FIRST_PLACES };
extern const char *const section_first_page[SECTION_FIRST_PLACES];
/** Are there figures whose row names this place? */
bool section_has_figures(const struct section_context *context, const char *place);
/** Adds the figures whose row names this place, each with its title and caption (NULL: the title alone),
 * and says which of them the first page has. */
void section_figures(struct text *out, const struct section_context *context, const char *place,
                     section_caption *caption);
/** Captions of the figures of all surfaces, and of those of the direct solution. */
section_caption section_all_surfaces_caption, section_direct_caption;
/** Says of the baseline's own separations how far they go on below where their chart is cut: " Cut at −0.5 σ: …". */
void section_cut(struct text *out, const struct section_context *context, const struct figure *figure);
/** " At P/(Aₙ E′) = 3.16·10⁻⁴, A/Aₙ is 0.18": the start of a caption that speaks of the middle load. */
void section_at_middle(struct text *out, const struct section_context *context, enum quantity quantity, double value);
/** " to 0.31 Ω·m²": the other end of a range. */
void section_to(struct text *out, enum quantity quantity, double value);
/** Adds the name of surface `index`, escaped for Markdown. */
void section_surface_name(struct text *out, const struct results *results, size_t index);
/** The same after `article` ("surface ", "Surface "), which a name that begins with that word goes without. */
void section_named(struct text *out, const char *article, const struct results *results, size_t index);

const struct surface_summary *section_surface(const struct section_context *context, size_t index);
/** The k-th smoothest usable surface. */
const struct surface_summary *section_smoothest(const struct section_context *context, size_t k);
/** Was any surface's fitted power law carried on below its sampling limit? */
bool section_extended(const struct section_context *context);
/** "elastic" or `plastic` for a model of the thesis where its family is understood; any other goes by its label. */
const char *section_law(size_t model, const char *plastic);
/** Does a model run that computes this quantity? */
bool section_computes(const struct section_context *context, enum quantity quantity);

/** Index of the k-th of the three loads that tables show, k = 1...3: the quarters of the list. */
size_t section_table_load(const struct results *results, size_t k);
/** Point of the baseline's curve at the middle load; NULL: the model has none there. */
const struct contact_point *section_middle(const struct section_context *context, size_t model);
/** Adds the load where the summary stands as a pressure: "15.0 MPa", "10 N (10 MPa)" where the scene gives forces,
 * "P/(Aₙ E′) = …" without a material. */
void section_middle_pressure(struct text *out, const struct section_context *context);
/** Is a model inside its range of validity on a surface at P/(A_n E') = load? */
bool section_is_valid(const struct surface_summary *summary, size_t model, double load);
/** Smallest and largest value over the models of the baseline surface at the middle load, of all or of those that are
 * `valid` there and may stand beside the leading one; count 0: none has it. The extremes' `_at` are models. */
struct comparison_extremes section_models(const struct section_context *context, enum quantity quantity, bool valid);

/** Adds a load of a surface as charts and tables show it: "3.2·10⁻⁴", or in the scene's unit "10"; as what: "P/(Aₙ
 * E′)", "load in N"; and both: "P/(Aₙ E′) = 3.2·10⁻⁴", "10 N". */
void section_load(struct text *out, const struct results *results, size_t surface, double load);
void section_load_symbol(struct text *out, const struct results *results);
void section_at_load(struct text *out, const struct results *results, size_t surface, double load);
/** What the models need of the baseline's bodies. */
const struct material_pair *section_pair(const struct section_context *context);

/** Mean pressure of the real contact of a surface, P/A, in units of S_y, NaN where S_y is not known. */
double section_contact_pressure(const struct section_context *context, size_t surface,
                                const struct contact_point *point);
/** Is S_y known, so that there is such a number? */
bool section_knows_yield(const struct section_context *context);
/** Does a point's P/A exceed the hardness of the surface's pair, by more than rounding? */
bool section_exceeds_hardness(const struct section_context *context, size_t surface, const struct contact_point *point);
/** "the hardness of 168 MPa", and what it is taken from where none is given. */
void section_hardness(struct text *out, const struct material_pair *pair);
/** Is model `m` elastic, and above the hardness on that surface at the middle load? That does not stand beside a
 * plastic leading model. False where an elastic one leads. */
bool section_is_unfit(const struct section_context *context, size_t surface, size_t m);

/** Range of a number over all usable surfaces in one model; false when no surface has a finite one. */
bool section_range(double *least, double *most, const struct section_context *context, size_t model,
                   double (*number)(const struct curve_summary *));

/** Calls `row` for every usable surface in the scene's order, between the name and the end of a table's row. */
void section_each_surface(struct text *out, const struct section_context *context,
                          void (*row)(struct text *out, const struct section_context *context, size_t index));
/** A number of the scene, as it stands there, between two texts. */
void section_given(struct text *out, const char *before, double value, const char *after);
/** "0.24 (0.21…0.27)": a number and its 95 % interval; "–" where nothing is known of it, the number alone where it has
 * no interval, or one within these digits. */
void section_interval(struct text *out, const struct estimate *estimate, double scale, int digits);
/** "×÷ 1.2", or "± 0.3" of a number that is not logarithmic. */
void section_factor(struct text *out, const struct estimate *estimate, double half_width);
/** One more cell of a row. */
void section_cell(struct text *out, double value, int digits);
/** The same for a load of surface `index`. */
void section_load_cell(struct text *out, const struct section_context *context, size_t index, double load);
/** The same for a load from which something holds on a curve: "from the first load on" where that is all that is known.
 */
void section_threshold_cell(struct text *out, const struct section_context *context, size_t index,
                            const struct curve_summary *curve, double load);
/** The same for a value with its standard error. */
void section_error_cell(struct text *out, double value, double error);

#endif
