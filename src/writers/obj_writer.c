//: Include what writing OBJ needs
#include "writers/obj_writer.h"

//: Write the vertices of OBJ
/// In the plane the third is 0.
static void write_vertices(FILE *stream, const tf_mesh_content *content)
{
    int axes = content->mesh.axes;
    const double *x = content->position;
    for (int v = 0; v < content->mesh.vertices; v++, x += axes) {
        double color[3];
        fprintf(stream, "v %.17g %.17g %.17g", x[0], x[1],
                axes == 3 ? x[2] : 0);
        if (tf_mesh_content_color(content, v, color))
            fprintf(stream, " %.17g %.17g %.17g", color[0], color[1], color[2]);
        fputc('\n', stream);
    }
}

//: Write the elements of OBJ
static void write_faces(FILE *stream, const tf_mesh_content *content)
{
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);) {
        fputc('f', stream);
        for (int i = 0; i < face.corners; i++)
            fprintf(stream, " %d", face.corner[i] + 1);
        fputc('\n', stream);
    }
}

void tf_obj_write(FILE *stream, const tf_mesh_content *content)
{
    const tf_mesh *mesh = &content->mesh;
    write_vertices(stream, content);
    write_faces(stream, content);
    for (int e = 0; e < mesh->edges; e++)
        fprintf(stream, "l %d %d\n", mesh->edge[2 * (size_t)e] + 1,
                mesh->edge[2 * (size_t)e + 1] + 1);
}
