//: Declare how to detect
#pragma once

#include "base/api.h"
#include "surface/contacts.h"
#include "surface/parallel.h"
#include "surface/surface.h"

/// @addtogroup surfaces
/// @{

/// How to detect.  All zero: all contacts, exactly, on the caller's thread.
typedef struct tf_detect_options {
    tf_contact_selection selection;      ///< which contacts are wanted
    const tf_arithmetic *arithmetic;     ///< NULL: tf_exact
    const tf_narrow_phase *narrow_phase; ///< NULL: tf_reference; with
                                         ///< tf_vectorized it is faster
    const tf_parallel *parallel;         ///< NULL: the caller's thread alone
} tf_detect_options;

//: Declare detection
/// Finds the contacts of a surface in a step: of each vertex with each triangle
/// and of each edge with each edge, in the plane of each vertex with each edge,
/// unless they share a vertex.  Contacts at the start count.
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
///     valid only with TF_OK
/// @param[out] flaw what is wrong where the status is not TF_OK; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the motion has another number of vertices
///     than the surface; TF_NOT_FINITE; TF_OUT_OF_RANGE; TF_BAD_ENVIRONMENT; or
///     TF_OUT_OF_MEMORY
TF_API tf_status tf_surface_detect(tf_surface *surface, const tf_motion *motion,
                                   const tf_detect_options *options,
                                   tf_contacts *found, tf_flaw *flaw);

/// @}
