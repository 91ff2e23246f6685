//: Declare how contacts are looked for again
#pragma once

#include "response/step.h"
#include "surface/pairs.h"

#include <stddef.h>

/// The candidates of a step and of all steps that are near it, so that they need
/// not be listed anew when vertices have moved a little.
typedef struct tf_recheck {
    double margin;         ///< how far vertices may move, a length
    bool listed;           ///< whether candidates of this step are listed
    size_t points, edges;  ///< how many candidates there are of each kind
    tf_buffer point, edge; ///< these candidates
    tf_buffer chosen;      ///< the candidates of one kind that are to be tested
    tf_buffer vertex_marks, edge_marks, triangle_marks;
    tf_buffer vertex_boxes, edge_boxes, triangle_boxes; ///< of the step now
} tf_recheck;

//: Declare the new search
/// Finds all contacts of a step, and unmarks all vertices.  Requires that each
/// contact of the last time has a vertex that is marked as changed, and that no
/// unmarked vertex has moved since.  `of` says how to decide.  Pairs of which no
/// vertex moves in the step are not tested, because the start is clear.
tf_status tf_recheck_find(tf_recheck *recheck, tf_surface *surface,
                          tf_step *step, tf_deciding *of,
                          const tf_parallel *parallel, tf_contacts *found,
                          int *rebuilds);

/// Forgets the candidates.  Those of the next step are first listed with at most
/// this margin.
void tf_recheck_begin(tf_recheck *recheck, double margin);

size_t tf_recheck_memory(const tf_recheck *recheck);
void tf_recheck_free(tf_recheck *recheck);
