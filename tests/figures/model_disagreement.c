#include "figures/numbers.h"

enum {
    QUERIES = 200000,
    JUDGED = 500, ///< of those, by the oracle too
    HALVINGS = 60
};

/// Random points and edges, as the figure makes them.
static void make_query(generator *random, double displacement,
                       tf_worldline vertex[3])
{
    for (int i = 0; i < 3; i++) {
        double start[2], end[2];
        for (int k = 0; k < 2; k++) {
            start[k] = uniform(random, 0, 1);
            end[k] = start[k] + displacement * uniform(random, -1, 1);
        }
        vertex[i] = tf_worldline_between(2, start, end);
    }
}

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/// The edge's ends at the time t, less the point.
static void see(const tf_worldline vertex[3], double t, double seen[2][2])
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            double at[2];
            for (int late = 0; late < 2; late++)
                at[late] =
                    vertex[i + 1].at[late].x[k] - vertex[0].at[late].x[k];
            seen[i][k] = (1 - t) * at[0] + t * at[1];
        }
}

static bool origin_within(const double a[2], const double b[2],
                          const double c[2])
{
    double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Whether the bent edge meets the point: in the point's frame the origin is in
/// a triangle of the sweep.
static bool meets_bent(const tf_worldline vertex[3])
{
    double start[2][2], end[2][2];
    see(vertex, 0, start);
    see(vertex, 1, end);
    return origin_within(start[0], start[1], end[1]) ||
           origin_within(start[0], end[0], end[1]);
}

/// The time between lo and hi at which the point is on the edge's line, given
/// that it changes sides.
static double crossing(const tf_worldline vertex[3], double lo, double hi)
{
    double seen[2][2];
    see(vertex, lo, seen);
    bool left = cross(seen[0], seen[1]) > 0;
    for (int i = 0; i < HALVINGS; i++) {
        double middle = (lo + hi) / 2;
        see(vertex, middle, seen);
        *((cross(seen[0], seen[1]) > 0) == left ? &lo : &hi) = middle;
    }
    return lo;
}

/// Whether the straight edge meets the point from lo to hi, while the side it
/// has the point on changes at most once.
static bool meets_straight_within(const tf_worldline vertex[3], double lo,
                                  double hi)
{
    double a[2][2], b[2][2];
    see(vertex, lo, a);
    see(vertex, hi, b);
    if ((cross(a[0], a[1]) > 0) == (cross(b[0], b[1]) > 0))
        return false;
    see(vertex, crossing(vertex, lo, hi), a);
    return a[0][0] * a[1][0] + a[0][1] * a[1][1] <= 0;
}

/// The side is the sign of a quadratic function, cut here at its vertex.
static bool meets_straight(const tf_worldline vertex[3])
{
    double value[3];
    for (int i = 0; i < 3; i++) {
        double seen[2][2];
        see(vertex, i / 2., seen);
        value[i] = cross(seen[0], seen[1]);
    }
    double bend = 2 * (value[0] - 2 * value[1] + value[2]);
    double top = (3 * value[0] - 4 * value[1] + value[2]) / (2 * bend);
    if (!(top > 0 && top < 1))
        return meets_straight_within(vertex, 0, 1);
    return meets_straight_within(vertex, 0, top) ||
           meets_straight_within(vertex, top, 1);
}

static void expect_at(const char *text, const char *name, double displacement,
                      double expected)
{
    char key[32];
    snprintf(key, sizeof key, "%s_%g", name, displacement);
    expect_number(text, key, expected);
}

static void expect_counts(const char *text, double displacement)
{
    generator random = {.state = 1};
    int hits = 0, extra = 0, fewer = 0;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[3];
        make_query(&random, displacement, vertex);
        bool bent = meets_bent(vertex), straight = meets_straight(vertex);
        if (i < JUDGED)
            ck_assert(bent == (oracle_time(2, 1, vertex, 2, vertex + 1) >= 0));
        hits += bent;
        extra += bent && !straight;
        fewer += straight && !bent;
    }
    int differ = extra + fewer;
    expect_at(text, "hits", displacement, (double)hits / QUERIES);
    expect_at(text, "extra", displacement, extra);
    expect_at(text, "fewer", displacement, fewer);
    expect_at(text, "differ", displacement, (double)differ / QUERIES);
    expect_at(text, "one_in", displacement, (double)QUERIES / differ);
    expect_at(text, "share", displacement, (double)differ / hits);
    expect_at(text, "error", displacement, sqrt(differ) / hits);
}

/// Short motions are near the limit, as near as their counts are certain.
static void expect_limit(const char *text)
{
    double limit = number_of(text, "share_in_the_limit");
    double share = number_of(text, "share_0.02");
    double error = number_of(text, "error_0.02");
    ck_assert_msg(fabs(share - limit) < 2 * error,
                  "a share of %g +- %g, and %g in the limit", share, error,
                  limit);
}

START_TEST(counts_are_right)
{
    // Those that the text tells.
    char *text = printed(&fig_model_disagreement);
    expect_number(text, "queries", QUERIES);
    expect_counts(text, 0.01);
    expect_counts(text, 0.1);
    expect_counts(text, 1);
    expect_limit(text);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/model_disagreement", counts_are_right);
}
