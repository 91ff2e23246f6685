//: Include what visible names need
#include "files/visible.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

//: Recognize a character that a terminal shows
/// How many bytes the UTF-8 character that starts here has; 0 if there is none,
/// or a control character.
static int shown_bytes(const unsigned char *at)
{
    if (*at < 0x80)
        return *at >= ' ' && *at != 0x7f;
    int bytes = *at >= 0xf8   ? 0
                : *at >= 0xf0 ? 4
                : *at >= 0xe0 ? 3
                : *at >= 0xc0 ? 2
                              : 0;
    unsigned code = *at & (0x7fu >> bytes);
    for (int i = 1; i < bytes; i++) {
        if ((at[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (at[i] & 0x3f);
    }
    // Two bytes begin with control characters, up to 0x9f; a smaller code than
    // the least is one that fewer bytes could hold.
    static const unsigned least[] = {0, 0, 0xa0, 0x800, 0x10000};
    bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code >= least[bytes] && code <= 0x10ffff && !surrogate ? bytes : 0;
}

//: Show all others by their codes
tf_visible tf_make_visible(const char *name)
{
    tf_visible shown = {.text = ""};
    char *at = shown.text;
    while (*name && at - shown.text < TF_VISIBLE_ROOM - 8) {
        int bytes = shown_bytes((const unsigned char *)name);
        if (bytes == 0)
            at += sprintf(at, "\\x%02x", (unsigned char)*name);
        memcpy(at, name, (size_t)bytes);
        at += bytes;
        name += bytes + (bytes == 0);
    }
    strcpy(at, *name ? "..." : "");
    return shown;
}

//: Quote a word
tf_quoted tf_quote(const char *word, size_t length)
{
    tf_quoted quoted;
    bool cut = length >= TF_QUOTED_ROOM;
    length = cut ? TF_QUOTED_ROOM - 4 : length;
    for (size_t i = 0; i < length; i++)
        quoted.text[i] = word[i] >= ' ' && word[i] <= '~' ? word[i] : '?';
    strcpy(quoted.text + length, cut ? "..." : "");
    return quoted;
}
