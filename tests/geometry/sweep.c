#include "geometry/sweep.h"

#include "support/support.h"

#include <signal.h>
#include <stdbool.h>

enum {
    MOST = TF_VERTICES
};

/// An element whose vertex v is at (v, 10 t, 0): events tell who they are.
static void make_element(int vertices, tf_worldline element[])
{
    for (int v = 0; v < vertices; v++)
        element[v] =
            tf_worldline_between(3, (double[]){v, 0, 0}, (double[]){v, 10, 0});
}

START_TEST(a_sweep_is_the_staircase)
{
    tf_worldline element[MOST];
    tf_simplex sweep[MOST];
    make_element(MOST, element);
    tf_sweep(_i, element, sweep);
    for (int s = 0; s < _i; s++) {
        int pivot = _i - 1 - s;
        ck_assert_int_eq(sweep[s].pivot, pivot);
        ck_assert_int_eq(sweep[s].count, _i + 1);
        for (int i = 0; i < sweep[s].count; i++) {
            int vertex = i <= pivot ? i : i - 1;
            const tf_event *expected = &element[vertex].at[i > pivot];
            ck_assert_msg(sweep[s].event[i] == expected,
                          "%d vertices, simplex %d, event %d", _i, s, i);
        }
    }
}
END_TEST

/// Which events of the vertices in `kept` a simplex has, a bit each.
static unsigned events_of(const tf_simplex *simplex, unsigned kept)
{
    unsigned events = 0;
    for (int i = 0; i < simplex->count; i++) {
        unsigned vertex = (unsigned)simplex->event[i]->x[0];
        if (kept >> vertex & 1U)
            events |= 1U << (2 * vertex + (unsigned)simplex->event[i]->t);
    }
    return events;
}

static bool has_face(const tf_simplex sweep[], int count, unsigned kept,
                     unsigned face)
{
    for (int s = 0; s < count; s++)
        if (events_of(&sweep[s], kept) == face)
            return true;
    return false;
}

/// The sweep of the edge (a, b) of a triangle, as events of the triangle.
static void expect_faces_of_edge(const tf_worldline triangle[3], int a, int b)
{
    tf_simplex whole[3], part[2];
    tf_worldline edge[2] = {triangle[a], triangle[b]};
    unsigned kept = 1U << a | 1U << b;
    tf_sweep(3, triangle, whole);
    tf_sweep(2, edge, part);
    for (int s = 0; s < 2; s++)
        ck_assert_msg(has_face(whole, 3, kept, events_of(&part[s], kept)),
                      "edge %d %d, simplex %d", a, b, s);
}

START_TEST(sweeps_of_neighbors_share_their_faces)
{
    tf_worldline triangle[3];
    make_element(3, triangle);
    for (int a = 0; a < 3; a++)
        for (int b = a + 1; b < 3; b++)
            expect_faces_of_edge(triangle, a, b);
}
END_TEST

START_TEST(four_vertices_break_the_contract)
{
    tf_worldline element[4];
    tf_simplex sweep[4];
    make_element(4, element);
    tf_sweep(4, element, sweep);
}
END_TEST

START_TEST(no_vertices_break_the_contract)
{
    tf_worldline element[1];
    tf_simplex sweep[1];
    make_element(1, element);
    tf_sweep(0, element, sweep);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("geometry/sweep");
    TCase *tcase = tcase_create("sweep");
    tcase_add_loop_test(tcase, a_sweep_is_the_staircase, 1, MOST + 1);
    tcase_add_test(tcase, sweeps_of_neighbors_share_their_faces);
    tcase_add_test_raise_signal(tcase, four_vertices_break_the_contract,
                                SIGABRT);
    tcase_add_test_raise_signal(tcase, no_vertices_break_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
