#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "query/query.h"

static const double corner[4][3] = {
    {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

START_TEST(the_corner_is_on_the_triangle)
{
    char *text = printed(&fig_inverted_tetrahedron);
    expect_number(text, "volume_start", 8.0 / 3);
    expect_number(text, "volume_end", -10.0 / 3);
    static const double end[] = {-2, -2, -2};
    tf_worldline line[4];
    for (int i = 0; i < 4; i++)
        line[i] = tf_worldline_between(3, corner[i], i == 0 ? end : corner[i]);
    tf_contact contact;
    tf_query(&tf_exact, 3, 1, line, 3, line + 1, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    ck_assert_double_eq_tol(contact.toi_lo, number_of(text, "time"), 1e-12);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/inverted_tetrahedron",
                    the_corner_is_on_the_triangle);
}
