//: Include what comparing elements needs
#include "scenes/same_elements.h"

#include <string.h>

//: Compare the elements of two files
static bool same_count(const tf_mesh_file *file, const tf_mesh_file *before,
                       int own, int other, const char *things)
{
    return own == other ||
           tf_mesh_file_fault(file, -1,
                              "%d %s, but %s has %d; all files must have the "
                              "same elements",
                              own, things, tf_make_visible(before->name).text,
                              other);
}

static bool fault_in_element(const tf_mesh_file *file,
                             const tf_mesh_file *before, int place,
                             const char *thing)
{
    return tf_mesh_file_fault(file, place,
                              "this %s is not as in %s; all files must have "
                              "the same elements in the same order",
                              thing, tf_make_visible(before->name).text);
}

/// Of polygons the corners are compared: their triangles depend on positions.
static bool same_faces(const tf_mesh_file *file, const tf_mesh_file *before)
{
    tf_face own = {0}, other = {0};
    while (tf_mesh_file_next_face(file, &own) &&
           tf_mesh_file_next_face(before, &other))
        if (own.corners != other.corners ||
            memcmp(own.corner, other.corner,
                   sizeof *own.corner * (size_t)own.corners) != 0)
            return fault_in_element(file, before,
                                    file->triangle_place.item[own.triangle],
                                    own.corners > 3 ? "face" : "triangle");
    return true;
}

static bool same_edges(const tf_mesh_file *file, const tf_mesh_file *before)
{
    size_t i = 0, both = file->edge.count < before->edge.count
                             ? file->edge.count
                             : before->edge.count;
    while (i < both && file->edge.item[i] == before->edge.item[i])
        i++;
    return i == both ||
           fault_in_element(file, before, file->edge_place.item[i / 2], "edge");
}

/// Describes the first difference, if there is one.
static bool same_elements(const tf_mesh_file *a, const tf_mesh_file *b)
{
    return same_count(a, b, tf_mesh_file_vertices(a), tf_mesh_file_vertices(b),
                      "vertices") &&
           same_faces(a, b) &&
           same_count(a, b, tf_mesh_file_triangles(a),
                      tf_mesh_file_triangles(b), "triangles") &&
           same_edges(a, b) &&
           same_count(a, b, tf_mesh_file_edges(a), tf_mesh_file_edges(b),
                      "edges");
}

//: Keep the triangles of polygons
/// All files of a sequence have those of the first one.
static void keep_triangles(const tf_mesh_file *file, const tf_mesh_file *before)
{
    if (tf_mesh_file_polygons(file) > 0)
        memcpy(file->triangle.item, before->triangle.item,
               file->triangle.count * sizeof *file->triangle.item);
}

bool tf_continue_sequence(tf_mesh_file *file, const tf_mesh_file *before)
{
    bool same = same_elements(file, before);
    if (same)
        keep_triangles(file, before);
    return same;
}
