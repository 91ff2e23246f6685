// Sorting: against a plain sort, and stable.
#include "surface/sort.h"

#include "support/generator.h"
#include "support/support.h"

#include <string.h>

enum {
    MOST = 200
};

/// Items are compared by their key alone.
typedef struct item {
    int key, number;
} item;

static bool has_less(const void *a, const void *b)
{
    return ((const item *)a)->key < ((const item *)b)->key;
}

START_TEST(lists_are_sorted_and_equal_items_keep_their_order)
{
    tf_buffer list = {0};
    tf_sort_memory memory = {0};
    generator random = generator_new(0);
    for (int i = 0; i < (int)cases(2000); i++) {
        int count = i < 20 ? i : below(&random, MOST + 1), sum = 0;
        int keys = 1 + below(&random, 2 * MOST);
        ck_assert(tf_buffer_extend(&list, (size_t)count, sizeof(item)));
        item *own = list.data;
        for (int k = 0; k < count; k++)
            own[k] = (item){below(&random, keys), k};
        ck_assert(tf_list_sort(&list, (size_t)count, sizeof *own, has_less,
                               &memory, NULL));
        own = list.data;
        for (int k = 0; k < count; k++)
            sum += own[k].number;
        for (int k = 1; k < count; k++)
            ck_assert(own[k - 1].key < own[k].key ||
                      (own[k - 1].key == own[k].key &&
                       own[k - 1].number < own[k].number));
        ck_assert_int_eq(sum, count * (count - 1) / 2);
    }
    ck_assert_uint_ge(tf_sort_memory_bytes(&memory), MOST * sizeof(item));
    tf_sort_memory_free(&memory);
    tf_buffer_free(&list);
}
END_TEST

START_TEST(one_of_two_arrays_holds_the_result)
{
    static const item items[] = {{3, 0}, {1, 1}, {2, 2}, {0, 3}, {4, 4}};
    for (size_t count = 1; count <= 5; count++) {
        const void *from[5], *to[5];
        for (size_t k = 0; k < count; k++)
            from[k] = &items[k];
        const void **sorted = tf_sort(count, from, to, has_less, NULL);
        ck_assert(sorted == from || sorted == to);
        for (size_t k = 1; k < count; k++)
            ck_assert(has_less(sorted[k - 1], sorted[k]));
    }
}
END_TEST

START_TEST(a_list_without_memory_stays)
{
    item only = {1, 2};
    tf_buffer list = {.data = &only, .bytes = sizeof only};
    tf_sort_memory memory = {0};
    ck_assert(!tf_list_sort(&list, SIZE_MAX / 64, 1, has_less, &memory, NULL));
    ck_assert_ptr_eq(list.data, &only);
    tf_sort_memory_free(&memory);
}
END_TEST

static bool tell_thrice(void *context, const tf_stage *stage)
{
    (void)stage;
    return ++*(int *)context < 3;
}

START_TEST(a_long_sort_can_be_cancelled)
{
    enum {
        LONG = 5000
    };
    static item all[LONG], sorted[LONG];
    int told = 0;
    tf_buffer list = {0};
    tf_sort_memory memory = {0};
    ck_assert(tf_buffer_extend(&list, LONG, sizeof(item)));
    for (int i = 0; i < LONG; i++)
        all[i] = (item){LONG - i, i};
    memcpy(list.data, all, sizeof all);
    tf_watch own, *watch = tf_watch_begin(&own, tell_thrice, &told);
    ck_assert(
        !tf_list_sort(&list, LONG, sizeof(item), has_less, &memory, watch));
    ck_assert_int_eq(told, 3);
    ck_assert_mem_eq(list.data, all, sizeof all);
    ck_assert(tf_list_sort(&list, LONG, sizeof(item), has_less, &memory, NULL));
    for (int i = 0; i < LONG; i++)
        sorted[i] = all[LONG - 1 - i];
    ck_assert_mem_eq(list.data, sorted, sizeof sorted);
    tf_sort_memory_free(&memory);
    tf_buffer_free(&list);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/sort");
    TCase *tcase = tcase_create("sort");
    tcase_add_test(tcase, lists_are_sorted_and_equal_items_keep_their_order);
    tcase_add_test(tcase, one_of_two_arrays_holds_the_result);
    tcase_add_test(tcase, a_list_without_memory_stays);
    tcase_add_test(tcase, a_long_sort_can_be_cancelled);
    suite_add_tcase(suite, tcase);
    return suite;
}
