//: Include what frames of meshes need
#include "writers/mesh_frame.h"

#include "files/destination.h"
#include "writers/endings.h"
#include "writers/mesh_output.h"
#include "writers/mesh_writer.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

//: Name a frame of a mesh
static bool name_frame(const tf_mesh_frame *frame,
                       char path[TF_MESH_FRAME_PATH], tf_fault *fault)
{
    int length = snprintf(path, TF_MESH_FRAME_PATH, "%s/%s-%05d%s",
                          frame->folder, frame->name, frame->number,
                          tf_mesh_ending(frame->from->format));
    return length < TF_MESH_FRAME_PATH ||
           tf_fault_set(fault, frame->folder, -1,
                        "cannot write: %s; give the mesh a shorter name",
                        strerror(ENAMETOOLONG));
}

//: Write and delete a frame of a mesh
void tf_mesh_frame_delete(const tf_mesh_frame *frame)
{
    char path[TF_MESH_FRAME_PATH];
    tf_fault fault;
    if (name_frame(frame, path, &fault))
        remove(path);
}

bool tf_mesh_frame_write(const tf_mesh_frame *frame,
                         char path[TF_MESH_FRAME_PATH], tf_fault *fault)
{
    tf_mesh_content content = {.mesh = tf_mesh_file_elements(frame->from, 3),
                               .position = frame->position,
                               .from = frame->from};
    if (!name_frame(frame, path, fault))
        return false;
    tf_mesh_output_remark(path, &content, frame->from);
    tf_destination to;
    FILE *stream = tf_destination_begin(&to, path, fault)
                       ? tf_destination_open(&to)
                       : NULL;
    if (stream)
        tf_mesh_write(stream, &content, frame->from->format);
    bool good = tf_destination_finish(&to, stream, 0);
    tf_destination_end(&to);
    return good;
}
