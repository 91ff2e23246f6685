//: Declare the dynamics
#pragma once

#include "base/status.h"
#include "simulate/body.h"

/// How a body moves if nothing is in its way, by implicit steps of one length.
///
/// A step ends where the sum of the elastic energy and of mass / (2 step^2)
/// times the square of the distance from where inertia leads is least.  This is
/// projective dynamics: each iteration first finds the target sum of each
/// element by itself, and then the positions that fit those sums best, by
/// equations whose matrix is always the same.  It is factorized once.
/// See "Projective Dynamics: Fusing Constraint Projections for Fast Simulation",
/// Bouaziz et al., 2014, and "Fast Simulation of Mass-Spring Systems", Liu et
/// al., 2013.
typedef struct tf_dynamics tf_dynamics;

/// Factorizes the matrix of a body.
/// @param body borrowed until the dynamics are freed
/// @param step how long a step takes, in seconds
/// @param[out] dynamics to be freed by tf_dynamics_free; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_dynamics_create(const tf_body *body, double step,
                             tf_dynamics **dynamics);
void tf_dynamics_free(tf_dynamics *dynamics);

/// Moves the vertices that are not scripted to the end of a step.
/// @param[in,out] end in: where inertia and forces alone would lead, and where
///     scripted vertices are to be; out: the end of the step
/// @param iterations 1 or more; the more, the stiffer
/// @return TF_OK or TF_OUT_OF_MEMORY
tf_status tf_dynamics_step(tf_dynamics *dynamics, double end[], int iterations);
