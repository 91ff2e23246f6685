// Run the program tanglefree by lines of shell, in a folder of its own.
#ifndef SUPPORT_PROGRAM_H
#define SUPPORT_PROGRAM_H

#include <stddef.h>

/// A fixture of tests: finds the program, then stays in a new folder, with
/// $TANGLEFREE the program and $QUERIES the folder tests/queries.
void enter_folder(void);
void leave_folder(void);

void make_file(const char *name, const char *text);
void make_binary_file(const char *name, const void *bytes, size_t size);

/// The text of a file, until the call after the next one.
const char *file_text(const char *name);

/// What the program did.
typedef struct outcome {
    int status;
    const char *out, *err; ///< until the next run
} outcome;

/// Runs a line of shell, in which $tf is the program.
__attribute__((format(printf, 1, 2))) outcome run(const char *format, ...);

/// Runs a command of the program in a process of its own, in the i-th broken
/// environment; the list of its arguments begins with a name and ends with NULL.
outcome run_broken(int environment, int (*command)(int argc, char *argv[]),
                   const char *const arguments[]);

void expect(outcome found, int status, const char *out, const char *err);

/// Expects that arguments are refused: nothing but a message that starts with
/// these words.
void expect_usage(const char *arguments, const char *words);

/// Expects words in a text.
void expect_words(const char *text, const char *words);

/// How often words are in a text.
int occurrences(const char *text, const char *words);

#endif
