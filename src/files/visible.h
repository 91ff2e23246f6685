//: Declare how to show a name
#pragma once

#include <stddef.h>

enum {
    TF_VISIBLE_ROOM = 4096
};

/// A text for a terminal: of what a file name may hold, control characters and
/// bytes that are no UTF-8, either of which may be commands to the terminal,
/// are shown as \x1b, for instance.  Cut where it is long.
typedef struct tf_visible {
    char text[TF_VISIBLE_ROOM];
} tf_visible;

tf_visible tf_make_visible(const char *name);

//: Declare how to quote a word
enum {
    TF_QUOTED_ROOM = 32
};

/// A word of a file for a message: cut where it is long, and with a ? for each
/// byte that is no printable ASCII.
typedef struct tf_quoted {
    char text[TF_QUOTED_ROOM];
} tf_quoted;

tf_quoted tf_quote(const char *word, size_t length);
