//: Declare the names of frames
#pragma once

#include <stdbool.h>

/// The paths of the files of a sequence.  All zero: there are none.
typedef struct tf_frame_names {
    char **path;
    int count;
} tf_frame_names;

void tf_frame_names_free(tf_frame_names *names);

/// Adds a path as it is.  False: there is no memory.
bool tf_frame_names_add(tf_frame_names *names, const char *path);

typedef enum tf_names_found {
    TF_NAMES_NO_MEMORY = 0,
    TF_NAMES_NONE, ///< no file has such a name
    TF_NAMES_ADDED
} tf_names_found;

/// Adds the files that a scene file calls by `name`, relative to itself: the one
/// of that name or, if there is none and *, ? or [] are in it, all that it is a
/// pattern for, as in a shell, in natural order.
/// @param scene the path of the scene file
tf_names_found tf_frame_names_find(tf_frame_names *names, const char *scene,
                                   const char *name);
