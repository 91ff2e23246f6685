// What is in a tetrahedron, against linear programs in rational numbers.
#include "surgery/tetrahedron.h"

#include "support/at_rest.h"
#include "support/support.h"

static tf_tetrahedron tetrahedron_of(double x[][3])
{
    static const int vertex[] = {0, 1, 2, 3};
    return tf_tetrahedron_of(vertex,
                             (const double *const[]){x[0], x[1], x[2], x[3]});
}

START_TEST(points_inside_and_on_the_border_are_held)
{
    generator random = generator_new(1);
    int held = 0, count = (int)cases(10000);
    for (int i = 0; i < count; i++) {
        double x[5][3];
        place_on_lattice(&random, 5, 2 + i % 3, x);
        tf_tetrahedron body = tetrahedron_of(x);
        unsigned outside = tf_tetrahedron_outside(&body, x[4]);
        bool found = tf_tetrahedron_holds(&body, x[4], outside);
        ck_assert_int_eq(found, meet_at_rest(3, 4, x, 1, x + 4));
        held += found;
    }
    ck_assert(20 * held > count && 2 * held < count);
}
END_TEST

START_TEST(a_point_is_outside_of_the_faces_that_it_sees)
{
    double x[5][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3, -1, 0}};
    tf_tetrahedron body = tetrahedron_of(x);
    ck_assert_uint_eq(tf_tetrahedron_outside(&body, x[4]), 1 | 4);
    x[3][2] = 0; // it is flat
    body = tetrahedron_of(x);
    ck_assert_uint_eq(tf_tetrahedron_outside(&body, x[4]), 0);
}
END_TEST

/// An edge between vertices; those from 4 on are no corners.
static tf_located_edge located_edge(const tf_tetrahedron *body, double x[][3],
                                    int a, int b)
{
    return (tf_located_edge){{a, b},
                             {x[a], x[b]},
                             {tf_tetrahedron_outside(body, x[a]),
                              tf_tetrahedron_outside(body, x[b])}};
}

START_TEST(edges_that_pass_through_are_found)
{
    generator random = generator_new(2);
    int met = 0;
    for (long i = 0; i < cases(10000); i++) {
        double x[6][3];
        place_on_lattice(&random, 6, 2 + below(&random, 4), x);
        if (meet_at_rest(3, 4, x, 1, x + 4) || meet_at_rest(3, 4, x, 1, x + 5))
            continue;
        tf_tetrahedron body = tetrahedron_of(x);
        tf_located_edge edge = located_edge(&body, x, 4, 5);
        bool found = tf_tetrahedron_meets(&body, &edge);
        ck_assert_int_eq(found, meet_at_rest(3, 4, x, 2, x + 4));
        met += found;
    }
    ck_assert_int_gt(met, 10);
}
END_TEST

// A tetrahedron is convex, so an edge from a corner enters it at once or never.
// If other faces of a flat one hold the corner, the answer may be that it does.
START_TEST(edges_from_a_corner_enter_at_once_or_never)
{
    generator random = generator_new(3);
    int met = 0;
    for (long i = 0; i < cases(10000); i++) {
        double x[5][3], step[1][3];
        place_on_lattice(&random, 5, 2 + below(&random, 3), x);
        tf_tetrahedron body = tetrahedron_of(x);
        const double *const opposite[] = {x[1], x[2], x[3]};
        if (meet_at_rest(3, 4, x, 1, x + 4) ||
            tf_point_touches_triangle(x[0], opposite))
            continue;
        for (int k = 0; k < 3; k++)
            step[0][k] = x[0][k] + (x[4][k] - x[0][k]) / 1024;
        bool enters = meet_at_rest(3, 4, x, 1, step);
        tf_located_edge edge = located_edge(&body, x, 0, 4);
        tf_located_edge reverse = located_edge(&body, x, 4, 0);
        ck_assert_int_eq(tf_tetrahedron_meets(&body, &edge), enters);
        ck_assert_int_eq(tf_tetrahedron_meets(&body, &reverse), enters);
        met += enters;
    }
    ck_assert_int_gt(met, 5);
}
END_TEST

// With the corner 0 in common, or with none.
START_TEST(separated_elements_are_apart)
{
    generator random = generator_new(4);
    int apart = 0, joined = 0;
    for (long i = 0; i < cases(10000); i++) {
        double x[7][3];
        int first = below(&random, 2) ? 0 : 6;
        place_on_lattice(&random, 7, 2 + below(&random, 4), x);
        tf_tetrahedron body = tetrahedron_of(x);
        tf_facet facet = {{first, 4, 5}, {x[first], x[4], x[5]}};
        if (!tf_tetrahedron_is_apart(&body, 3, &facet))
            continue;
        double far[3][3] = {{x[4][0], x[4][1], x[4][2]},
                            {x[5][0], x[5][1], x[5][2]},
                            {x[6][0], x[6][1], x[6][2]}};
        ck_assert(!meet_at_rest(3, 4, x, first == 0 ? 2 : 3, far));
        tf_located_edge edge = located_edge(&body, x, first, 4);
        ck_assert(!tf_tetrahedron_meets(&body, &edge));
        ck_assert(tf_tetrahedron_is_apart(&body, 2, &facet));
        apart++;
        joined += first == 0;
    }
    ck_assert(apart > 10 && joined > 10);
}
END_TEST

START_TEST(own_edges_of_a_tetrahedron_do_not_meet_it)
{
    double x[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tf_tetrahedron body = tetrahedron_of(x);
    tf_located_edge edge = located_edge(&body, x, 1, 3);
    ck_assert(!tf_tetrahedron_meets(&body, &edge));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/tetrahedron");
    TCase *tcase = tcase_create("closed");
    tcase_add_test(tcase, points_inside_and_on_the_border_are_held);
    tcase_add_test(tcase, a_point_is_outside_of_the_faces_that_it_sees);
    tcase_add_test(tcase, edges_that_pass_through_are_found);
    tcase_add_test(tcase, edges_from_a_corner_enter_at_once_or_never);
    tcase_add_test(tcase, separated_elements_are_apart);
    tcase_add_test(tcase, own_edges_of_a_tetrahedron_do_not_meet_it);
    suite_add_tcase(suite, tcase);
    return suite;
}
