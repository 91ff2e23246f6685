// The bytes of files, compressed or not.
#include "formats/file_bytes.h"

#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static tf_fault fault;

static bool is_never_hopeless(const tf_bytes *bytes, size_t last)
{
    ck_assert_uint_ge(bytes->count, last);
    ck_assert_int_eq(bytes->item[bytes->count], '\0');
    return false;
}

static bool is_hopeless_at_once(const tf_bytes *bytes, size_t last)
{
    return bytes->count >= last;
}

/// Random bytes of any size, as one or several pieces of gzip.
static char *make_zipped(const char *name, size_t size, int pieces)
{
    generator random = generator_new(size);
    char *bytes = malloc(size + 1);
    for (size_t i = 0; i < size; i++)
        bytes[i] = (char)below(&random, 5);
    remove(name);
    for (int i = 0; i < pieces; i++) {
        size_t first = size * (size_t)i / (size_t)pieces;
        size_t end = size * (size_t)(i + 1) / (size_t)pieces;
        gzFile file = gzopen(name, "ab");
        ck_assert_int_eq(gzwrite(file, bytes + first, (unsigned)(end - first)),
                         (int)(end - first));
        gzclose(file);
    }
    return bytes;
}

static void expect_bytes(const char *path, const char *bytes, size_t size)
{
    tf_bytes read = {0};
    ck_assert_msg(tf_bytes_read(&read, path, "name", is_never_hopeless, &fault),
                  "%s", fault.text);
    ck_assert_uint_eq(read.count, size);
    ck_assert_mem_eq(read.item, bytes, size);
    ck_assert_int_eq(read.item[size], '\0');
    tf_bytes_free(&read);
}

static void expect_fault(const char *path, const char *words)
{
    tf_bytes read = {0};
    ck_assert(!tf_bytes_read(&read, path, "name", is_never_hopeless, &fault));
    ck_assert_str_eq(fault.text, words);
    ck_assert_str_eq(fault.file, "name");
    ck_assert_int_lt(fault.place, 0);
    tf_bytes_free(&read);
}

START_TEST(files_are_decompressed)
{
    static const size_t sizes[] = {1, 100, 131071, 131072, 700000};
    for (int i = 0; i < 5; i++)
        for (int pieces = 1; pieces < 3; pieces++) {
            char *bytes = make_zipped("zipped", sizes[i], pieces);
            expect_bytes("zipped", bytes, sizes[i]);
            ck_assert_ptr_nonnull(freopen("zipped", "r", stdin));
            expect_bytes("-", bytes, sizes[i]);
            make_binary_file("plain", bytes, sizes[i]);
            expect_bytes("plain", bytes, sizes[i]);
            free(bytes);
        }
    make_file("empty", "");
    expect_bytes("empty", "", 0);
    make_binary_file("short", "\x1f", 1);
    expect_bytes("short", "\x1f", 1);
}
END_TEST

/// A copy of a file, so many bytes, of which one is changed (not if it is beyond
/// them).
static void damage(const char *from, const char *to, size_t size, size_t at)
{
    static char bytes[200000];
    FILE *file = fopen(from, "rb");
    size_t count = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    ck_assert_uint_le(size, count);
    if (at < size)
        bytes[at] ^= 0x55;
    make_binary_file(to, bytes, size);
}

static size_t size_of(const char *name)
{
    FILE *file = fopen(name, "rb");
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    fclose(file);
    return (size_t)size;
}

START_TEST(gzip_that_is_cut_short_is_refused)
{
    free(make_zipped("zipped", 100000, 1));
    size_t size = size_of("zipped");
    for (size_t cut = 18; cut < size; cut += cut < 40 ? 1 : 97) {
        damage("zipped", "cut", cut, cut);
        expect_fault("cut", "the gzip file ends too early; copy it again");
    }
    for (size_t cut = size - 8; cut < size; cut++) {
        damage("zipped", "cut", cut, cut);
        expect_fault("cut", "the gzip file ends too early; copy it again");
    }
}
END_TEST

START_TEST(damaged_gzip_is_refused)
{
    free(make_zipped("zipped", 100000, 1));
    size_t size = size_of("zipped");
    for (size_t at = size - 8; at < size; at++) {
        damage("zipped", "bad", size, at);
        expect_fault("bad", "the gzip file is damaged; copy it again");
    }
    for (size_t at = 200; at < size - 8; at += 501) {
        tf_bytes read = {0};
        damage("zipped", "bad", size, at);
        ck_assert(
            !tf_bytes_read(&read, "bad", "name", is_never_hopeless, &fault));
        expect_words(fault.text, "; copy it again");
        tf_bytes_free(&read);
    }
}
END_TEST

START_TEST(hopeless_files_are_given_up)
{
    tf_bytes read = {0};
    ck_assert(
        tf_bytes_read(&read, "/dev/zero", "", is_hopeless_at_once, &fault));
    ck_assert_uint_lt(read.count, 1 << 20);
    tf_bytes_free(&read);
}
END_TEST

START_TEST(unreadable_files_are_refused)
{
    expect_fault("absent",
                 "cannot open: No such file or directory; check the name");
    expect_fault(".", "cannot read: Is a directory; check that this is a file");
    ck_assert_int_eq(fclose(stdin), 0);
    expect_fault("-", "cannot read: Bad file descriptor; check that this is a "
                      "file");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/file_bytes");
    TCase *bytes = tcase_create("bytes");
    tcase_add_checked_fixture(bytes, enter_folder, leave_folder);
    tcase_add_test(bytes, files_are_decompressed);
    tcase_add_test(bytes, gzip_that_is_cut_short_is_refused);
    tcase_add_test(bytes, damaged_gzip_is_refused);
    tcase_add_test(bytes, hopeless_files_are_given_up);
    tcase_add_test(bytes, unreadable_files_are_refused);
    suite_add_tcase(suite, bytes);
    return suite;
}
