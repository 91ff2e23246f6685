//: Declare what an error is about
#pragma once

#include "base/api.h"
#include "base/status.h"

#include <stddef.h>

/// @addtogroup trouble
/// @{

/// What an error is about.  Later versions may add to this list.
typedef enum tf_subject {
    TF_NO_SUBJECT = 0,      ///< nothing in particular
    TF_VERTEX,              ///< a vertex of the caller's list
    TF_EDGE,                ///< an edge of the caller's list
    TF_TRIANGLE,            ///< a triangle of the caller's list
    TF_BATCH_QUERY,         ///< a query of the caller's list
    TF_OPTION,              ///< an option
    TF_POINT_EDGE_PAIR,     ///< a vertex, and an edge
    TF_POINT_TRIANGLE_PAIR, ///< a vertex, and a triangle
    TF_EDGE_EDGE_PAIR,      ///< two edges
    TF_EDGE_TRIANGLE_PAIR,  ///< an edge, and a triangle that it passes through
} tf_subject;

/// What is wrong, and where.  The caller allocates it, and a function that
/// takes one sets all of it, also with TF_OK.  Its layout is final.
typedef struct tf_error {
    tf_status status;   ///< what the function returns
    tf_subject subject; ///< what it is about
    size_t index;       ///< the place of an element or a query in the list that
                        ///< the caller gave; 0 if it is about none
    int vertex
        [5];      ///< the vertices that it is about: the bad index, the vertex,
                  ///< the ends of an edge, or those of the first element of a
                  ///< pair and then of the second; -1 where there is none
    int vertices; ///< with TF_BAD_INDEX: how many vertices there are
    int time;     ///< 0 or 1: it is about the start or the end of the step; -1:
                  ///< about neither
    double value; ///< with TF_BAD_OPTION: the value of the option
    const char *option; ///< its name, or NULL; in static storage
    const char *range;  ///< what it must be, as "from 0 to 1", or NULL; in
                        ///< static storage
} tf_error;

/// @}
