//: Declare the cache of pairs
#pragma once

#include "surface/pairs.h"

/// The pairs of a surface that may come into contact as the ends of a step
/// change, how far each may move until it must be checked again, and how far all
/// elements have moved.  All zero: none yet.
typedef struct tf_pair_cache {
    int workers;         ///< how many have kept pairs
    tf_buffer kept;      ///< the pairs of each of them
    tf_buffer movements; ///< of vertices, edges and triangles
    tf_buffer checked;   ///< the last checked ends
} tf_pair_cache;

size_t tf_pair_cache_memory(const tf_pair_cache *cache);
void tf_pair_cache_free(tf_pair_cache *cache);

//: Declare how contacts are searched
/// What is searched for contacts, and how.  Which pairs are in contact is exact;
/// what describes a contact is estimated where it can be.
typedef struct tf_contact_search {
    tf_surface *surface;
    const tf_motion *motion; ///< always with the same start; its end may change
    const tf_narrow_phase *narrow_phase;
    tf_contact_estimator *estimate;
    const tf_parallel *parallel;
} tf_contact_search;

/// Finds all contacts of a motion from the beginning, and puts all pairs of
/// elements whose swept boxes overlap into the cache, in place of those that it
/// has.  Returns what tf_surface_move does, with the reason in `error`, or what
/// tf_pairs_find does.
tf_status tf_pair_cache_build(tf_pair_cache *cache,
                              const tf_contact_search *search,
                              tf_contacts *found, tf_error *error);

/// Finds the contacts among the pairs of the cache.  Checks only pairs that were
/// in contact and those that have moved so far that they could be now.  Returns
/// TF_OK, TF_OUT_OF_MEMORY, TF_CANCELLED, or what the narrow phase does.
tf_status tf_pair_cache_update(tf_pair_cache *cache,
                               const tf_contact_search *search,
                               tf_contacts *found);

/// Whether the ends of a surface's motion are the last checked ones.
bool tf_pair_cache_is_current(const tf_pair_cache *cache,
                              const tf_contact_search *search);
