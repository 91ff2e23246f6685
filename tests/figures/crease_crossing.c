#include "figures/numbers.h"

#include "support/oracle.h"
#include "support/queries.h"

enum {
    FACES = 4
}; ///< of a bent triangle

static const double at[2][3][2][3] = {{{{-3, -6, 6}, {4, -5, 6}},
                                       {{6, -3, -1}, {6, 3, -1}},
                                       {{6, 6, -4}, {0, 6, -5}}},
                                      {{{5, 5, -6}, {-1, 3, -4}},
                                       {{-3, -6, 3}, {2, -6, 6}},
                                       {{-6, -2, -3}, {-5, 4, 1}}}};

static void make_triangles(tf_worldline corner[2][3])
{
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            corner[k][i] = tf_worldline_between(3, at[k][i][0], at[k][i][1]);
}

START_TEST(none_of_the_fifteen_queries_hits)
{
    static const int side[3][2] = {{0, 1}, {1, 2}, {0, 2}};
    tf_worldline corner[2][3];
    make_triangles(corner);
    mpq_t toi;
    mpq_init(toi);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            ck_assert(!oracle_meet(3, 1, &corner[k][i], 3, corner[1 - k], toi));
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            tf_worldline first[2], second[2];
            for (int end = 0; end < 2; end++) {
                first[end] = corner[0][side[i][end]];
                second[end] = corner[1][side[j][end]];
            }
            ck_assert(!oracle_meet(3, 2, first, 2, second, toi));
        }
    mpq_clear(toi);
}
END_TEST

// The length of the crossing in another way: two triangles share the segment
// between the places where a side of the one pierces the other.

/// A flat face of a bent triangle.
typedef struct face {
    tf_vector corner[3];
} face;

/// The flat pieces of a bent triangle, the middle one in two.
static void make_faces(const tf_worldline corner[3], double t,
                       face faces[FACES])
{
    // The place of the way from vertex i to vertex j.
    tf_vector place[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++) {
            double weight[3] = {0};
            weight[i] += 1 - t;
            weight[j] += t;
            staircase_point(3, 3, corner, weight, t, place[i][j].x);
        }
    static const int way[FACES][3][2] = {{{0, 0}, {0, 1}, {0, 2}},
                                         {{0, 1}, {1, 1}, {1, 2}},
                                         {{0, 1}, {1, 2}, {0, 2}},
                                         {{0, 2}, {1, 2}, {2, 2}}};
    for (int f = 0; f < FACES; f++)
        for (int i = 0; i < 3; i++)
            faces[f].corner[i] = place[way[f][i][0]][way[f][i][1]];
}

/// Six times the volume of a tetrahedron.
static double volume(tf_vector a, tf_vector b, tf_vector c, tf_vector d)
{
    return tf_vector_dot(fig_cross(fig_difference(b, a), fig_difference(c, a)),
                         fig_difference(d, a));
}

/// Where a segment pierces a face.
static bool pierce(tf_vector from, tf_vector to, const face *f,
                   tf_vector *place)
{
    const tf_vector *c = f->corner;
    double below = volume(c[0], c[1], c[2], from);
    double above = volume(c[0], c[1], c[2], to);
    if (below * above >= 0)
        return false;
    double side[3];
    for (int i = 0; i < 3; i++)
        side[i] = volume(from, to, c[i], c[(i + 1) % 3]);
    if (side[0] * side[1] < 0 || side[1] * side[2] < 0 || side[0] * side[2] < 0)
        return false;
    *place = fig_lerp(from, to, below / (below - above));
    return true;
}

/// The length of the segment that two faces share.
static double shared_length(const face *a, const face *b)
{
    tf_vector place[6];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3;
        count += pierce(a->corner[i], a->corner[next], b, &place[count]);
        count += pierce(b->corner[i], b->corner[next], a, &place[count]);
    }
    return count < 2 ? 0 : fig_length(fig_difference(place[1], place[0]));
}

static double crossing_length(double t)
{
    tf_worldline corner[2][3];
    face first[FACES], second[FACES];
    make_triangles(corner);
    double length = 0;
    make_faces(corner[0], t, first);
    make_faces(corner[1], t, second);
    for (int i = 0; i < FACES; i++)
        for (int j = 0; j < FACES; j++)
            length += shared_length(&first[i], &second[j]);
    return length;
}

START_TEST(triangles_cross_in_mid_step_only)
{
    char *text = printed(&fig_crease_crossing);
    expect_number(text, "point_triangle_hits", 0);
    expect_number(text, "edge_edge_hits", 0);
    expect_number(text, "length_start", crossing_length(0));
    expect_number(text, "length_end", crossing_length(1));
    expect_number(text, "length_start", 0);
    expect_number(text, "length_end", 0);
    double length = number_of(text, "length");
    ck_assert_double_gt(length, 1);
    ck_assert_double_eq_tol(length, crossing_length(number_of(text, "time")),
                            1e-9);
    free(text);
}
END_TEST

START_TEST(close_ups_are_before_and_after)
{
    char *text = printed(&fig_crease_crossing);
    double before = number_of(text, "time_before");
    double after = number_of(text, "time_after");
    ck_assert_double_lt(before, after);
    ck_assert_double_lt(after, number_of(text, "time"));
    expect_number(text, "length_before", 0);
    ck_assert_double_eq(crossing_length(before), 0);
    ck_assert_double_gt(crossing_length(after), 1);
    ck_assert_double_eq_tol(number_of(text, "length_after"),
                            crossing_length(after), 1e-9);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *suite =
        suite_of("figures/crease_crossing", triangles_cross_in_mid_step_only);
    TCase *queries = tcase_create("queries");
    tcase_add_test(queries, none_of_the_fifteen_queries_hits);
    tcase_add_test(queries, close_ups_are_before_and_after);
    suite_add_tcase(suite, queries);
    return suite;
}
