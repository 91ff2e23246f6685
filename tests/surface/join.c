// The join of two trees, against all pairs of boxes.
#include "surface/join.h"

#include "support/support.h"

#include <stdlib.h>
#include <string.h>

enum {
    MOST = 700
};

/// Elements with vertices at random, which differ, in a tree.
typedef struct elements {
    int count, corners, corner[3 * MOST];
    tf_box box[MOST];
    tf_tree tree;
} elements;

static tf_box vertex[MOST];
static tf_box whole;

static void place_vertices(generator *random, float size)
{
    whole = tf_box_empty;
    for (int i = 0; i < MOST; i++) {
        for (int k = 0; k < 3; k++) {
            vertex[i].low[k] = (float)uniform(random, 0, 1);
            vertex[i].high[k] = vertex[i].low[k] + size;
        }
        whole = tf_box_union(whole, vertex[i]);
    }
}

static void fill(generator *random, int count, int corners, elements *list)
{
    *list = (elements){.count = count, .corners = corners};
    for (int i = 0; i < count; i++) {
        int *corner = list->corner + corners * i, v = below(random, MOST);
        list->box[i] = vertex[v];
        for (int c = 0; c < corners; c++) {
            corner[c] = v;
            list->box[i] = tf_box_union(list->box[i], vertex[v]);
            v = (v + 1 + below(random, 5)) % MOST;
        }
    }
    tf_tree_workspace workspace = {0};
    tf_tree_elements given = {.count = count,
                              .corners = corners,
                              .corner = list->corner,
                              .vertex = vertex,
                              .whole = &whole};
    ck_assert(tf_tree_build(&list->tree, &given, &workspace, NULL));
    tf_tree_workspace_free(&workspace);
}

static bool overlap(const tf_box *a, const tf_box *b)
{
    for (int k = 0; k < 3; k++)
        if (a->low[k] > b->high[k] || b->low[k] > a->high[k])
            return false;
    return true;
}

static bool share(const elements *s, int i, const elements *t, int j)
{
    for (int a = 0; a < s->corners; a++)
        for (int b = 0; b < t->corners; b++)
            if (s->corner[s->corners * i + a] == t->corner[t->corners * j + b])
                return true;
    return false;
}

static bool is_pair(const elements *s, int i, const elements *t, int j)
{
    return !share(s, i, t, j) && (s != t || i != j) &&
           overlap(&s->box[i], &t->box[j]);
}

// Sinks -----------------------------------------------------------------------

/// Which pairs came; of pairs of one list the lower index is the first.
typedef struct table {
    tf_pair_sink sink;
    bool same;
    int left; ///< how many batches are still wanted
    int came[MOST][MOST];
} table;

static bool take(tf_pair_sink *sink, int count, const tf_candidate pair[])
{
    table *all = (table *)sink;
    ck_assert_int_gt(count, 0);
    ck_assert_int_le(count, TF_BATCH);
    for (int i = 0; i < count; i++) {
        int a = pair[i].first, b = pair[i].second;
        all->came[all->same && b < a ? b : a][all->same && b < a ? a : b]++;
    }
    return --all->left > 0;
}

static table *join(const elements *s, const elements *t, int batches)
{
    table *all = calloc(1, sizeof *all);
    all->sink.take = take;
    all->same = s == t;
    all->left = batches;
    int leaves = s->tree.packs[0];
    for (int leaf = 0; leaf < leaves; leaf += 3) {
        tf_range part = {leaf, leaf + 3 < leaves ? leaf + 3 : leaves};
        tf_tree_join(&s->tree, &t->tree, part, &all->sink);
    }
    return all;
}

static void compare(const elements *s, const elements *t)
{
    table *all = join(s, t, 1 << 30);
    for (int i = 0; i < s->count; i++)
        for (int j = s == t ? i + 1 : 0; j < t->count; j++)
            ck_assert_int_eq(all->came[i][j], is_pair(s, i, t, j));
    free(all);
}

START_TEST(every_pair_is_found_once)
{
    static const int counts[] = {1, 16, 17, 300, MOST};
    static const float sizes[] = {0.001f, 0.1f, 2};
    static elements s, t;
    generator random = generator_new((uint64_t)_i);
    int corners = 1 + _i / 3 % 2, others = 1 + _i / 6;
    place_vertices(&random, sizes[_i % 3]);
    for (int i = 0; i < 5; i++) {
        fill(&random, counts[i], corners, &s);
        fill(&random, counts[4 - i], others, &t);
        compare(&s, &s);
        compare(&s, &t);
        tf_tree_free(&s.tree);
        tf_tree_free(&t.tree);
    }
}
END_TEST

START_TEST(a_join_stops_when_told)
{
    static elements s;
    generator random = generator_new(9);
    place_vertices(&random, 2);
    fill(&random, MOST, 2, &s);
    table *all = join(&s, &s, 2);
    ck_assert(all->sink.stopped);
    ck_assert_int_eq(all->left, 0);
    free(all);
    tf_tree_free(&s.tree);
}
END_TEST

START_TEST(an_empty_tree_has_no_pairs)
{
    static elements s, none;
    generator random = generator_new(10);
    place_vertices(&random, 2);
    fill(&random, 20, 2, &s);
    compare(&s, &none);
    tf_tree_free(&s.tree);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/join");
    TCase *tcase = tcase_create("join");
    tcase_add_loop_test(tcase, every_pair_is_found_once, 0, 18);
    tcase_add_test(tcase, a_join_stops_when_told);
    tcase_add_test(tcase, an_empty_tree_has_no_pairs);
    suite_add_tcase(suite, tcase);
    return suite;
}
