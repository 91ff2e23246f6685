//: Declare the answers to many queries
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "query/contact.h"
#include "query/narrow_phase.h"
#include "surface/parallel.h"

/// @addtogroup queries
/// @{

/// Whether, when and how the two elements of each of many queries first meet.
/// Each contact is the one that tf_point_edge, tf_point_triangle or tf_edge_edge
/// finds, bit for bit, and is found sooner: in space most queries whose elements
/// stay apart are decided by vector instructions.  Allocates no memory.
///
/// An error names the first bad query by its place in the list, the same for any
/// number of workers: with TF_BAD_INDEX also the index, with TF_NOT_FINITE and
/// TF_OUT_OF_RANGE the vertex and the end of the step.
///
/// @param arithmetic what finds the signs; NULL: tf_exact
/// @param queries the queries; if there are none, it needs no motion
/// @param parallel the threads to use; NULL: the caller's alone
/// @param[out] contact the answers, one for each query; valid only with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK, also without queries; TF_BAD_OPTION if there is no such kind or
///     number of workers; TF_BAD_COUNT if there are more queries than memory
///     could hold, or no list of them; TF_BAD_AXES or TF_BAD_COUNT about the
///     motion; TF_BAD_INDEX; TF_NOT_FINITE; TF_OUT_OF_RANGE; or
///     TF_BAD_ENVIRONMENT
TF_API tf_status tf_query_batch(const tf_arithmetic *arithmetic,
                                const tf_queries *queries,
                                const tf_parallel *parallel,
                                tf_contact contact[], tf_error *error);

/// @}
