//: Include what writing STL needs
#include "writers/stl_writer.h"

#include "geometry/vector.h"
#include "writers/encoder.h"

//: Find the normal of a triangle
/// Of length 1, or zero.  Where floats hold the corners and don't round them to
/// 0, no cross product over- or underflows.
static tf_vector normal_of(const tf_vector corner[3])
{
    tf_vector normal =
        tf_vector_cross(tf_vector_difference(corner[1], corner[0]),
                        tf_vector_difference(corner[2], corner[0]));
    double length = tf_vector_length(normal);
    return tf_vector_scaled(length > 0 ? 1 / length : 0, normal);
}

//: Write a triangle of STL
static void write_vector(const tf_encoder *to, tf_vector a)
{
    for (int k = 0; k < 3; k++)
        tf_encode(to, TF_FLOAT, a.x[k]);
}

static void write_facet(const tf_encoder *to, const double position[],
                        const int vertex[3])
{
    tf_vector corner[3];
    for (int i = 0; i < 3; i++)
        corner[i] = tf_vector_at(position, vertex[i]);
    write_vector(to, normal_of(corner));
    for (int i = 0; i < 3; i++)
        write_vector(to, corner[i]);
    tf_encode_integer(to, 0, 2);
}

//: Write STL
void tf_stl_write(FILE *stream, const tf_mesh_content *content)
{
    const tf_encoder to = {.stream = stream};
    const char head[80] = "binary STL of tanglefree";
    const tf_mesh *mesh = &content->mesh;
    fwrite(head, 1, sizeof head, stream);
    tf_encode_integer(&to, mesh->triangles, 4);
    for (int t = 0; t < mesh->triangles; t++)
        write_facet(&to, content->position, mesh->triangle + 3 * (size_t)t);
}
