// Morton keys and their sort.
#include "surface/morton.h"

#include "support/scrambled_workers.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tf_box whole = {.high = {TF_CELLS, TF_CELLS, TF_CELLS}};

/// The key of the sum of so many paths that all start at one place.
static uint32_t key_at(int paths, float x, float y, float z)
{
    float n = (float)paths;
    tf_path sum = {.at = {n * x, n * y, n * z, 1, 2, 3}};
    tf_morton_grid grid = tf_morton_grid_of(&whole, paths);
    return tf_morton_key(&sum, &grid);
}

/// The bits of three numbers of ten bits, one at a time.
static uint32_t shuffle(int x, int y, int z)
{
    uint32_t key = 0;
    for (int i = 0; i < 10; i++)
        key |= (uint32_t)(x >> i & 1) << 3 * i |
               (uint32_t)(y >> i & 1) << (3 * i + 1) |
               (uint32_t)(z >> i & 1) << (3 * i + 2);
    return key;
}

START_TEST(keys_shuffle_bits)
{
    generator random = generator_new(1);
    for (int i = 0; i < (int)cases(100000); i++) {
        int x = below(&random, 1024), y = below(&random, 1024),
            z = below(&random, 1024);
        ck_assert_uint_eq(
            key_at(1 + i % 3, (float)x, (float)y, (float)z + 0.25f),
            shuffle(x, y, z));
    }
}
END_TEST

START_TEST(the_high_side_belongs_to_the_last_cells)
{
    ck_assert_uint_eq(key_at(1, TF_CELLS, TF_CELLS, TF_CELLS), (1 << 30) - 1);
    ck_assert_uint_eq(key_at(2, 5, TF_CELLS, 7), shuffle(5, 1023, 7));
}
END_TEST

START_TEST(what_rounding_puts_beyond_a_side_is_within_the_grid)
{
    ck_assert_uint_eq(key_at(1, -2, 3, 1500), shuffle(0, 3, 1023));
    ck_assert_uint_eq(key_at(3, 7, 2000, -1), shuffle(7, 1023, 0));
}
END_TEST

START_TEST(a_cell_begins_with_its_low_side)
{
    for (int i = 1; i < TF_CELLS; i++) {
        float before = nextafterf((float)i, 0);
        ck_assert_uint_eq(key_at(1, (float)i, 0, 0), shuffle(i, 0, 0));
        ck_assert_uint_eq(key_at(1, before, 0, 0), shuffle(i - 1, 0, 0));
    }
}
END_TEST

START_TEST(a_flat_scene_has_keys)
{
    tf_box flat = {.low = {0, 5}, .high = {TF_CELLS, 5}};
    tf_path path = {.at = {3, 5}};
    tf_morton_grid grid = tf_morton_grid_of(&flat, 1);
    ck_assert_uint_eq(tf_morton_key(&path, &grid), shuffle(3, 0, 0));
    ck_assert(grid.cells[1] == 0 && grid.cells[2] == 0);
}
END_TEST

START_TEST(a_grid_begins_where_the_starts_do)
{
    const tf_box far = {.low = {-64, 32, 1}, .high = {TF_CELLS - 64, 1056, 2}};
    for (int paths = 1; paths <= 3; paths++) {
        float n = (float)paths;
        tf_morton_grid grid = tf_morton_grid_of(&far, paths);
        tf_path sum = {.at = {n * (5 - 64), n * (7 + 32), n * 1.5f}};
        ck_assert_uint_eq(tf_morton_key(&sum, &grid), shuffle(5, 7, 512));
    }
}
END_TEST

static int compare(const void *first, const void *second)
{
    const tf_keyed *a = first, *b = second;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return a->element - b->element;
}

static void sort(int count, int keys, const tf_parallel *parallel)
{
    generator random = generator_new((uint64_t)count);
    size_t size = sizeof(tf_keyed) * (size_t)(count + 1);
    tf_keyed *expected = malloc(size), *from = malloc(size), *to = malloc(size);
    tf_digit_counts *counts = malloc(TF_SORT_PARTS * sizeof *counts);
    for (int i = 0; i < count; i++)
        from[i] = (tf_keyed){(uint32_t)below(&random, keys), i};
    memcpy(expected, from, size);
    qsort(expected, (size_t)count, sizeof *expected, compare);
    tf_keyed *sorted = tf_morton_sort(count, from, to, counts, parallel);
    int alike = 0;
    while (alike < count && compare(&sorted[alike], &expected[alike]) == 0)
        alike++;
    ck_assert_int_eq(alike, count);
    free(expected);
    free(from);
    free(to);
    free(counts);
}

START_TEST(equal_keys_stay_in_order)
{
    static const int counts[] = {
        0, 1, 2, 1000, TF_SORT_PART, TF_SORT_PART + 1, 200000};
    static const int keys[] = {1, 7, 2000, 1 << 30};
    int workers = 3;
    tf_parallel parallel = scrambled_workers(&workers);
    for (int i = 0; i < 7; i++) {
        sort(counts[i], keys[_i], NULL);
        sort(counts[i], keys[_i], &parallel);
    }
}
END_TEST

START_TEST(many_items_are_sorted_in_larger_parts)
{
    sort(TF_SORT_PARTS * TF_SORT_PART + 12345, 1 << 30, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/morton");
    TCase *tcase = tcase_create("Morton order");
    tcase_add_test(tcase, keys_shuffle_bits);
    tcase_add_test(tcase, the_high_side_belongs_to_the_last_cells);
    tcase_add_test(tcase, what_rounding_puts_beyond_a_side_is_within_the_grid);
    tcase_add_test(tcase, a_cell_begins_with_its_low_side);
    tcase_add_test(tcase, a_flat_scene_has_keys);
    tcase_add_test(tcase, a_grid_begins_where_the_starts_do);
    tcase_add_loop_test(tcase, equal_keys_stay_in_order, 0, 4);
    tcase_add_test(tcase, many_items_are_sorted_in_larger_parts);
    suite_add_tcase(suite, tcase);
    return suite;
}
