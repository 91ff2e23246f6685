#include "support/json.h"

#include <stdbool.h>
#include <string.h>

// Each reader steps *at behind what it reads, or returns false and leaves *at
// where the rules are broken.

static void skip_space(const char **at)
{
    *at += strspn(*at, " \t\r\n");
}

static bool read_word(const char **at, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(*at, word, length) != 0)
        return false;
    *at += length;
    return true;
}

static bool read_digits(const char **at)
{
    size_t count = strspn(*at, "0123456789");
    *at += count;
    return count > 0;
}

static bool read_number(const char **at)
{
    read_word(at, "-");
    if (!read_word(at, "0") && !read_digits(at))
        return false;
    if (read_word(at, ".") && !read_digits(at))
        return false;
    if (!read_word(at, "e") && !read_word(at, "E"))
        return true;
    if (!read_word(at, "+"))
        read_word(at, "-");
    return read_digits(at);
}

static bool read_character(const char **at)
{
    bool plain = (unsigned char)**at >= ' ' && **at != '"' && **at != '\\';
    *at += plain;
    return plain || read_word(at, "\\\"") || read_word(at, "\\\\");
}

/// No escapes but of quotes and backslashes: the program writes no others.
static bool read_string(const char **at)
{
    if (!read_word(at, "\""))
        return false;
    while (read_character(at))
        continue;
    return read_word(at, "\"");
}

static bool read_value(const char **at);

/// What is between braces or brackets, the first of which has been read.
static bool read_list(const char **at, const char *end, bool named)
{
    skip_space(at);
    if (read_word(at, end))
        return true;
    do {
        skip_space(at);
        if (named && !read_string(at))
            return false;
        skip_space(at);
        if (named && !read_word(at, ":"))
            return false;
        if (!read_value(at))
            return false;
    } while (read_word(at, ","));
    return read_word(at, end);
}

static bool read_value(const char **at)
{
    skip_space(at);
    bool good;
    if (read_word(at, "{"))
        good = read_list(at, "}", true);
    else if (read_word(at, "["))
        good = read_list(at, "]", false);
    else if (**at == '"')
        good = read_string(at);
    else
        good = read_word(at, "null") || read_word(at, "true") ||
               read_word(at, "false") || read_number(at);
    skip_space(at);
    return good;
}

const char *json_fault(const char *text)
{
    const char *at = text;
    return read_value(&at) && *at == '\0' ? NULL : at;
}
