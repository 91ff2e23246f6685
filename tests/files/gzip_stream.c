#include "files/gzip_stream.h"

#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

START_TEST(names_end_in_gz)
{
    ck_assert(tf_is_gzip_name("a.gz"));
    ck_assert(tf_is_gzip_name("a.ply.GZ"));
    ck_assert(tf_is_gzip_name(".gz"));
    ck_assert(!tf_is_gzip_name("a.ply"));
    ck_assert(!tf_is_gzip_name("gz"));
    ck_assert(!tf_is_gzip_name("a.gz.ply"));
    ck_assert(!tf_is_gzip_name(""));
}
END_TEST

/// Writes lines, compressed, to a file.
static bool write_lines(const char *path, int lines)
{
    FILE *plain = fopen(path, "wb");
    FILE *stream = tf_gzip_open(plain);
    ck_assert_ptr_nonnull(stream);
    for (int i = 0; i < lines; i++)
        fprintf(stream, "line %d %d\n", i, i * 7919 % 10007);
    bool good = !ferror(stream);
    errno = 0;
    good = fclose(stream) == 0 && good;
    int cause = errno;
    fclose(plain);
    errno = cause;
    return good;
}

START_TEST(what_is_written_comes_back)
{
    static const int lines[] = {0, 1, 100000};
    for (int i = 0; i < 3; i++) {
        ck_assert(write_lines("made.gz", lines[i]));
        outcome found = run("gzip -dc made.gz | awk '$0 != \"line \" NR - 1 "
                            "\" \" (NR - 1) * 7919 %% 10007 { exit 3 } END { "
                            "print NR }' && [ $(wc -c <made.gz) -lt 1000000 ]");
        ck_assert_int_eq(found.status, 0);
        ck_assert_int_eq(atoi(found.out), lines[i]);
    }
}
END_TEST

START_TEST(the_same_bytes_are_written_each_time)
{
    ck_assert(write_lines("one.gz", 1000));
    expect(run("sleep 1.1"), 0, "", "");
    ck_assert(write_lines("other.gz", 1000));
    expect(run("cmp one.gz other.gz"), 0, "", "");
}
END_TEST

START_TEST(errors_are_those_of_the_file)
{
    static const int lines[] = {0, 1, 100000};
    for (int i = 0; i < 3; i++) {
        ck_assert(!write_lines("/dev/full", lines[i]));
        ck_assert_int_eq(errno, ENOSPC);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/gzip_stream");
    TCase *tcase = tcase_create("streams");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, names_end_in_gz);
    tcase_add_test(tcase, what_is_written_comes_back);
    tcase_add_test(tcase, the_same_bytes_are_written_each_time);
    tcase_add_test(tcase, errors_are_those_of_the_file);
    suite_add_tcase(suite, tcase);
    return suite;
}
