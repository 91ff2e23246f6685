//: Include what words need
#define _GNU_SOURCE // strncasecmp
#include "formats/words.h"

#include "files/number.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

//: Begin the words of a file
tf_words tf_words_of(tf_mesh_file *file, const char *text, size_t size)
{
    return (tf_words){
        .text = {.name = file->name,
                 .at = tf_text_begin(text),
                 .line = 1,
                 .fault = file->fault},
        .start = text,
        .end = text + size,
        .early_end = "the file ends too early; it may be cut short, or its "
                     "header declares too much",
        .file = file,
    };
}

//: Step from word to word
void tf_words_skip_line(tf_words *words)
{
    const char *at = words->text.at;
    const char *end = memchr(at, '\n', (size_t)(words->end - at));
    words->text.at = end ? end : words->end;
}

static const char *ends_of(const tf_words *words)
{
    return words->has_comments ? " \t\r\n#" : " \t\r\n";
}

static size_t word_length(const tf_words *words)
{
    return strcspn(words->text.at, ends_of(words));
}

bool tf_words_find(tf_words *words)
{
    tf_text *text = &words->text;
    for (;;) {
        tf_text_skip_blanks(text);
        if (words->has_comments && *text->at == '#')
            tf_words_skip_line(words);
        if (*text->at != '\n')
            return text->at < words->end;
        text->at++;
        text->line++;
    }
}

bool tf_words_need(tf_words *words)
{
    return tf_words_find(words) ||
           tf_text_fault(&words->text, "%s", words->early_end);
}

bool tf_words_take(tf_words *words, const char *word)
{
    size_t length = strlen(word);
    if (!tf_words_find(words) || length != word_length(words) ||
        strncasecmp(words->text.at, word, length) != 0)
        return false;
    words->text.at += length;
    return true;
}

bool tf_words_skip(tf_words *words)
{
    bool found = tf_words_need(words);
    size_t length = found ? word_length(words) : 0;
    words->text.at += length;
    return length > 0 || (found && tf_text_fault_in_nul(&words->text));
}

//: Read the numbers of a text
bool tf_words_fault(const tf_words *words, const char *verdict)
{
    return tf_text_fault_in_word(&words->text, words->text.at,
                                 word_length(words), verdict);
}

bool tf_words_read_number(tf_words *words, double *number)
{
    return tf_words_need(words) &&
           tf_text_read_number(&words->text, ends_of(words), number);
}

bool tf_words_read_position(tf_words *words, double x[3], const char *at[3])
{
    for (int k = 0; k < 3; k++) {
        if (!tf_words_need(words))
            return false;
        at[k] = words->text.at;
        if (!tf_words_read_number(words, &x[k]))
            return false;
    }
    return true;
}

static bool fault_in_integer(const tf_words *words, int least)
{
    char verdict[100];
    snprintf(verdict, sizeof verdict,
             "not an integer from %d to %d; correct it, or the numbers before "
             "it",
             least, INT_MAX);
    return tf_words_fault(words, verdict);
}

bool tf_words_read_integer(tf_words *words, int least, int *integer)
{
    if (!tf_words_need(words))
        return false;
    const char *at = words->text.at;
    int64_t read;
    if (!tf_integer_read(&at, &read) || !tf_ends_word(*at, ends_of(words)) ||
        read < least || read > INT_MAX)
        return fault_in_integer(words, least);
    words->text.at = at;
    *integer = (int)read;
    return true;
}
