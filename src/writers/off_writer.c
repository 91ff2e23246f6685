//: Include what writing OFF needs
#include "writers/off_writer.h"

#include <math.h>

//: Write the vertices of OFF
static bool has_byte_colors(const tf_mesh_content *content)
{
    int red = tf_columns_find(content->columns, "red");
    return content->columns->column[red].type == TF_UCHAR;
}

static void write_color(FILE *stream, const tf_mesh_content *content,
                        const double color[3])
{
    if (has_byte_colors(content))
        fprintf(stream, " %.0f %.0f %.0f 255", color[0] * 255, color[1] * 255,
                color[2] * 255);
    else
        fprintf(stream, " %.17g %.17g %.17g 1", color[0], color[1], color[2]);
}

/// In the plane the third is 0.
static void write_vertex(FILE *stream, const tf_mesh_content *content,
                         int vertex)
{
    int axes = content->mesh.axes;
    const double *x = content->position + (size_t)axes * (size_t)vertex;
    double color[3];
    fprintf(stream, "%.17g %.17g %.17g", x[0], x[1], axes == 3 ? x[2] : 0);
    if (tf_mesh_content_color(content, vertex, color))
        write_color(stream, content, color);
    fputc('\n', stream);
}

//: Write OFF
void tf_off_write(FILE *stream, const tf_mesh_content *content)
{
    const tf_mesh *mesh = &content->mesh;
    double unused[3];
    bool colored =
        mesh->vertices > 0 && tf_mesh_content_color(content, 0, unused);
    fprintf(stream, "%s\n%d %d 0\n", colored ? "COFF" : "OFF", mesh->vertices,
            tf_mesh_content_faces(content));
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(stream, content, v);
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);) {
        fprintf(stream, "%d", face.corners);
        for (int i = 0; i < face.corners; i++)
            fprintf(stream, " %d", face.corner[i]);
        fputc('\n', stream);
    }
}
