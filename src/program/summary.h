//: Declare summaries
#pragma once

#include <stddef.h>
#include <stdio.h>

/// A line of a summary: its name, and a count, a number or a word.
typedef struct tf_entry {
    const char *name;
    enum {
        TF_ENTRY_COUNT,
        TF_ENTRY_NUMBER,
        TF_ENTRY_WORD
    } kind;
    size_t count;
    double number;
    const char *word; ///< without quotes and the like
} tf_entry;

tf_entry tf_entry_count(const char *name, size_t count);
tf_entry tf_entry_number(const char *name, double number);
tf_entry tf_entry_word(const char *name, const char *word);

//: Declare how to write summaries
/// Writes the entries for people, a line each.
void tf_summary_write(FILE *stream, int entries, const tf_entry entry[]);

/// Writes the entries as an object of JSON: with _ for the blanks of names, all
/// digits of numbers, and null for what is not finite.
void tf_summary_write_json(FILE *stream, int entries, const tf_entry entry[]);
