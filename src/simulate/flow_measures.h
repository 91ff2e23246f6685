//: Declare what can be measured on a surface
#pragma once

#include "surgery/adaptive.h"

#include <stdbool.h>

typedef struct tf_flow_measures {
    int vertices, triangles, components;
    int genus;      ///< the sum of those of all components: handles
    int boundaries; ///< loops of the boundary
    double area;
    double volume; ///< that is enclosed; 0 if there are boundaries
} tf_flow_measures;

/// Measures a surface without gaps.  False if there is no memory.
bool tf_flow_measure(const tf_adaptive_surface *surface,
                     tf_flow_measures *measures);
