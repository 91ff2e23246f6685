//: Declare the reader of a scene file
#pragma once

#include "files/fault.h"
#include "scenes/scene_meshes.h"

#include <yaml.h>

/// A scene file that is being read.
typedef struct tf_scene_reader {
    const char *path;
    yaml_document_t document;
    tf_scene_meshes *meshes;
    tf_fault *fault;
} tf_scene_reader;

/// The node of an index.
yaml_node_t *tf_scene_node(tf_scene_reader *reader, int index);

/// The line of a node, from 1.
long tf_scene_line(const yaml_node_t *node);

/// Set a fault, at the line of a node, as printf, or that there is no memory;
/// false.
__attribute__((format(printf, 3, 4))) bool
tf_scene_fault_at(tf_scene_reader *reader, const yaml_node_t *node,
                  const char *format, ...);
bool tf_scene_fault_in_memory(tf_scene_reader *reader);

//: Declare how to read mappings of a scene
typedef struct tf_scene_key tf_scene_key;

/// Reads the value of a key.  False: there is a fault.
/// @param target what the mapping describes
typedef bool tf_value_reader(tf_scene_reader *reader, const tf_scene_key *key,
                             const yaml_node_t *node, void *target);

/// A key, and what reads its value.  A list of them ends with one without name.
struct tf_scene_key {
    const char *name;
    tf_value_reader *read;
    size_t member;      ///< for the readers below: where in the target to write
    double least, most; ///< of a number; both 0: any is good
};

/// Reads a mapping, each key at most once.  False: there is a fault.
/// @param wanted what the mapping has, for a message
bool tf_scene_read_mapping(tf_scene_reader *reader, const yaml_node_t *node,
                           const tf_scene_key keys[], const char *wanted,
                           void *target);

/// Where in the target the value of a key is written.
void *tf_scene_member(const tf_scene_key *key, void *target);

//: Declare how to read values of a scene
/// The text of a node, lent; NULL: there is a fault.
/// @param what it is, for a message
const char *tf_scene_text(tf_scene_reader *reader, const yaml_node_t *node,
                          const char *what);

/// Reads a number that is finite and from `least` to `most`.
bool tf_scene_read_number(tf_scene_reader *reader, const yaml_node_t *node,
                          const tf_scene_key *key, double *number);

/// Values that are a copied text, char *; a double; an int; and of three doubles.
tf_value_reader tf_scene_take_text, tf_scene_take_number, tf_scene_take_whole,
    tf_scene_take_vector;

/// Whether a node is a list that is not empty.
bool tf_scene_is_list(const yaml_node_t *node);
