//: Include what the folder of a simulation needs
#define _POSIX_C_SOURCE 200809L
#include "program/simulation_folder.h"

#include "files/folder.h"
#include "files/output_file.h"
#include "program/frame_file.h"
#include "program/steps_file.h"
#include "scenes/forecast.h"
#include "simulate/filed_scene.h"
#include "writers/endings.h"
#include "writers/mesh_frame.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

//: Name the files in the folder of a simulation
enum {
    TABLE = -1, // as the number of a frame
    NAME = 32   // room for a name
};

static void name_file(char name[NAME], int step)
{
    if (step == TABLE)
        strcpy(name, "steps.csv");
    else
        snprintf(name, NAME, "frame-%05d.ply", step);
}

/// Sets to work on a frame or on the table; returns the path.
static const char *choose_file(tf_simulation_folder *folder, int step)
{
    char name[NAME];
    name_file(name, step);
    snprintf(folder->file, sizeof folder->file, "%s/%s", folder->path, name);
    return folder->file;
}

static bool fault_in_writing(tf_simulation_folder *folder)
{
    return tf_fault_set(&folder->fault, folder->file, -1,
                        "cannot write: %s; mend that, and go on with --resume",
                        strerror(errno));
}

//: Write the meshes of a frame
/// The positions of a mesh with three coordinates a vertex, to be freed; NULL:
/// there is no memory.
static double *take_positions(const tf_snapshot *now, const int first[2])
{
    size_t count = (size_t)(first[1] - first[0]);
    double *x = calloc(3 * count + 1, sizeof *x);
    int axes = now->mesh.axes;
    for (size_t v = 0; v < count && x; v++)
        memcpy(x + 3 * v, now->position + (size_t)axes * ((size_t)first[0] + v),
               (size_t)axes * sizeof *x);
    return x;
}

/// Unless it stays where its file has it.
static bool write_own_mesh(tf_simulation_folder *folder,
                           const tf_filed_scene *filed, int m,
                           const tf_snapshot *now)
{
    const tf_scene_mesh *mesh = &filed->meshes.mesh[m];
    if (mesh->role == TF_FIXED ||
        (mesh->role == TF_SCRIPTED && mesh->frames.count == 1))
        return true;
    const tf_mesh_file *file = tf_scene_frames_file(&filed->frames, m, 1);
    double *x = take_positions(now, filed->frames.joined.first_vertex + m);
    tf_mesh_frame frame = {folder->path, mesh->name, now->step, file, x};
    bool good = x ? tf_mesh_frame_write(&frame, folder->file, &folder->fault)
                  : tf_fault_set(&folder->fault, folder->path, -1, "%s",
                                 tf_status_message(TF_OUT_OF_MEMORY));
    folder->bytes += good ? tf_bytes_of(folder->file) : 0;
    free(x);
    return good;
}

static bool write_own_meshes(tf_simulation_folder *folder,
                             const tf_simulation *simulation)
{
    const tf_filed_scene *filed = simulation->scene->own;
    tf_snapshot now = simulation->scene->kind->snapshot(simulation);
    bool good = true;
    for (int m = 0; filed && m < filed->meshes.count && good; m++)
        good = write_own_mesh(folder, filed, m, &now);
    return good;
}

//: Write a frame whole
/// Writes the scratch file of a frame.
static bool begin_frame(tf_output_file *out, tf_simulation_folder *folder,
                        const tf_simulation *simulation)
{
    const char *path = choose_file(folder, simulation->step);
    FILE *stream =
        tf_output_file_begin(out, path) ? tf_output_file_open(out) : NULL;
    if (!stream)
        return false;
    tf_frame_write(stream, simulation);
    return tf_output_file_close(out, stream);
}

/// The start has no line in the table.
static bool write_step(tf_simulation_folder *folder,
                       const tf_simulation *simulation, bool start)
{
    tf_output_file out = {0};
    folder->bytes = 0;
    if (!write_own_meshes(folder, simulation))
        return false;
    bool good = begin_frame(&out, folder, simulation);
    if (good && !start) {
        choose_file(folder, TABLE);
        good = tf_steps_file_add(folder->table, simulation);
    }
    if (good) {
        choose_file(folder, simulation->step);
        good = tf_output_file_keep(&out);
    }
    folder->bytes += good ? tf_bytes_of(folder->file) : 0;
    if (!good) {
        fault_in_writing(folder);
        tf_output_file_drop(&out);
    }
    return good;
}

