// Queries about linear motion: what the library's methods answer, and what is
// true.
#ifndef SUPPORT_LINEAR_METHODS_H
#define SUPPORT_LINEAR_METHODS_H

#include "linear/rigid_motion.h"
#include "linear/tolerances.h"
#include "query/contact.h"
#include "query/motion.h"
#include "support/queries.h"

#include <stdbool.h>

/// The quadratic's or cubic's status about the vertices of the indices
/// vertex[], those of the first element first.
tf_status cubic_query(query_kind kind, const tf_tolerances *tolerances,
                      const tf_motion *motion, const int vertex[],
                      tf_contact *contact);

/// The same of additive advancement.
tf_status additive_query(query_kind kind, const tf_advance_limits *limits,
                         const tf_motion *motion, const int vertex[],
                         tf_contact *contact, tf_advancement *advancement);

/// The answer of the quadratic or cubic to a query, with a tolerance for the
/// distance.
tf_contact cubic_answer(const query *q, double tolerance);

/// The answer of additive advancement.
tf_contact additive_answer(const query *q, const tf_advance_limits *limits,
                           tf_advancement *advancement);

/// Whether the elements meet in linear motion, and when.
bool linear_query_truth(const query *q, double *toi);

/// Fail the test, showing the query, unless the contact is one: finite numbers
/// in their ranges, or zeros.
void expect_contact(const query *q, const tf_contact *contact);

/// Fail the test, showing the query, unless the quadratic or cubic without
/// tolerance answers it rightly.
void expect_linear_truth(const query *q);

#endif
