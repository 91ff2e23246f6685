//: Include what writing a source of joined vertices needs
#include "writers/joined_writer.h"

#include "writers/encoder.h"

#include <string.h>

//: Walk through the parts of a source
typedef struct joiner {
    const tf_mesh_content *content;
    const tf_source *source;
    tf_encoder to;
    size_t done;          ///< how many bytes of the source are dealt with
    size_t part;          ///< the next one
    int vertex, vertices; ///< how many were met, and how many of them kept
    int face, edge; ///< the triangle and the edge of the source that are next
    tf_face made;   ///< the next face of the mesh
    int made_edge;  ///< its next edge
    bool more;      ///< whether there is another face
} joiner;

static joiner begin(FILE *stream, const tf_mesh_content *content)
{
    const tf_mesh_file *file = content->joined;
    joiner j = {.content = content,
                .source = file->source,
                .to = {.stream = stream,
                       .is_text = !file->counts_bytes,
                       .is_big_endian = file->source->is_big_endian}};
    j.more = tf_mesh_content_next_face(content, &j.made);
    return j;
}

/// The indices that follow a part.
static int count_corners(const tf_source *source, size_t part)
{
    size_t end = part + 1;
    while (end < source->parts && source->part[end].kind == TF_CORNER_PART)
        end++;
    return (int)(end - part - 1);
}

/// -1: it is gone, or there is no such vertex, as points may have it.
static int number_of(const joiner *j, const tf_source_part *corner)
{
    bool known = corner->vertex < tf_mesh_file_vertices(j->content->joined);
    return known ? j->content->number[corner->vertex] : -1;
}

//: Find what is made of a face
/// How many faces of the mesh are made of one that is at that place.
static int count_made(const joiner *j, int place)
{
    const int *from = j->content->from->triangle_place.item;
    tf_face face = j->made;
    int count = 0;
    for (bool more = j->more; more && from[face.triangle] == place;
         more = tf_mesh_content_next_face(j->content, &face))
        count++;
    return count;
}

static int count_made_edges(const joiner *j, int place)
{
    const tf_mesh_file *made = j->content->from;
    int edge = j->made_edge;
    while (edge < tf_mesh_file_edges(made) &&
           made->edge_place.item[edge] == place)
        edge++;
    return edge - j->made_edge;
}

static void skip_made(joiner *j, int faces)
{
    for (int i = 0; i < faces; i++)
        j->more = tf_mesh_content_next_face(j->content, &j->made);
}

//: Copy a part of a source
static void copy_up_to(joiner *j, size_t at)
{
    fwrite(j->source->text + j->done, 1, at - j->done, j->to.stream);
    j->done = at;
}

static void drop(joiner *j, const tf_source_part *part)
{
    copy_up_to(j, part->at);
    j->done += part->length;
}

/// Writes another number; OBJ counts from 1.
static void replace(joiner *j, const tf_source_part *part, int number)
{
    copy_up_to(j, part->at);
    tf_encode_integer(&j->to, number, (int)part->length);
    j->done += part->length;
}

/// The header of PLY is text.
static void replace_count(joiner *j, const tf_source_part *part, int count)
{
    drop(j, part);
    fprintf(j->to.stream, "%d", count);
}

static void replace_corners(joiner *j, const tf_source_part *whole, int corners)
{
    int first = j->content->joined->first_index;
    for (const tf_source_part *c = whole + 1; c <= whole + corners; c++)
        replace(j, c, number_of(j, c) + first);
}

//: Write a line of OBJ anew
/// A corner with what follows its number.
static void write_corner(const joiner *j, const tf_source_part *corner)
{
    const char *rest = j->source->text + corner->at + corner->length;
    tf_encode_blank(&j->to);
    tf_encode_integer(
        &j->to, number_of(j, corner) + j->content->joined->first_index, 0);
    fwrite(rest, 1, strcspn(rest, " \t\r\n\\#"), j->to.stream);
}

/// The first of so many corners that has that number now.
static const tf_source_part *
corner_of(const joiner *j, const tf_source_part *whole, int corners, int number)
{
    for (int i = 1; i < corners; i++)
        if (number_of(j, whole + i) == number)
            return whole + i;
    return whole + corners;
}

static void write_line(const joiner *j, const tf_source_part *whole,
                       int corners, const int number[], int count)
{
    static const char words[] = {
        [TF_FACE_PART] = 'f', [TF_EDGE_PART] = 'l', [TF_POINT_PART] = 'p'};
    fputc(words[whole->kind], j->to.stream);
    for (int i = 0; i < count; i++)
        write_corner(j, corner_of(j, whole, corners, number[i]));
    tf_encode_line_end(&j->to);
}

