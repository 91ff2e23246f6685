// The join of two trees, against all pairs of boxes.
#include "surface/join.h"

#include "support/boxes.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST = 700
};

/// Elements with vertices at random, which differ, in a tree.
typedef struct elements {
    int count, corners, corner[3 * MOST];
    tf_box box[MOST];
    bool swept;
    tf_tree tree;
} elements;

/// Coordinates are whole numbers of parts of the frame, so that times are
/// quotients of small integers.
enum {
    PARTS = 1024
};

static tf_path vertex[MOST];
static tf_box whole;

static float part(generator *random, int from, int to)
{
    return (float)(from + below(random, to - from + 1)) / PARTS;
}

/// Vertices within `size` parts of each other, at the start and at the end.
static void place_vertices(generator *random, int size)
{
    whole = tf_box_empty;
    for (int i = 0; i < MOST; i++) {
        tf_box box;
        for (int side = 0; side < TF_SIDES; side++)
            vertex[i].at[side] = part(random, -size / 2, size / 2);
        memcpy(box.low, vertex[i].at, sizeof box.low);
        memcpy(box.high, vertex[i].at, sizeof box.high);
        whole = box_union(whole, box);
    }
}

static tf_box box_of(const elements *list, int i)
{
    tf_box box = tf_box_empty;
    for (int c = 0; c < list->corners; c++) {
        const float *at = vertex[list->corner[list->corners * i + c]].at;
        tf_box own;
        memcpy(own.low, at, sizeof own.low);
        memcpy(own.high, at, sizeof own.high);
        box = box_union(box, own);
    }
    for (int k = 0; list->swept && k < TF_AXES; k++) {
        box.low[TF_AXES + k] = fminf(box.low[k], box.low[TF_AXES + k]);
        box.high[TF_AXES + k] = fmaxf(box.high[k], box.high[TF_AXES + k]);
    }
    return box;
}

/// Puts the elements of a list into its tree.
static void build(elements *list)
{
    for (int i = 0; i < list->count; i++)
        list->box[i] = box_of(list, i);
    tf_tree_workspace workspace = {0};
    tf_tree_elements given = {.count = list->count,
                              .corners = list->corners,
                              .corner = list->corner,
                              .vertex = vertex,
                              .whole = &whole,
                              .swept = list->swept};
    ck_assert(tf_tree_build(&list->tree, &given, &workspace, NULL));
    tf_tree_workspace_free(&workspace);
}

static void fill(generator *random, int count, int corners, bool swept,
                 elements *list)
{
    *list = (elements){.count = count, .corners = corners, .swept = swept};
    for (int i = 0; i < count; i++) {
        int *corner = list->corner + corners * i, v = below(random, MOST);
        for (int c = 0; c < corners; c++) {
            corner[c] = v;
            v = (v + 1 + below(random, 5)) % MOST;
        }
    }
    build(list);
}

// Overlaps --------------------------------------------------------------------

/// On which side of another box one is: -1, 1, or 0 if they overlap there.
static int side_of(const tf_box *a, const tf_box *b, int side)
{
    return a->high[side] < b->low[side] ? -1 : a->low[side] > b->high[side];
}

/// Whether boxes are on the same side of each other at both ends, on an axis.
static bool are_apart(const tf_box *a, const tf_box *b)
{
    bool apart = false;
    for (int k = 0; k < TF_AXES; k++)
        apart |= side_of(a, b, k) != 0 &&
                 side_of(a, b, k) == side_of(a, b, TF_AXES + k);
    return apart;
}

static bool overlap_at_end(const tf_box *a, const tf_box *b)
{
    bool overlap = true;
    for (int k = TF_AXES; k < TF_SIDES; k++)
        overlap &= side_of(a, b, k) == 0;
    return overlap;
}

/// A number, as a quotient with a positive divisor.
typedef struct quotient {
    long number, divisor;
} quotient;

static bool is_less(quotient a, quotient b)
{
    return a.number * b.divisor < b.number * a.divisor;
}

/// Narrows a period to when a linear distance, in parts, is not negative; false
/// if that is never.
static bool narrow(quotient period[2], long start, long end)
{
    if (start < 0 && end < 0)
        return false;
    quotient zero = {start < 0 ? -start : start, labs(start - end)};
    if (start < 0 && is_less(period[0], zero))
        period[0] = zero;
    if (end < 0 && is_less(zero, period[1]))
        period[1] = zero;
    return true;
}

/// Whether boxes whose sides move linearly overlap at one time.
static bool overlap_in_time(const tf_box *a, const tf_box *b)
{
    quotient period[2] = {{0, 1}, {1, 1}};
    for (int k = 0; k < TF_AXES; k++) {
        int l = TF_AXES + k;
        if (!narrow(period, lrintf(PARTS * (a->high[k] - b->low[k])),
                    lrintf(PARTS * (a->high[l] - b->low[l]))) ||
            !narrow(period, lrintf(PARTS * (b->high[k] - a->low[k])),
                    lrintf(PARTS * (b->high[l] - a->low[l]))))
            return false;
    }
    return !is_less(period[1], period[0]);
}

static bool share(const elements *s, int i, const elements *t, int j)
{
    for (int a = 0; a < s->corners; a++)
        for (int b = 0; b < t->corners; b++)
            if (s->corner[s->corners * i + a] == t->corner[t->corners * j + b])
                return true;
    return false;
}

