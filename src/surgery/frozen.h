//: Declare how defects are left alone
#pragma once

#include "base/error.h"
#include "surgery/adaptive_surface.h"

/// Orients the triangles of a surface alike, finds all of its defects, and
/// freezes their vertices; lists the defects in what the surface lends.  Sets an
/// error to what it returns: TF_OK, TF_OUT_OF_MEMORY, or another status of the
/// check of surfaces.
tf_status tf_leave_defects(tf_adaptive_surface *surface, const tf_mesh *mesh,
                           tf_error *error);

/// Whether nothing of a surface is frozen, for what cannot leave it alone.  Sets
/// an error to what it returns: TF_OK, or the first of its defects, as it was
/// made.
tf_status tf_check_freedom(const tf_adaptive_surface *surface, tf_error *error);
