//: Declare the outcomes of an operation
#pragma once

#include "base/api.h"

/// @addtogroup adaptive
/// @{

/// What became of an operation on a surface.  Each is all or nothing: one that
/// is refused has changed nothing.
///
/// A split, a move, a collapse or a flip that is done is a continuous motion of
/// the surface, in which it never touches itself: so it stays embedded, no part
/// of it passes through another, and none is turned inside out.  This is exact;
/// what might not be such a motion is refused.
typedef enum tf_outcome {
    TF_NO_OUTCOME = 0,  ///< it failed, with a status other than TF_OK
    TF_COMMITTED,       ///< it is done
    TF_IMPOSSIBLE,      ///< no surface would be left, there is no such element,
                        ///< or it is left alone (tf_adaptive_create_around)
    TF_FLATTENED,       ///< a new triangle would be collinear
    TF_OVERLAPPED,      ///< a new triangle would touch another one
    TF_PASSED_VERTEX,   ///< a vertex would be swept over
    TF_PASSED_EDGE,     ///< an edge would be swept over
    TF_PASSED_TRIANGLE, ///< the vertex that moves would pass through a triangle
    TF_OUTCOMES = 16    ///< room for those of later versions
} tf_outcome;

/// @}
