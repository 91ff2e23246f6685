// Candidates, against the boxes of all pairs at some times, in doubles.
#include "surface/candidates.h"

#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static surface_case given;

// Boxes -----------------------------------------------------------------------

/// The box, in doubles, of an element at one time.
typedef struct exact_box {
    double low[3], high[3];
} exact_box;

static exact_box box_of(int count, const int vertex[], double time)
{
    int axes = given.mesh.axes;
    exact_box box = {{0}, {0}};
    for (int k = 0; k < axes; k++)
        for (int i = 0; i < count; i++) {
            double from = given.start[axes * vertex[i] + k],
                   to = given.end[axes * vertex[i] + k],
                   x = (1 - time) * from + time * to;
            box.low[k] = i == 0 || x < box.low[k] ? x : box.low[k];
            box.high[k] = i == 0 || x > box.high[k] ? x : box.high[k];
        }
    return box;
}

/// Whether boxes overlap, by so much of their coordinates.
static bool overlap(const exact_box *a, const exact_box *b, double part)
{
    for (int k = 0; k < given.mesh.axes; k++) {
        double low = fmax(a->low[k], b->low[k]),
               high = fmin(a->high[k], b->high[k]);
        if (high - part * fabs(high) < low + part * fabs(low))
            return false;
    }
    return true;
}

enum {
    MOMENTS = 8
};

/// Whether boxes overlap at the start, at the end, or at one of some times
/// between, where coordinates are rounded, certainly.
static bool overlap_in_time(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i <= MOMENTS; i++) {
        double time = (double)i / MOMENTS;
        exact_box first = box_of(count, a, time),
                  second = box_of(others, b, time);
        if (overlap(&first, &second, i % MOMENTS == 0 ? 0 : 0x1p-40))
            return true;
    }
    return false;
}

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

// Lists -----------------------------------------------------------------------

/// The vertices of an element: the i-th vertex itself, or that of a list.
typedef struct elements {
    int corners, count;
    const int *corner; ///< NULL: the vertices
} elements;

static const int *vertices_of(const elements *list, const int *i)
{
    return list->corner ? list->corner + list->corners * *i : i;
}

static int compare_pairs(const void *first, const void *second)
{
    const tf_candidate *a = first, *b = second;
    if (a->first != b->first)
        return a->first < b->first ? -1 : 1;
    return (a->second > b->second) - (a->second < b->second);
}

/// Pairs in increasing order, of two elements of one list the lower first.
static tf_candidate *sorted(size_t count, const tf_candidate pair[], bool same)
{
    tf_candidate *copy = malloc(sizeof *copy * (count + 1));
    for (size_t i = 0; i < count; i++) {
        bool swap = same && pair[i].second < pair[i].first;
        copy[i].first = swap ? pair[i].second : pair[i].first;
        copy[i].second = swap ? pair[i].first : pair[i].second;
    }
    qsort(copy, count, sizeof *copy, compare_pairs);
    return copy;
}

/// Each pair of elements that share no vertex and whose boxes overlap at one time
/// must be a candidate, and no pair twice, nor one that shares a vertex.
static void check_list(const elements *s, const elements *t, size_t count,
                       const tf_candidate pair[])
{
    bool same = s->corner && s->corner == t->corner;
    tf_candidate *list = sorted(count, pair, same);
    size_t next = 0;
    for (int i = 0; i < s->count; i++)
        for (int j = same ? i + 1 : 0; j < t->count; j++) {
            const int *a = vertices_of(s, &i), *b = vertices_of(t, &j);
            bool listed =
                next < count && list[next].first == i && list[next].second == j;
            next += (size_t)listed;
            if (share(s->corners, a, t->corners, b))
                ck_assert(!listed);
            else
                ck_assert_msg(
                    listed || !overlap_in_time(s->corners, a, t->corners, b),
                    "%d and %d, seed %llu", i, j, (unsigned long long)seed());
        }
    ck_assert_uint_eq(next, count);
    free(list);
}

