#include "check.h"

#include "intersect/cascade.h"
#include "support/oracle.h"
#include "support/rational.h"

typedef struct encounter {
    double point[2][2];
    double edge[2][2][2];
} encounter;

encounter for_one_instant(void);

/// The exact time at which a point first meets an edge of one or two vertices.
static bool first_time(const tf_worldline *point, int vertices,
                       const tf_worldline edge[], mpq_t t)
{
    return oracle_meet(2, 1, point, vertices, edge, t);
}

/// The time at which they meet last: the first of the reversed motion, in which
/// the staircase climbs the other way.
static void last_time(const tf_worldline *point, const tf_worldline edge[2],
                      mpq_t t)
{
    tf_worldline back = tf_worldline_between(2, point->at[1].x, point->at[0].x);
    tf_worldline edge_back[2];
    for (int v = 0; v < 2; v++)
        edge_back[1 - v] =
            tf_worldline_between(2, edge[v].at[1].x, edge[v].at[0].x);
    mpq_t left;
    mpq_init(left);
    first_time(&back, 2, edge_back, left);
    mpq_set_ui(t, 1, 1);
    mpq_sub(t, t, left);
    mpq_clear(left);
}

/// Whether they meet according to the library.
static bool library_meets(const tf_worldline *point, const tf_worldline edge[2])
{
    tf_simplex s[1], r[2];
    tf_sweep(1, point, s);
    tf_sweep(2, edge, r);
    bool meets = false;
    for (int j = 0; j < 2; j++) {
        tf_pair pair = tf_pair_of(&s[0], &r[j], 2);
        tf_intersection found =
            tf_intersect(&oracle_arithmetic, &pair, TF_ONLY_VERDICT);
        meets |= found.verdict == TF_HIT;
    }
    return meets;
}

static void expect_one_instant(const tf_worldline *point,
                               const tf_worldline edge[2])
{
    mpq_t first, last, at_vertex;
    mpq_inits(first, last, at_vertex, NULL);
    check_that(library_meets(point, edge) && first_time(point, 2, edge, first),
               "they meet", "they do not meet");
    double t = mpq_get_d(first);
    check_that(mpq_sgn(first) > 0 && mpq_cmp_ui(first, 1, 1) < 0,
               "0 < t < 1 when they meet first", "t = %s", text_real(t));
    last_time(point, edge, last);
    check_that(mpq_equal(first, last), "a single instant",
               "they meet first at t = %s and last at t = %s", text_real(t),
               text_real(mpq_get_d(last)));
    check_that(first_time(point, 1, edge, at_vertex) &&
                   mpq_equal(first, at_vertex),
               "the point is at vertex 0 then",
               "it is elsewhere on the edge, at t = %s", text_real(t));
    mpq_clears(first, last, at_vertex, NULL);
}

TEST(meets_for_one_instant)
{
    check_input("none: the function gives an encounter");
    encounter e;
    check_value(e, for_one_instant());
    tf_worldline point = tf_worldline_between(2, e.point[0], e.point[1]);
    tf_worldline edge[2];
    for (int v = 0; v < 2; v++)
        edge[v] = tf_worldline_between(2, e.edge[v][0], e.edge[v][1]);
    check_input("point: %s\n%s", text_line(2, &point),
                text_lines(2, "vertex", 2, edge));
    check_picture(2, 1, &point, 2, edge);
    check_finite(2, 1, &point);
    check_finite(2, 2, edge);
    for (int t = 0; t < 2; t++)
        check_that(e.edge[0][t][0] != e.edge[1][t][0] ||
                       e.edge[0][t][1] != e.edge[1][t][1],
                   "an edge that has a length", "none at t = %d", t);
    expect_one_instant(&point, edge);
}

void run_tests(void)
{
    check_run(1, meets_for_one_instant);
}
