// Lists of elements, against a sort by comparison.
#include "surface/elements.h"

#include "support/support.h"

#include <stdlib.h>
#include <string.h>

enum {
    MOST = 300
};

START_TEST(vertices_are_sorted)
{
    static const int all[6][3] = {{1, 5, 9}, {1, 9, 5}, {5, 1, 9},
                                  {5, 9, 1}, {9, 1, 5}, {9, 5, 1}};
    for (int i = 0; i < 6; i++) {
        int corner[3], pair[2] = {all[i][0], all[i][1]};
        memcpy(corner, all[i], sizeof corner);
        tf_element_sort(3, corner);
        ck_assert_mem_eq(corner, all[0], sizeof corner);
        tf_element_sort(2, pair);
        ck_assert_int_lt(pair[0], pair[1]);
    }
}
END_TEST

static int corners_compared;

static int compare(const void *a, const void *b)
{
    const int *first = a, *second = b;
    for (int c = 0; c < corners_compared; c++)
        if (first[c] != second[c])
            return first[c] < second[c] ? -1 : 1;
    return 0;
}

/// Sorts by comparison, drops repetitions, and returns how many are left.
static int sort_plainly(int corners, int count, int corner[])
{
    size_t size = sizeof *corner * (size_t)corners;
    int kept = 0;
    corners_compared = corners;
    qsort(corner, (size_t)count, size, compare);
    for (int i = 0; i < count; i++)
        if (i == 0 ||
            memcmp(corner + (i - 1) * corners, corner + i * corners, size) != 0)
            memmove(corner + kept++ * corners, corner + i * corners, size);
    return kept;
}

START_TEST(lists_are_sorted_without_repetitions)
{
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < (int)cases(2000); i++) {
        int corners = 2 + below(&random, 2), count = below(&random, MOST + 1);
        int vertices = 3 + below(&random, 40), expected[3 * MOST];
        tf_elements list = {.corners = corners};
        tf_sort_workspace workspace = {0};
        ck_assert(tf_buffer_reserve(&list.storage, MOST, 3 * sizeof(int)));
        int *corner = list.storage.data;
        for (int j = 0; j < count * corners; j++)
            corner[j] = below(&random, vertices);
        memcpy(expected, corner, sizeof expected);
        int kept = sort_plainly(corners, count, expected);
        ck_assert(tf_elements_sort(&list, count, vertices, &workspace));
        ck_assert_int_eq(list.count, kept);
        ck_assert_mem_eq(list.corner, expected,
                         sizeof *expected * (size_t)(kept * corners));
        tf_buffer_free(&list.storage);
        tf_sort_workspace_free(&workspace);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/elements");
    TCase *tcase = tcase_create("elements");
    tcase_add_test(tcase, vertices_are_sorted);
    tcase_add_loop_test(tcase, lists_are_sorted_without_repetitions, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}
