// Why points against triangles and edges against edges are enough: a moving
// edge and a moving triangle without a vertex in common meet an even number of
// times, if the ends of the step count too.
#include "arithmetic/exact.h"
#include "arithmetic/perturbed.h"
#include "intersect/cascade.h"
#include "support/oracle.h"
#include "support/support.h"

#include <stdio.h>

enum {
    COUNTS = 1 + 2 + 2 * 3 + 3 * 4 ///< of none, to both ends and all pairs
};

/// Vertices in increasing index.
typedef struct element {
    int vertices;
    tf_worldline vertex[TF_VERTICES];
} element;

// Faces -----------------------------------------------------------------------

static element vertex_of(const element *e, int i)
{
    element vertex = {.vertices = 1, .vertex = {e->vertex[i]}};
    return vertex;
}

/// The edge against vertex i of a triangle.
static element edge_of(const element *triangle, int i)
{
    element edge = {.vertices = 0};
    for (int j = 0; j < 3; j++)
        if (j != i)
            edge.vertex[edge.vertices++] = triangle->vertex[j];
    return edge;
}

// Contacts --------------------------------------------------------------------

/// How many pairs of the simplices that two elements sweep meet.
static int count_intersections(const tf_arithmetic *arithmetic,
                               const element *a, const element *b)
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(a->vertices, a->vertex, s);
    tf_sweep(b->vertices, b->vertex, r);
    int count = 0;
    for (int i = 0; i < a->vertices; i++)
        for (int j = 0; j < b->vertices; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], TF_AXES);
            count += tf_intersect(arithmetic, &pair, TF_WITH_POINT).verdict ==
                     TF_HIT;
        }
    return count;
}

static int count_points(const tf_arithmetic *arithmetic, const element *points,
                        const element *triangle)
{
    int count = 0;
    for (int i = 0; i < points->vertices; i++) {
        element point = vertex_of(points, i);
        count += count_intersections(arithmetic, &point, triangle);
    }
    return count;
}

static int count_edges(const tf_arithmetic *arithmetic, const element *edge,
                       const element *triangle)
{
    int count = 0;
    for (int i = 0; i < 3; i++) {
        element other = edge_of(triangle, i);
        count += count_intersections(arithmetic, edge, &other);
    }
    return count;
}

// The ends of the step --------------------------------------------------------

static oracle_simplex slice(const element *e, int t)
{
    oracle_simplex at = {.count = e->vertices};
    for (int i = 0; i < at.count; i++)
        at.event[i] = &e->vertex[i].at[t];
    return at;
}

static bool meet_at_end(const element *a, const element *b, int t)
{
    oracle_simplex s = slice(a, t), r = slice(b, t);
    return oracle_slices_meet(TF_AXES, &s, &r);
}

/// Whether two triangles meet at an end: then an edge of one meets the other.
static bool triangles_meet_at_end(const element *a, const element *b, int t)
{
    for (int i = 0; i < 3; i++) {
        element of_a = edge_of(a, i), of_b = edge_of(b, i);
        if (meet_at_end(&of_a, b, t) || meet_at_end(&of_b, a, t))
            return true;
    }
    return false;
}

// Steps -----------------------------------------------------------------------

/// An element that starts anywhere and moves by less than `reach` an axis.
static element random_element(generator *random, int vertices, double reach)
{
    element made = {.vertices = vertices};
    for (int i = 0; i < vertices; i++) {
        made.vertex[i].at[1].t = 1;
        for (int k = 0; k < TF_AXES; k++) {
            double *start = &made.vertex[i].at[0].x[k];
            *start = uniform(random, -1, 1);
            made.vertex[i].at[1].x[k] = *start + uniform(random, -reach, reach);
        }
    }
    return made;
}

/// The vertices of an element at both ends, in hexadecimal floats.
static const char *text_of(const element *shown, char text[1024])
{
    int length = 0;
    for (int t = 0; t < 2; t++)
        for (int i = 0; i < shown->vertices; i++) {
            const double *x = shown->vertex[i].at[t].x;
            length += snprintf(text + length, 1024 - (size_t)length,
                               "%a,%a,%a\n", x[0], x[1], x[2]);
        }
    return text;
}

static void fail_step(const char *why, const element *a, const element *b)
{
    char first[1024], second[1024];
    ck_abort_msg("%s\nseed %llu\n%sand\n%s", why, (unsigned long long)seed(),
                 text_of(a, first), text_of(b, second));
}

static void expect_even(int count, bool seen[COUNTS], const element *edge,
                        const element *triangle)
{
    seen[count] = true;
    if (count % 2 != 0)
        fail_step("an odd number of intersections", edge, triangle);
}

static void expect_variety(const bool seen[COUNTS])
{
    ck_assert_msg(cases(1000) < 1000 || (seen[0] && seen[2] && seen[4]),
                  "the steps are too tame");
}

START_TEST(the_number_of_intersections_is_even)
{
    generator random = generator_new(1);
    bool seen[COUNTS] = {false};
    for (long i = cases(100000); i > 0; i--) {
        double reach = uniform(&random, 0.1, 2);
        element edge = random_element(&random, 2, reach);
        element triangle = random_element(&random, 3, reach);
        int count = meet_at_end(&edge, &triangle, 0) +
                    meet_at_end(&edge, &triangle, 1) +
                    count_points(&tf_exact, &edge, &triangle) +
                    count_edges(&tf_exact, &edge, &triangle);
        expect_even(count, seen, &edge, &triangle);
    }
    expect_variety(seen);
}
END_TEST

