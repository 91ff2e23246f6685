// Memory that is kept.
#include "surface/buffer.h"

#include "base/allocator.h"
#include "support/support.h"
#include "support/watched_memory.h"

#include <signal.h>
#include <stdint.h>
#include <string.h>

START_TEST(reserved_memory_is_aligned_and_kept)
{
    tf_buffer buffer = {0};
    ck_assert(tf_buffer_reserve(&buffer, 10, 7));
    ck_assert_uint_eq((uintptr_t)buffer.data % 64, 0);
    ck_assert_uint_ge(buffer.bytes, 70);
    void *data = buffer.data;
    ck_assert(tf_buffer_reserve(&buffer, 3, 7));
    ck_assert_ptr_eq(buffer.data, data);
    tf_buffer_free(&buffer);
    ck_assert_ptr_null(buffer.data);
    ck_assert_uint_eq(buffer.bytes, 0);
}
END_TEST

// Whatever the alignment of what is allocated.
START_TEST(all_of_it_may_be_written)
{
    watched_memory memory;
    memory_watch(&memory);
    for (memory.offset = 0; memory.offset < 64; memory.offset += 16)
        for (size_t size = 1; size < 200; size++) {
            tf_buffer buffer = {0};
            ck_assert(tf_buffer_reserve(&buffer, size, 1));
            ck_assert_uint_eq((uintptr_t)buffer.data % 64, 0);
            ck_assert_uint_ge(buffer.bytes, size);
            ck_assert_uint_le(memory.bytes, buffer.bytes + 64);
            memset(buffer.data, 1, buffer.bytes);
            tf_buffer_free(&buffer);
        }
    memory_end(&memory);
}
END_TEST

START_TEST(without_memory_a_buffer_stays_as_it_is)
{
    watched_memory memory;
    memory_watch(&memory);
    tf_buffer reserved = {0}, list = {0};
    ck_assert(tf_buffer_reserve(&reserved, 5, 8));
    ck_assert(tf_buffer_extend(&list, 5, 8));
    memset(list.data, 3, 40);
    tf_buffer before = reserved, list_before = list;
    memory.left = 0;
    ck_assert(!tf_buffer_reserve(&reserved, 500, 8));
    ck_assert(!tf_buffer_extend(&list, 500, 8));
    ck_assert_mem_eq(&reserved, &before, sizeof before);
    ck_assert_mem_eq(&list, &list_before, sizeof list);
    memory.left = -1;
    ck_assert(tf_buffer_extend(&list, 500, 8));
    for (int i = 0; i < 40; i++)
        ck_assert_int_eq(((char *)list.data)[i], 3);
    tf_buffer_free(&reserved);
    tf_buffer_free(&list);
    memory_end(&memory);
}
END_TEST

START_TEST(a_list_keeps_what_it_holds)
{
    enum {
        COUNT = 10000
    };
    tf_buffer buffer = {0};
    int moves = 0;
    for (int i = 0; i < COUNT; i++) {
        size_t before = buffer.bytes;
        ck_assert(tf_buffer_extend(&buffer, (size_t)i + 1, sizeof i));
        memcpy((char *)buffer.data + (size_t)i * sizeof i, &i, sizeof i);
        moves += buffer.bytes != before;
    }
    for (int i = 0; i < COUNT; i++) {
        int kept;
        memcpy(&kept, (char *)buffer.data + (size_t)i * sizeof i, sizeof kept);
        ck_assert_int_eq(kept, i);
    }
    // The room doubles.
    ck_assert_int_le(moves, 16);
    tf_buffer_free(&buffer);
}
END_TEST

START_TEST(impossible_sizes_are_refused)
{
    tf_buffer buffer = {0};
    ck_assert(tf_buffer_reserve(&buffer, 5, 8));
    tf_buffer before = buffer;
    ck_assert(!tf_buffer_reserve(&buffer, SIZE_MAX / 2, 8));
    ck_assert(!tf_buffer_extend(&buffer, SIZE_MAX / 2, 8));
    ck_assert(!tf_buffer_reserve(&buffer, SIZE_MAX / 8, 1));
    ck_assert_ptr_eq(buffer.data, before.data);
    ck_assert_uint_eq(buffer.bytes, before.bytes);
    tf_buffer_free(&buffer);
    ck_assert(!tf_buffer_extend(&buffer, SIZE_MAX / 4, 1));
    ck_assert_uint_eq(tf_memory_in_use(), 0);
}
END_TEST

START_TEST(reserved_memory_is_not_extended)
{
    tf_buffer buffer = {0};
    tf_buffer_reserve(&buffer, 5, 8);
    tf_buffer_extend(&buffer, 500, 8);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/buffer");
    TCase *tcase = tcase_create("buffer");
    tcase_add_test(tcase, reserved_memory_is_aligned_and_kept);
    tcase_add_test(tcase, all_of_it_may_be_written);
    tcase_add_test(tcase, without_memory_a_buffer_stays_as_it_is);
    tcase_add_test(tcase, a_list_keeps_what_it_holds);
    tcase_add_test(tcase, impossible_sizes_are_refused);
    tcase_add_test_raise_signal(tcase, reserved_memory_is_not_extended,
                                SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
