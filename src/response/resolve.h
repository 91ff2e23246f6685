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
/// This is exact.  So the end is free of intersections, it is a legal start for
/// the next step, what was inside a closed surface is still inside, and loops
/// that were linked still are.  The function always returns, and there is such
/// an end for every proposal.  A step without contacts comes back bit for bit,
/// and in any other step so does every vertex that no level has moved.  Only a
/// `draft`, see below, promises less.
///
/// Vertices of inverse mass 0 are scripted.  Pairs whose vertices all are
/// scripted are left out: they may meet, they may be tangled at the start, and
/// nothing is done about it.  tf_surface_set_filter says what remains if pairs
/// are left out: at the end, an edge and a triangle may only intersect if no
/// more than one of their five vertices is free, and in the plane two edges if
/// no more than one of their four is.
///
/// With `zone`, pairs of which all triangles at both elements are in one zone
/// are left out: they may meet, and may be tangled at the start.  Two triangles
/// without a common vertex that are not both in one zone start and end apart,
/// as do an edge of no triangle and a triangle, and in the plane two edges.
///
/// Scripted vertices end where they are proposed to, bit for bit, unless
/// something free stops them that cannot give way, such as a sheet upon which
/// two plates close.  Those that are stopped together go the same fraction of
/// their way, which bisection down to 1/128 finds by resolving shortened steps:
/// a fraction that they can go, though larger ones may do as well.  If the
/// failsafe is needed around them even while they rest, they stay at their
/// start.  Vertices that edges connect with them, through scripted ones, are
/// held back as well, but along each edge the fractions may differ by how much
/// the script stretches it, divided by the longer displacement: a limb that
/// moves or turns as a whole stops as a whole.  tf_resolver_followed tells how
/// far each went.
///
/// With `substeps` the step is taken in parts, one after another.  Each part
/// is clear as told above, and starts where the last one has ended; so the end
/// is free of intersections.  But the step as a whole, in which all vertices go
/// straight from their start to their end, need not be clear.  In each part a
/// vertex is proposed to move by its displacement in the step divided by their
/// number or, if there is restitution, by what the last part has left it of
/// that; a scripted one to go on along its script.  Bodies meet when they are
/// near each other, not a step's length before, so that a long step throws
/// fewer vertices out of their way, and takes more time.
///
/// With a `thickness`, a pair that is apart by that distance or more at the start
/// is so at the end, too, exactly; in substeps at the end of each.  Pairs that
/// start nearer only don't meet, and nor do pairs on the way.
///
/// A `draft` is for callers that change their proposal when they know the
/// contacts.  It is answered by impulses and zones alone, and of the pairs only
/// those are looked at that the proposal brings near each other.  So its end need
/// not be clear, unless there were no contacts and it was no answer `again`; a
/// thickness may be missed, and nothing is held back.  An answer `again` from
/// the same start, bit for bit, with the same masses, zones and filter, to a
/// draft or to another such answer, looks at the pairs of that one first, which
/// is faster.  What it promises is what any answer does, but where vertices end
/// may depend on the answers before.
///
/// Time and memory grow about in proportion to the contacts of all rounds.  These
/// may be many: n edges that are pushed through n others have n^2.  For n = 1000
/// such a step takes a few seconds and 0.7 GB.
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
