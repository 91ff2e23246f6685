// Files that appear whole or not at all, and standard output.
#define _GNU_SOURCE // symlink
#include "files/destination.h"

#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <unistd.h>

static tf_destination to;
static tf_fault fault;

/// Begins to write a text.
static void begin_writing(const char *path, const char *text)
{
    fault = (tf_fault){0};
    ck_assert(tf_destination_begin(&to, path, &fault));
    FILE *stream = tf_destination_open(&to);
    ck_assert_ptr_nonnull(stream);
    fputs(text, stream);
}

START_TEST(a_file_appears_when_it_is_kept)
{
    begin_writing("made", "text\n");
    ck_assert_int_ne(access("made", F_OK), 0);
    ck_assert(tf_destination_close(&to));
    ck_assert_int_ne(access("made", F_OK), 0);
    ck_assert(tf_destination_keep(&to));
    tf_destination_end(&to);
    ck_assert_str_eq(file_text("made"), "text\n");
    ck_assert_str_eq(fault.text, "");
}
END_TEST

START_TEST(a_file_that_is_not_kept_is_as_it_was)
{
    make_file("made", "before\n");
    for (int closed = 0; closed < 2; closed++) {
        begin_writing("made", "text\n");
        if (closed)
            ck_assert(tf_destination_close(&to));
        tf_destination_end(&to);
        ck_assert_str_eq(file_text("made"), "before\n");
    }
    expect(run("ls -A | grep tanglefree"), 1, "", "");
}
END_TEST

START_TEST(finishing_keeps_what_is_good)
{
    begin_writing("made", "text\n");
    ck_assert(tf_destination_finish(&to, true, 0));
    tf_destination_end(&to);
    ck_assert_str_eq(file_text("made"), "text\n");
    begin_writing("made", "other\n");
    ck_assert(!tf_destination_finish(&to, false, 0));
    ck_assert_str_eq(fault.text, "");
    tf_destination_end(&to);
    begin_writing("made", "other\n");
    ck_assert(!tf_destination_finish(&to, true, ENOSPC));
    tf_destination_end(&to);
    ck_assert_str_eq(fault.file, "made");
    expect_words(fault.text, "cannot write: No space left on device; ");
    ck_assert_str_eq(file_text("made"), "text\n");
}
END_TEST

START_TEST(names_that_end_in_gz_are_compressed)
{
    begin_writing("made.gz", "text\n");
    ck_assert(tf_destination_finish(&to, true, 0));
    tf_destination_end(&to);
    expect(run("gzip -t made.gz && gzip -dc made.gz"), 0, "text\n", "");
    begin_writing("made.gz", "other\n");
    tf_destination_end(&to);
    expect(run("gzip -dc made.gz; ls -A | grep tanglefree"), 1, "text\n", "");
}
END_TEST

START_TEST(a_hyphen_is_standard_output)
{
    ck_assert(tf_destination_is_standard("-"));
    ck_assert(!tf_destination_is_standard("./-"));
    ck_assert(!tf_destination_is_standard("-x"));
    ck_assert_ptr_nonnull(freopen("printed", "w", stdout));
    begin_writing("-", "text\n");
    ck_assert_ptr_eq(to.stream, stdout);
    ck_assert(tf_destination_finish(&to, true, 0));
    tf_destination_end(&to);
    ck_assert_str_eq(file_text("printed"), "text\n");
    ck_assert(!ferror(stdout));
}
END_TEST

START_TEST(what_cannot_be_written_is_named)
{
    ck_assert(!tf_destination_begin(&to, "no/made", &fault));
    ck_assert_str_eq(fault.file, "no/made");
    expect_words(fault.text,
                 "there is no folder 'no'; make it, or choose another");
    tf_destination_end(&to);
    ck_assert_ptr_nonnull(freopen("/dev/full", "w", stdout));
    static const char *const names[][2] = {{"/dev/full", "/dev/full"},
                                           {"full.gz", "full.gz"},
                                           {"-", "standard output"}};
    ck_assert_int_eq(symlink("/dev/full", "full.gz"), 0);
    for (int i = 0; i < 3; i++) {
        begin_writing(names[i][0], "text\n");
        ck_assert(!tf_destination_finish(&to, true, 0));
        tf_destination_end(&to);
        ck_assert_str_eq(fault.file, names[i][1]);
        expect_words(fault.text, "cannot write: No space left on device; ");
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/destination");
    TCase *tcase = tcase_create("files");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_file_appears_when_it_is_kept);
    tcase_add_test(tcase, a_file_that_is_not_kept_is_as_it_was);
    tcase_add_test(tcase, finishing_keeps_what_is_good);
    tcase_add_test(tcase, names_that_end_in_gz_are_compressed);
    tcase_add_test(tcase, a_hyphen_is_standard_output);
    tcase_add_test(tcase, what_cannot_be_written_is_named);
    suite_add_tcase(suite, tcase);
    return suite;
}
