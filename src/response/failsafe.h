//: Declare the failsafe
#pragma once

#include "response/groups.h"
#include "response/options.h"
#include "response/step.h"

#include <stddef.h>

/// Vertices in groups that move as one.  A group of more than one vertex has one
/// displacement, rounded at each vertex, or is at rest for good.
typedef struct tf_failsafe {
    tf_groups groups;
    tf_buffer entry; ///< the ends when the failsafe began
    tf_buffer group; ///< what is known of each group, by its root
} tf_failsafe;

/// Puts each vertex into a group of its own, which ends where it does now.
/// False if there is no memory.
bool tf_failsafe_begin(tf_failsafe *failsafe, const tf_step *step);

/// Answers contacts: unites the groups of each, and puts those to rest that have
/// contacts within themselves.
void tf_failsafe_round(tf_failsafe *failsafe, tf_step *step,
                       const tf_contacts *contacts);

/// Counts the groups.
void tf_failsafe_account(tf_failsafe *failsafe, const tf_step *step,
                         tf_response_report *report);

size_t tf_failsafe_memory(const tf_failsafe *failsafe);
void tf_failsafe_free(tf_failsafe *failsafe);
