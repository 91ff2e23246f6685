//: Declare the contacts of a surface
#pragma once

#include "base/api.h"
#include "base/progress.h"
#include "query/contact.h"
#include "query/narrow_phase.h"
#include "surface/parallel.h"

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

/// Two elements of a surface that touch during a step.
typedef struct tf_surface_contact {
    tf_kind kind;  ///< of what elements
    int vertex[4]; ///< of the first element, then of the second, each in
                   ///< increasing order, and for two edges the one with the
                   ///< lowest vertex first; the last is -1 in the plane
    tf_contact contact; ///< what the query of that kind answers, with the
                        ///< vertices in this order
} tf_surface_contact;

//: Declare what it took to find contacts
/// What it took to find the contacts of a step: how many candidates there were
/// (with TF_ANY_CONTACT, were tried), and how many of them were decided by what.
typedef struct tf_detect_statistics {
    size_t candidates;  ///< pairs that share no vertex, whose boxes are not
                        ///< apart, and that no filter leaves out
    size_t by_axis;     ///< an axis separates the elements at both ends
    size_t by_filter;   ///< by estimates with a bound on their error
    size_t by_signs;    ///< by the signs of the arithmetic
    size_t reserved[4]; ///< 0; for the counts of later versions
} tf_detect_statistics;

/// The contacts of a step, and what it took to find them.
typedef struct tf_contacts {
    bool any;     ///< whether there is a contact, or with tf_clamped may be one
    size_t count; ///< how many are listed
    const tf_surface_contact *contact; ///< sorted by kind, then by vertices
    tf_detect_statistics statistics;   ///< what it took
} tf_contacts;

//: Declare how to detect
/// How to detect.  All zero: all contacts, exactly, on the caller's thread.
typedef struct tf_detect_options {
    size_t size; ///< sizeof(tf_detect_options); 0: that of version 1.0
    tf_contact_selection selection;      ///< which contacts are wanted
    const tf_arithmetic *arithmetic;     ///< NULL: tf_exact
    const tf_narrow_phase *narrow_phase; ///< NULL: tf_vectorized
    const tf_parallel *parallel;         ///< NULL: the caller's thread alone
    tf_progress *progress;               ///< NULL: nothing is told
    void *context;                       ///< passed on to `progress`

    /// The zone in which each triangle of tf_surface_triangles is, or in the
    /// plane each edge of tf_surface_edges: a number from 0, or -1: none.  A
    /// pair of elements is left out if all triangles at both of them are in the
    /// same zone; in the plane, all edges.  Edges and vertices of no triangle
    /// are in no zone, nor are the ends of such edges.  NULL: no pair is left
    /// out.  See tf_surface_zones.
    const int *zone;
} tf_detect_options;

/// @}
