//: Declare the relaxation
#pragma once

#include "base/status.h"
#include "response/options.h"
#include "simulate/body.h"

#include <stddef.h>

/// How the elastic elements of a body and the contacts of a step come to terms.
///
/// A response stops a vertex by an impulse on its own mass, and knows nothing of
/// the springs that pull the vertex on; the dynamics know nothing of what is in
/// the way.  A relaxation visits both, one by one, again and again: an element
/// moves its vertices until it pulls as hard as its length says, and a contact
/// pushes its own until they do not approach each other.  Each visit moves
/// vertices by impulses that add up to zero.  See "XPBD: Position-Based
/// Simulation of Compliant Constrained Dynamics", Macklin et al., 2016.
typedef struct tf_relaxation tf_relaxation;

/// Prepares the relaxation of steps of one length.
/// @param step how long a step takes, in seconds
/// @param[out] relaxation to be freed by tf_relaxation_free; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_relaxation_create(const tf_body *body, double step,
                               tf_relaxation **relaxation);
void tf_relaxation_free(tf_relaxation *relaxation);

/// Begins a step, in which nothing is in the way so far.
/// @param start where the vertices are at the start
/// @param end where the dynamics lead
void tf_relaxation_begin(tf_relaxation *relaxation, const double start[],
                         const double end[]);

/// Adds contacts, with the impulses that they begin with.
/// @param options of which friction and vertex_friction count
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_relaxation_add(tf_relaxation *relaxation,
                            const tf_response_options *options, size_t contacts,
                            const tf_answered_contact contact[]);

/// Relaxes the elements and all contacts that were added.
/// @param[out] end where they allow the vertices to be
void tf_relaxation_run(tf_relaxation *relaxation, double end[]);