//: Write a vertex, a face or edges of a source
/// One is kept if no vertex before it has its number.
static void write_vertex(joiner *j, const tf_source_part *whole)
{
    bool kept = j->content->number[j->vertex++] == j->vertices;
    j->vertices += kept;
    if (!kept)
        drop(j, whole);
}

static void write_face(joiner *j, const tf_source_part *whole, int corners)
{
    int place = j->content->joined->triangle_place.item[j->face];
    int made = count_made(j, place);
    j->face += corners - 2;
    if (made == 1 && j->made.corners == corners) {
        replace_corners(j, whole, corners);
        skip_made(j, made);
        return;
    }
    drop(j, whole);
    for (int i = 0; i < made; i++, skip_made(j, 1))
        write_line(j, whole, corners, j->made.corner, j->made.corners);
}

static void write_edges(joiner *j, const tf_source_part *whole, int corners)
{
    int place = j->content->joined->edge_place.item[j->edge];
    int made = count_made_edges(j, place);
    const int *edge = j->content->mesh.edge;
    j->edge += corners - 1;
    if (made == corners - 1)
        replace_corners(j, whole, corners);
    else
        drop(j, whole);
    for (int i = 0; i < made; i++, j->made_edge++)
        if (made < corners - 1)
            write_line(j, whole, corners, edge + 2 * (size_t)j->made_edge, 2);
}

/// Points of vertices that are gone are gone, too.
static void write_points(joiner *j, const tf_source_part *whole, int corners)
{
    int left = 0;
    for (int i = 1; i <= corners; i++)
        left += number_of(j, whole + i) >= 0;
    if (left == corners) {
        replace_corners(j, whole, corners);
        return;
    }
    drop(j, whole);
    for (int i = 1; i <= corners; i++) {
        int number = number_of(j, whole + i);
        if (number >= 0)
            write_line(j, whole, corners, &number, 1);
    }
}

//: Find out whether a source can be written
/// Lists in PLY may have an item for each corner.
static bool is_whole_in_ply(joiner *j, int corners)
{
    int place = j->content->joined->triangle_place.item[j->face];
    int made = count_made(j, place);
    bool whole = made == 0 || (made == 1 && j->made.corners == corners);
    j->face += corners - 2;
    skip_made(j, made);
    return whole;
}

/// Places that are too great for an int cannot be told apart.
static bool has_places(const tf_mesh_file *file)
{
    int triangles = tf_mesh_file_triangles(file);
    int edges = tf_mesh_file_edges(file);
    return (triangles == 0 || file->triangle_place.item[triangles - 1] >= 0) &&
           (edges == 0 || file->edge_place.item[edges - 1] >= 0);
}

bool tf_joined_is_writable(const tf_mesh_content *content)
{
    const tf_mesh_file *file = content->joined;
    const tf_source *source = file->source;
    if (!source || !source->keeps_parts || source->parts == 0 ||
        !has_places(file))
        return false;
    joiner j = begin(NULL, content);
    bool good = true;
    for (size_t p = 0; p < source->parts && good && file->format != TF_OBJ; p++)
        if (source->part[p].kind == TF_FACE_PART)
            good = is_whole_in_ply(&j, count_corners(source, p));
    return good;
}

//: Write a source of joined vertices
static void write_part(joiner *j, const tf_source_part *part, int corners)
{
    const tf_mesh *mesh = &j->content->mesh;
    switch (part->kind) {
    case TF_VERTEX_PART:
        write_vertex(j, part);
        break;
    case TF_FACE_PART:
        write_face(j, part, corners);
        break;
    case TF_EDGE_PART:
        write_edges(j, part, corners);
        break;
    case TF_POINT_PART:
        write_points(j, part, corners);
        break;
    case TF_VERTEX_COUNT_PART:
        replace_count(j, part, mesh->vertices);
        break;
    case TF_FACE_COUNT_PART:
        replace_count(j, part, tf_mesh_content_faces(j->content));
        break;
    default:
        replace_count(j, part, mesh->edges);
        break;
    }
}

void tf_joined_write(FILE *stream, const tf_mesh_content *content)
{
    joiner j = begin(stream, content);
    while (j.part < j.source->parts) {
        const tf_source_part *part = &j.source->part[j.part];
        int corners = count_corners(j.source, j.part);
        write_part(&j, part, corners);
        j.part += 1 + (size_t)corners;
    }
    copy_up_to(&j, j.source->size);
}
