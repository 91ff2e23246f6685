#define _GNU_SOURCE // lstat, symlink

#include "files/output_file.h"

#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/// How many files there are in the folder, those whose name starts with a dot,
/// too.
static int files(void)
{
    return atoi(run("ls -A | grep -cv '^\\(out\\|err\\)$'").out);
}

/// Writes a text to a file; keeps it.
static void write_file(const char *path, const char *text)
{
    tf_output_file file;
    ck_assert_msg(tf_output_file_begin(&file, path), "%s: %s", path,
                  strerror(errno));
    FILE *stream = tf_output_file_open(&file);
    ck_assert_ptr_nonnull(stream);
    fputs(text, stream);
    ck_assert(tf_output_file_close(&file, stream));
    ck_assert_msg(tf_output_file_keep(&file), "%s", strerror(errno));
    ck_assert_ptr_null(file.scratch);
}

static unsigned permissions(const char *path)
{
    struct stat found;
    ck_assert_int_eq(stat(path, &found), 0);
    return found.st_mode & 0777;
}

START_TEST(a_new_file_appears_when_kept)
{
    umask(027);
    write_file("new.obj", "text");
    ck_assert_str_eq(file_text("new.obj"), "text");
    ck_assert_uint_eq(permissions("new.obj"), 0640);
    ck_assert_int_eq(files(), 1);
}
END_TEST

START_TEST(a_file_is_replaced_when_kept)
{
    make_file("old", "before");
    ck_assert_int_eq(chmod("old", 0604), 0);
    tf_output_file file;
    ck_assert(tf_output_file_begin(&file, "old"));
    FILE *stream = tf_output_file_open(&file);
    fputs("after", stream);
    ck_assert(tf_output_file_close(&file, stream));
    ck_assert_str_eq(file_text("old"), "before");
    ck_assert_int_eq(files(), 2);
    ck_assert(tf_output_file_keep(&file));
    ck_assert_str_eq(file_text("old"), "after");
    ck_assert_uint_eq(permissions("old"), 0604);
    ck_assert_int_eq(files(), 1);
}
END_TEST

START_TEST(a_dropped_file_leaves_nothing)
{
    make_file("old", "before");
    tf_output_file file;
    ck_assert(tf_output_file_begin(&file, "old"));
    fclose(tf_output_file_open(&file));
    tf_output_file_drop(&file);
    tf_output_file_drop(&file);
    ck_assert_str_eq(file_text("old"), "before");
    ck_assert_int_eq(files(), 1);
}
END_TEST

START_TEST(links_are_followed)
{
    ck_assert_int_eq(mkdir("folder", 0700), 0);
    make_file("folder/file", "before");
    ck_assert_int_eq(symlink("folder/file", "link"), 0);
    write_file("link", "after");
    ck_assert_str_eq(file_text("folder/file"), "after");
    struct stat found;
    ck_assert_int_eq(lstat("link", &found), 0);
    ck_assert(S_ISLNK(found.st_mode));
}
END_TEST

START_TEST(pipes_are_written_to)
{
    ck_assert_int_eq(mkfifo("pipe", 0600), 0);
    ck_assert_int_eq(symlink("pipe", "link"), 0);
    int end = open("pipe", O_RDONLY | O_NONBLOCK);
    write_file("link", "text");
    char text[10] = "";
    ck_assert_int_eq(read(end, text, sizeof text), 4);
    ck_assert_str_eq(text, "text");
    close(end);
    struct stat found;
    ck_assert_int_eq(stat("pipe", &found), 0);
    ck_assert(S_ISFIFO(found.st_mode));
    ck_assert_int_eq(lstat("link", &found), 0);
    ck_assert(S_ISLNK(found.st_mode));
}
END_TEST

START_TEST(what_cannot_be_a_file_is_refused)
{
    static const struct {
        const char *path;
        int error;
    } cases[] = {{".", EISDIR}, {"absent/file", ENOENT}, {"file/x", ENOTDIR}};
    make_file("file", "");
    for (int i = 0; i < 3; i++) {
        tf_output_file file;
        ck_assert(!tf_output_file_begin(&file, cases[i].path));
        ck_assert_int_eq(errno, cases[i].error);
        ck_assert_ptr_null(file.scratch);
        tf_output_file_drop(&file);
    }
}
END_TEST

// By its number, under which no other file could take its place.
START_TEST(a_full_device_is_reported)
{
    char path[100];
    int device = open("/dev/full", O_WRONLY);
    snprintf(path, sizeof path, "/dev/fd/%d", device);
    tf_output_file file;
    ck_assert(tf_output_file_begin(&file, path));
    FILE *stream = tf_output_file_open(&file);
    fputs("text", stream);
    ck_assert(!tf_output_file_close(&file, stream));
    ck_assert_int_eq(errno, ENOSPC);
    tf_output_file_drop(&file);
    close(device);
}
END_TEST

START_TEST(a_file_that_gets_too_large_is_reported)
{
    tf_output_file file;
    ck_assert(tf_output_file_begin(&file, "large"));
    struct rlimit limit;
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = 1000;
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    FILE *stream = tf_output_file_open(&file);
    for (int i = 0; i < 100000; i++)
        fputc('x', stream);
    // What was not written is lost, though the last bytes would fit again.
    limit.rlim_cur = limit.rlim_max;
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    ck_assert(!tf_output_file_close(&file, stream));
    ck_assert_int_eq(errno, EFBIG);
    tf_output_file_drop(&file);
    ck_assert_int_eq(files(), 0);
}
END_TEST

static const int signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM};

START_TEST(a_signal_removes_the_scratch_file)
{
    pid_t child = fork();
    if (child == 0) {
        const struct rlimit no_core = {0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        signal(signals[_i], SIG_DFL);
        tf_output_file file;
        _exit(tf_output_file_begin(&file, "new") ? raise(signals[_i]) : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ck_assert_msg(WIFSIGNALED(status) && WTERMSIG(status) == signals[_i],
                  "status %#x", (unsigned)status);
    ck_assert_int_eq(files(), 0);
}
END_TEST

START_TEST(an_ignored_signal_changes_nothing)
{
    signal(SIGHUP, SIG_IGN);
    tf_output_file file;
    ck_assert(tf_output_file_begin(&file, "new"));
    raise(SIGHUP);
    ck_assert_int_eq(files(), 1);
    tf_output_file_drop(&file);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/output_file");
    TCase *written = tcase_create("what is written");
    tcase_add_checked_fixture(written, enter_folder, leave_folder);
    tcase_add_test(written, a_new_file_appears_when_kept);
    tcase_add_test(written, a_file_is_replaced_when_kept);
    tcase_add_test(written, a_dropped_file_leaves_nothing);
    tcase_add_test(written, links_are_followed);
    tcase_add_test(written, pipes_are_written_to);
    tcase_add_test(written, what_cannot_be_a_file_is_refused);
    tcase_add_test(written, a_full_device_is_reported);
    tcase_add_test(written, a_file_that_gets_too_large_is_reported);
    suite_add_tcase(suite, written);

    TCase *ended = tcase_create("signals");
    tcase_add_checked_fixture(ended, enter_folder, leave_folder);
    tcase_add_loop_test(ended, a_signal_removes_the_scratch_file, 0,
                        sizeof signals / sizeof *signals);
    tcase_add_test(ended, an_ignored_signal_changes_nothing);
    suite_add_tcase(suite, ended);
    return suite;
}
