//: Include what scenes need
#include "simulate/scene.h"

#include "simulate/falling.h"
#include "simulate/flag.h"
#include "simulate/pulled.h"

#include <string.h>

//: List the scenes
static const tf_scene scenes[] = {
    {
        .name = "sphere",
        .shows = "cloth falls on a ball, which then turns",
        .size_means = "cells along a side of the cloth",
        .size = 35,
        .least = 4,
        .steps = 400,
        .step = 0.01,
        .axes = 3,
        .gravity = 9.81,
        .air = {.drag = 0.3},
        .friction = 0.4,
        .build = tf_build_sphere,
    },
    {
        .name = "stack",
        .shows = "sheets fall on a column, one upon the other",
        .size_means = "cells along a side of a sheet",
        .size = 20,
        .least = 4,
        .steps = 250,
        .step = 0.01,
        .axes = 3,
        .gravity = 9.81,
        .air = {.drag = 0.3},
        .friction = 0.3,
        .build = tf_build_stack,
    },
    {
        .name = "twist",
        .shows =
            "a strip whose ends are turned buckles, and winds about itself",
        .size_means = "cells across the strip",
        .size = 12,
        .least = 2,
        .steps = 750,
        .step = 0.005,
        .axes = 3,
        .air = {.drag = 0.3},
        .friction = 0.2,
        .build = tf_build_twist,
    },
    {
        .name = "knot",
        .shows = "a rope with a knot is pulled tight",
        .size_means = "pairs of sides of the rope",
        .size = 5,
        .least = 2,
        .steps = 550,
        .step = 0.005,
        .axes = 3,
        .air = {.drag = 0.3},
        .friction = 0.2,
        .build = tf_build_knot,
    },
    {
        .name = "curtain",
        .shows = "a sheet is drawn through a ring by its middle",
        .size_means = "cells along a side of the sheet",
        .size = 35,
        .least = 10,
        .steps = 1200,
        .step = 0.0025,
        .axes = 3,
        .gravity = 9.81,
        .air = {.drag = 0.3},
        .build = tf_build_curtain,
    },
    {
        .name = "flag",
        .shows = "a flag is blown about its pole, and flaps",
        .size_means = "cells along the pole",
        .size = 20,
        .least = 4,
        .steps = 800,
        .step = 0.005,
        .axes = 3,
        .gravity = 9.81,
        .air = {.drag = 0.8, .wind = {5, 0, 0}, .veer = 1, .gust = 1.5},
        .friction = 0.2,
        .build = tf_build_flag,
    },
    {
        .name = "plane-chain",
        .shows = "in the plane, a chain falls into a box",
        .size_means = "links of the chain",
        .size = 200,
        .least = 40,
        .steps = 400,
        .step = 0.005,
        .axes = 2,
        .gravity = 9.81,
        .friction = 0.3,
        .build = tf_build_chain,
    },
};

const tf_scene *tf_scenes(int *count)
{
    *count = sizeof scenes / sizeof *scenes;
    return scenes;
}

//: Find a scene by its name
const tf_scene *tf_scene_named(const char *name)
{
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        if (strcmp(name, scenes[i].name) == 0)
            return &scenes[i];
    return NULL;
}

//: Set a stage
void tf_scene_build(const tf_scene *scene, int size, tf_stage *stage)
{
    *stage = (tf_stage){.body.axes = scene->axes};
    scene->build(stage, size);
}
