// What the answers to a query have in common, whatever the truth: quick to try,
// without an oracle.
#ifndef SUPPORT_INVARIANTS_H
#define SUPPORT_INVARIANTS_H

#include "query/contact.h"
#include "support/queries.h"

/// What is wrong with the answers to a query of numbered vertices whose exact
/// contact is `exact`; NULL if nothing is.  Static storage.
typedef const char *invariant(generator *random, const query *q,
                              const tf_contact *exact);

/// The exact contact in itself: it is certain, at a time within the step that
/// is known to 2^-50, and at convex combinations of the vertices.
invariant contact_fault;

/// Time reversed: the verdict is the same.  The first contact of one direction
/// is the last of the other, so that it is not after the other's first.  Each
/// pair of simplices meets in both directions or in neither; it is classified
/// alike, and the times mirror each other if there is one common point at most.
/// The first of the pairs has the contact.
invariant reversal_fault;

/// A change, picked at random, of the axes, of the direction of one axis, of the
/// unit of length, of the order of the elements or of the vertices in a list:
/// the contact changes as it has to.
invariant change_fault;

/// All these changes in one scene: a batch of verdicts without contacts finds
/// the same for all.
invariant batch_fault;

/// Integers, as far as they hold the coordinates: verdict and classification
/// are the same, at a time that may be the same.
invariant integers_fault;

/// Clamped arithmetic: the verdict is the same or there is none, at a time that
/// may be the same.
invariant clamped_fault;

#endif
