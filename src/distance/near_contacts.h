//: Declare near pairs as contacts
#pragma once

#include "surface/contacts.h"
#include "surface/surface_memory.h"

/// How near to each other pairs of elements may end a step.
typedef struct tf_thickness {
    double length; ///< finite; 0: at any distance
    tf_buffer row; ///< the near pairs that were last listed
} tf_thickness;

/// Lists a row for each pair that is nearer than the length at the end of a
/// step without contacts, and was not at its start.  The rows are lent,
/// sorted as contacts are, and unlike these they have the verdict TF_APART.
/// Their points are the nearest ones at the end, their normal goes there
/// from the second element's to the first one's, and they have no velocity.
/// Leaves the statistics of `found` as they are.  Sets the error to what it
/// returns: TF_OK, TF_OUT_OF_MEMORY, TF_CANCELLED, or another status of
/// tf_near_search_run.
tf_status tf_near_contacts_find(tf_thickness *thickness, tf_surface *surface,
                                const tf_motion *motion,
                                const tf_parallel *parallel, tf_contacts *found,
                                tf_error *error);

/// Finds how many pairs are nearer than the length at the start of a step.
tf_status tf_near_contacts_count_start(const tf_thickness *thickness,
                                       tf_surface *surface,
                                       const tf_motion *motion,
                                       const tf_parallel *parallel,
                                       size_t *count, tf_error *error);
