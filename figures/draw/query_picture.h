// The picture of a query.
#ifndef FIG_DRAW_QUERY_PICTURE_H
#define FIG_DRAW_QUERY_PICTURE_H

#include "draw/drawing.h"
#include "files/query_file.h"
#include "query/query.h"

enum {
    FIG_QUERY_VERTICES = 4, ///< the most, of both elements
    FIG_NAME_TEXT = 64      ///< of a name as mathematics, $ and prime included
};

/// A query that was answered, and how it is to be drawn.  What is zero stands
/// for what is usual.
typedef struct fig_answered {
    const tf_query_kind *kind;
    tf_worldline vertex[FIG_QUERY_VERTICES]; ///< first element, then second
    tf_contact contact;
    long number;
    char *const *names; ///< of the vertices, as mathematics without $
    bool titled;        ///< the page has a title: the query's is left out
    bool still;         ///< a picture shows one time:
    double time;        ///< 0..1
    bool coordinates;   ///< write them down, and name the normal
} fig_answered;

/// Its drawing, which borrows it: the elements, in space-time or at some times,
/// beside their difference; the answer in a caption, and as numbers.
fig_drawing fig_query_drawing(const fig_answered *answered);

#endif
