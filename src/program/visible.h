//: Declare how to show a name
#pragma once

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
