// The allocator that callers set.
#include "base/allocator.h"

#include "base/memory.h"
#include "support/support.h"
#include "support/watched_memory.h"

#include <signal.h>
#include <stdlib.h>

/// What a context has seen.
typedef struct seen {
    size_t allocated, freed; ///< bytes
} seen;

static void *allocate(void *context, size_t size)
{
    ((seen *)context)->allocated += size;
    return malloc(size);
}

static void release(void *context, void *memory, size_t size)
{
    ((seen *)context)->freed += size;
    free(memory);
}

START_TEST(memory_is_the_allocators)
{
    seen own = {0};
    ck_assert_int_eq(tf_set_allocator(allocate, release, &own), TF_OK);
    void *memory = tf_allocate(10);
    ck_assert_uint_eq(own.allocated, 10);
    ck_assert_uint_eq(own.freed, 0);
    tf_release(memory, 10);
    ck_assert_uint_eq(own.freed, 10);

    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_OK);
    tf_release(tf_allocate(10), 10);
    ck_assert_uint_eq(own.allocated, 10);
    ck_assert_uint_eq(own.freed, 10);
}
END_TEST

static void expect_in_use(seen *other)
{
    ck_assert_int_eq(tf_set_allocator(allocate, release, other), TF_IN_USE);
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_IN_USE);
    ck_assert_uint_eq(tf_memory_peak(), 20);
}

START_TEST(allocator_in_use_stays)
{
    seen first = {0}, other = {0};
    ck_assert_int_eq(tf_set_allocator(allocate, release, &first), TF_OK);
    void *a = tf_allocate(10), *b = tf_allocate(10);
    expect_in_use(&other);
    tf_release(a, 10);
    expect_in_use(&other);
    tf_release(b, 10);
    ck_assert_uint_eq(first.freed, 20);
    ck_assert_int_eq(tf_set_allocator(allocate, release, &other), TF_OK);
    tf_release(tf_allocate(10), 10);
    ck_assert_uint_eq(first.allocated, 20);
    ck_assert_uint_eq(other.allocated, 10);
}
END_TEST

START_TEST(malloc_in_use_stays)
{
    seen other = {0};
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_OK);
    void *memory = tf_allocate(20);
    expect_in_use(&other);
    tf_release(memory, 20);
    ck_assert_uint_eq(other.allocated + other.freed, 0);
}
END_TEST

START_TEST(setting_it_resets_the_peak)
{
    tf_release(tf_allocate(1000), 1000);
    ck_assert_uint_ge(tf_memory_peak(), 1000);
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_OK);
    ck_assert_uint_eq(tf_memory_peak(), 0);
    tf_release(tf_allocate(10), 10);
    ck_assert_uint_eq(tf_memory_peak(), 10);
}
END_TEST

START_TEST(one_function_needs_the_other)
{
    if (_i == 0)
        tf_set_allocator(allocate, NULL, NULL);
    else
        tf_set_allocator(NULL, release, NULL);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/allocator");
    TCase *tcase = tcase_create("allocator");
    tcase_add_test(tcase, memory_is_the_allocators);
    tcase_add_test(tcase, allocator_in_use_stays);
    tcase_add_test(tcase, malloc_in_use_stays);
    tcase_add_test(tcase, setting_it_resets_the_peak);
    tcase_add_loop_test_raise_signal(tcase, one_function_needs_the_other,
                                     SIGABRT, 0, 2);
    suite_add_tcase(suite, tcase);
    return suite;
}
