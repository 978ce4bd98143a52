/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/asperity.h"
#include "model_support.h"

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/asperity.csv");
    struct material_pair pair = model_support_tin();
    for (size_t i = 0; i < table.rows; i++) {
        double radius = table_number(&table, i, "radius_m"), interference = table_number(&table, i, "interference_m");
        struct asperity elastic = asperity_make(radius, &pair, false);
        struct asperity_contact contact = asperity_press(&elastic, interference);
        assert_near(contact.area_m2, table_number(&table, i, "area_m2_hertz"), 1e-10);
        assert_near(contact.load_N, table_number(&table, i, "load_N_hertz"), 1e-10);
        struct asperity plastic = asperity_make(radius, &pair, true);
        contact = asperity_press(&plastic, interference);
        assert_near(contact.area_m2, table_number(&table, i, "area_m2_jg"), 1e-10);
        assert_near(contact.load_N, table_number(&table, i, "load_N_jg"), 1e-10);
        assert_near(contact.radius_m, table_number(&table, i, "contact_radius_m_jg"), 1e-10);
    }
}

TEST_CASE(interference_at_inverts_the_radius)
{
    struct material_pair pair = model_support_tin();
    struct asperity asperity = asperity_make(2e-5, &pair, true);
    static const double ratios[] = {0.05, 0.41, 1};
    for (int i = 0; i < 3; i++) {
        struct asperity_contact contact = asperity_press(&asperity, asperity_interference_at(&asperity, ratios[i]));
        assert_near(contact.radius_m / asperity.radius_m, ratios[i], 1e-13);
    }
    struct asperity elastic = asperity_make(2e-5, &pair, false);
    assert_true(isinf(asperity_interference_at(&elastic, 1)));
}
