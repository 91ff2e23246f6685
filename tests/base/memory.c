// The library's memory, and how much of it is in use.
#include "base/memory.h"

#include "base/allocator.h"
#include "support/support.h"
#include "support/watched_memory.h"

#include <pthread.h>
#include <stdint.h>
#include <string.h>

START_TEST(zeroed_memory_is_zero)
{
    watched_memory memory; // it does not begin with zeros
    memory_watch(&memory);
    char zero[1000] = {0}, *all = tf_allocate_zeroed(sizeof zero);
    ck_assert_mem_eq(all, zero, sizeof zero);
    tf_release(all, sizeof zero);
    memory_end(&memory);
}
END_TEST

START_TEST(too_much_is_refused)
{
    static const size_t size[] = {(size_t)PTRDIFF_MAX + 1, SIZE_MAX / 2 + 2,
                                  SIZE_MAX};
    watched_memory memory;
    for (int own = 0; own < 2; own++) {
        if (own)
            memory_watch(&memory);
        void *some = tf_allocate(10);
        size_t before = tf_memory_in_use();
        for (int i = 0; i < 3; i++) {
            ck_assert_ptr_null(tf_allocate(size[i]));
            ck_assert_ptr_null(tf_allocate_zeroed(size[i]));
            ck_assert_ptr_null(tf_reallocate(some, 10, size[i]));
        }
        ck_assert_uint_eq(tf_memory_in_use(), before);
        tf_release(some, 10);
    }
    ck_assert_int_eq(memory.calls, 1);
    memory_end(&memory);
}
END_TEST

static void expect_counts(size_t in_use, size_t peak)
{
    ck_assert_uint_eq(tf_memory_in_use(), in_use);
    ck_assert_uint_eq(tf_memory_peak(), peak);
}

// By malloc, realloc and free.
START_TEST(what_is_in_use_is_counted)
{
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_OK);
    expect_counts(0, 0);
    char *a = tf_allocate(100), *b = tf_allocate(30);
    expect_counts(130, 130);
    memset(a, 7, 100);
    a = tf_reallocate(a, 100, 5000);
    for (int i = 0; i < 100; i++)
        ck_assert_int_eq(a[i], 7);
    expect_counts(5030, 5030);
    tf_release(a, 5000);
    expect_counts(30, 5030);
    char *c = tf_reallocate(NULL, 0, 20);
    expect_counts(50, 5030);
    tf_release(NULL, 0);
    tf_release(b, 30);
    tf_release(c, 20);
    expect_counts(0, 5030);
}
END_TEST

START_TEST(another_allocator_moves_what_grows)
{
    watched_memory memory;
    memory_watch(&memory);
    char *a = tf_reallocate(NULL, 0, 10);
    memcpy(a, "123456789", 10);
    a = tf_reallocate(a, 10, 1000);
    ck_assert_str_eq(a, "123456789");
    ck_assert_int_eq(memory.calls, 2);
    expect_counts(1000, 1010); // both, while it is copied
    memory.left = 0;
    ck_assert_ptr_null(tf_reallocate(a, 1000, 2000));
    ck_assert_str_eq(a, "123456789");
    ck_assert_ptr_null(tf_allocate(1));
    ck_assert_ptr_null(tf_allocate_zeroed(1));
    expect_counts(1000, 1010);
    tf_release(a, 1000);
    memory_end(&memory);
}
END_TEST

enum {
    THREADS = 4,
    TIMES = 2000000,
    HELD = 8
};

static atomic_int ready;

/// Holds at most 8 pieces of memory of up to 64 bytes at a time.
static void *work(void *argument)
{
    generator random = generator_new((uint64_t)(uintptr_t)argument);
    void *held[HELD] = {0};
    size_t size[HELD] = {0};
    atomic_fetch_add(&ready, 1);
    while (atomic_load(&ready) < THREADS) // until all have begun
        ;
    for (int i = 0; i < TIMES; i++) {
        int which = below(&random, HELD);
        tf_release(held[which], size[which]);
        size[which] = 1 + (size_t)below(&random, 64);
        held[which] = tf_allocate(size[which]);
    }
    for (int i = 0; i < HELD; i++)
        tf_release(held[i], size[i]);
    return NULL;
}

START_TEST(threads_count_together)
{
    static char seeds[THREADS];
    pthread_t thread[THREADS];
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_OK);
    for (int i = 0; i < THREADS; i++)
        ck_assert_int_eq(pthread_create(&thread[i], NULL, work, seeds + i), 0);
    for (int i = 0; i < THREADS; i++)
        pthread_join(thread[i], NULL);
    ck_assert_uint_eq(tf_memory_in_use(), 0);
    ck_assert_uint_gt(tf_memory_peak(), HELD);
    ck_assert_uint_le(tf_memory_peak(), (size_t)THREADS * HELD * 64);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/memory");
    TCase *tcase = tcase_create("memory");
    tcase_add_test(tcase, zeroed_memory_is_zero);
    tcase_add_test(tcase, too_much_is_refused);
    tcase_add_test(tcase, what_is_in_use_is_counted);
    tcase_add_test(tcase, another_allocator_moves_what_grows);
    tcase_add_test(tcase, threads_count_together);
    suite_add_tcase(suite, tcase);
    return suite;
}
