//: Declare detection
#pragma once

#include "base/api.h"
#include "query/contact.h"
#include "query/narrow_phase.h"
#include "surface/parallel.h"
#include "surface/surface.h"

#include <stdbool.h>
#include <stddef.h>

/// @addtogroup surfaces
/// @{

/// Which contacts of a step are wanted.
typedef enum tf_contact_selection {
    TF_ALL_CONTACTS = 0, ///< all of them
    TF_FIRST_CONTACT,    ///< the one with the least `toi_lo`; of several, the
                         ///< first in the order of all
    TF_ANY_CONTACT, ///< none, only whether there is one; ends with the first
                    ///< that is found
} tf_contact_selection;

/// How to detect.  All zero: all contacts, exactly, on the caller's thread.
typedef struct tf_detect_options {
    tf_contact_selection selection;      ///< which contacts are wanted
    const tf_arithmetic *arithmetic;     ///< NULL: tf_exact
    const tf_narrow_phase *narrow_phase; ///< NULL: tf_reference; with
                                         ///< tf_vectorized it is faster
    const tf_parallel *parallel;         ///< NULL: the caller's thread alone
} tf_detect_options;

//: Declare the contacts of a surface
/// Two elements of a surface that touch during a step.
typedef struct tf_surface_contact {
    tf_kind kind;  ///< of what elements
    int vertex[4]; ///< of the first element, then of the second, each in
                   ///< increasing order, and for two edges the one with the
                   ///< lowest vertex first; the last is -1 in the plane
    tf_contact contact; ///< what the query of that kind answers, with the
                        ///< vertices in this order
} tf_surface_contact;

/// What it took to find the contacts of a step: how many candidates there were
/// (with TF_ANY_CONTACT, were tried), and how many of them were decided by
/// what.
typedef struct tf_detect_statistics {
    size_t candidates; ///< pairs that share no vertex and whose boxes overlap
    size_t by_axis;    ///< an axis separates the elements at both ends
    size_t by_filter;  ///< by estimates with a bound on their error
    size_t by_signs;   ///< by the signs of the arithmetic
} tf_detect_statistics;

/// The contacts of a step, and what it took to find them.
typedef struct tf_contacts {
    bool any;     ///< whether there is a contact, or with tf_clamped may be one
    size_t count; ///< how many are listed
    const tf_surface_contact *contact; ///< sorted by kind, then by vertices
    tf_detect_statistics statistics;   ///< what it took
} tf_contacts;

//: Declare how to detect
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
/// @param detection what is wanted, and how; NULL: all zero
/// @param[out] found the contacts, lent until the next call for this surface;
///     valid only with TF_OK
/// @param[out] flaw what is wrong where the status is not TF_OK; may be NULL
/// @return TF_OK; TF_BAD_COUNT if the motion has another number of vertices
///     than the surface; TF_NOT_FINITE; TF_OUT_OF_RANGE; TF_BAD_ENVIRONMENT; or
///     TF_OUT_OF_MEMORY
TF_API tf_status tf_surface_detect(tf_surface *surface, const tf_motion *motion,
                                   const tf_detect_options *detection,
                                   tf_contacts *found, tf_flaw *flaw);

/// @}
