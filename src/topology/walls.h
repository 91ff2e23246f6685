//: Declare surgery on a ball
#pragma once

#include "surgery/adaptive_surface.h"
#include "surgery/outcome.h"

enum {
    TF_MOST_WALLS = 6
};

/// The walls of a ball: triangles that go.  They bound it together with those
/// that a surgery adds instead.
typedef struct tf_walls {
    int count;
    tf_added_triangle wall[TF_MOST_WALLS];
} tf_walls;

void tf_walls_add(tf_walls *walls, const tf_adaptive_surface *surface, int a,
                  int b, int c);

/// Tries a surgery, or its last stage, that replaces the walls of a ball: as
/// tf_surgery_try does, and whether there is a ball, and it holds nothing.
tf_outcome tf_walls_try(const tf_walls *walls, tf_adaptive_surface *surface);
