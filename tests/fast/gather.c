// Gathering, against copying number by number.
#include "fast/gather.h"

#include "support/support.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_VERTICES = 20,
    QUERIES = 100,
    BLOCKS = TF_MASK_QUERIES / TF_BLOCK_QUERIES
};

static const tf_kind kinds[] = {TF_POINT_TRIANGLE, TF_EDGE_EDGE};

/// Some queries of a scene, whose arrays end with the last vertex, so that the
/// sanitizer sees what is read behind it.
typedef struct some_queries {
    double *start, *end;
    int vertex[4 * QUERIES];
    tf_motion motion;
    tf_queries queries;
} some_queries;

static double *coordinates(generator *random, int vertices)
{
    double *x = malloc(sizeof *x * 3 * (size_t)vertices);
    ck_assert_ptr_nonnull(x);
    for (int i = 0; i < 3 * vertices; i++)
        x[i] = uniform(random, -1, 1);
    return x;
}

static void choose_vertices(generator *random, int vertices, int vertex[4])
{
    for (int i = 0; i < 4; i++) {
        bool taken;
        do {
            taken = false;
            vertex[i] = below(random, vertices);
            for (int j = 0; j < i; j++)
                taken |= vertex[j] == vertex[i];
        } while (taken);
    }
}

static void fill(some_queries *all, generator *random, tf_kind kind)
{
    int vertices = 4 + below(random, MOST_VERTICES - 3);
    all->start = coordinates(random, vertices);
    all->end = coordinates(random, vertices);
    for (int i = 0; i < QUERIES; i++)
        choose_vertices(random, vertices, all->vertex + (ptrdiff_t)4 * i);
    all->motion = (tf_motion){3, vertices, all->start, all->end};
    all->queries = (tf_queries){kind, &all->motion, QUERIES, all->vertex};
}

static void empty(some_queries *all)
{
    free(all->start);
    free(all->end);
}

// Coordinates -------------------------------------------------------------------

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/// Whether a lane has the coordinates of a query, each element's in order.
static bool has_query(const tf_query_block *block, int lane,
                      const some_queries *all, size_t query)
{
    int vertex[4], first = all->queries.kind == TF_EDGE_EDGE ? 2 : 1;
    memcpy(vertex, all->vertex + 4 * query, sizeof vertex);
    qsort(vertex, (size_t)first, sizeof *vertex, compare);
    qsort(vertex + first, (size_t)(4 - first), sizeof *vertex, compare);
    bool same = true;
    for (int v = 0; v < 4; v++)
        for (int k = 0; k < 3; k++) {
            size_t place = (size_t)(3 * vertex[v] + k);
            same &= block->at[0][v][k][lane] == all->start[place];
            same &= block->at[1][v][k][lane] == all->end[place];
        }
    return same;
}

START_TEST(each_lane_has_its_query_and_the_last_ones_the_last)
{
    generator random = generator_new(100 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(200); times++) {
        some_queries all;
        fill(&all, &random, kinds[_i]);
        size_t begin = (size_t)below(&random, QUERIES - TF_MASK_QUERIES);
        size_t count = 1 + (size_t)below(&random, TF_MASK_QUERIES);
        tf_query_block block[BLOCKS];
        ck_assert(tf_gather(&all.queries, begin, begin + count, block));
        size_t lanes = (count + TF_BLOCK_QUERIES - 1) / TF_BLOCK_QUERIES *
                       TF_BLOCK_QUERIES;
        for (size_t i = 0; i < lanes; i++)
            ck_assert(has_query(&block[i / TF_BLOCK_QUERIES],
                                (int)(i % TF_BLOCK_QUERIES), &all,
                                begin + (i < count ? i : count - 1)));
        empty(&all);
    }
}
END_TEST

// Indices -----------------------------------------------------------------------

START_TEST(one_bad_index_is_found)
{
    generator random = generator_new(200 + (uint64_t)_i);
    for (int times = 0; times < (int)cases(50); times++) {
        some_queries all;
        fill(&all, &random, kinds[_i]);
        size_t count = 1 + (size_t)below(&random, TF_MASK_QUERIES);
        int *bad = all.vertex + (ptrdiff_t)4 * below(&random, (int)count);
        tf_query_block block[BLOCKS];
        for (int i = 0; i < 4; i++) {
            const int good = bad[i];
            const int wrong[] = {-1,
                                 INT_MIN,
                                 all.motion.vertices,
                                 INT_MAX,
                                 bad[(i + 1) % 4],
                                 bad[(i + 2) % 4],
                                 bad[(i + 3) % 4]};
            for (size_t j = 0; j < sizeof wrong / sizeof *wrong; j++) {
                bad[i] = wrong[j];
                ck_assert(!tf_gather(&all.queries, 0, count, block));
            }
            bad[i] = good;
            ck_assert(tf_gather(&all.queries, 0, count, block));
        }
        empty(&all);
    }
}
END_TEST

START_TEST(a_scene_without_vertices_has_no_good_index)
{
    static const int counts[] = {0, -1};
    static const int vertex[] = {0, 1, 2, 3};
    tf_motion motion = {.axes = 3, .vertices = counts[_i]};
    tf_queries one = {TF_EDGE_EDGE, &motion, 1, vertex};
    tf_query_block block[BLOCKS];
    ck_assert(!tf_gather(&one, 0, 1, block));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("fast/gather");
    TCase *c = tcase_create("gather");
    tcase_add_loop_test(c, each_lane_has_its_query_and_the_last_ones_the_last,
                        0, 2);
    tcase_add_loop_test(c, one_bad_index_is_found, 0, 2);
    tcase_add_loop_test(c, a_scene_without_vertices_has_no_good_index, 0, 2);
    suite_add_tcase(suite, c);
    return suite;
}