bool tf_simulation_folder_add(tf_simulation_folder *folder,
                              const tf_simulation *simulation)
{
    return write_step(folder, simulation, false);
}

//: Look into the folder of a simulation
/// The step of a frame by its name; -1: that names no frame.
static int step_named(const char *name)
{
    int step = -1;
    char same[NAME];
    if (sscanf(name, "frame-%5d.ply", &step) != 1 || step < 0)
        return -1;
    name_file(same, step);
    return strcmp(name, same) == 0 ? step : -1;
}

/// The step of the last frame, or -1.
static int find_last(const char *path)
{
    DIR *entries = opendir(path);
    int last = -1;
    for (struct dirent *e; entries && (e = readdir(entries));) {
        int step = step_named(e->d_name);
        last = step > last ? step : last;
    }
    if (entries)
        closedir(entries);
    return last;
}

//: Begin the folder of a simulation
bool tf_simulation_folder_begin(tf_simulation_folder *folder, const char *path,
                                const tf_simulation *simulation)
{
    *folder = (tf_simulation_folder){.path = path};
    const char *ending = tf_any_mesh_ending(path);
    if (ending)
        return tf_fault_set(&folder->fault, path, -1,
                            "frames need a folder; leave out %s", ending);
    if (!tf_folder_begin(path,
                         ", or go on with the simulation in it by --resume",
                         &folder->fault))
        return false;
    folder->table = tf_steps_file_begin(choose_file(folder, TABLE),
                                        simulation->scene->kind);
    return folder->table ? write_step(folder, simulation, true)
                         : fault_in_writing(folder);
}

//: Go on with the simulation in a folder
static bool read_frame(tf_simulation_folder *folder, int step,
                       tf_simulation *simulation)
{
    char arguments[TF_SIMULATION_NAME];
    tf_frame_fault fault = tf_frame_read(simulation, choose_file(folder, step));
    if (fault == TF_FRAME_UNREADABLE)
        return tf_fault_set_unread(&folder->fault, folder->file, -1, errno);
    tf_simulation_name(simulation, arguments);
    return (fault == TF_FRAME_GOOD && simulation->step == step) ||
           tf_fault_set(
               &folder->fault, folder->file, -1,
               "is no frame of 'tanglefree simulate %s'; "
               "correct the arguments, or delete the file to go on from "
               "the one before",
               arguments);
}

static bool resume_table(tf_simulation_folder *folder,
                         const tf_simulation_kind *kind, int steps)
{
    folder->table =
        tf_steps_file_resume(choose_file(folder, TABLE), kind, steps);
    if (folder->table)
        return true;
    return errno
               ? tf_fault_set_unopened(&folder->fault, folder->file, errno)
               : tf_fault_set(&folder->fault, folder->file, -1,
                              "has no line for each of the %d steps whose "
                              "frames are there; delete frames after the last "
                              "line to go on from there",
                              steps);
}

bool tf_simulation_folder_resume(tf_simulation_folder *folder, const char *path,
                                 tf_simulation *simulation)
{
    int last = find_last(path);
    *folder = (tf_simulation_folder){.path = path};
    tf_output_file_clear(choose_file(folder, last + 1));
    if (last < 0)
        return tf_fault_set(&folder->fault, path, -1,
                            "has no frames to go on from; leave out --resume");
    folder->bytes = tf_bytes_of(choose_file(folder, last));
    return read_frame(folder, last, simulation) &&
           resume_table(folder, simulation->scene->kind, last);
}

//: Forecast the frames of a simulation
void tf_simulation_folder_forecast(tf_simulation_folder *folder,
                                   const tf_simulation *simulation, int steps)
{
    tf_forecast_frames(folder->path, steps - simulation->step, folder->bytes);
}

//: Close the folder of a simulation
void tf_simulation_folder_close(tf_simulation_folder *folder)
{
    if (folder->table)
        fclose(folder->table);
    folder->table = NULL;
}