static void check_candidates(tf_surface *surface, const tf_candidates *found)
{
    elements vertices = {1, given.mesh.vertices, NULL}, edges = {2, 0, NULL},
             triangles = {3, 0, NULL};
    edges.corner = tf_surface_edges(surface, &edges.count);
    triangles.corner = tf_surface_triangles(surface, &triangles.count);
    bool plane = given.mesh.axes == 2;
    check_list(&vertices, plane ? &edges : &triangles, found->point_count,
               found->points);
    if (plane)
        ck_assert_uint_eq(found->edge_count, 0);
    else
        check_list(&edges, &edges, found->edge_count, found->edges);
}

// Surfaces --------------------------------------------------------------------

static void check_surfaces(int count, int most, placement placed, int stream)
{
    generator random = generator_new((uint64_t)stream);
    for (int i = 0; i < count; i++) {
        random_surface(&random, 2 + i % 2, most, placed, &given);
        tf_surface *surface = surface_of(&given.mesh);
        tf_candidates found;
        ck_assert_int_eq(
            tf_surface_candidates(surface, &given.motion, NULL, &found, NULL),
            TF_OK);
        check_candidates(surface, &found);
        tf_surface_free(surface);
    }
}

START_TEST(no_overlapping_boxes_are_missed)
{
    check_surfaces((int)cases(60), 12, (placement)_i, 100 + _i);
    check_surfaces((int)cases(6), SURFACE_ELEMENTS, (placement)_i, 200 + _i);
}
END_TEST

START_TEST(one_long_element_among_many_small_ones_is_found)
{
    generator random = generator_new(300);
    random_surface(&random, 3, SURFACE_ELEMENTS, ANYWHERE, &given);
    for (int i = 0; i < 3 * given.mesh.vertices; i++) {
        given.start[i] *= 1e-9;
        given.end[i] *= 1e-9;
    }
    for (int k = 0; k < 3; k++)
        given.start[3 * given.triangle[0] + k] = 1e9;
    tf_surface *surface = surface_of(&given.mesh);
    tf_candidates found;
    ck_assert_int_eq(
        tf_surface_candidates(surface, &given.motion, NULL, &found, NULL),
        TF_OK);
    check_candidates(surface, &found);
    tf_surface_free(surface);
}
END_TEST

START_TEST(any_number_of_workers_gives_the_same_list)
{
    generator random = generator_new(400 + (uint64_t)_i);
    random_surface(&random, 3, SURFACE_ELEMENTS, (placement)_i, &given);
    tf_surface *one = surface_of(&given.mesh),
               *several = surface_of(&given.mesh);
    tf_candidates expected;
    ck_assert_int_eq(
        tf_surface_candidates(one, &given.motion, NULL, &expected, NULL),
        TF_OK);
    for (int workers = 1; workers <= 8; workers++) {
        tf_parallel parallel = scrambled_workers(&workers);
        tf_candidates found;
        ck_assert_int_eq(
            tf_surface_candidates(several, &given.motion,
                                  &(tf_detect_options){.parallel = &parallel},
                                  &found, NULL),
            TF_OK);
        ck_assert_uint_eq(found.point_count, expected.point_count);
        ck_assert_uint_eq(found.edge_count, expected.edge_count);
        size_t all = found.point_count + found.edge_count;
        ck_assert_mem_eq(found.points, expected.points,
                         all * sizeof *found.points);
    }
    tf_surface_free(one);
    tf_surface_free(several);
}
END_TEST

START_TEST(null_breaks_the_contract)
{
    tf_surface_candidates(NULL, &given.motion, NULL, &(tf_candidates){0}, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/candidates");
    TCase *tcase = tcase_create("candidates");
    tcase_add_loop_test(tcase, no_overlapping_boxes_are_missed, 0, PLACEMENTS);
    tcase_add_test(tcase, one_long_element_among_many_small_ones_is_found);
    tcase_add_loop_test(tcase, any_number_of_workers_gives_the_same_list, 0,
                        PLACEMENTS);
    tcase_add_test_raise_signal(tcase, null_breaks_the_contract, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
