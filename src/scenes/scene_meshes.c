//: Include what the meshes of a scene need
#define _GNU_SOURCE // strndup, strcasecmp
#include "scenes/scene_meshes.h"

#include "files/masses.h"

#include <stdlib.h>
#include <string.h>

//: Name the roles
static const tf_role moving = TF_MOVING, scripted = TF_SCRIPTED,
                     fixed = TF_FIXED;

const tf_choice tf_roles[] = {
    {"moving", &moving},
    {"scripted", &scripted},
    {"fixed", &fixed},
    {NULL, NULL},
};

//: Add and free the meshes of a scene
tf_scene_mesh *tf_scene_meshes_add(tf_scene_meshes *meshes)
{
    size_t count = (size_t)meshes->count + 1;
    tf_scene_mesh *moved = realloc(meshes->mesh, count * sizeof *moved);
    if (!moved)
        return NULL;
    meshes->mesh = moved;
    moved[count - 1] =
        (tf_scene_mesh){.friction = -1, .line = -1, .material = {-1, -1, -1}};
    meshes->count++;
    return &moved[count - 1];
}

void tf_scene_meshes_free(tf_scene_meshes *meshes)
{
    for (int i = 0; i < meshes->count; i++) {
        free(meshes->mesh[i].name);
        free(meshes->mesh[i].group);
        free(meshes->mesh[i].pinned);
        tf_frame_names_free(&meshes->mesh[i].pinned_in);
        tf_frame_names_free(&meshes->mesh[i].frames);
    }
    free(meshes->mesh);
    free(meshes->physics.shows);
    free(meshes->physics.shape);
    *meshes = (tf_scene_meshes){0};
}

//: Name a mesh by its file
/// How much of a name is before its ending, and that of a compressed file.
static size_t without_ending(const char *name)
{
    size_t length = strlen(name);
    if (length > 3 && strcasecmp(name + length - 3, ".gz") == 0)
        length -= 3;
    const char *dot = memrchr(name, '.', length);
    return dot && dot > name ? (size_t)(dot - name) : length;
}

/// How much is before the number at the end; all, if nothing is.
static size_t without_number(const char *name, size_t length)
{
    size_t rest = length;
    while (rest > 0 && name[rest - 1] >= '0' && name[rest - 1] <= '9')
        rest--;
    while (rest > 0 && rest < length && strchr("-_. ", name[rest - 1]))
        rest--;
    return rest > 0 ? rest : length;
}

static char *name_of(const tf_frame_names *frames)
{
    const char *slash = strrchr(frames->path[0], '/');
    const char *name = slash ? slash + 1 : frames->path[0];
    size_t length = without_ending(name);
    return strndup(name,
                   frames->count > 1 ? without_number(name, length) : length);
}

bool tf_scene_meshes_name(tf_scene_meshes *meshes)
{
    bool good = true;
    for (int i = 0; i < meshes->count && good; i++) {
        tf_scene_mesh *mesh = &meshes->mesh[i];
        if (!mesh->name)
            mesh->name = name_of(&mesh->frames);
        good = mesh->name;
    }
    return good;
}

//: Check that the meshes of a scene go together
/// What is wrong with a mesh is the fault of its line.
typedef struct check {
    tf_scene_meshes *meshes;
    const char *file;
    tf_fault *fault;
} check;

static bool check_name(const check *of, int i)
{
    const tf_scene_mesh *mesh = &of->meshes->mesh[i];
    for (int j = 0; j < i; j++)
        if (strcmp(of->meshes->mesh[j].name, mesh->name) == 0)
            return tf_fault_set(of->fault, of->file, mesh->line,
                                "there is already a mesh named '%s'; name one "
                                "of them differently, by 'name:'",
                                tf_make_visible(mesh->name).text);
    return true;
}

/// @param other one that decides how many frames the scene has
static bool check_frames(const check *of, const tf_scene_mesh *mesh,
                         const tf_scene_mesh *other)
{
    int frames = mesh->frames.count;
    return mesh->role == TF_FIXED || frames == 1 ||
           frames == other->frames.count ||
           tf_fault_set(of->fault, of->file, mesh->line,
                        "'%s' has %d frames, but '%s' has %d; give each mesh "
                        "one frame, or all the same number",
                        tf_make_visible(mesh->name).text, frames,
                        tf_make_visible(other->name).text, other->frames.count);
}

static bool check_mass(const check *of, const tf_scene_mesh *mesh, bool wanted)
{
    return mesh->role != TF_MOVING || mesh->mass > 0 || !wanted ||
           tf_fault_set(of->fault, of->file, mesh->line,
                        "'%s' has no mass, but another moving mesh has one; "
                        "give a mass to all moving meshes or to none",
                        tf_make_visible(mesh->name).text);
}

//: Check the meshes of a scene
static const tf_scene_mesh *find_longest(const tf_scene_meshes *meshes)
{
    const tf_scene_mesh *longest = NULL;
    for (int i = 0; i < meshes->count; i++) {
        const tf_scene_mesh *mesh = &meshes->mesh[i];
        if (mesh->role != TF_FIXED &&
            (!longest || mesh->frames.count > longest->frames.count))
            longest = mesh;
    }
    return longest;
}

static bool has_mass(const tf_scene_meshes *meshes)
{
    bool found = false;
    for (int i = 0; i < meshes->count; i++)
        found = found ||
                (meshes->mesh[i].role == TF_MOVING && meshes->mesh[i].mass > 0);
    return found;
}

bool tf_scene_meshes_check(tf_scene_meshes *meshes, const char *file,
                           tf_fault *fault)
{
    check of = {meshes, file, fault};
    const tf_scene_mesh *longest = find_longest(meshes);
    bool masses = has_mass(meshes), good = true;
    meshes->frames = longest ? longest->frames.count : 1;
    for (int i = 0; i < meshes->count && good; i++)
        good = check_name(&of, i) &&
               check_frames(&of, &meshes->mesh[i],
                            longest ? longest : meshes->mesh) &&
               check_mass(&of, &meshes->mesh[i], masses);
    return good;
}

//: Choose the file of a frame
const char *tf_scene_mesh_path(const tf_scene_mesh *mesh, int frame)
{
    bool stays = mesh->role == TF_FIXED || mesh->frames.count == 1;
    return mesh->frames.path[stays ? 0 : frame];
}

//: Pin vertices of a mesh
bool tf_scene_mesh_pin(const tf_scene_mesh *mesh, const char *file,
                       int vertices, double inverse_mass[], tf_fault *fault)
{
    for (int i = 0; i < mesh->pins; i++) {
        if (mesh->pinned[i] >= vertices)
            return tf_fault_set(fault, file, mesh->pinned_line,
                                "'%s' has no vertex %d; its vertices are "
                                "numbered from 0 to %d",
                                tf_make_visible(mesh->name).text,
                                mesh->pinned[i], vertices - 1);
        inverse_mass[mesh->pinned[i]] = 0;
    }
    return mesh->pinned_in.count == 0 ||
           tf_fixed_read(mesh->pinned_in.path[0], vertices, inverse_mass,
                         fault);
}
