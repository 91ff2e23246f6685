#include "check.h"

#include "geometry/sweep.h"
#include "support/oracle.h"

typedef struct crossing {
    double triangle[2][3][2][3];
    double t;
} crossing;

crossing crossed_in_mid_step(void);

/// The bent triangle at a time, in flat triangles: one for each simplex that
/// has three events at one time, two for the parallelogram between.
typedef struct bent {
    tf_event corner[4][3];
} bent;

enum {
    PIECES = 4
};

static tf_event cut(const tf_event *early, const tf_event *late, double t)
{
    tf_event corner = {.t = 0};
    for (int k = 0; k < 3; k++)
        corner.x[k] = (1 - t) * early->x[k] + t * late->x[k];
    return corner;
}

static bent bend(const tf_worldline v[3], double t)
{
    // Pairs of a vertex at the start and one at the end: the corners of pieces.
    static const int pairs[PIECES][3][2] = {{{0, 2}, {1, 2}, {2, 2}},
                                            {{0, 1}, {0, 2}, {1, 2}},
                                            {{0, 1}, {1, 2}, {1, 1}},
                                            {{0, 0}, {0, 1}, {0, 2}}};
    bent b;
    for (int i = 0; i < PIECES; i++)
        for (int j = 0; j < 3; j++)
            b.corner[i][j] =
                cut(&v[pairs[i][j][0]].at[0], &v[pairs[i][j][1]].at[1], t);
    return b;
}

/// Whether two triangles cross at a time, bent as they are.
static bool cross_at(const tf_worldline a[3], const tf_worldline b[3], double t)
{
    bent p = bend(a, t), q = bend(b, t);
    for (int i = 0; i < PIECES; i++)
        for (int j = 0; j < PIECES; j++) {
            const tf_event *c = p.corner[i], *d = q.corner[j];
            oracle_simplex s = {3, {&c[0], &c[1], &c[2]}};
            oracle_simplex r = {3, {&d[0], &d[1], &d[2]}};
            if (oracle_slices_meet(3, &s, &r))
                return true;
        }
    return false;
}

static const int side[3][2] = {{0, 1}, {0, 2}, {1, 2}};

/// Fails where a vertex of a, the first or the second triangle, meets b.
static void expect_no_point(const char *which, const tf_worldline a[3],
                            const tf_worldline b[3])
{
    mpq_t toi;
    mpq_init(toi);
    for (int i = 0; i < 3; i++) {
        bool meet = oracle_meet(3, 1, &a[i], 3, b, toi);
        check_that(
            !meet, "no contact of a point with a triangle",
            "a contact of vertex %d of the %s triangle with the other, at "
            "t = %s",
            i, which, text_real(mpq_get_d(toi)));
    }
    mpq_clear(toi);
}

/// Fails where an edge of a meets one of b.
static void expect_no_edges(const tf_worldline a[3], const tf_worldline b[3])
{
    mpq_t toi;
    mpq_init(toi);
    for (int i = 0; i < 9; i++) {
        const int *e = side[i / 3], *f = side[i % 3];
        bool meet = oracle_meet(3, 2, (tf_worldline[]){a[e[0]], a[e[1]]}, 2,
                                (tf_worldline[]){b[f[0]], b[f[1]]}, toi);
        check_that(
            !meet, "no contact of an edge with an edge",
            "a contact of edge %d, %d of the first triangle with edge %d, "
            "%d of the second, at t = %s",
            e[0], e[1], f[0], f[1], text_real(mpq_get_d(toi)));
    }
    mpq_clear(toi);
}

TEST(cross_without_a_contact)
{
    check_input("none: the function gives two triangles and a time");
    crossing found;
    check_value(found, crossed_in_mid_step());
    tf_worldline v[2][3];
    for (int i = 0; i < 6; i++) {
        double(*x)[3] = found.triangle[i / 3][i % 3];
        v[i / 3][i % 3] = tf_worldline_between(3, x[0], x[1]);
    }
    check_input("%s\n%s\nt = %s", text_lines(3, "first, vertex", 3, v[0]),
                text_lines(3, "second, vertex", 3, v[1]), text_real(found.t));
    check_finite(3, 3, v[0]);
    check_finite(3, 3, v[1]);
    check_that(!cross_at(v[0], v[1], 0), "no intersection at t = 0", "one");
    expect_no_point("first", v[0], v[1]);
    expect_no_point("second", v[1], v[0]);
    expect_no_edges(v[0], v[1]);
    check_that(found.t > 0 && found.t < 1, "0 < t < 1", "t = %s",
               text_real(found.t));
    check_that(cross_at(v[0], v[1], found.t), "a crossing at the time t",
               "none");
}

void run_tests(void)
{
    check_run(1, cross_without_a_contact);
}
