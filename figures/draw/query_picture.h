// The picture of a query.
#ifndef TF_DRAW_QUERY_PICTURE_H
#define TF_DRAW_QUERY_PICTURE_H

#include "draw/drawing.h"
#include "program/query_file.h"
#include "query/contact.h"

/// A query that was answered.
typedef struct tf_answered {
    const tf_query_kind *kind;
    tf_question question;
    tf_contact contact;
    long number;
} tf_answered;

/// Its drawing, which borrows it: the elements, in space-time or at some times,
/// beside their difference; the answer in a caption, and as numbers.
tf_drawing tf_query_drawing(const tf_answered *answered);

#endif
