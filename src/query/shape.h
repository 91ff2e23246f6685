//: Declare the shape of a query
#pragma once

#include "query/kind.h"

/// How many axes a scene has, and how many vertices the two elements have.
typedef struct tf_query_shape {
    int axes, vertices, others;
} tf_query_shape;

/// The shape of a kind of queries; NULL: there is no such kind.
const tf_query_shape *tf_query_shape_of(tf_kind kind);
