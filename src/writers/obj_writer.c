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

//: Write what the faces of OBJ have
static void write_excerpt(const tf_encoder *to, const tf_face_attributes *faces,
                          const tf_excerpt *excerpt)
{
    fwrite(faces->text + excerpt->at, 1, excerpt->length, to->stream);
    tf_encode_line_end(to);
}

/// Before the vertices.
static void write_libraries(const tf_encoder *to,
                            const tf_face_attributes *faces)
{
    for (size_t i = 0; faces && i < faces->library.count; i++)
        write_excerpt(to, faces, &faces->library.item[i]);
}

static void write_texture(const tf_encoder *to, const tf_face_attributes *faces)
{
    for (size_t i = 0; faces && i < faces->texture.rows; i++) {
        fputs("vt ", to->stream);
        tf_encode_doubles(to, tf_columns_row(&faces->texture, (int)i),
                          faces->texture_axes);
        tf_encode_line_end(to);
    }
}

/// The lines of a heading that have changed since the last face; `last`: where
/// they were.
static void write_heading(const tf_encoder *to, const tf_face_attributes *faces,
                          int face, tf_excerpt last[TF_HEADING_LINES])
{
    size_t number = (size_t)*tf_columns_row(&faces->row, face);
    const tf_excerpt *line = faces->heading.item + TF_HEADING_LINES * number;
    for (int i = 0; i < TF_HEADING_LINES; i++) {
        if (line[i].at != last[i].at && line[i].length > 0)
            write_excerpt(to, faces, &line[i]);
        last[i] = line[i];
    }
}

//: Write the elements of OBJ
/// Which count from 1; `texture`, if any, is a row for each vertex.
static void write_element(const tf_encoder *to, char word, const int vertex[],
                          const int texture[], int count)
{
    fputc(word, to->stream);
    for (int i = 0; i < count; i++) {
        tf_encode_blank(to);
        tf_encode_integer(to, vertex[i] + 1, 4);
        if (texture) {
            fputc('/', to->stream);
            tf_encode_integer(to, texture[i] + 1, 4);
        }
    }
    tf_encode_line_end(to);
}

/// The rows of a face if all of its corners have one, or else NULL.
static const int *textures_of(const tf_face_attributes *faces, size_t corner,
                              int count)
{
    if (!faces || faces->corner.count == 0)
        return NULL;
    const int *texture = faces->corner.item + corner;
    for (int i = 0; i < count; i++)
        if (texture[i] < 0)
            return NULL;
    return texture;
}

static void write_faces(const tf_encoder *to, const tf_mesh_content *content)
{
    const tf_face_attributes *faces = content->faces;
    tf_excerpt last[TF_HEADING_LINES] = {{0}};
    size_t corner = 0;
    int count = 0;
    for (tf_face face = {0}; tf_mesh_content_next_face(content, &face);) {
        if (faces)
            write_heading(to, faces, count++, last);
        write_element(to, 'f', face.corner,
                      textures_of(faces, corner, face.corners), face.corners);
        corner += (size_t)face.corners;
    }
}

//: Write OBJ
void tf_obj_write(FILE *stream, const tf_mesh_content *content)
{
    const tf_encoder to = {.stream = stream, .is_text = true};
    const tf_mesh *mesh = &content->mesh;
    write_libraries(&to, content->faces);
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(&to, content, v);
    write_texture(&to, content->faces);
    write_faces(&to, content);
    for (int e = 0; e < mesh->edges; e++)
        write_element(&to, 'l', mesh->edge + 2 * (size_t)e, NULL, 2);
}
