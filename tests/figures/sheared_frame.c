#include "figures/numbers.h"

// The corners less the point, at t = 0 and t = 1.
static const double seen[2][3][3] = {
    {{-2.75, -0.5, -1.75}, {1.75, -0.5, -2.25}, {-0.75, 3.5, -2}},
    {{-2.5, -1, 1.25}, {1.5, -1.5, 1.75}, {-0.5, 2.5, 2.25}}};

/// The corners of a tetrahedron, by time and vertex, after its pivot.
static const double *corner_of(int pivot, int i)
{
    return i <= pivot ? seen[0][i] : seen[1][i - 1];
}

/// Exact: the coordinates are short.
static double determinant(const double *a, const double *b, const double *c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) -
           a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

static double weight_of(int pivot, int i)
{
    const double *rest[3];
    for (int k = 0; k < 3; k++)
        rest[k] = corner_of(pivot, k < i ? k : k + 1);
    return (i % 2 == 0 ? 1 : -1) * determinant(rest[0], rest[1], rest[2]);
}

START_TEST(signs_are_those_of_determinants)
{
    char *text = printed(&fig_sheared_frame);
    for (int pivot = 0; pivot < 3; pivot++)
        for (int i = 0; i < 4; i++) {
            char key[32];
            double weight = weight_of(pivot, i);
            snprintf(key, sizeof key, "sign_%d_%d", pivot, i);
            expect_number(text, key, weight > 0 ? 1 : weight < 0 ? -1 : 0);
        }

    // The origin is the middle of the second tetrahedron's corners.
    for (int i = 0; i < 4; i++)
        ck_assert_double_eq(weight_of(1, i), weight_of(1, 0));
    expect_number(text, "toi", 0.5);
    expect_number(text, "barycentric_a", 0.25);
    expect_number(text, "barycentric_b", 0.5);
    expect_number(text, "barycentric_c", 0.25);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sheared_frame", signs_are_those_of_determinants);
}
