#define _GNU_SOURCE // mkdtemp, nftw, realpath

#include "support/program.h"

#include "support/environments.h"
#include "support/support.h"

#include <ftw.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// A folder to work in ---------------------------------------------------------

static char program[4096], queries[4096], before[4096];

void enter_folder(void)
{
    const char *told = getenv("TANGLEFREE");
    ck_assert_msg(realpath(told ? told : "build/tanglefree", program),
                  "TANGLEFREE does not name the program");
    ck_assert(realpath("tests/queries", queries));
    ck_assert(getcwd(before, sizeof before));
    char folder[] = "/tmp/tanglefree-test-XXXXXX";
    ck_assert(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    ck_assert_int_eq(setenv("TANGLEFREE", program, 1), 0);
    ck_assert_int_eq(setenv("QUERIES", queries, 1), 0);
}

static int remove_entry(const char *path, const struct stat *status, int type,
                        struct FTW *place)
{
    (void)status;
    (void)type;
    (void)place;
    return remove(path);
}

void leave_folder(void)
{
    char *folder = getcwd(NULL, 0);
    ck_assert_int_eq(chdir(before), 0);
    nftw(folder, remove_entry, 8, FTW_DEPTH | FTW_PHYS);
    free(folder);
}

// Files -----------------------------------------------------------------------

void make_binary_file(const char *name, const void *bytes, size_t size)
{
    FILE *file = fopen(name, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert_uint_eq(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

void make_file(const char *name, const char *text)
{
    make_binary_file(name, text, strlen(text));
}

const char *file_text(const char *name)
{
    static char text[2][1000000];
    static int next;
    char *read = text[next = !next];
    FILE *file = fopen(name, "r");
    ck_assert_ptr_nonnull(file);
    size_t length = fread(read, 1, sizeof text[0] - 1, file);
    read[length] = '\0';
    fclose(file);
    return read;
}

// Running the program ---------------------------------------------------------

outcome run(const char *format, ...)
{
    char line[1000];
    int length = snprintf(line, sizeof line, "{ tf=\"$TANGLEFREE\"; ");
    va_list arguments;
    va_start(arguments, format);
    length += vsnprintf(line + length, sizeof line - (size_t)length, format,
                        arguments);
    va_end(arguments);
    snprintf(line + length, sizeof line - (size_t)length,
             "\n} </dev/null >out 2>err");
    int status = system(line);
    ck_assert_msg(WIFEXITED(status), "%s: status %#x", line, (unsigned)status);
    return (outcome){WEXITSTATUS(status), file_text("out"), file_text("err")};
}

static _Noreturn void command_in(int environment,
                                 int (*command)(int argc, char *argv[]),
                                 const char *const arguments[])
{
    static char *kept[16]; // a command may change its list
    char *copy[16];
    int count = 0;
    for (; arguments[count]; count++)
        copy[count] = kept[count] = strdup(arguments[count]);
    copy[count] = NULL;
    if (!freopen("out", "w", stdout) || !freopen("err", "w", stderr))
        _exit(9);
    environment_break(environment);
    exit(command(count, copy));
}

outcome run_broken(int environment, int (*command)(int argc, char *argv[]),
                   const char *const arguments[])
{
    pid_t child = fork();
    if (child == 0)
        command_in(environment, command, arguments);
    int status = 0;
    waitpid(child, &status, 0);
    ck_assert_msg(WIFEXITED(status), "%s: status %#x",
                  environment_name(environment), (unsigned)status);
    return (outcome){WEXITSTATUS(status), file_text("out"), file_text("err")};
}

void expect(outcome found, int status, const char *out, const char *err)
{
    ck_assert_str_eq(found.err, err);
    ck_assert_str_eq(found.out, out);
    ck_assert_int_eq(found.status, status);
}

void expect_usage(const char *arguments, const char *words)
{
    outcome found = run("$tf %s", arguments);
    ck_assert_msg(strncmp(found.err, words, strlen(words)) == 0,
                  "%s: '%s', not '%s'", arguments, found.err, words);
    ck_assert_str_eq(found.out, "");
    ck_assert_int_eq(found.status, 2);
}

void expect_words(const char *text, const char *words)
{
    ck_assert_msg(strstr(text, words), "'%s' is not in '%s'", words, text);
}

int occurrences(const char *text, const char *words)
{
    int times = 0;
    while ((text = strstr(text, words))) {
        text += strlen(words);
        times++;
    }
    return times;
}
