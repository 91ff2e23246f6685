//: Declare the failsafe
#pragma once

#include "geometry/step.h"
#include "response/groups.h"
#include "response/options.h"

#include <stddef.h>

/// Vertices in groups that move as one.  All vertices of a group have the same
/// displacement, except that each end is rounded by itself and that scripted
/// vertices end where they are proposed to; or the group is at rest for good.
typedef struct tf_failsafe {
    tf_groups groups;
    tf_buffer entry; ///< the ends without pushes when the failsafe began
    tf_buffer group; ///< what is known about each group, at its root
} tf_failsafe;

/// Puts each vertex into a group of its own and leaves its end as it is.
/// Returns false if there is no memory.
bool tf_failsafe_begin(tf_failsafe *failsafe, const tf_step *step);

/// Answers contacts: puts each group to rest that has a contact within itself,
/// then unites the groups that meet.
void tf_failsafe_round(tf_failsafe *failsafe, tf_step *step,
                       const tf_contacts *contacts);

/// Marks the vertices that are in groups, or rest; returns how many groups of
/// more than one vertex there are.
int tf_failsafe_mark(tf_failsafe *failsafe, const tf_step *step);

size_t tf_failsafe_memory(const tf_failsafe *failsafe);
void tf_failsafe_free(tf_failsafe *failsafe);
