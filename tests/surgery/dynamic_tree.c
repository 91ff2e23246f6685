// Boxes that come and go, against trying each.
#include "surgery/dynamic_tree.h"

#include "support/support.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum {
    ELEMENTS = 200
};

static tf_dynamic_tree tree;
static tf_aabb box[ELEMENTS];
static bool is_in[ELEMENTS];

static tf_aabb some_box(generator *random)
{
    tf_aabb made = tf_aabb_empty();
    for (int i = 0; i < 2; i++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] =
                i == 0 ? below(random, 8) : made.low[k] + below(random, 12) / 4;
        tf_aabb_add(&made, x);
    }
    return made;
}

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static void expect_found(generator *random)
{
    int found[ELEMENTS];
    tf_aabb wanted = some_box(random);
    int count = tf_dynamic_tree_find(&tree, &wanted, found), next = 0;
    qsort(found, (size_t)count, sizeof *found, compare);
    for (int i = 0; i < ELEMENTS; i++)
        if (is_in[i] && tf_aabbs_overlap(&box[i], &wanted)) {
            ck_assert_int_lt(next, count);
            ck_assert_int_eq(found[next++], i);
        }
    ck_assert_int_eq(next, count);
}

static void change_some(generator *random)
{
    int i = below(random, ELEMENTS);
    bool goes = is_in[i] && below(random, 2);
    if (goes)
        tf_dynamic_tree_remove(&tree, i);
    else
        box[i] = some_box(random);
    if (is_in[i] && !goes)
        tf_dynamic_tree_change(&tree, i, box[i]);
    else if (!is_in[i])
        tf_dynamic_tree_insert(&tree, i, box[i]);
    is_in[i] = !goes;
}

static void begin(generator *random, int built)
{
    int order[ELEMENTS];
    ck_assert(tf_dynamic_tree_reserve(&tree, ELEMENTS));
    for (int i = 0; i < ELEMENTS; i++) {
        box[i] = some_box(random);
        is_in[i] = i < built;
        order[i] = i;
    }
    ck_assert(tf_dynamic_tree_build(&tree, box, order, built, NULL));
}

START_TEST(what_overlaps_is_found)
{
    generator random = generator_new(1 + (uint64_t)_i);
    for (long times = 0; times < cases(20); times++) {
        begin(&random, _i);
        for (int i = 0; i < 1000; i++) {
            change_some(&random);
            if (i % 10 == 0)
                expect_found(&random);
        }
    }
    tf_dynamic_tree_free(&tree);
}
END_TEST

static tf_aabb scaled(tf_aabb own, int exponent)
{
    for (int k = 0; k < 3; k++) {
        own.low[k] = ldexp(own.low[k], exponent);
        own.high[k] = ldexp(own.high[k], exponent);
    }
    return own;
}

// In which order boxes are found depends on where they are in the tree.
START_TEST(the_unit_of_length_changes_no_tree)
{
    for (int exponent = -1000; exponent <= 1000; exponent += 40) {
        generator random = generator_new(10);
        tf_dynamic_tree other = {0};
        begin(&random, 0);
        ck_assert(tf_dynamic_tree_reserve(&other, ELEMENTS));
        for (int i = 0; i < ELEMENTS; i++) {
            int found[2][ELEMENTS];
            tf_dynamic_tree_insert(&tree, i, box[i]);
            tf_dynamic_tree_insert(&other, i, scaled(box[i], exponent));
            tf_aabb wanted = some_box(&random);
            tf_aabb same = scaled(wanted, exponent);
            int count = tf_dynamic_tree_find(&tree, &wanted, found[0]);
            ck_assert_int_eq(tf_dynamic_tree_find(&other, &same, found[1]),
                             count);
            ck_assert_mem_eq(found[0], found[1], sizeof(int) * (size_t)count);
        }
        tf_dynamic_tree_free(&other);
        tf_dynamic_tree_free(&tree);
        tree = (tf_dynamic_tree){0};
    }
}
END_TEST

START_TEST(a_box_has_a_scale)
{
    static const double most[] = {0x1p-1074, 0x1p-1001, 0x1p-1000,
                                  1,         0x1.8p3,   0x1p999,
                                  0x1p1000,  0x1p1001,  DBL_MAX};
    static const int exponent[] = {1000,  1000,  999,   -1,   -4,
                                   -1000, -1000, -1000, -1000};
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 6; k++) {
            const double a[] = {k == 0 ? most[i] : 0, k == 1 ? most[i] : 0,
                                k == 2 ? most[i] : 0};
            const double b[] = {k == 3 ? -most[i] : 0, k == 4 ? -most[i] : 0,
                                k == 5 ? -most[i] : 0};
            tf_aabb own = tf_aabb_empty();
            tf_aabb_add(&own, a);
            tf_aabb_add(&own, b);
            ck_assert_double_eq(tf_aabb_scale(&own), ldexp(1, exponent[i]));
        }
    tf_aabb none = tf_aabb_empty();
    ck_assert_double_eq(tf_aabb_scale(&none), 1);
}
END_TEST

