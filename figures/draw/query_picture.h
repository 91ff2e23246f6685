// The picture of a query.
#ifndef FIG_DRAW_QUERY_PICTURE_H
#define FIG_DRAW_QUERY_PICTURE_H

#include "draw/drawing.h"
#include "program/query_file.h"
#include "query/query.h"

enum {
    FIG_QUERY_VERTICES = 4 ///< the most, of both elements
};

/// A query that was answered.
typedef struct fig_answered {
    const tf_query_kind *kind;
    tf_worldline vertex[FIG_QUERY_VERTICES]; ///< first element, then second
    tf_contact contact;
    long number;
} fig_answered;

/// Its drawing, which borrows it: the elements, in space-time or at some times,
/// beside their difference; the answer in a caption, and as numbers.
fig_drawing fig_query_drawing(const fig_answered *answered);

#endif
