/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A quantity's row is whole: what it is called, and a word wherever one is looked for. */
#include "base/unit.h"
#include "base/words.h"
#include "chart/figures.h"
#include "contact/model.h"
#include "support.h"

static struct words *words;

/** Fails unless words.txt has the words of `kind` and a name. */
static void expect_word(const char *kind, const char *name)
{
    if (words_say(words, "%s%s", kind, name)[0] == '\0')
        fail_msg("%s", words->status->message);
}

TEST_CASE(rows_have_names_units_and_words)
{
    char number[20];
    words = support_words();
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        const struct quantity_row *row = &quantity_rows[q];
        assert_true(row->name && row->short_symbol && row->unit);
        assert_true(row->name[0] && row->short_symbol[0]);
        assert_true(!(row->is & QUANTITY_SIGMA_ALONE) || row->sigma_column);
        assert_true(!row->sigma_column || strcmp(quantity_unit((enum quantity)q).unit, "σ") == 0);
        assert_int_equal(row->shown.scale > 0, row->shown.unit != NULL);
        assert_int_equal(row->handy.scale > 0, row->handy.unit != NULL);
        for (int k = 0; k < q; k++)
            assert_string_not_equal(row->name, quantity_rows[k].name);
        for (size_t k = 0; k < 2; k++) {
            const struct quantity_panel *panel = &row->panels[k];
            snprintf(number, sizeof number, "6-%02d", panel->number);
            if (!panel->file)
                continue;
            expect_word("axis.", row->name);
            expect_word(panel->number > 0 ? "" : "panel.", panel->number > 0 ? number : row->name);
            if (!quantity_of_joint((enum quantity)q))
                expect_word("table.", row->name);
        }
        if (row->solved.ratio) {
            assert_non_null(row->solved.column);
            expect_word("panel.direct.", row->name);
            expect_word("table.direct.", row->name);
        }
        for (size_t k = 0; k < 2 && row->asked[k].key; k++) {
            assert_true(row->asked[k].symbol && row->asked[k].per_area > 0);
            assert_true(row->asked[k].least < row->asked[k].most);
            if (quantity_unit((enum quantity)q).offset == 0)
                expect_word("asked.", row->asked[k].reciprocal ? row->asked[k].key : row->name);
        }
        if (row->precedence > 0)
            assert_non_null(row->asked[0].key);
        size_t n = 0;
        while (row->note && n < FIGURE_NOTES && strcmp(figure_notes[n], row->note) != 0)
            n++;
        assert_true(n < FIGURE_NOTES);
    }
}

/** Each is computed by some model, or made of what one computes. */
TEST_CASE(every_quantity_is_computed_or_made)
{
    unsigned computed = 0;
    for (size_t m = 0; m < model_count; m++)
        computed |= model_rows[m]->quantities;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        assert_int_equal((computed & QUANTITY_BIT(q)) != 0, quantity_rows[q].from == 0);
    assert_int_equal(quantity_with_made(computed), (1U << QUANTITY_COUNT) - 1);
}

/** Of a key the quantity of the whole joint is meant, where the scene calls for it. */
TEST_CASE(keys_stand_for_what_is_called_for)
{
    static const struct {
        const char *key;
        unsigned called;
        enum quantity quantity;
        bool there, reciprocal;
    } keys[] = {{"ecr", 0, QUANTITY_ECR, true, false},
                {"ecr", EFFECT_BIT(EFFECT_FILM), QUANTITY_JOINT_ECR, true, false},
                {"ecr", EFFECT_BIT(EFFECT_PLATING), QUANTITY_JOINT_ECR, true, false},
                {"conductance", EFFECT_BIT(EFFECT_FILM), QUANTITY_TCR, true, true},
                {"conductance", EFFECT_BIT(EFFECT_GAP), QUANTITY_JOINT, true, false},
                {"tcr", EFFECT_BIT(EFFECT_GAP), QUANTITY_JOINT, true, true},
                {"temperature", EFFECT_BIT(EFFECT_FILM), QUANTITY_TEMPERATURE, false, false},
                {"temperature", EFFECT_BIT(EFFECT_HEATING), QUANTITY_TEMPERATURE, true, false},
                {"friction", 0, QUANTITY_COUNT, false, false}};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
        const struct quantity_asked *how;
        assert_int_equal(quantity_of_key(&how, keys[k].key, keys[k].called), keys[k].quantity);
        assert_int_equal(how != NULL, keys[k].there);
        assert_true(!how || how->reciprocal == keys[k].reciprocal);
    }
}

/** What is asked where nothing is, and what surfaces are ranked by. */
TEST_CASE(the_greatest_precedence_comes_first)
{
    const unsigned area = QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_STIFFNESS);
    assert_int_equal(quantity_first(area), QUANTITY_AREA);
    assert_int_equal(quantity_first(area | QUANTITY_BIT(QUANTITY_TCR)), QUANTITY_TCR);
    assert_int_equal(quantity_first(area | QUANTITY_RESISTANCES), QUANTITY_ECR);
    assert_int_equal(quantity_first(area | QUANTITY_RESISTANCES | QUANTITY_BIT(QUANTITY_JOINT)), QUANTITY_JOINT);
    assert_int_equal(quantity_first(area | QUANTITY_RESISTANCES | QUANTITY_BIT(QUANTITY_SHAPE_ECR) |
                                    QUANTITY_BIT(QUANTITY_SHAPE_JOINT)),
                     QUANTITY_SHAPE_ECR);
    assert_int_equal(quantity_first(area | QUANTITY_RESISTANCES | QUANTITY_BIT(QUANTITY_SHAPE_ECR) |
                                    QUANTITY_BIT(QUANTITY_SHAPE_JOINT) | QUANTITY_BIT(QUANTITY_JOINT)),
                     QUANTITY_SHAPE_JOINT);
}

/** `compare` shows these in one table. */
TEST_CASE(symbols_of_handy_quantities_differ)
{
    for (int q = 0; q < QUANTITY_COUNT; q++)
        for (int r = 0; r < q; r++)
            if (quantity_rows[q].handy.unit && quantity_rows[r].handy.unit)
                assert_string_not_equal(quantity_rows[q].short_symbol, quantity_rows[r].short_symbol);
}
