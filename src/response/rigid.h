//: Declare rigid zones
#pragma once

#include "geometry/step.h"
#include "response/groups.h"
#include "surface/contacts.h"

/// Zones that move as rigid bodies.
typedef struct tf_rigid {
    tf_groups groups;
    tf_buffer entry; ///< the ends without pushes when the level began
    tf_buffer body;  ///< what is known about each zone, at its root
} tf_rigid;

/// Puts each vertex into a zone of its own and leaves its end as it is.
/// Returns false if there is no memory.
bool tf_rigid_begin(tf_rigid *rigid, const tf_step *step);

/// Unites the zones of each contact, and moves each zone that has a contact as a
/// rigid body that keeps its momentum and its angular momentum.  A zone with a
/// scripted vertex is left alone.  This is only a proposal and may make contacts:
/// a body that turns is not rigid on the way, where its elements are bent, and
/// its ends are rounded.
void tf_rigid_round(tf_rigid *rigid, tf_step *step,
                    const tf_contacts *contacts);

size_t tf_rigid_memory(const tf_rigid *rigid);
void tf_rigid_free(tf_rigid *rigid);
