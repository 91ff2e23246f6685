//: Include what texts need
#include "files/text.h"

#include "files/number.h"

#include <math.h>
#include <string.h>

//: Describe what is wrong with a text
bool tf_text_fault(const tf_text *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(text->fault, text->name, text->line, format, arguments);
    va_end(arguments);
    return false;
}

bool tf_text_fault_in_nul(const tf_text *text)
{
    return tf_text_fault(text, "a NUL byte; the file must be plain text (ASCII "
                               "or UTF-8, not UTF-16)");
}

bool tf_text_fault_in_word(const tf_text *text, const char *word, size_t length,
                           const char *verdict)
{
    return length == 0 ? tf_text_fault_in_nul(text)
                       : tf_text_fault(text, "'%s' is %s",
                                       tf_quote(word, length).text, verdict);
}

//: Step over blanks
const char *tf_text_begin(const char *text)
{
    return text + (strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0);
}

void tf_text_skip_blanks(tf_text *text)
{
    while (*text->at == ' ' || *text->at == '\t' || *text->at == '\r')
        text->at++;
}

bool tf_ends_word(char c, const char *ends)
{
    return c == '\0' || strchr(ends, c);
}

//: Read a finite number
bool tf_text_read_number(tf_text *text, const char *ends, double *number)
{
    const char *word = text->at;
    bool good =
        tf_number_read(&text->at, number) && tf_ends_word(*text->at, ends);
    size_t length = strcspn(word, " \t\r\n");
    return (good && isfinite(*number)) ||
           tf_text_fault_in_word(text, word, length,
                                 good ? TF_TOO_LARGE_VERDICT
                                 : memchr(word, ',', length)
                                     ? TF_COMMA_VERDICT
                                     : TF_NO_NUMBER_VERDICT);
}
