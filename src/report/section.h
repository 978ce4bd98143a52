/* The computed parts of the report: one function a field of templates/report.md. */
#ifndef REPORT_SECTION_H
#define REPORT_SECTION_H

#include "results/comparison.h"

/** What the sections are written from. */
struct section_context {
    const struct results *results;
    const struct comparison *study;
    const struct surface_record *baseline;
};

struct section_row {
    const char *name; /* as in the template */
    void (*write)(struct text *out, const struct section_context *context);
};

/** The fields, each list ended by a row without a name. */
extern const struct section_row section_summary[];
extern const struct section_row section_prose[];
extern const struct section_row section_tables[];
extern const struct section_row section_repeat[];

/** Surfaces that a table or list of the report shows at most; data/ and results.json have all. */
enum { SECTION_ROWS = 100 };

extern const struct section_row section_cost[];

/** The caption's text of a figure: its title and one sentence on what is seen in it. */
struct figure_row;
void section_caption(struct text *out, const struct section_context *context, const struct figure_row *row);

/** Was any surface's fitted law carried on below its sampling limit? */
bool section_extended(const struct section_context *context);
const struct surface_summary *section_surface(const struct section_context *context, size_t index);
/** May this model run in this scene? */
bool section_called_for(const struct section_context *context, enum model_id model);
/** Point of the baseline's curve at the middle load; NULL: the model has none there. */
const struct contact_point *section_middle(const struct section_context *context, enum model_id model);
/** Adds the middle load as a pressure: "15.0 MPa". */
void section_middle_pressure(struct text *out, const struct section_context *context);
/** Smallest and largest value over the models of the baseline surface at the middle load; count 0: none has it. The
 * extremes' `_at` are models. */
struct comparison_extremes section_models(const struct section_context *context, enum comparison_quantity quantity);

/** Calls `row` for every usable surface in the scene's order, between the name and the end of a table's row. */
void section_each_surface(struct text *out, const struct section_context *context,
                          void (*row)(struct text *out, const struct section_context *context, size_t index));
/** One more cell of a row. */
void section_cell(struct text *out, double value, int digits);
/** The same for a load. */
void section_load_cell(struct text *out, double load);

#endif
