//: Declare the list of what is left
#pragma once

#include "program/surface_output.h"
#include "scenes/scene_frames.h"

/// The intersections that untangling leaves, as the command check lists them,
/// kept until the report is written.  All zero: there is no list.
typedef struct tf_left_list {
    FILE *stream; ///< to the text
    char *text;
    size_t size;
    bool *listed;
    tf_surface_part part;
    tf_surface_output output;
} tf_left_list;

/// Begins a list about frames, of which the first was read, in JSON if that is
/// the format, and otherwise in CSV.  False: there is a fault of the frames.
/// @param names what rows name besides the elements
/// @param name what each of the meshes is called; borrowed
bool tf_left_list_begin(tf_left_list *list, tf_scene_frames *frames,
                        tf_format format, tf_row_names names,
                        const char *name[]);

/// Adds what is left in the next frame.  False: there is a fault of the frames.
bool tf_left_list_add(tf_left_list *list, tf_scene_frames *frames,
                      const tf_crossings *left);

/// Writes the list, if anything is in it, after an empty line unless that is
/// JSON.  False: there is a fault of the frames.
bool tf_left_list_write(tf_left_list *list, tf_scene_frames *frames,
                        FILE *stream);

void tf_left_list_free(tf_left_list *list);
