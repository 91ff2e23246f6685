#include "figures/numbers.h"

#include "support/oracle.h"

static const double at[2][2][2][3] = {
    {{{-2.625, -1, -1}, {-2.875, -0.5, 0.5}},
     {{1.375, 0.5, -2}, {1.375, -0.5, 2.75}}},
    {{{0.5, -1.375, 2.75}, {-0.25, -1.375, -2}},
     {{-0.5, 2.625, 1.5}, {0.75, 2.625, -1}}}};

/// The triangle of an edge's sweep: first the one that moves with vertex 1.
static oracle_simplex triangle(const tf_worldline edge[2], int i)
{
    return (oracle_simplex){3,
                            {&edge[0].at[0],
                             i == 0 ? &edge[1].at[0] : &edge[0].at[1],
                             &edge[1].at[1]}};
}

enum {
    SAMPLES = 80
};

/// A place of a triangle's slice at the time t: the share s of its way from the
/// crease to the end.
static void find_place(int edge, int i, double t, double s, double place[3])
{
    int end = i == 0 ? 1 : 0;
    const double(*first)[3] = at[edge][0], (*second)[3] = at[edge][1];
    for (int k = 0; k < 3; k++) {
        double crease = (1 - t) * first[0][k] + t * second[1][k];
        double vertex = (1 - t) * at[edge][end][0][k] + t * at[edge][end][1][k];
        place[k] = (1 - s) * crease + s * vertex;
    }
}

static double sampled_at(int i, int j, double t)
{
    double least = INFINITY;
    for (int n = 0; n <= SAMPLES * SAMPLES + 2 * SAMPLES; n++) {
        double a[3], b[3];
        find_place(0, i, t, n / (SAMPLES + 1) / (double)SAMPLES, a);
        find_place(1, j, t, n % (SAMPLES + 1) / (double)SAMPLES, b);
        least =
            fmin(least, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
    }
    return least;
}

/// How near two pieces come, by trying many places at many times: at most a bit
/// too much.
static double sampled(int i, int j)
{
    double least = INFINITY;
    for (int step = 0; step <= SAMPLES; step++)
        least = fmin(least, sampled_at(i, j, step / (double)SAMPLES));
    return least;
}

START_TEST(the_distances_are_those_of_places_tried)
{
    char *text = printed(&fig_edge_edge_distances);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            char key[16];
            snprintf(key, sizeof key, "nearest_%d%d", i, j);
            double found = number_of(text, key), tried = sampled(i, j);
            ck_assert_msg(found <= tried + 1e-3 && found >= tried - 0.06,
                          "%s is %g, but tried %g", key, found, tried);
        }
    expect_number(text, "nearest_01", 0);
    expect_number(text, "nearest_other", number_of(text, "nearest_00"));
    free(text);
}
END_TEST

START_TEST(the_four_pairs_do_what_the_oracle_says)
{
    tf_worldline edge[2][2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            edge[k][i] = tf_worldline_between(3, at[k][i][0], at[k][i][1]);
    char *text = printed(&fig_edge_edge_distances);
    mpq_t toi;
    mpq_init(toi);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            oracle_simplex s = triangle(edge[0], i), r = triangle(edge[1], j);
            char key[16];
            snprintf(key, sizeof key, "hit_%d%d", i, j);
            expect_number(text, key, oracle_simplices_meet(3, &s, &r, toi));
        }
    ck_assert(oracle_meet(3, 2, edge[0], 2, edge[1], toi));
    expect_number(text, "toi", mpq_get_d(toi));
    mpq_clear(toi);

    // By hand: (a0 + a1 + 2 a1') / 4 = (2 b0 + b0' + b1') / 4.
    expect_number(text, "toi", 0.5);
    expect_number(text, "barycentric_a1", 0.75);
    expect_number(text, "barycentric_b1", 0.25);
    // (4, 1.5, -1) x (1, 4, 1) = (5.5, -5, 14.5), times (0.75, -1, 9.5).
    expect_number(text, "normal_velocity", 146.875 / sqrt(265.5));
    free(text);
}
END_TEST

/// Whether the triangles overlap in space, whatever the time.
static bool overlap_in_space(int i, int j)
{
    tf_worldline edge[2][2];
    for (int k = 0; k < 2; k++)
        for (int v = 0; v < 2; v++)
            edge[k][v] = tf_worldline_between(3, at[k][v][0], at[k][v][1]);
    oracle_simplex s = triangle(edge[0], i), r = triangle(edge[1], j);
    return oracle_slices_meet(3, &s, &r);
}

// The chapter says which.
START_TEST(three_pairs_overlap_in_space)
{
    ck_assert(!overlap_in_space(0, 0));
    ck_assert(overlap_in_space(0, 1));
    ck_assert(overlap_in_space(1, 0));
    ck_assert(overlap_in_space(1, 1));
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/edge_edge_distances",
                        the_four_pairs_do_what_the_oracle_says);
    TCase *distances = tcase_create("distances");
    tcase_add_test(distances, the_distances_are_those_of_places_tried);
    tcase_add_test(distances, three_pairs_overlap_in_space);
    suite_add_tcase(s, distances);
    return s;
}
