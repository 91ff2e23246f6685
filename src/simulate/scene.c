//: Include what scenes need
#include "simulate/scene.h"

#include <string.h>

//: Add a script to a stage
void tf_stage_add_script(tf_stage *stage, tf_script script)
{
    for (int i = 0; i < script.count && !stage->body.failed; i++)
        stage->body.mass[script.first + i] = 0;
    stage->script[stage->scripts++] = script;
}

//: Find a scene by its name
const tf_scene *tf_scene_named(const tf_scene list[], const char *name)
{
    while (list->name && strcmp(name, list->name) != 0)
        list++;
    return list->name ? list : NULL;
}
