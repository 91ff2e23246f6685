//: Declare how errors are set
#pragma once

#include "base/error.h"

/// Each sets an error, unless it is NULL, and returns the status:
/// one that is about nothing in particular,
tf_status tf_fail(tf_error *error, tf_status status);

/// about an element of the caller's list, and one of its vertices,
tf_status tf_fail_element(tf_error *error, tf_status status, tf_subject subject,
                          size_t index, int vertex);

/// TF_BAD_INDEX about such an element, or a query, with the bad index and the
/// number of vertices,
tf_status tf_fail_index(tf_error *error, tf_subject subject, size_t index,
                        int vertex, int vertices);

/// about a vertex at a time,
tf_status tf_fail_vertex(tf_error *error, tf_status status, int vertex,
                         int time);

/// about a vertex of a query at a time,
tf_status tf_fail_query(tf_error *error, tf_status status, size_t index,
                        int vertex, int time);

/// about the vertices of the two elements of a pair, up to a -1 or `most` of
/// them,
tf_status tf_fail_pair(tf_error *error, tf_status status, tf_subject pair,
                       int most, const int vertex[], int time);

/// or TF_BAD_OPTION, of all vertices or of one.  The name and the range are in
/// static storage.
tf_status tf_fail_option(tf_error *error, const char *option, const char *range,
                         double value);
tf_status tf_fail_vertex_option(tf_error *error, const char *option,
                                const char *range, int vertex, double value);
