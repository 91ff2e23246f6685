//: Include what the folder of a simulation needs
#define _GNU_SOURCE // asprintf
#include "program/simulation_folder.h"

#include "program/steps_file.h"

#include <dirent.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

//: Describe what is wrong with the folder of a simulation
/// Sets the fault, as printf, behind the name of the folder or of a file in it.
__attribute__((format(printf, 3, 4))) static bool
set_fault(tf_simulation_folder *folder, const char *file, const char *format,
          ...)
{
    char verdict[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(verdict, sizeof verdict, format, arguments);
    va_end(arguments);
    snprintf(folder->fault, sizeof folder->fault, "%s%s%s: %s",
             tf_make_visible(folder->path).text, file ? "/" : "",
             file ? file : "", verdict);
    return false;
}

static bool fault_in_writing(tf_simulation_folder *folder, const char *file)
{
    return set_fault(folder, file,
                     "cannot write: %s; mend that, and go on with --resume",
                     strerror(errno));
}

//: Name the files in the folder of a simulation
static const char table_name[] = "steps.csv";

enum {
    FRAME_NAME = 32
};

static void name_frame(char name[FRAME_NAME], int step)
{
    snprintf(name, FRAME_NAME, "frame-%05d.ply", step);
}

/// To be freed; NULL, with errno, without memory.
static char *path_of(const tf_simulation_folder *folder, const char *file)
{
    char *path;
    return asprintf(&path, "%s/%s", folder->path, file) < 0 ? NULL : path;
}

//: Write a frame whole
static bool write_scratch(const tf_output_file *out,
                          const tf_simulated *simulated)
{
    FILE *stream = tf_output_file_open(out);
    if (!stream)
        return false;
    bool made = simulated->kind->write_frame(stream, simulated);
    int cause = errno;
    bool closed = tf_output_file_close(out, stream);
    if (!made)
        errno = cause;
    return made && closed;
}

/// Writes the scratch file of a frame.
static bool begin_frame(tf_output_file *out, const tf_simulation_folder *folder,
                        const char *name, const tf_simulated *simulated)
{
    char *path = path_of(folder, name);
    *out = (tf_output_file){0};
    bool good = path && tf_output_file_begin(out, path) &&
                write_scratch(out, simulated);
    int cause = errno;
    free(path);
    errno = cause;
    return good;
}

/// Drops a frame after an error.
static bool drop_frame(tf_output_file *out, tf_simulation_folder *folder,
                       const char *file)
{
    fault_in_writing(folder, file);
    tf_output_file_drop(out);
    return false;
}

//: Begin the folder of a simulation
static bool is_empty(const char *path)
{
    DIR *entries = opendir(path);
    int count = 0;
    while (entries && count < 3 && readdir(entries))
        count++;
    if (entries)
        closedir(entries);
    return entries && count < 3; // "." and ".."
}

static bool make_folder(tf_simulation_folder *folder)
{
    if (mkdir(folder->path, 0777) == 0)
        return true;
    if (errno != EEXIST)
        return set_fault(folder, NULL,
                         "cannot make this folder: %s; choose another with -o",
                         strerror(errno));
    return is_empty(folder->path) ||
           set_fault(
               folder, NULL,
               "exists, and is not an empty folder; choose another, or go "
               "on with the simulation in it by --resume");
}

static bool begin_table(tf_simulation_folder *folder,
                        const tf_simulated_kind *kind)
{
    char *path = path_of(folder, table_name);
    folder->table = path ? tf_steps_file_begin(path, kind) : NULL;
    bool good = folder->table || fault_in_writing(folder, table_name);
    free(path);
    return good;
}

bool tf_simulation_folder_begin(tf_simulation_folder *folder, const char *path,
                                const tf_simulated *simulated)
{
    char name[FRAME_NAME];
    tf_output_file out;
    *folder = (tf_simulation_folder){.path = path};
    name_frame(name, simulated->step);
    if (!make_folder(folder) || !begin_table(folder, simulated->kind))
        return false;
    return (begin_frame(&out, folder, name, simulated) &&
            tf_output_file_keep(&out)) ||
           drop_frame(&out, folder, name);
}

//: Find the last frame of a simulation
/// The step of a frame by its name; -1: that names no frame.
static int step_named(const char *name)
{
    int step = -1;
    char same[FRAME_NAME];
    if (sscanf(name, "frame-%5d.ply", &step) != 1 || step < 0)
        return -1;
    name_frame(same, step);
    return strcmp(name, same) == 0 ? step : -1;
}

static int find_last_frame(const char *path)
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

//: Go on with the simulation in a folder
static bool read_frame(tf_simulation_folder *folder, int step,
                       tf_simulated *simulated)
{
    char name[FRAME_NAME];
    name_frame(name, step);
    char *path = path_of(folder, name);
    tf_frame_fault fault = path ? simulated->kind->read_frame(simulated, path)
                                : TF_FRAME_UNREADABLE;
    int cause = errno;
    free(path);
    if (fault == TF_FRAME_UNREADABLE)
        return set_fault(folder, name, "cannot read: %s; check the file",
                         strerror(cause));
    return (fault == TF_FRAME_GOOD && simulated->step == step) ||
           set_fault(folder, name,
                     "is no frame of 'tanglefree simulate %s'; "
                     "correct the arguments, or delete the file to go on from "
                     "the one before",
                     simulated->name);
}

static bool resume_table(tf_simulation_folder *folder,
                         const tf_simulated_kind *kind, int steps)
{
    char *path = path_of(folder, table_name);
    folder->table = path ? tf_steps_file_resume(path, kind, steps) : NULL;
    int cause = errno;
    free(path);
    if (folder->table)
        return true;
    return cause ? set_fault(folder, table_name, "cannot open: %s",
                             strerror(cause))
                 : set_fault(folder, table_name,
                             "has no line for each of the %d steps whose "
                             "frames are there; delete frames after the last "
                             "line to go on from there",
                             steps);
}

bool tf_simulation_folder_resume(tf_simulation_folder *folder, const char *path,
                                 tf_simulated *simulated)
{
    *folder = (tf_simulation_folder){.path = path};
    int last = find_last_frame(path);
    if (last < 0)
        return set_fault(folder, NULL,
                         "has no frames to go on from; leave out --resume");
    return read_frame(folder, last, simulated) &&
           resume_table(folder, simulated->kind, last);
}

//: Add a step to the folder of a simulation
bool tf_simulation_folder_add(tf_simulation_folder *folder,
                              const tf_simulated *simulated)
{
    char name[FRAME_NAME];
    tf_output_file out;
    name_frame(name, simulated->step);
    if (!begin_frame(&out, folder, name, simulated))
        return drop_frame(&out, folder, name);
    if (!tf_steps_file_add(folder->table, simulated))
        return drop_frame(&out, folder, table_name);
    return tf_output_file_keep(&out) || drop_frame(&out, folder, name);
}

void tf_simulation_folder_close(tf_simulation_folder *folder)
{
    if (folder->table)
        fclose(folder->table);
    folder->table = NULL;
}
