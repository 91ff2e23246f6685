// Judge the library's answers to queries by the oracle's.
#ifndef SUPPORT_JUDGE_H
#define SUPPORT_JUDGE_H

#include "query/query.h"
#include "support/oracle.h"
#include "support/queries.h"

/// What is true of a query.
typedef struct truth {
    bool hit;
    mpq_t toi; ///< where there is a hit
} truth;

void truth_init(truth *known);
void truth_clear(truth *known);

/// Ask the oracle.
void truth_find(const query *q, truth *known);

/// Ask an arithmetic that knows every sign.  What is wrong with its answer, but
/// for the contact's geometry; NULL if nothing is.  Static storage.
const char *exact_fault(const query *q, const tf_arithmetic *arithmetic,
                        const truth *known, tf_contact *contact);

/// The same for an arithmetic that does not know every sign: it must not claim
/// what is not so.
const char *sound_fault(const query *q, const tf_arithmetic *arithmetic,
                        const truth *known, tf_contact *contact);

/// What is wrong with the barycentric coordinates, the normal, the velocity or
/// the classification of a contact of a query whose coordinates are small
/// integers.
const char *geometry_fault(const query *q, const tf_contact *contact);

/// Fail the test, showing the query, unless `fault` is NULL.
void expect_no_fault(const char *fault, const query *q);

/// Ask an arithmetic that takes the query's coordinates.
tf_contact ask(const tf_arithmetic *arithmetic, const query *q);

/// What is wrong with the perturbed answer to a query with numbered vertices,
/// as far as exact signs tell: it is generic, and the exact one unless a
/// contact touches; NULL if nothing is.
const char *perturbed_fault(const query *q);

/// Judge a query by exact and clamped arithmetic.
void expect_truth(const query *q, const truth *known);

#endif
