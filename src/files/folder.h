//: Declare how to begin a folder
#pragma once

#include "files/fault.h"

/// Makes a folder, or takes one that is empty.  False: there is a fault.
/// @param otherwise what else can be done if there are files in it, behind
///     "choose another"; or ""
bool tf_folder_begin(const char *path, const char *otherwise, tf_fault *fault);
