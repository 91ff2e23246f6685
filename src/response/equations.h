//: Declare the equations of a zone
#pragma once

#include "response/zone.h"

#include <stdbool.h>
#include <stddef.h>

/// The constraints of a zone, taken as equations A x = b: impulses are to
/// widen the gap of each constraint by exactly its bound.  Constraints and
/// impulses are scaled such that A, which is symmetric and positive
/// semidefinite, has ones on its diagonal.
typedef struct tf_equations {
    const tf_zone *zone;
    int count;     ///< how many equations, and numbers in a vector
    double *scale; ///< impulse i is scale[i] x[i]
    double *impulse, *displacement;
} tf_equations;

/// Returns how many numbers of a zone's workspace the equations need, together
/// with some vectors.
size_t tf_equations_workspace(int axes, int vertices, int constraints,
                              int vectors);

/// Takes a zone's constraints as equations, and gives each vector a part of the
/// zone's workspace.
tf_equations tf_equations_of(const tf_zone *zone, int vectors,
                             double *vector[]);

//: Declare how to solve equations
/// Sets x to the impulses that the constraints have, and residual to b - A x.
/// Returns the length below which a residual counts as zero.
double tf_equations_start(const tf_equations *equations, double x[],
                          double residual[]);

/// product = A x.
void tf_equations_multiply(const tf_equations *equations, const double x[],
                           double product[]);

/// Stores the impulses in the constraints and applies them.  Friction, for
/// which there is no equation, becomes zero.
void tf_equations_finish(const tf_equations *equations, const double x[]);

//: Declare sums of vectors
/// Returns the inner product of two vectors.
double tf_equations_dot(const tf_equations *equations, const double a[],
                        const double b[]);

/// sum = a + factor b; sum may be a or b.
void tf_equations_add(const tf_equations *equations, const double a[],
                      double factor, const double b[], double sum[]);

//: Declare when a residual is small
/// If A makes a residual shorter by this factor or more, no step makes the
/// residual much shorter: the equations contradict each other, or so nearly
/// that it would take impulses a million times as large to satisfy them.
extern const double tf_equations_weakest;

/// Whether the residual is no longer than `enough`, or its product with A is no
/// longer than tf_equations_weakest times the residual.
bool tf_equations_are_solved(const tf_equations *equations,
                             const double residual[], const double product[],
                             double enough);
