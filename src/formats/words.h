//: Declare a text of words
#pragma once

#include "files/text.h"
#include "formats/mesh_file.h"

/// The words of a text in which the ends of lines mean no more than blanks do.
typedef struct tf_words {
    tf_text text;
    const char *start, *end; ///< of the text
    bool has_comments;       ///< from # to the end of a line
    const char *early_end;   ///< what is said if a word is missing at the end
    tf_mesh_file *file;      ///< to which the faults are told
} tf_words;

/// The words of a file.
tf_words tf_words_of(tf_mesh_file *file, const char *text, size_t size);

//: Declare how to take words
/// Steps to the next word; false at the end of the text.
bool tf_words_find(tf_words *words);

/// Steps to the next word; it is a fault if there is none.
bool tf_words_need(tf_words *words);

/// Steps over the next word if it is this one, in small or capital letters.
bool tf_words_take(tf_words *words, const char *word);

/// Steps over the next word, whatever it is; it is a fault if there is none.
bool tf_words_skip(tf_words *words);

/// Steps over what is left of the line.
void tf_words_skip_line(tf_words *words);

//: Declare how to take numbers
/// Reads the next word as a finite number, an integer that an int holds, from
/// `least` on, or three coordinates, of which `at` are the beginnings.  False:
/// there is a fault.
bool tf_words_read_number(tf_words *words, double *number);
bool tf_words_read_integer(tf_words *words, int least, int *integer);
bool tf_words_read_position(tf_words *words, double x[3], const char *at[3]);

/// Sets a fault that quotes the next word; false.
bool tf_words_fault(const tf_words *words, const char *verdict);
