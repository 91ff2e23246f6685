// Surfaces of meshes.
#ifndef SUPPORT_SURFACE_OF_H
#define SUPPORT_SURFACE_OF_H

#include "surface/surface.h"

/// The surface of a mesh that must be good.
tf_surface *surface_of(const tf_mesh *mesh);

#endif
