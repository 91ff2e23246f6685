//: Include what the content of a mesh needs
#include "writers/mesh_content.h"

//: Go through the faces of a content
int tf_mesh_content_faces(const tf_mesh_content *content)
{
    tf_face face = {0};
    int count = 0;
    while (tf_mesh_content_next_face(content, &face))
        count++;
    return count;
}

bool tf_mesh_content_next_face(const tf_mesh_content *content, tf_face *face)
{
    if (content->from)
        return tf_mesh_file_next_face(content->from, face);
    const tf_mesh *mesh = &content->mesh;
    face->triangle += face->corner ? 1 : 0;
    if (face->triangle >= mesh->triangles)
        return false;
    face->corner = mesh->triangle + 3 * (size_t)face->triangle;
    face->corners = 3;
    return true;
}

//: Find the color of a vertex
bool tf_mesh_content_color(const tf_mesh_content *content, int vertex,
                           double color[3])
{
    static const char *const names[] = {"red", "green", "blue"};
    static const double most[] = {[TF_UCHAR] = 255, [TF_USHORT] = 65535};
    const tf_columns *columns = content->columns;
    for (int i = 0; i < 3; i++) {
        int column = columns ? tf_columns_find(columns, names[i]) : -1;
        if (column < 0)
            return false;
        tf_number_type type = columns->column[column].type;
        bool part = type == TF_UCHAR || type == TF_USHORT;
        color[i] =
            tf_columns_row(columns, vertex)[column] / (part ? most[type] : 1);
    }
    return true;
}
