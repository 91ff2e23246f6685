//: Declare the coupling
#pragma once

#include "response/resolve.h"
#include "simulate/body.h"

/// A response to contacts that knows of what is elastic.
///
/// It answers a step twice.  The first answer, a draft, finds what is in the way.
/// A relaxation lets those contacts and the elastic elements come to terms, and
/// proposes an end, which the second answer makes clear.  If that leaves
/// something stretched, or has gained energy, they go on for a few rounds.  The
/// answers depend on the step alone.
typedef struct tf_coupling tf_coupling;

/// @param body,resolver borrowed until the coupling is freed
/// @param step how long a step takes, in seconds
/// @param[out] coupling to be freed by tf_coupling_free; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_coupling_create(const tf_body *body, double step,
                             tf_resolver *resolver, tf_coupling **coupling);
void tf_coupling_free(tf_coupling *coupling);

/// What the parts of steps took, in seconds.
typedef struct tf_coupling_times {
    double draft, relaxation, answers;
} tf_coupling_times;

/// Has the parts of all steps from now on timed.
/// @param clock tells the time, in seconds
void tf_coupling_watch(tf_coupling *coupling, double (*clock)(void));

/// Returns what the parts of all steps took that have been timed.
tf_coupling_times tf_coupling_took(const tf_coupling *coupling);

/// The energy with which a step begins.
typedef struct tf_coupling_energy {
    double gravity; ///< downwards, in meters per square second
    double start;   ///< kinetic and tf_body_potential_energy, in joules
} tf_coupling_energy;

/// Resolves a step as tf_step_resolve does; tf_resolver_unpushed of the resolver
/// then decides the velocities.
/// @param[in,out] end in: where the dynamics lead; out: a clear end
/// @param options restitution is none
/// @param energy NULL: it doesn't matter whether any is gained; nor does it if
///     a scripted vertex moves, as that does work
/// @param[out] report what all answers took; whole only with TF_OK
/// @return what tf_step_resolve returns
tf_status tf_coupling_resolve(tf_coupling *coupling, const double start[],
                              double end[], const double inverse_mass[],
                              const tf_response_options *options,
                              const tf_coupling_energy *energy,
                              tf_response_report *report);
