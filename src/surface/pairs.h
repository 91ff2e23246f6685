//: Declare how pairs are decided
#pragma once

#include "surface/contacts.h"
#include "surface/surface_memory.h"

#include <stdbool.h>

/// Estimates a contact of two elements that meet; false, and no contact, if it
/// cannot.  The vertices are in the order of a tf_surface_contact.
typedef bool tf_contact_estimator(tf_kind kind, const tf_motion *motion,
                                  const int vertex[4], tf_contact *contact);

/// How pairs of elements are decided: a job of the surface's workers.
typedef struct tf_pair_job {
    const tf_surface *surface;
    const tf_motion *motion;
    const tf_arithmetic *arithmetic;
    const tf_narrow_phase *narrow_phase;
    tf_contact_estimator *estimate; ///< describes contacts where it can; NULL:
                                    ///< the arithmetic describes all of them
    tf_contact_selection selection;
    bool measures; ///< whether the workers note the clearances of pairs
    tf_kind kind;  ///< of the pairs that come next

    /// Keeps the pairs of a batch that a worker has decided; false if there is
    /// no memory.  NULL: none are kept.
    bool (*keep)(void *keeper, const tf_worker *worker, int count,
                 const tf_candidate pair[]);
    void *keeper; ///< passed on to `keep`
} tf_pair_job;

//: Declare the decision of pairs
/// Readies the surface's workers for deciding pairs.  False if there is no
/// memory.
bool tf_pairs_begin(tf_surface *surface, const tf_parallel *parallel,
                    const tf_pair_job *job);

/// Decides pairs, of at most TF_BATCH, and adds those in contact to what the
/// worker around the sink has found: a tf_pair_sink's function.
bool tf_pairs_take(tf_pair_sink *sink, int count, const tf_candidate pair[]);

/// Lists what all workers have found, lent by the surface, and adds up what it
/// took; `found` was all zero.  False if there is no memory, or if the caller has
/// cancelled.
bool tf_pairs_gather(tf_surface *surface, tf_contact_selection selection,
                     tf_contacts *found);

/// Finds all pairs of elements in contact that the trees of the surface yield,
/// and sets `found` if it succeeds.  Returns TF_OK, TF_OUT_OF_MEMORY,
/// TF_CANCELLED, or what a decision returns.
tf_status tf_pairs_find(tf_surface *surface, tf_pair_job *job,
                        const tf_parallel *parallel, tf_contacts *found);

/// Adds what one search took to what all took.
void tf_detect_statistics_add(tf_detect_statistics *all,
                              const tf_detect_statistics *own);
