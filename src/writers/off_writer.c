//: Include what writing OFF needs
#include "writers/off_writer.h"

#include "writers/encoder.h"

#include <math.h>

//: Write the color of a vertex of OFF
static bool has_byte_colors(const tf_mesh_content *content)
{
    int red = tf_columns_find(content->columns, "red");
    return content->columns->column[red].type == TF_UCHAR;
}

/// The fourth number says that it is opaque.
static void write_color(const tf_encoder *to, const tf_mesh_content *content,
                        const double color[3])
{
    bool bytes = has_byte_colors(content);
    double number[] = {color[0], color[1], color[2], 1};
    for (int i = 0; i < 4; i++) {
        tf_encode_blank(to);
        tf_encode_double(to, bytes ? round(255 * number[i]) : number[i]);
    }
}

//: Write the vertices of OFF
static void write_vertex(const tf_encoder *to, const tf_mesh_content *content,
                         int vertex)
{
    int axes = content->mesh.axes;
    double color[3];
    tf_encode_position(to, content->position + (size_t)axes * (size_t)vertex,
                       axes);
    if (tf_mesh_content_color(content, vertex, color))
        write_color(to, content, color);
    tf_encode_line_end(to);
}

//: Write the faces of OFF
static void write_faces(const tf_encoder *to, const tf_mesh_content *content)
{
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);) {
        tf_encode_integer(to, face.corners, 4);
        for (int i = 0; i < face.corners; i++) {
            tf_encode_blank(to);
            tf_encode_integer(to, face.corner[i], 4);
        }
        tf_encode_line_end(to);
    }
}

//: Write OFF
void tf_off_write(FILE *stream, const tf_mesh_content *content)
{
    const tf_encoder to = {.stream = stream, .is_text = true};
    const tf_mesh *mesh = &content->mesh;
    double unused[3];
    bool colored =
        mesh->vertices > 0 && tf_mesh_content_color(content, 0, unused);
    fprintf(stream, "%s\n%d %d 0\n", colored ? "COFF" : "OFF", mesh->vertices,
            tf_mesh_content_faces(content));
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(&to, content, v);
    write_faces(&to, content);
}
