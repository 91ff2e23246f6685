//: Include what scenes as texts need
#include "simulate/scene_text.h"

#include "simulate/simulation.h"

#include <stdlib.h>

//: Write a number of a scene
/// With as many digits as it needs.
static void write_scene_number(FILE *stream, const char *before, double number)
{
    char text[32];
    int digits = 6;
    do
        snprintf(text, sizeof text, "%.*g", digits, number);
    while (strtod(text, NULL) != number && digits++ < 17);
    fprintf(stream, "%s%s", before, text);
}

static void write_line(FILE *stream, const char *key, double number)
{
    write_scene_number(stream, key, number);
    fputc('\n', stream);
}

//: Write the air of a scene
static void write_air(FILE *stream, const tf_air *air)
{
    write_scene_number(stream, "air: {drag: ", air->drag);
    for (int k = 0; k < 3; k++)
        write_scene_number(stream, k == 0 ? ", wind: [" : ", ", air->wind[k]);
    write_scene_number(stream, "], veer: ", air->veer);
    write_scene_number(stream, ", gust: ", air->gust);
    fputs("}\n", stream);
}

//: Write the material of a scene
static void write_material(FILE *stream, const tf_material *material)
{
    write_scene_number(stream, "material: {density: ", material->density);
    write_scene_number(stream, ", stretch: ", material->stretch);
    write_scene_number(stream, ", bend: ", material->bend);
    fputs("}\n", stream);
}

//: Write the resolution of a scene
static void write_resolution(FILE *stream, const tf_scene *scene)
{
    const tf_resolution *resolution = &scene->resolution;
    fprintf(stream, "%s:", scene->kind->option);
    write_scene_number(stream, " ", resolution->usual);
    fprintf(stream, " # %s\n",
            resolution->counts ? resolution->counts : "the length of edges");
}

//: Write a scene
void tf_scene_write(FILE *stream, const tf_scene *scene)
{
    fprintf(stream,
            "# tanglefree simulate %s.yaml -o FOLDER\n"
            "shows: %s\n"
            "shape: %s # built in\n",
            scene->name, scene->shows, scene->name);
    write_resolution(stream, scene);
    fprintf(stream, "steps: %d\n", scene->steps);
    write_line(stream, "step: ", scene->step);
    if (scene->field)
        return;
    write_line(stream, "gravity: ", scene->gravity);
    write_line(stream, "friction: ", scene->friction);
    write_air(stream, &scene->air);
    write_material(stream, &scene->material);
}
