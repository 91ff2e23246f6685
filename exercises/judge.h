// The two processes that run the checks of an exercise (see check.h): what the
// judge reports, and how results get to it.
#ifndef EXERCISES_JUDGE_H
#define EXERCISES_JUDGE_H

/// The judge remembers what the next call is given.
void judge_note_input(const char *text);

/// The judge remembers a query that shows that input: a kind, then its rows.
void judge_note_picture(const char *text);

/// A check fails.  The judge reports it and ends.  The answer's process lets the
/// judge know, in case it came from within the student's code, and ends.
_Noreturn void judge_fail(const char *expected, const char *got,
                          const char *where);

#endif
