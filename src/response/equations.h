//: Declare the equations of a zone
#pragma once

#include "response/zone.h"

#include <stdbool.h>
#include <stddef.h>

/// The rows of a zone, taken for equations A x = b: impulses shall part the
/// elements of each contact just to its bound.  Each is scaled, as is its
/// impulse, so that A, symmetric and not negative, has ones on its diagonal.
typedef struct tf_equations {
    const tf_zone *zone;
    int count;     ///< of equations, and of numbers in a vector
    double *scale; ///< impulse i is scale[i] x[i]
    double *impulse, *displacement;
} tf_equations;

/// The numbers of the zone's room that equations need with some vectors.
size_t tf_equations_room(int axes, int vertices, int rows, int vectors);

/// Takes the zone's room, and gives each vector a part of it.
tf_equations tf_equations_of(const tf_zone *zone, int vectors,
                             double *vector[]);

//: Declare how to solve equations
/// Sets x to the impulses that the rows have, and residual to b - A x.  Returns
/// the length of a residual that is as good as none.
double tf_equations_start(const tf_equations *equations, double x[],
                          double residual[]);

/// product = A x.
void tf_equations_multiply(const tf_equations *equations, const double x[],
                           double product[]);

/// Leaves the impulses in the rows and applies them.  Friction, for which there
/// is no equation, becomes zero.
void tf_equations_finish(const tf_equations *equations, const double x[]);

//: Declare sums of vectors
/// The inner product of two vectors.
double tf_equations_dot(const tf_equations *equations, const double a[],
                        const double b[]);

/// sum = a + factor b; sum may be a or b.
void tf_equations_add(const tf_equations *equations, const double a[],
                      double factor, const double b[], double sum[]);

//: Declare when a residual is small
/// What is left of a residual that no step makes much shorter: where A takes it
/// to a vector so much shorter, equations contradict each other, or so nearly
/// that it would take a million times the impulses to agree.
extern const double tf_equations_weakest;

/// Whether the residual is no longer than `enough`, or its product with A so
/// much shorter than it.
bool tf_equations_are_solved(const tf_equations *equations,
                             const double residual[], const double product[],
                             double enough);
