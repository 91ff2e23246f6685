//: Include what writing meshes needs
#include "writers/mesh_writer.h"

#include "writers/endings.h"
#include "writers/joined_writer.h"
#include "writers/obj_writer.h"
#include "writers/off_writer.h"
#include "writers/ply_writer.h"
#include "writers/source_writer.h"
#include "writers/stl_writer.h"
#include "writers/vtp_writer.h"

#include <float.h>
#include <math.h>

//: Find out whether a mesh is its source
bool tf_mesh_is_source(const tf_mesh_content *content, tf_mesh_format format)
{
    const tf_mesh_file *file =
        content->joined ? content->joined : content->from;
    return file && file->source && file->format == format;
}

bool tf_mesh_has_floats(const tf_mesh_content *content, tf_mesh_format format)
{
    return format == TF_STL_BINARY ||
           (format == TF_STL_TEXT && !tf_mesh_is_source(content, format));
}

//: Check that a mesh can be written
#define END_THE_NAME "end the name in .obj, .ply or .vtp"

static bool check_elements(const tf_mesh_content *content,
                           tf_mesh_format format, const char *path,
                           tf_fault *fault)
{
    bool holds_edges = !tf_mesh_has_floats(content, format) && format != TF_OFF;
    return holds_edges || content->mesh.triangles > 0 ||
           tf_fault_set(
               fault, path, -1,
               "%s holds faces, and this mesh has only edges; " END_THE_NAME,
               tf_mesh_format_name(format));
}

/// The rounding of a finite number to a float must be one, too.
static bool check_range(const tf_mesh_content *content, tf_mesh_format format,
                        const char *path, tf_fault *fault)
{
    const tf_mesh *mesh = &content->mesh;
    size_t count = (size_t)mesh->vertices * (size_t)mesh->axes;
    for (size_t i = 0; i < count && tf_mesh_has_floats(content, format); i++)
        if (fabs(content->position[i]) > (double)FLT_MAX)
            return tf_fault_set(fault, path, -1,
                                "the coordinate %.17g is beyond the floats of "
                                "STL; scale the mesh down, or " END_THE_NAME,
                                content->position[i]);
    return true;
}

bool tf_mesh_check_writable(const tf_mesh_content *content,
                            tf_mesh_format format, const char *path,
                            tf_fault *fault)
{
    const char *ending = tf_unwritten_ending(path);
    if (ending)
        return tf_fault_set(fault, path, -1,
                            "%s is not written; end the name in .obj, .ply, "
                            ".stl, .off or .vtp",
                            ending);
    if (format == TF_MSH && !tf_mesh_is_source(content, format))
        return tf_fault_set(fault, path, -1,
                            "%s is written only if the mesh comes from one, "
                            "with its triangles; " END_THE_NAME,
                            tf_mesh_format_name(format));
    return check_elements(content, format, path, fault) &&
           check_range(content, format, path, fault);
}

//: Write a mesh
static void write_anew(FILE *stream, const tf_mesh_content *content,
                       tf_mesh_format format)
{
    switch (format) {
    case TF_OBJ:
        tf_obj_write(stream, content);
        break;
    case TF_OFF:
        tf_off_write(stream, content);
        break;
    case TF_STL_TEXT:
    case TF_STL_BINARY:
        tf_stl_write(stream, content);
        break;
    case TF_VTP:
        tf_vtp_write(stream, content);
        break;
    default:
        tf_ply_write(stream, content, format);
        break;
    }
}

void tf_mesh_write(FILE *stream, const tf_mesh_content *content,
                   tf_mesh_format format)
{
    if (tf_mesh_is_source(content, format) && content->joined)
        tf_joined_write(stream, content);
    else if (tf_mesh_is_source(content, format))
        tf_source_write(stream, content->from, content->position);
    else
        write_anew(stream, content, format);
}
