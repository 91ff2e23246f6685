//: Include what scenes need
#include "simulate/scene.h"

#include "simulate/falling.h"

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
        .gravity = 9.81,
        .air = {.drag = 0.3},
        .friction = 0.4,
        .build = tf_build_sphere,
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
