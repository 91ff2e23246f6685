#include "figures/numbers.h"

enum {
    QUERIES = 200000,
    JUDGED = 500, ///< of those, by the oracle too
    CORNERS = 4
};

/// Random points and triangles, as the figure makes them.
static void make_query(generator *random, tf_worldline vertex[4])
{
    for (int i = 0; i < 4; i++) {
        double start[3], end[3];
        for (int k = 0; k < 3; k++) {
            start[k] = uniform(random, 0, 1);
            end[k] = start[k] + 0.1 * uniform(random, -1, 1);
        }
        vertex[i] = tf_worldline_between(3, start, end);
    }
}

/// The tetrahedron of a pivot in the point's frame: its corners at t = 0, up to
/// the pivot's, and then those at t = 1.
static void see(const tf_worldline vertex[4], int pivot,
                double corner[CORNERS][3])
{
    for (int i = 0; i < CORNERS; i++) {
        int late = i > pivot;
        for (int k = 0; k < 3; k++)
            corner[i][k] =
                vertex[1 + i - late].at[late].x[k] - vertex[0].at[late].x[k];
    }
}

/// Whether all corners are strictly on one side of the origin on some axis.
static bool beside_an_axis(double corner[CORNERS][3])
{
    for (int k = 0; k < 3; k++) {
        int above = 0, below = 0;
        for (int i = 0; i < CORNERS; i++) {
            above += corner[i][k] > 0;
            below += corner[i][k] < 0;
        }
        if (above == CORNERS || below == CORNERS)
            return true;
    }
    return false;
}

static double determinant(const double *a, const double *b, const double *c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) -
           a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Cramer's rule for the origin's weight of corner i, but for a common factor.
static double weight_of(double corner[CORNERS][3], int i)
{
    const double *rest[3];
    for (int k = 0; k < 3; k++)
        rest[k] = corner[k < i ? k : k + 1];
    return (i % 2 == 0 ? 1 : -1) * determinant(rest[0], rest[1], rest[2]);
}

/// The barycentric coordinates in the order in which they are asked for: at
/// each time the point's, which is the sum, and then the triangle's.
static void find_coordinates(double corner[CORNERS][3], int pivot,
                             double coordinate[CORNERS + 2])
{
    int count = 0;
    for (int late = 0; late < 2; late++) {
        double *sum = &coordinate[count++];
        *sum = 0;
        for (int i = late ? pivot + 1 : 0; i < (late ? CORNERS : pivot + 1);
             i++)
            *sum += coordinate[count++] = weight_of(corner, i);
    }
}

/// How many signs are asked for until two conflict; none must be zero.  Tells
/// whether none did.
static bool ask(double corner[CORNERS][3], int pivot, int *signs)
{
    double coordinate[CORNERS + 2];
    find_coordinates(corner, pivot, coordinate);
    for (int i = 0; i < CORNERS + 2; i++) {
        ++*signs;
        if ((coordinate[i] > 0) != (coordinate[0] > 0))
            return false;
    }
    return true;
}

static bool ask_all(const tf_worldline vertex[4], int *signs)
{
    bool hit = false;
    for (int pivot = 2; pivot >= 0; pivot--) {
        double corner[CORNERS][3];
        see(vertex, pivot, corner);
        if (!beside_an_axis(corner) && ask(corner, pivot, signs))
            hit = true;
    }
    return hit;
}

START_TEST(counts_are_right)
{
    generator random = {.state = 1};
    int queries[2] = {0, 0}, signs[2] = {0, 0}, none = 0;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[4];
        make_query(&random, vertex);
        int asked = 0;
        bool hit = ask_all(vertex, &asked);
        if (i < JUDGED)
            ck_assert(hit == (oracle_time(3, 1, vertex, 3, vertex + 1) >= 0));
        none += asked == 0;
        queries[hit] += asked > 0;
        signs[hit] += asked;
    }
    char *text = printed(&fig_signs_evaluated);
    expect_number(text, "queries", QUERIES);
    expect_number(text, "hits", queries[true]);
    expect_number(text, "none_percent", 100. * none / QUERIES);
    expect_number(text, "miss_mean", (double)signs[false] / queries[false]);
    expect_number(text, "hit_mean", (double)signs[true] / queries[true]);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/signs_evaluated", counts_are_right);
}
