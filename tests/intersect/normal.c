#include "intersect/normal.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "geometry/vector.h"
#include "support/queries.h"
#include "support/rational.h"
#include "support/support.h"

#include <float.h>
#include <math.h>

/// The sweeps of the query's elements.
typedef struct sweeps {
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
} sweeps;

static void sweep(const query *q, sweeps *swept)
{
    tf_sweep(q->vertices, q->vertex, swept->s);
    tf_sweep(q->others, query_const_others(q), swept->r);
}

/// Append the edges of a simplex within t = 0, then those within t = 1.
static void add_edges(const tf_simplex *simplex, int *count, tf_vector edge[])
{
    for (int t = 0; t < 2; t++) {
        const tf_event *first = NULL;
        for (int i = 0; i < simplex->count; i++) {
            if (simplex->event[i]->t != t)
                continue;
            if (first)
                for (int k = 0; k < TF_AXES; k++)
                    edge[*count].x[k] = simplex->event[i]->x[k] - first->x[k];
            *count += first != NULL;
            first = first ? first : simplex->event[i];
        }
    }
}

/// The cross product of the edges of two simplices, of length 1 or 0.
static tf_vector expected_normal(int axes, const tf_simplex *s,
                                 const tf_simplex *r)
{
    tf_vector edge[TF_AXES] = {{{0}}}, n = {{0}};
    int count = 0;
    add_edges(s, &count, edge);
    add_edges(r, &count, edge);
    ck_assert_int_eq(count, axes - 1);
    const double *a = edge[0].x, *b = edge[1].x;
    if (axes == 2)
        n = (tf_vector){{-a[1], a[0], 0}};
    else
        n = (tf_vector){{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]}};
    double length = sqrt(tf_vector_dot(n, n));
    return length > 0 ? tf_vector_scaled(1 / length, n) : n;
}

START_TEST(the_normal_is_the_cross_product_of_horizontal_edges)
{
    generator random = generator_new((uint64_t)_i);
    long zeros = 0, all = cases(20000);
    for (long c = 0; c < all; c++) {
        query q = query_lattice(&random, (query_kind)_i, 4);
        sweeps swept;
        sweep(&q, &swept);
        int i = below(&random, q.vertices), j = below(&random, q.others);
        tf_vector n = tf_contact_normal(&oracle_arithmetic, q.axes, &swept.s[i],
                                        &swept.r[j]);
        tf_vector e = expected_normal(q.axes, &swept.s[i], &swept.r[j]);
        bool right = true;
        for (int k = 0; k < TF_AXES; k++)
            right = right && fabs(n.x[k] - e.x[k]) < 1e-12;
        bool zero = tf_vector_dot(e, e) == 0;
        ck_assert_msg(right && (!zero || tf_vector_dot(n, n) == 0),
                      "(%a, %a, %a), not (%a, %a, %a)\n%s", n.x[0], n.x[1],
                      n.x[2], e.x[0], e.x[1], e.x[2], query_text(&q));
        zeros += zero;
    }
    ck_assert_msg(zeros > 0 && zeros < all / 2, "%ld zeros", zeros);
}
END_TEST

/// The normal of an edge at rest, in the plane.
static tf_vector normal_of_edge(const tf_arithmetic *arithmetic, double x,
                                double y)
{
    query q = query_new(POINT_EDGE);
    for (int t = 0; t < 2; t++) {
        q.vertex[2].at[t].x[0] = x;
        q.vertex[2].at[t].x[1] = y;
    }
    sweeps swept;
    sweep(&q, &swept);
    return tf_contact_normal(arithmetic, 2, &swept.s[0], &swept.r[0]);
}

START_TEST(edges_of_any_length_have_a_normal)
{
    for (int exponent = -1074; exponent < 1023; exponent++) {
        double unit = ldexp(1, exponent);
        tf_vector n = normal_of_edge(&oracle_arithmetic, unit, 0);
        ck_assert_msg(n.x[0] == 0 && n.x[1] == 1 && n.x[2] == 0,
                      "2^%d: (%a, %a, %a)", exponent, n.x[0], n.x[1], n.x[2]);
        n = normal_of_edge(&oracle_arithmetic, 0, -unit);
        ck_assert_msg(n.x[0] == 1 && n.x[1] == 0, "2^%d: (%a, %a)", exponent,
                      n.x[0], n.x[1]);
    }
}
END_TEST

