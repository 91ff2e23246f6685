//: Declare rigid zones
#pragma once

#include "response/groups.h"
#include "response/step.h"
#include "surface/detect.h"

/// Zones that move as rigid bodies.
typedef struct tf_rigid {
    tf_groups groups;
    tf_buffer entry; ///< the ends when the level began
    tf_buffer body;  ///< what is known of each zone, by its root
} tf_rigid;

/// Puts each vertex into a zone of its own, which ends where it does now.
/// False if there is no memory.
bool tf_rigid_begin(tf_rigid *rigid, const tf_step *step);

/// Unites the zones of each contact and moves those that grew as rigid bodies,
/// with the momenta that they have.  A zone with a vertex that should not be
/// moved stays as it is.  This is only a proposal: a body that turns is no rigid
/// one on the way, where its elements are bent, nor in doubles.
void tf_rigid_round(tf_rigid *rigid, tf_step *step,
                    const tf_contacts *contacts);

size_t tf_rigid_memory(const tf_rigid *rigid);
void tf_rigid_free(tf_rigid *rigid);
