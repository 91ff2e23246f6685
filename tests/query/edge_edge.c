#include "query/edge_edge.h"

#include "query/query.h"
#include "support/rational.h"
#include "support/statuses.h"
#include "support/support.h"

#include <math.h>

// The first edge falls from z = 1 to z = -1; the second, in the plane z = 0, is
// at rest.

typedef struct fall {
    const char *what;
    double first[2][2], second[2][2];
    bool hit;
    double barycentric[2], normal; // of the second vertices; the normal's z
} fall;

static const fall falls[] = {
    {"a cross", {{0, -1}, {0, 3}}, {{-1, 0}, {1, 0}}, true, {0.25, 0.5}, -1},
    {"a cross, the falling edge reversed",
     {{0, 3}, {0, -1}},
     {{-1, 0}, {1, 0}},
     true,
     {0.75, 0.5},
     1},
    {"a T", {{0, 0}, {0, 1}}, {{-1, 0}, {1, 0}}, true, {0, 0.5}, -1},
    {"an L", {{1, 0}, {1, 1}}, {{-1, 0}, {1, 0}}, true, {0, 1}, -1},
    {"an L that leaves a gap",
     {{1, 0x1p-1074}, {1, 1}},
     {{-1, 0}, {1, 0}},
     false,
     {0},
     0},
    {"side by side", {{-1, 1}, {1, 1}}, {{-1, 0}, {1, 0}}, false, {0}, 0},
    {"one on the other",
     {{-1, 0}, {1, 0}},
     {{-1, 0}, {1, 0}},
     true,
     {-1, -1},
     0},
    {"end to end", {{1, 0}, {2, 0}}, {{-1, 0}, {1, 0}}, true, {0, 1}, 0},
    {"one behind the other",
     {{1.5, 0}, {2, 0}},
     {{-1, 0}, {1, 0}},
     false,
     {0},
     0},
    {"a point on an edge",
     {{0, 0}, {0, 0}},
     {{-1, 0}, {1, 0}},
     true,
     {-1, 0.5},
     0},
    {"a point beside an edge",
     {{0, 1}, {0, 1}},
     {{-1, 0}, {1, 0}},
     false,
     {0},
     0},
};

enum {
    FALLS = sizeof falls / sizeof *falls
};

static tf_worldline vertex(const double x[2], double start, double end)
{
    return tf_worldline_between(3, (double[]){x[0], x[1], start},
                                (double[]){x[0], x[1], end});
}

START_TEST(a_falling_edge_meets_an_edge)
{
    const fall *f = &falls[_i];
    tf_worldline first[2], second[2];
    for (int v = 0; v < 2; v++) {
        first[v] = vertex(f->first[v], 1, -1);
        second[v] = vertex(f->second[v], 0, 0);
    }
    tf_contact c;
    ck_assert_int_eq(tf_query(&oracle_arithmetic, 3, 2, first, 2, second, &c),
                     TF_OK);
    ck_assert_msg(c.verdict == (f->hit ? TF_HIT : TF_APART), "%s: verdict %d",
                  f->what, c.verdict);
    if (!f->hit)
        return;
    ck_assert_msg(c.toi_lo <= 0.5 && 0.5 <= c.toi_hi, "%s: [%a, %a]", f->what,
                  c.toi_lo, c.toi_hi);
    for (int e = 0; e < 2; e++)
        ck_assert_msg(f->barycentric[e] < 0 ||
                          fabs(c.barycentric[e][1] - f->barycentric[e]) < 1e-12,
                      "%s: coordinate %d is %a", f->what, e,
                      c.barycentric[e][1]);
    ck_assert_msg(c.normal[2] == f->normal, "%s: normal %a", f->what,
                  c.normal[2]);
    ck_assert_msg(c.normal_velocity == -2 * f->normal, "%s: normal velocity %a",
                  f->what, c.normal_velocity);
}
END_TEST

// Statuses

static tf_status ask_public(const tf_arithmetic *arithmetic,
                            const tf_motion *motion, const int vertex[],
                            tf_contact *contact)
{
    return tf_edge_edge(arithmetic, motion, vertex, vertex + 2, contact);
}

static void use_public(void)
{
    statuses_use(EDGE_EDGE, ask_public);
}

START_TEST(null_indices_break_the_contract)
{
    static const double x[4 * TF_AXES] = {0};
    tf_motion motion = {.axes = 3, .vertices = 4, .start = x, .end = x};
    tf_contact contact;
    exit_on_broken_contract();
    static const int edge[] = {0, 1};
    tf_edge_edge(&oracle_arithmetic, &motion, _i == 0 ? NULL : edge,
                 _i == 0 ? edge : NULL, &contact);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("query/edge_edge");
    TCase *tcase = tcase_create("edge_edge");
    tcase_add_loop_test(tcase, a_falling_edge_meets_an_edge, 0, FALLS);
    tcase_add_loop_exit_test(tcase, null_indices_break_the_contract,
                             BROKEN_CONTRACT, 0, 2);
    suite_add_tcase(suite, tcase);
    suite_add_tcase(suite, statuses_case("statuses", use_public));
    return suite;
}
