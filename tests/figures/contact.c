#include "figures/numbers.h"

static void expect_vector(const char *text, const char *name,
                          const double expected[3])
{
    for (int k = 0; k < 3; k++) {
        char key[64];
        snprintf(key, sizeof key, "%s_%c", name, 'x' + k);
        expect_number(text, key, expected[k]);
    }
}

// By hand.  The triangle's sides are (4, -1, 0) and (1, 3.75, 2), the edges
// (5, -1.25, 0) and (0, 4, 2): all at right angles to (-1, -4, 8), of length 9.
static const double normal[] = {-1. / 9, -4. / 9, 8. / 9};

START_TEST(contacts_are_those_found_by_hand)
{
    char *text = printed(&fig_contact);
    expect_vector(text, "point_triangle_normal", normal);
    // (5, 0, -3) of the point less (1, 0, 1) of the triangle.
    expect_vector(text, "point_triangle_velocity", (double[]){4, 0, -4});
    expect_number(text, "point_triangle_normal_velocity", -4);
    expect_number(text, "point_triangle_toi", 0.5);
    // (1.5, 1.625, 1) = (a + b + 2 c) / 4 at half time.
    expect_number(text, "point_triangle_barycentric_0", 0.25);
    expect_number(text, "point_triangle_barycentric_1", 0.25);
    expect_number(text, "point_triangle_barycentric_2", 0.5);

    expect_vector(text, "edge_edge_normal", normal);
    // (-3, 0, -5) less (1, 0, 0).
    expect_vector(text, "edge_edge_velocity", (double[]){-4, 0, -5});
    expect_number(text, "edge_edge_normal_velocity", -4);
    expect_number(text, "edge_edge_toi", 0.5);
    // (0, 0.5, 0) = (5 a0 + 3 a1) / 8 = (3 b0 + 5 b1) / 8 at half time.
    expect_number(text, "edge_edge_first_barycentric_0", 0.625);
    expect_number(text, "edge_edge_first_barycentric_1", 0.375);
    expect_number(text, "edge_edge_second_barycentric_0", 0.375);
    expect_number(text, "edge_edge_second_barycentric_1", 0.625);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/contact", contacts_are_those_found_by_hand);
}