/// Whether a pair must come: 1, may not: 0, or may: -1.
static int expected(const elements *s, int i, const elements *t, int j)
{
    const tf_box *a = &s->box[i], *b = &t->box[j];
    if (share(s, i, t, j) || (s == t && i == j))
        return 0;
    if (s->swept)
        return overlap_at_end(a, b);
    return are_apart(a, b) ? 0 : overlap_in_time(a, b) ? 1 : -1;
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

/// Pairs that may come: those that did, and those that did not.
static long spared, dropped;

static void compare(const elements *s, const elements *t)
{
    table *all = join(s, t, 1 << 30);
    for (int i = 0; i < s->count; i++)
        for (int j = s == t ? i + 1 : 0; j < t->count; j++) {
            int came = all->came[i][j], wanted = expected(s, i, t, j);
            // An assertion that passes takes longer than the question itself.
            if (came > 1 || (wanted >= 0 && came != wanted))
                ck_abort_msg("%d, %d: %d times, expected %d", i, j, came,
                             wanted);
            spared += wanted < 0 && came;
            dropped += wanted < 0 && !came;
        }
    free(all);
}

START_TEST(every_pair_is_found_once)
{
    static const int counts[] = {1, 16, 17, 300, MOST};
    static const int sizes[] = {2000, 200, 8};
    static elements s, t;
    generator random = generator_new((uint64_t)_i);
    int corners = 1 + _i / 3 % 2, others = 1 + _i / 6 % 3;
    bool swept = _i >= 18;
    place_vertices(&random, sizes[_i % 3]);
    for (int i = 0; i < 5; i++) {
        fill(&random, counts[i], corners, swept, &s);
        fill(&random, counts[4 - i], others, swept, &t);
        compare(&s, &s);
        compare(&s, &t);
        tf_tree_free(&s.tree);
        tf_tree_free(&t.tree);
    }
}
END_TEST

// An eighth of all pairs pass each other on all axes, but hardly one at one time.
START_TEST(times_drop_pairs_of_crowds)
{
    static elements s;
    generator random = generator_new(11);
    spared = dropped = 0;
    place_vertices(&random, 2000);
    fill(&random, MOST, 1, false, &s);
    compare(&s, &s);
    ck_assert_int_gt(dropped, spared);
    tf_tree_free(&s.tree);
}
END_TEST

// Differences of coordinates and times are rounded here, so that times on several
// axes differ by a last bit though the points meet.
START_TEST(all_that_meet_in_one_place_are_pairs)
{
    static elements s;
    generator random = generator_new(12 + (uint64_t)_i);
    int time = 1 + below(&random, 998), times = 999, most = (1 << 24) / times;
    whole = tf_box_empty;
    for (int side = 0; side < TF_SIDES; side++) {
        whole.low[side] = -1;
        whole.high[side] = 1;
    }
    for (int v = 0; v < MOST; v++)
        for (int k = 0; k < TF_AXES; k++) {
            int speed = below(&random, 2 * most + 1) - most;
            vertex[v].at[k] = ldexpf((float)(-time * speed), -24);
            vertex[v].at[TF_AXES + k] =
                ldexpf((float)((times - time) * speed), -24);
        }
    s = (elements){.count = MOST, .corners = 1};
    for (int v = 0; v < MOST; v++)
        s.corner[v] = v;
    build(&s);
    table *all = join(&s, &s, 1 << 30);
    int wrong = 0;
    for (int i = 0; i < MOST; i++)
        for (int j = i + 1; j < MOST; j++)
            wrong += all->came[i][j] != 1;
    ck_assert_int_eq(wrong, 0);
    free(all);
    tf_tree_free(&s.tree);
}
END_TEST

/// The neighbor of a number on one side, or the number itself.
static float beside(float x, int side)
{
    return side == 0 ? x : nextafterf(x, side < 0 ? -1.0f : 1.0f);
}

// Two points that are in one place but for a last bit, on one axis, at each end.
START_TEST(points_that_touch_at_one_time_are_a_pair)
{
    static elements s;
    int k = _i % TF_AXES, start = _i / 3 % 3 - 1, end = _i / 9 % 3 - 1;
    for (int v = 0; v < 2; v++)
        for (int side = 0; side < TF_SIDES; side++)
            vertex[v].at[side] = 0.3f;
    vertex[1].at[k] = beside(0.3f, start);
    vertex[1].at[TF_AXES + k] = beside(0.3f, end);
    whole = tf_box_empty;
    for (int side = 0; side < TF_SIDES; side++) {
        whole.low[side] = 0;
        whole.high[side] = 1;
    }
    s = (elements){
        .count = 2, .corners = 1, .corner = {0, 1}, .swept = _i >= 27};
    build(&s);
    table *all = join(&s, &s, 2);
    ck_assert_int_eq(all->came[0][1], start * end <= 0);
    free(all);
    tf_tree_free(&s.tree);
}
END_TEST

START_TEST(a_join_stops_when_told)
{
    static elements s;
    generator random = generator_new(9);
    place_vertices(&random, 8);
    fill(&random, MOST, 2, false, &s);
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
    place_vertices(&random, 8);
    fill(&random, 20, 2, false, &s);
    compare(&s, &none);
    tf_tree_free(&s.tree);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/join");
    TCase *tcase = tcase_create("join");
    tcase_add_loop_test(tcase, every_pair_is_found_once, 0, 36);
    tcase_add_test(tcase, times_drop_pairs_of_crowds);
    tcase_add_loop_test(tcase, points_that_touch_at_one_time_are_a_pair, 0, 54);
    tcase_add_loop_test(tcase, all_that_meet_in_one_place_are_pairs, 0, 10);
    tcase_add_test(tcase, a_join_stops_when_told);
    tcase_add_test(tcase, an_empty_tree_has_no_pairs);
    suite_add_tcase(suite, tcase);
    return suite;
}
