//: Declare how to resolve a step
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "response/options.h"
#include "response/resolver.h"

/// @addtogroup response
/// @{

/// Changes the end of a step such that no two elements meet on the way.
///
/// After TF_OK no two elements that share no vertex touch at any time of the
/// stored step, its start and its end included, where the pairs of elements are
/// a vertex and a triangle or two edges or, in the plane, a vertex and an edge.
/// This is exact; tf_surface_set_filter says what remains if pairs are left out.
/// So the end is free of intersections, it is a legal start for
/// the next step, and nothing has passed through anything.  The function always
/// returns, and there is such an end for every proposal.  A step without
/// contacts comes back bit for bit, and in any other step so does every vertex
/// that no level has moved.
///
/// Vertices of inverse mass 0 are scripted: they end where they are proposed
/// to, bit for bit, unless the failsafe has to hold them back, for example when
/// two plates close upon a sheet.  The report counts those that it held back.
///
/// Time and memory grow about in proportion to the contacts of all rounds.  These
/// may be many: n edges that are pushed through n others have n^2.  For n = 1000
/// such a step takes some ten seconds and 0.7 GB.
///
/// Pairs that start too near are pushed apart, and such a push is no motion: take
/// velocities from tf_resolver_unpushed, not from `end`, or bodies at rest begin
/// to hop.
///
/// The result is the same, to the last bit, for any number of threads.
/// tf_resolver_contacts, tf_resolver_vertices and tf_resolver_pushes tell what
/// was done.
///
/// @param resolver the resolver of the surface
/// @param vertices how many vertices have positions
/// @param start where they start, `axes` coordinates each; free of
///     intersections (tf_surface_check) and of touching
/// @param[in,out] end in: where any simulation proposes that they end; out,
///     only with TF_OK: where they end
/// @param inverse_mass of each vertex, 0 or more; 0: the vertex is scripted;
///     NULL: 1 for all
/// @param options how to respond; NULL: all zero
/// @param[out] report what it took, lent until the next call for this resolver;
///     set only with TF_OK; may be NULL
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the surface has another number of vertices;
///     TF_NOT_FINITE; TF_BAD_MASS; TF_BAD_OPTION if an option is not in its
///     range, and then `error` has the vertex if it is an option of vertices;
///     TF_START_NOT_CLEAR; TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or TF_CANCELLED,
///     and then the resolver and its surface are as good as new
TF_API tf_status tf_step_resolve(tf_resolver *resolver, int vertices,
                                 const double start[], double end[],
                                 const double inverse_mass[],
                                 const tf_response_options *options,
                                 const tf_response_report **report,
                                 tf_error *error);

/// @}
