//: Include what notes on frames need
#define _POSIX_C_SOURCE 200809L // open_memstream, getline
#include "simulate/frame_notes.h"

#include "files/visible.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Write the notes on frames
static const char *role_name(tf_role role)
{
    const tf_choice *choice = tf_roles;
    while (choice->name && *(const tf_role *)choice->value != role)
        choice++;
    return choice->name;
}

char *tf_frame_notes_write(const tf_scene_meshes *meshes,
                           const tf_joined *joined)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        return NULL;
    int up = meshes->physics.up;
    fprintf(stream, "up %c", up < 0 ? 'z' : "xyz"[up]);
    for (int m = 0; m < meshes->count; m++) {
        const tf_scene_mesh *mesh = &meshes->mesh[m];
        const int *first = joined->first_vertex + m;
        fprintf(stream, "\nmesh of %d vertices, %s: %s", first[1] - first[0],
                role_name(mesh->role), tf_make_visible(mesh->name).text);
    }
    bool good = !ferror(stream);
    if (fclose(stream) == 0 && good)
        return text;
    free(text);
    return NULL;
}

//: Take a note
static int vertices_of(const tf_frame_notes *notes)
{
    return notes->meshes > 0 ? notes->mesh[notes->meshes - 1].end : 0;
}

static bool add_mesh(tf_frame_notes *notes, int vertices, tf_role role)
{
    size_t count = (size_t)notes->meshes + 1;
    tf_mesh_note *moved = realloc(notes->mesh, count * sizeof *moved);
    if (!moved)
        return false;
    notes->mesh = moved;
    int end = vertices_of(notes) + vertices;
    moved[notes->meshes++] = (tf_mesh_note){end, role};
    return true;
}

/// A comment that is no note, or one of another version, says nothing.
static bool take_note(tf_frame_notes *notes, const char *line)
{
    char axis, name[16];
    int vertices;
    if (sscanf(line, "comment up %c\n", &axis) == 1 && axis >= 'x' &&
        axis <= 'z')
        notes->up = axis - 'x';
    if (sscanf(line, "comment mesh of %9d vertices, %15[a-z]:", &vertices,
               name) < 2)
        return true;
    const tf_role *role = tf_choice_named(tf_roles, name);
    bool fits = vertices >= 0 && vertices <= INT_MAX - vertices_of(notes);
    return !role || !fits || add_mesh(notes, vertices, *role);
}

//: Read the notes on frames
static bool read_header(tf_frame_notes *notes, FILE *stream)
{
    char *line = NULL;
    size_t room = 0;
    bool good = true;
    bool goes_on =
        getline(&line, &room, stream) > 0 && strcmp(line, "ply\n") == 0;
    while (good && goes_on && getline(&line, &room, stream) > 0) {
        good = take_note(notes, line);
        goes_on = strcmp(line, "end_header\n") != 0;
    }
    free(line);
    return good;
}

bool tf_frame_notes_read(tf_frame_notes *notes, const char *path)
{
    *notes = (tf_frame_notes){.up = -1};
    FILE *stream = fopen(path, "rb");
    bool good = !stream || read_header(notes, stream);
    if (stream)
        fclose(stream);
    return good;
}

tf_role tf_frame_notes_role(const tf_frame_notes *notes, int vertex)
{
    for (int m = 0; m < notes->meshes; m++)
        if (vertex < notes->mesh[m].end)
            return notes->mesh[m].role;
    return TF_MOVING;
}

void tf_frame_notes_free(tf_frame_notes *notes)
{
    free(notes->mesh);
    *notes = (tf_frame_notes){.up = -1};
}
