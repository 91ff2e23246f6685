//: Declare the scenes of surfaces that flow
#pragma once

#include "flow/flow.h"
#include "simulate/body.h"

/// A scene in which a surface flows.  It is stirred, and has no masses.
typedef struct tf_flow_scene {
    const char *name;
    const char *shows; ///< what happens in it, in a line
    double edge;       ///< the usual length of an edge
    double most;       ///< the longest that is useful
    double step;       ///< how long one takes
    int steps;         ///< how many there usually are
    bool keep_topology;
    tf_flow_velocity *velocity;
    void (*build)(tf_body *body, double edge);
} tf_flow_scene;

/// All such scenes, and how many there are.
const tf_flow_scene *tf_flow_scenes(int *count);

/// The scene of that name; NULL if there is none.
const tf_flow_scene *tf_flow_scene_named(const char *name);
