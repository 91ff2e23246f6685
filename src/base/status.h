//: Declare the statuses
#pragma once

#include "base/api.h"

/// @addtogroup trouble
/// @{

/// What a function returns that can fail because of its input or the machine.
/// Its results are set only with TF_OK.
typedef enum tf_status {
    TF_OK = 0,          ///< success
    TF_NOT_FINITE,      ///< a coordinate is infinite or NaN
    TF_OUT_OF_RANGE,    ///< a coordinate is not one that can be computed with
    TF_BAD_INDEX,       ///< an index repeats, or names no vertex
    TF_BAD_ENVIRONMENT, ///< numbers are not rounded in the default way of IEEE
    TF_NO_ELEMENTS,     ///< a surface has neither triangles nor edges
    TF_BAD_COUNT, ///< a count is negative or too large, or that of vertices is
                  ///< not the surface's
    TF_OUT_OF_MEMORY,     ///< there is not enough memory
    TF_BAD_OPTION,        ///< an option, tolerance or limit is not in its range
    TF_BAD_MASS,          ///< an inverse mass is negative, infinite or NaN
    TF_START_NOT_CLEAR,   ///< a surface intersects itself when the step starts
    TF_EDGE_NOT_MANIFOLD, ///< an edge has triangles that no surface allows
    TF_VERTEX_NOT_MANIFOLD, ///< so has a vertex
    TF_COLLINEAR,           ///< a triangle has no area
    TF_NOT_EMBEDDED,        ///< a surface intersects or touches itself
    TF_BAD_AXES,  ///< neither 2 nor 3 axes, or not those that are needed
    TF_CANCELLED, ///< the caller wanted the call to end
    TF_IN_USE,    ///< memory is in use, so the allocator must stay
} tf_status;

/// One sentence that states what is wrong and how to fix it.  Thread-safe.
/// @param status one of the statuses above, or of a later version
/// @return the sentence, in static storage
TF_API const char *tf_status_message(tf_status status);

/// @}