// All elements go, and come again, in the branches that they had.
static double squared(void *context, int element)
{
    (void)context;
    (void)element;
    return 1;
}

START_TEST(what_is_infinite_finds_elements_alone)
{
    // With few elements the tree has places that are empty.
    generator random = generator_new(4);
    const tf_aabb all = {{-INFINITY, -INFINITY, -INFINITY},
                         {INFINITY, INFINITY, INFINITY}};
    for (int built = 0; built < 4; built++) {
        int found[ELEMENTS];
        double least, nowhere[] = {0, NAN, 0}, far[] = {0, 0, INFINITY};
        begin(&random, built);
        ck_assert_int_eq(tf_dynamic_tree_find(&tree, &all, found), built);
        ck_assert_int_eq(
            tf_dynamic_tree_nearest(&tree, nowhere, squared, NULL, &least), -1);
        ck_assert_int_eq(
            tf_dynamic_tree_nearest(&tree, far, squared, NULL, &least), -1);
        tf_dynamic_tree_free(&tree);
        tree = (tf_dynamic_tree){0};
    }
}
END_TEST

START_TEST(branches_are_used_again)
{
    generator random = generator_new(9);
    begin(&random, ELEMENTS);
    int branches = tree.branches;
    for (int i = 0; i < ELEMENTS; i++)
        tf_dynamic_tree_remove(&tree, i);
    memset(is_in, 0, sizeof is_in);
    expect_found(&random);
    for (int i = 0; i < ELEMENTS; i++) {
        tf_dynamic_tree_insert(&tree, i, box[i]);
        is_in[i] = true;
    }
    expect_found(&random);
    ck_assert_int_eq(tree.branches, branches);
    tf_dynamic_tree_free(&tree);
}
END_TEST

// A copy finds the same, in the same order, after the same changes.
START_TEST(a_copy_behaves_as_its_tree)
{
    generator random = generator_new(11);
    tf_dynamic_tree copy = {0};
    begin(&random, ELEMENTS / 2);
    for (int i = 0; i < 300; i++)
        change_some(&random);
    ck_assert(tf_dynamic_tree_reserve(&copy, ELEMENTS));
    tf_dynamic_tree_copy(&copy, &tree, ELEMENTS);
    for (int i = 0; i < 300; i++) {
        int found[2][ELEMENTS], element = below(&random, ELEMENTS);
        tf_aabb other = some_box(&random);
        if (is_in[element]) {
            tf_dynamic_tree_change(&tree, element, other);
            tf_dynamic_tree_change(&copy, element, other);
        }
        tf_aabb wanted = some_box(&random);
        int count = tf_dynamic_tree_find(&tree, &wanted, found[0]);
        ck_assert_int_eq(tf_dynamic_tree_find(&copy, &wanted, found[1]), count);
        ck_assert_mem_eq(found[0], found[1], sizeof(int) * (size_t)count);
    }
    tf_dynamic_tree_free(&copy);
    tf_dynamic_tree_free(&tree);
}
END_TEST

static bool tell_thrice(void *context, const tf_stage *stage)
{
    (void)stage;
    return ++*(int *)context < 3;
}

START_TEST(building_a_large_tree_can_be_cancelled)
{
    enum {
        MANY = 4000
    };
    static tf_aabb boxes[MANY];
    static int order[MANY];
    generator random = generator_new(12);
    int told = 0;
    for (int i = 0; i < MANY; i++) {
        boxes[i] = some_box(&random);
        order[i] = i;
    }
    tf_watch own, *watch = tf_watch_begin(&own, tell_thrice, &told);
    ck_assert(tf_dynamic_tree_reserve(&tree, MANY));
    ck_assert(!tf_dynamic_tree_build(&tree, boxes, order, MANY, watch));
    ck_assert_int_eq(told, 3);
    ck_assert(tf_dynamic_tree_build(&tree, boxes, order, MANY, NULL));
    tf_dynamic_tree_free(&tree);
}
END_TEST

Suite *suite(void)
{
    static const int built[] = {0, 1, 2, ELEMENTS};
    Suite *suite = suite_create("surgery/dynamic_tree");
    TCase *tcase = tcase_create("search");
    for (int i = 0; i < 4; i++)
        tcase_add_loop_test(tcase, what_overlaps_is_found, built[i],
                            built[i] + 1);
    tcase_add_test(tcase, the_unit_of_length_changes_no_tree);
    tcase_add_test(tcase, a_box_has_a_scale);
    tcase_add_test(tcase, what_is_infinite_finds_elements_alone);
    tcase_add_test(tcase, branches_are_used_again);
    tcase_add_test(tcase, a_copy_behaves_as_its_tree);
    tcase_add_test(tcase, building_a_large_tree_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}
