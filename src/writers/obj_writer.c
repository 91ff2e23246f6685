//: Include what writing OBJ needs
#include "writers/obj_writer.h"

#include "writers/encoder.h"

//: Write the vertices of OBJ
static void write_vertex(const tf_encoder *to, const tf_mesh_content *content,
                         int vertex)
{
    int axes = content->mesh.axes;
    double color[3];
    fputs("v ", to->stream);
    tf_encode_position(to, content->position + (size_t)axes * (size_t)vertex,
                       axes);
    if (tf_mesh_content_color(content, vertex, color)) {
        tf_encode_blank(to);
        tf_encode_doubles(to, color, 3);
    }
    tf_encode_line_end(to);
}

//: Write the elements of OBJ
/// Which count from 1.
static void write_element(const tf_encoder *to, char word, const int vertex[],
                          int count)
{
    fputc(word, to->stream);
    for (int i = 0; i < count; i++) {
        tf_encode_blank(to);
        tf_encode_integer(to, vertex[i] + 1, 4);
    }
    tf_encode_line_end(to);
}

void tf_obj_write(FILE *stream, const tf_mesh_content *content)
{
    const tf_encoder to = {.stream = stream, .is_text = true};
    const tf_mesh *mesh = &content->mesh;
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(&to, content, v);
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);)
        write_element(&to, 'f', face.corner, face.corners);
    for (int e = 0; e < mesh->edges; e++)
        write_element(&to, 'l', mesh->edge + 2 * (size_t)e, 2);
}
