//: Declare groups
#pragma once

#include "surface/buffer.h"

#include <stdbool.h>

/// A partition of the numbers 0 to count - 1 into groups.
typedef struct tf_groups {
    int count;
    int *parent; ///< one of the group that is nearer to its root;
                 ///< of the root itself: the root
    tf_buffer storage;
} tf_groups;

/// Puts each number into a group of its own.  False if there is no memory.
bool tf_groups_begin(tf_groups *groups, int count);

/// Returns the root of a number's group, which is the least number in it.
int tf_groups_find(tf_groups *groups, int number);

/// Unites the groups of two numbers and returns the root of the new group.
int tf_groups_unite(tf_groups *groups, int a, int b);
