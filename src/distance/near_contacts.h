//: Declare near pairs as contacts
#pragma once

#include "surface/contacts.h"
#include "surface/surface_memory.h"

/// Pairs of elements that end a step nearer to each other than they may.
typedef struct tf_thickness {
    double length;     ///< how near they may be, finite; 0: any distance
    tf_buffer row;     ///< contacts and near pairs, as they were last listed
    size_t near;       ///< how many of these are near pairs
    tf_buffer contact; ///< the contacts among them
} tf_thickness;

size_t tf_thickness_memory(const tf_thickness *thickness);
void tf_thickness_free(tf_thickness *thickness);

/// Adds to the contacts of a step, which the surface lends, a row for each pair
/// that is nearer than the length at the end of the step and was not at its start;
/// what they are then lent by the thickness, in the same order, one row for a pair
/// that is in contact, too.  The row of a near pair has the verdict TF_APART,
/// unlike any contact: its points are the nearest ones at the end, its normal goes
/// from the second to the first of these, or is zero where they meet, and it has
/// no velocity.  Sets the error to what it returns: TF_OK, TF_OUT_OF_MEMORY,
/// TF_CANCELLED, or another status of tf_near_search_run.
tf_status tf_near_contacts_add(tf_thickness *thickness, tf_surface *surface,
                               const tf_motion *motion,
                               const tf_parallel *parallel,
                               tf_contacts *contacts, tf_error *error);

/// Finds how many pairs are nearer than the length at the start of a step.
tf_status tf_near_contacts_count_start(const tf_thickness *thickness,
                                       tf_surface *surface,
                                       const tf_motion *motion,
                                       const tf_parallel *parallel,
                                       size_t *count, tf_error *error);
