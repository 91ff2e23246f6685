//: Include what scenes need
#include "simulate/scene.h"

#include <string.h>

//: Add a script to a setup
void tf_scene_setup_add_script(tf_scene_setup *setup, tf_script script)
{
    for (int i = 0; i < script.count && !setup->body.failed; i++)
        setup->body.mass[script.first + i] = 0;
    setup->script[setup->scripts++] = script;
}

//: Find a scene by its name
const tf_scene *tf_scene_named(const tf_scene list[], const char *name)
{
    while (list->name && strcmp(name, list->name) != 0)
        list++;
    return list->name ? list : NULL;
}
