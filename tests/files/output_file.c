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

// Killed programs -------------------------------------------------------------

/// Begins a file in a child process that is then killed.
static void leave_scratch(const char *path)
{
    pid_t child = fork();
    if (child == 0) {
        tf_output_file file;
        if (tf_output_file_begin(&file, path))
            raise(SIGKILL);
        _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ck_assert(WIFSIGNALED(status));
}

START_TEST(the_next_program_removes_what_a_killed_one_left)
{
    ck_assert_int_eq(mkdir("folder", 0700), 0);
    ck_assert_int_eq(symlink("folder/file", "link"), 0);
    make_file("folder/file", "before");
    for (int i = 1; i < 4; i++)
        leave_scratch("folder/file");
    expect(run("ls -A folder | wc -l"), 0, "2\n", "");
    write_file("folder/other", "text");
    expect(run("ls -A folder | wc -l"), 0, "3\n", "");
    if (_i)
        tf_output_file_clear("link");
    else
        write_file("link", "after");
    expect(run("ls -A folder"), 0, "file\nother\n", "");
    ck_assert_str_eq(file_text("folder/file"), _i ? "before" : "after");
}
END_TEST

START_TEST(a_file_is_cleared_before_it_is_there)
{
    leave_scratch("new");
    ck_assert_int_eq(files(), 1);
    tf_output_file_clear("./new");
    ck_assert_int_eq(files(), 0);
    tf_output_file_clear("missing/new");
}
END_TEST

START_TEST(no_descriptor_is_left_open)
{
    struct rlimit limit;
    getrlimit(RLIMIT_NOFILE, &limit);
    limit.rlim_cur = 32;
    ck_assert_int_eq(setrlimit(RLIMIT_NOFILE, &limit), 0);
    for (int i = 0; i < 40; i++) {
        tf_output_file file;
        write_file("new", "text");
        ck_assert(tf_output_file_begin(&file, "new"));
        tf_output_file_clear("new");
        tf_output_file_drop(&file);
        ck_assert(!tf_output_file_begin(&file, "."));
    }
}
END_TEST

// More than have names that are looked for.
START_TEST(files_in_the_making_are_left_alone)
{
    enum {
        WRITERS = 20
    };
    tf_output_file file[WRITERS];
    for (int i = 0; i < WRITERS; i++)
        ck_assert(tf_output_file_begin(&file[i], "new"));
    tf_output_file_clear("new");
    ck_assert_int_eq(files(), WRITERS);
    for (int i = 0; i < WRITERS; i++) {
        FILE *stream = tf_output_file_open(&file[i]);
        fprintf(stream, "%d", i);
        ck_assert(tf_output_file_close(&file[i], stream));
    }
    for (int i = WRITERS - 1; i >= 0; i--) {
        char text[10];
        sprintf(text, "%d", i);
        ck_assert(tf_output_file_keep(&file[i]));
        ck_assert_str_eq(file_text("new"), text);
        tf_output_file_clear("new");
        ck_assert_int_eq(files(), i + 1);
    }
}
END_TEST

/// Puts something that no killed program has left where a scratch file would be.
static void put_something(const char *name, int what)
{
    make_file("precious", "text");
    switch (what) {
    case 0:
        ck_assert_int_eq(symlink("precious", name), 0);
        break;
    case 1:
        ck_assert_int_eq(link("precious", name), 0);
        break;
    case 2:
        ck_assert_int_eq(mkfifo(name, 0600), 0);
        break;
    case 3:
        ck_assert_int_eq(mkdir(name, 0700), 0);
        break;
    default:
        ck_assert_int_eq(symlink("nowhere", name), 0);
    }
}

START_TEST(only_what_a_killed_program_left_is_removed)
{
    tf_output_file file;
    ck_assert(tf_output_file_begin(&file, "new"));
    char *name = strdup(file.scratch);
    tf_output_file_drop(&file);
    put_something(name, _i);
    struct stat before, after;
    ck_assert_int_eq(lstat(name, &before), 0);
    write_file("new", "other");
    tf_output_file_clear("new");
    ck_assert_int_eq(lstat(name, &after), 0);
    ck_assert_uint_eq(before.st_ino, after.st_ino);
    ck_assert_uint_eq(before.st_mode, after.st_mode);
    ck_assert_str_eq(file_text("precious"), "text");
    ck_assert_str_eq(file_text("new"), "other");
    ck_assert_int_eq(files(), 3);
    free(name);
}
END_TEST

/// Writes the same file again and again; ends with the number of failures.
static void write_often(int writer, int times)
{
    int failures = 0;
    for (int i = 0; i < times; i++) {
        tf_output_file file;
        FILE *stream = tf_output_file_begin(&file, "new")
                           ? tf_output_file_open(&file)
                           : NULL;
        bool good = stream && fprintf(stream, "%d %d end", writer, i) > 0 &&
                    fflush(stream) == 0 && fclose(stream) == 0;
        if (i % 5 == 4)
            tf_output_file_drop(&file);
        else
            failures += !good || !tf_output_file_keep(&file);
    }
    _exit(failures);
}

// Four write to the end, and four are killed and begin again until these have
// ended.  Nobody takes the scratch file of another who lives.
START_TEST(many_programs_write_a_file_at_once)
{
    enum {
        WRITERS = 8
    };
    pid_t child[WRITERS];
    generator random = generator_new(70);
    for (int i = 0; i < WRITERS; i++)
        if ((child[i] = fork()) == 0)
            write_often(i, i < 4 ? (int)cases(1500) : 1000000000);
    int left = 4;
    while (left > 0) {
        int victim = 4 + below(&random, 4), status = 0;
        kill(child[victim], SIGKILL);
        waitpid(child[victim], NULL, 0);
        if ((child[victim] = fork()) == 0)
            write_often(victim, 1000000000);
        usleep((useconds_t)below(&random, 3000));
        for (int i = 0; i < 4; i++)
            if (child[i] > 0 && waitpid(child[i], &status, WNOHANG) > 0) {
                ck_assert_msg(WIFEXITED(status) && WEXITSTATUS(status) == 0,
                              "writer %d: status %#x", i, (unsigned)status);
                child[i] = 0;
                left--;
            }
    }
    for (int i = 4; i < WRITERS; i++) {
        kill(child[i], SIGKILL);
        waitpid(child[i], NULL, 0);
    }
    expect_words(file_text("new"), " end");
    tf_output_file_clear("new");
    ck_assert_int_eq(files(), 1);
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

    TCase *killed = tcase_create("killed programs");
    tcase_add_checked_fixture(killed, enter_folder, leave_folder);
    tcase_set_timeout(killed, 60);
    tcase_add_loop_test(killed, the_next_program_removes_what_a_killed_one_left,
                        0, 2);
    tcase_add_test(killed, a_file_is_cleared_before_it_is_there);
    tcase_add_test(killed, no_descriptor_is_left_open);
    tcase_add_test(killed, files_in_the_making_are_left_alone);
    tcase_add_loop_test(killed, only_what_a_killed_program_left_is_removed, 0,
                        5);
    tcase_add_test(killed, many_programs_write_a_file_at_once);
    suite_add_tcase(suite, killed);
    return suite;
}
