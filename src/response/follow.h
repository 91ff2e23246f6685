//: Declare how far scripts are followed
#pragma once

#include "geometry/step.h"
#include "response/groups.h"
#include "surface/elements.h"

#include <stddef.h>

/// How far the scripted vertices go that cannot go all the way.  Those that are
/// held back together are a company, and go the same fraction of their ways,
/// which is found by bisection, one trial after another.  All zero: none yet.
typedef struct tf_follow {
    int companies;     ///< how many
    int trials;        ///< how many there were
    int retreats;      ///< how often companies went back to where they could go
    tf_buffer company; ///< what is known about each
    tf_buffer number;  ///< of each vertex: companies; and by group
    tf_buffer fraction; ///< of its way that each vertex is to go
    tf_buffer
        squeezed; ///< of each vertex: whether a company was held back in its
                  ///< group of the failsafe
    tf_buffer proposed; ///< the step, shortened
} tf_follow;

/// Whether a scripted vertex does not end where it is proposed to.
bool tf_follow_is_held(const tf_step *step);

/// Begins with a step that all scripted vertices are to go all the way.  False if
/// there is no memory.
bool tf_follow_begin(tf_follow *follow, const tf_step *step);

/// Learns from the last trial, a resolved step: from the scripted vertices that
/// do not end where this trial has proposed, and from the groups of its failsafe.
/// Returns whether another trial is wanted.
bool tf_follow_learn(tf_follow *follow, const tf_step *step, tf_groups *groups);

/// Shortens the ways of scripted vertices for the next trial, whole ways that end
/// at `proposed`; returns where the vertices are to end, lent, or NULL if the
/// caller has cancelled.
const double *tf_follow_propose(tf_follow *follow, const tf_step *step,
                                const double proposed[],
                                const tf_elements *edges);

size_t tf_follow_memory(const tf_follow *follow);
void tf_follow_free(tf_follow *follow);
