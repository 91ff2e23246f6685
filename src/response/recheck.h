//: Declare how contacts are looked for again
#pragma once

#include "response/step.h"
#include "surface/pairs.h"

#include <stddef.h>

/// The candidates of a step and of all that are near it, so that they need not
/// be found anew when vertices have moved a little.
typedef struct tf_recheck {
    double margin;         ///< by which vertices may move, a length
    bool listed;           ///< whether there are candidates of this step
    size_t points, edges;  ///< how many candidates of each kind
    tf_buffer point, edge; ///< these candidates
    tf_buffer chosen;      ///< those of one kind that are tested
    tf_buffer vertex_marks, edge_marks, triangle_marks;
    tf_buffer vertex_boxes, edge_boxes, triangle_boxes; ///< of the step now
} tf_recheck;

//: Declare the new search
/// Finds all contacts of a step, given that all that there were the last time
/// are of vertices that are marked as changed, and that only such vertices have
/// moved since; then unmarks them.  `of` says how.  Pairs of vertices that all
/// stay where they were are not looked at: the start is clear.
tf_status tf_recheck_find(tf_recheck *recheck, tf_surface *surface,
                          tf_step *step, tf_deciding *of,
                          const tf_parallel *parallel, tf_contacts *found,
                          int *rebuilds);

/// Forgets the candidates; those of the next step are listed with at most this
/// margin at first.
void tf_recheck_begin(tf_recheck *recheck, double margin);

size_t tf_recheck_memory(const tf_recheck *recheck);
void tf_recheck_free(tf_recheck *recheck);
