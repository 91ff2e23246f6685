// What the figures of adaptive surfaces print.
#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "query/query.h"

static void shares_of_angles_add_up(void)
{
    static const char *const meshes[] = {"clamp", "piston", "fitting"};
    for (int i = 0; i < 3; i++) {
        double before = 0, after = 0;
        for (int bin = 0; bin < (int)number("bins"); bin++) {
            before += measured("remeshing", "%s before %d", meshes[i], bin);
            after += measured("remeshing", "%s after %d", meshes[i], bin);
        }
        ck_assert_double_eq_tol(before, 100, 0.01);
        ck_assert_double_eq_tol(after, 100, 0.01);
        ck_assert_double_lt(measured("remeshing", "%s thin", meshes[i]), 3);
    }
}

/// A tetrahedron of which only the first corner, (1, 1, 1), moves.
static void make_tetrahedron(const double end[3], tf_worldline corner[4])
{
    const double ways[][6] = {{1, 1, 1, end[0], end[1], end[2]},
                              {1, -1, -1, 1, -1, -1},
                              {-1, 1, -1, -1, 1, -1},
                              {-1, -1, 1, -1, -1, 1}};
    make_vertices(3, 4, *ways, corner);
}

/// In a straight motion they meet at that time.  The step's own motion bends
/// the edge within what it sweeps over, so it has the same contact later.
static void edges_meet_and_the_corner_misses_the_triangle(void)
{
    const double end[] = {0.5, 0.5, -3}, t = number("time");
    tf_worldline corner[4];
    tf_contact contact;
    make_tetrahedron(end, corner);
    tf_worldline side[2] = {corner[0], corner[3]};
    tf_query(&tf_exact, 3, 2, corner + 1, 2, side, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    for (int k = 0; k < 3; k++) {
        double moved = 1 + t * (end[k] - 1), fixed = corner[3].at[0].x[k];
        double middle = (corner[1].at[0].x[k] + corner[2].at[0].x[k]) / 2;
        ck_assert_double_eq_tol(fixed + 0.625 * (moved - fixed), middle, 1e-15);
    }
    tf_query(&tf_exact, 3, 1, corner, 3, corner + 1, &contact);
    ck_assert_int_eq(contact.verdict, TF_APART);
}

static void the_corner_meets_the_triangle(void)
{
    tf_worldline corner[4];
    tf_contact contact;
    make_tetrahedron((double[]){-2, -2, -2}, corner);
    tf_query(&tf_exact, 3, 1, corner, 3, corner + 1, &contact);
    ck_assert_int_eq(contact.verdict, TF_HIT);
    expect_within(1e-12, contact.toi_lo, "time");
}

const figure_test adaptive_tests[] = {
    {&fig_angle_histograms, shares_of_angles_add_up},
    {&fig_corner_past_triangle, edges_meet_and_the_corner_misses_the_triangle},
    {&fig_inverted_tetrahedron, the_corner_meets_the_triangle},
    {NULL, NULL}};
