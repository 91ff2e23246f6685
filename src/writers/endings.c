//: Include what endings need
#define _GNU_SOURCE // strncasecmp
#include "writers/endings.h"

#include "files/gzip_stream.h"

#include <string.h>

//: Compare the ending of a name
/// The length of a name without .gz.
static size_t length_before_gz(const char *path)
{
    return strlen(path) - (tf_is_gzip_name(path) ? 3 : 0);
}

bool tf_ends_in(const char *path, const char *ending)
{
    size_t length = length_before_gz(path), own = strlen(ending);
    return length >= own && strncasecmp(path + length - own, ending, own) == 0;
}

//: Name the formats
static const char *const format_names[] = {
    [TF_OBJ] = "OBJ",
    [TF_PLY_TEXT] = "PLY",
    [TF_PLY_LITTLE_ENDIAN] = "PLY",
    [TF_PLY_BIG_ENDIAN] = "PLY",
    [TF_STL_TEXT] = "STL",
    [TF_STL_BINARY] = "STL",
    [TF_OFF] = "OFF",
    [TF_MSH] = "Gmsh's .msh",
    [TF_VTP] = "VTK's .vtp",
};

const char *tf_mesh_format_name(tf_mesh_format format)
{
    return format_names[format];
}

//: Choose the format of a file
/// An ending stands for the formats of a name.
typedef struct ending {
    const char *text;
    tf_mesh_format format; ///< if the usual one has another name
} ending;

static const ending endings[] = {
    {".obj", TF_OBJ},        {".ply", TF_PLY_LITTLE_ENDIAN},
    {".stl", TF_STL_BINARY}, {".off", TF_OFF},
    {".msh", TF_MSH},        {".vtp", TF_VTP},
    {".pvd", TF_VTP},
};

tf_mesh_format tf_mesh_format_of(const char *path, tf_mesh_format usual)
{
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        if (tf_ends_in(path, endings[i].text))
            return strcmp(format_names[usual],
                          format_names[endings[i].format]) == 0
                       ? usual
                       : endings[i].format;
    return usual;
}

const char *tf_mesh_ending(tf_mesh_format format)
{
    size_t i = 0;
    while (strcmp(format_names[endings[i].format], format_names[format]) != 0)
        i++;
    return endings[i].text;
}

//: Find the ending of a mesh
const char *tf_any_mesh_ending(const char *path)
{
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        if (tf_ends_in(path, endings[i].text))
            return endings[i].text;
    return tf_unwritten_ending(path);
}

const char *tf_unwritten_ending(const char *path)
{
    static const char *const others[] = {
        ".gltf", ".glb",  ".fbx",  ".dae", ".abc",   ".usd",  ".usda", ".usdc",
        ".usdz", ".vtk",  ".vtu",  ".3ds", ".3mf",   ".amf",  ".step", ".stp",
        ".iges", ".igs",  ".x3d",  ".wrl", ".blend", ".mesh", ".poly", ".xyz",
        ".pcd",  ".geo",  ".bgeo", ".mdd", ".pc2",   ".pvd",  ".c4d",  ".ma",
        ".mb",   ".node", ".ele",  ".inp"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (tf_ends_in(path, others[i]))
            return others[i];
    return NULL;
}
