//: Declare detection
#pragma once

#include "base/api.h"
#include "base/error.h"
#include "surface/contacts.h"
#include "surface/surface.h"

/// @addtogroup surfaces
/// @{

/// Finds the contacts of a surface in a step: of each vertex with each triangle
/// and of each edge with each edge, in the plane of each vertex with each edge,
/// unless they share a vertex, or a filter leaves them out
/// (tf_surface_set_filter).  Contacts at the start count.
///
/// If the surface is free of intersections at the start (tf_surface_check) and
/// there is no contact, it is free of them at the end, and nothing has passed
/// through anything on the way: see the book, "Four dimensions".  Without the
/// first condition the answer is right for each pair of elements, but says
/// nothing about pairs of triangles that intersect all the time.
///
/// The same rows, bit for bit, for any number of threads, and with an exact
/// arithmetic for any narrow phase.
///
/// @param surface the surface
/// @param motion its vertices at the start and the end of the step
/// @param options what is wanted, and how; NULL: all zero
/// @param[out] found the contacts, lent until the next call for this surface;
///     set only with TF_OK
/// @param[out] error what is wrong, if anything; may be NULL
/// @return TF_OK; TF_BAD_AXES or TF_BAD_COUNT if the motion has other axes than
///     the surface, or another number of vertices; TF_BAD_OPTION;
///     TF_NOT_FINITE; TF_OUT_OF_RANGE; TF_BAD_ENVIRONMENT; TF_OUT_OF_MEMORY; or
///     TF_CANCELLED
TF_API tf_status tf_surface_detect(tf_surface *surface, const tf_motion *motion,
                                   const tf_detect_options *options,
                                   tf_contacts *found, tf_error *error);

/// @}