/// Number the vertices of an edge and a triangle at random, and move them from
/// and to points of a lattice.
static void fill_lattice(generator *random, element *edge, element *triangle)
{
    int values = 2 + below(random, 3);
    *edge = (element){.vertices = 0};
    *triangle = (element){.vertices = 0};
    for (int v = 0; v < 5; v++) {
        int left = 2 - edge->vertices;
        element *e = below(random, 5 - v) < left ? edge : triangle;
        double x[2][TF_AXES];
        for (int i = 0; i < 2 * TF_AXES; i++)
            x[i / TF_AXES][i % TF_AXES] = below(random, values);
        tf_worldline *line = &e->vertex[e->vertices++];
        *line = tf_worldline_between(TF_AXES, x[0], x[1]);
        tf_worldline_set_vertex(line, v);
    }
}

/// The perturbed edge and triangle at an end.
static bool perturbed_meet_at_end(const element *edge, const element *triangle,
                                  int t)
{
    tf_pair pair = {
        .start_count = t == 0 ? 5 : 0, .axes = 3, .axis = {0, 1, 2}};
    const element *sides[2] = {edge, triangle};
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < sides[side]->vertices; i++) {
            pair.event[pair.count] = &sides[side]->vertex[i].at[t];
            pair.operand[pair.count++] = side == 0 ? +1 : -1;
        }
    tf_intersection found;
    ck_assert(tf_complementary_intersect(&tf_perturbed, &pair, TF_WITH_POINT,
                                         &found));
    return found.verdict == TF_HIT;
}

START_TEST(perturbed_intersections_are_even_however_degenerate)
{
    generator random = generator_new(3);
    bool seen[COUNTS] = {false};
    for (long i = cases(100000); i > 0; i--) {
        element edge, triangle;
        fill_lattice(&random, &edge, &triangle);
        int count = perturbed_meet_at_end(&edge, &triangle, 0) +
                    perturbed_meet_at_end(&edge, &triangle, 1) +
                    count_points(&tf_perturbed, &edge, &triangle) +
                    count_edges(&tf_perturbed, &edge, &triangle);
        expect_even(count, seen, &edge, &triangle);
    }
    expect_variety(seen);
}
END_TEST

/// Whether a point of one triangle meets the other, or an edge an edge.
static bool in_contact(const element *a, const element *b)
{
    int count = count_points(&tf_exact, a, b) + count_points(&tf_exact, b, a);
    for (int i = 0; i < 3; i++) {
        element edge = edge_of(a, i);
        count += count_edges(&tf_exact, &edge, b);
    }
    return count > 0;
}

START_TEST(a_step_without_contact_ends_clear)
{
    generator random = generator_new(2);
    long clear = 0;
    for (long i = cases(20000); i > 0; i--) {
        double reach = uniform(&random, 0.05, 0.5);
        element a = random_element(&random, 3, reach);
        element b = random_element(&random, 3, reach);
        if (triangles_meet_at_end(&a, &b, 0) || in_contact(&a, &b))
            continue;
        clear++;
        if (triangles_meet_at_end(&a, &b, 1))
            fail_step("a step without contact ends in a crossing", &a, &b);
    }
    ck_assert_int_gt(clear, 0);
}
END_TEST

/// Two triangles that cross in mid-step without a contact: bent triangles can
/// meet at their creases first.
START_TEST(a_step_without_contact_may_cross_between)
{
    static const double start[6][3] = {
        {-0.872, 0.676, 0.823},  {0.713, -0.982, -0.792},
        {-0.615, 0.064, 0.312},  {0.441, 0.554, 0.489},
        {0.673, -0.944, -0.039}, {-0.490, -0.936, -0.491}};
    static const double end[6][3] = {
        {-0.946, 0.844, 1.005},  {0.656, -1.159, -1.030},
        {-0.580, -0.087, 0.384}, {0.163, 0.361, 0.330},
        {0.940, -0.787, -0.074}, {-0.268, -0.777, -0.223}};
    element a = {.vertices = 3}, b = {.vertices = 3};
    for (int i = 0; i < 6; i++) {
        element *e = i == 0 || i == 1 || i == 5 ? &a : &b;
        int place = e == &b ? i - 2 : i < 2 ? i : 2;
        e->vertex[place] = tf_worldline_between(3, start[i], end[i]);
    }

    mpq_t first;
    mpq_init(first);
    ck_assert(oracle_meet(TF_AXES, 3, a.vertex, 3, b.vertex, first));
    ck_assert_double_lt(mpq_get_d(first), 0.1);
    mpq_clear(first);

    ck_assert(!in_contact(&a, &b));
    ck_assert(!triangles_meet_at_end(&a, &b, 0));
    ck_assert(!triangles_meet_at_end(&a, &b, 1));
}
END_TEST

Suite *suite(void)
{
    Suite *parity = suite_create("parity");
    TCase *steps = tcase_create("steps");
    tcase_add_test(steps, the_number_of_intersections_is_even);
    tcase_add_test(steps, perturbed_intersections_are_even_however_degenerate);
    tcase_add_test(steps, a_step_without_contact_ends_clear);
    tcase_add_test(steps, a_step_without_contact_may_cross_between);
    suite_add_tcase(parity, steps);
    return parity;
}
