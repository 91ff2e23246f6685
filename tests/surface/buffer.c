// Memory that is kept.
#include "surface/buffer.h"

#include "support/support.h"

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
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/buffer");
    TCase *tcase = tcase_create("buffer");
    tcase_add_test(tcase, reserved_memory_is_aligned_and_kept);
    tcase_add_test(tcase, a_list_keeps_what_it_holds);
    tcase_add_test(tcase, impossible_sizes_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