START_TEST(an_edge_of_no_length_has_no_normal)
{
    tf_vector n = normal_of_edge(&oracle_arithmetic, 0, 0);
    ck_assert_double_eq(tf_vector_dot(n, n), 0);
}
END_TEST

START_TEST(products_that_overflow_leave_no_normal)
{
    query q = query_new(POINT_EDGE);
    for (int t = 0; t < 2; t++) {
        q.vertex[1].at[t].x[0] = -DBL_MAX;
        q.vertex[2].at[t].x[0] = DBL_MAX;
    }
    sweeps swept;
    sweep(&q, &swept);
    tf_vector n = tf_contact_normal(&tf_clamped, 2, &swept.s[0], &swept.r[0]);
    ck_assert_double_eq(tf_vector_dot(n, n), 0);
    n = tf_contact_normal(&oracle_arithmetic, 2, &swept.s[0], &swept.r[0]);
    ck_assert_double_eq(n.x[1], 1);
}
END_TEST

/// The normal of two edges at rest, in space.
static tf_vector normal_of_edges(const tf_arithmetic *arithmetic,
                                 const double a[3], const double b[3])
{
    query q = query_new(EDGE_EDGE);
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < TF_AXES; k++) {
            q.vertex[1].at[t].x[k] = a[k];
            q.vertex[3].at[t].x[k] = b[k];
        }
    sweeps swept;
    sweep(&q, &swept);
    return tf_contact_normal(arithmetic, 3, &swept.s[0], &swept.r[0]);
}

START_TEST(a_component_of_infinite_radius_leaves_no_normal)
{
    // The products are finite, the sum of their absolute values is not.
    static const double a[] = {1.2e154, 1.1e154, 0},
                        b[] = {1.1e154, 1.2e154, 1e-160};
    tf_vector n = normal_of_edges(&tf_clamped, a, b);
    ck_assert_msg(n.x[0] == 0 && n.x[1] == 0 && n.x[2] == 0, "(%a, %a, %a)",
                  n.x[0], n.x[1], n.x[2]);
    n = normal_of_edges(&oracle_arithmetic, a, b);
    ck_assert_double_eq(n.x[2], 1);
}
END_TEST

START_TEST(a_radius_shortens_no_normal)
{
    // One component is a difference of equal products: zero but for rounding.
    static const double a[] = {3, 1, 0}, b[] = {3, 1, 1e-200};
    tf_vector n = normal_of_edges(&tf_clamped, a, b);
    ck_assert_double_eq_tol(tf_vector_dot(n, n), 1, 1e-15);
}
END_TEST

static tf_value value_of_little_worth(const tf_differences *differences)
{
    tf_value value = oracle_arithmetic.value(differences);
    value.radius = 8 * fabs(value.number);
    return value;
}

START_TEST(a_normal_that_is_hardly_known_has_length_1)
{
    tf_arithmetic arithmetic = oracle_arithmetic;
    arithmetic.value = value_of_little_worth;
    tf_vector n = normal_of_edge(&arithmetic, 1, 0);
    ck_assert_double_eq(n.x[0], 0);
    ck_assert_double_eq(n.x[1], 1);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("intersect/normal");
    TCase *tcase = tcase_create("normal");
    tcase_add_loop_test(
        tcase, the_normal_is_the_cross_product_of_horizontal_edges, 0, KINDS);
    tcase_add_test(tcase, edges_of_any_length_have_a_normal);
    tcase_add_test(tcase, an_edge_of_no_length_has_no_normal);
    tcase_add_test(tcase, products_that_overflow_leave_no_normal);
    tcase_add_test(tcase, a_component_of_infinite_radius_leaves_no_normal);
    tcase_add_test(tcase, a_radius_shortens_no_normal);
    tcase_add_test(tcase, a_normal_that_is_hardly_known_has_length_1);
    suite_add_tcase(suite, tcase);
    return suite;
}
