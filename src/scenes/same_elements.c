//: Include what comparing elements needs
#include "scenes/same_elements.h"

//: Compare the elements of two files
static bool same_count(const tf_mesh_file *file, const tf_mesh_file *before,
                       int own, int other, const char *things)
{
    return own == other ||
           tf_mesh_file_fault(file, -1,
                              "the number of %s is %d, but %d in %s; all files "
                              "must have the same elements",
                              things, own, other,
                              tf_make_visible(before->name).text);
}

static bool same_list(const tf_mesh_file *file, const tf_mesh_file *before,
                      const tf_ints *own, const tf_ints *other,
                      const tf_ints *places, const char *thing)
{
    size_t i = 0, both = own->count < other->count ? own->count : other->count;
    while (i < both && own->item[i] == other->item[i])
        i++;
    size_t corners = i < both ? own->count / places->count : 1;
    return i == both ||
           tf_mesh_file_fault(file, places->item[i / corners],
                              "this %s is not as in %s; all files must have "
                              "the same elements in the same order",
                              thing, tf_make_visible(before->name).text);
}

bool tf_have_same_elements(const tf_mesh_file *a, const tf_mesh_file *b)
{
    return same_count(a, b, tf_mesh_file_vertices(a), tf_mesh_file_vertices(b),
                      "vertices") &&
           same_list(a, b, &a->triangle, &b->triangle, &a->triangle_place,
                     "triangle") &&
           same_count(a, b, tf_mesh_file_triangles(a),
                      tf_mesh_file_triangles(b), "triangles") &&
           same_list(a, b, &a->edge, &b->edge, &a->edge_place, "edge") &&
           same_count(a, b, tf_mesh_file_edges(a), tf_mesh_file_edges(b),
                      "edges");
}
