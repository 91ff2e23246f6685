//: Include what writing meshes needs
#define _GNU_SOURCE // strcasecmp
#include "formats/mesh_writer.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

//: Choose the format of a file
static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path), own = strlen(ending);
    return length >= own && strcasecmp(path + length - own, ending) == 0;
}

tf_mesh_format tf_mesh_format_of(const char *path, tf_mesh_format usual)
{
    if (ends_in(path, ".obj"))
        return TF_OBJ;
    if (ends_in(path, ".ply") && usual == TF_OBJ)
        return TF_PLY_LITTLE_ENDIAN;
    return usual;
}

const char *tf_mesh_ending(tf_mesh_format format)
{
    return format == TF_OBJ ? ".obj" : ".ply";
}

//: Write the header of PLY
static const char *const encodings[] = {
    [TF_PLY_TEXT] = "ascii",
    [TF_PLY_LITTLE_ENDIAN] = "binary_little_endian",
    [TF_PLY_BIG_ENDIAN] = "binary_big_endian",
};

static const char *const type_names[] = {
    [TF_CHAR] = "char",     [TF_UCHAR] = "uchar",  [TF_SHORT] = "short",
    [TF_USHORT] = "ushort", [TF_INT] = "int",      [TF_UINT] = "uint",
    [TF_FLOAT] = "float",   [TF_DOUBLE] = "double"};

/// Those of the columns that follow so many coordinates.
static void write_column_names(FILE *stream, const tf_columns *columns,
                               int after)
{
    for (int i = 0; columns && i < columns->count; i++)
        if (columns->column[i].after == after)
            fprintf(stream, "property %s %s\n",
                    type_names[columns->column[i].type],
                    columns->column[i].name);
}

static void write_properties(FILE *stream, const char *prefix,
                             const tf_columns *columns)
{
    for (int k = 0; k < 3; k++) {
        write_column_names(stream, columns, k);
        fprintf(stream, "property double %s%c\n", prefix, "xyz"[k]);
    }
    write_column_names(stream, columns, 3);
}

static void write_ply_header(FILE *stream, const tf_mesh_content *content,
                             tf_mesh_format format)
{
    const tf_mesh *mesh = &content->mesh;
    fprintf(stream, "ply\nformat %s 1.0\n", encodings[format]);
    if (content->comment)
        fprintf(stream, "comment %s\n", content->comment);
    fprintf(stream, "element vertex %d\n", mesh->vertices);
    write_properties(stream, "", content->columns);
    if (content->velocity)
        write_properties(stream, "v", NULL);
    if (mesh->triangles > 0)
        fprintf(stream,
                "element face %d\nproperty list uchar int vertex_indices\n",
                mesh->triangles);
    if (mesh->edges > 0)
        fprintf(stream,
                "element edge %d\nproperty int vertex1\nproperty int vertex2\n",
                mesh->edges);
    fputs("end_header\n", stream);
}

//: Write numbers in an encoding
/// How numbers are written.
typedef struct encoder {
    FILE *stream;
    tf_mesh_format format;
} encoder;

static void write_bytes(const encoder *to, uint64_t bits, int count)
{
    bool big = to->format == TF_PLY_BIG_ENDIAN;
    for (int i = 0; i < count; i++) {
        int place = big ? count - 1 - i : i;
        fputc((int)(bits >> 8 * place & 0xff), to->stream);
    }
}

static bool is_text(const encoder *to)
{
    return to->format == TF_OBJ || to->format == TF_PLY_TEXT;
}

/// 17 digits determine a double.
static void write_double(const encoder *to, double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    if (is_text(to))
        fprintf(to->stream, "%.17g", number);
    else
        write_bytes(to, bits, 8);
}

/// Before a number in text, but for the first of its line.
static void write_blank(const encoder *to)
{
    if (is_text(to))
        fputc(' ', to->stream);
}

/// In the plane the third is 0.
static void write_coordinates(const encoder *to, const double x[], int axes)
{
    for (int k = 0; k < 3; k++) {
        if (k > 0)
            write_blank(to);
        write_double(to, k < axes ? x[k] : 0);
    }
}

/// OBJ counts from 1.
static void write_indices(const encoder *to, const int index[], int count)
{
    int first = to->format == TF_OBJ;
    for (int i = 0; i < count; i++)
        if (is_text(to))
            fprintf(to->stream, i > 0 ? " %d" : "%d", index[i] + first);
        else
            write_bytes(to, (uint64_t)index[i], 4);
}

//: Write the values of columns
/// 9 digits determine a float.  What a type cannot hold becomes what it can.
static void write_float(const encoder *to, double value)
{
    float number = (float)value;
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    if (is_text(to))
        fprintf(to->stream, "%.9g", value);
    else
        write_bytes(to, bits, 4);
}

static void write_integer(const encoder *to, tf_number_type type, double value)
{
    static const int bytes[] = {1, 1, 2, 2, 4, 4};
    static const double least[] = {INT8_MIN, 0, INT16_MIN, 0, INT32_MIN, 0};
    static const double most[] = {INT8_MAX,   UINT8_MAX, INT16_MAX,
                                  UINT16_MAX, INT32_MAX, UINT32_MAX};
    double legal = fmin(fmax(value, least[type]), most[type]);
    int64_t number = isnan(value) ? 0 : (int64_t)legal;
    if (is_text(to))
        fprintf(to->stream, "%" PRId64, number);
    else
        write_bytes(to, (uint64_t)number, bytes[type]);
}

static void write_value(const encoder *to, tf_number_type type, double value)
{
    if (type == TF_DOUBLE)
        write_double(to, value);
    else if (type == TF_FLOAT)
        write_float(to, value);
    else
        write_integer(to, type, value);
}

//: Write a row in its order
static void write_row(const encoder *to, const tf_columns *columns,
                      const double x[], int row)
{
    const double *value = tf_columns_row(columns, row);
    for (int k = 0, written = 0; k <= 3; k++) {
        for (int i = 0; i < columns->count; i++) {
            if (columns->column[i].after != k)
                continue;
            if (written++ > 0)
                write_blank(to);
            write_value(to, columns->column[i].type, value[i]);
        }
        if (k < 3 && written++ > 0)
            write_blank(to);
        if (k < 3)
            write_double(to, x[k]);
    }
}

//: Write the color of a vertex of OBJ
/// From 0 to 1; those of columns of small integers are parts of the greatest.
static void write_color(const encoder *to, const tf_columns *columns, int row)
{
    static const char *const names[] = {"red", "green", "blue"};
    static const double most[] = {[TF_UCHAR] = 255, [TF_USHORT] = 65535};
    for (int i = 0; i < 3; i++)
        if (tf_columns_find(columns, names[i]) < 0)
            return;
    for (int i = 0; i < 3; i++) {
        int column = tf_columns_find(columns, names[i]);
        tf_number_type type = columns->column[column].type;
        bool part = type == TF_UCHAR || type == TF_USHORT;
        write_blank(to);
        write_double(to, tf_columns_row(columns, row)[column] /
                             (part ? most[type] : 1));
    }
}

//: Write the items of a mesh
/// In OBJ with the word that begins its line.
static void begin_item(const encoder *to, const char *word)
{
    if (to->format == TF_OBJ)
        fputs(word, to->stream);
}

static void end_item(const encoder *to)
{
    if (is_text(to))
        fputc('\n', to->stream);
}

static void write_vertex(const encoder *to, const tf_mesh_content *content,
                         int vertex)
{
    int axes = content->mesh.axes;
    size_t place = (size_t)axes * (size_t)vertex;
    const double *x = content->position + place;
    begin_item(to, "v ");
    if (content->columns && to->format != TF_OBJ)
        write_row(to, content->columns, x, vertex);
    else
        write_coordinates(to, x, axes);
    if (content->columns && to->format == TF_OBJ)
        write_color(to, content->columns, vertex);
    if (content->velocity && to->format != TF_OBJ) {
        write_blank(to);
        write_coordinates(to, content->velocity + place, axes);
    }
    end_item(to);
}

/// PLY has the number of corners first.
static void write_triangle(const encoder *to, const int corner[3])
{
    begin_item(to, "f ");
    if (to->format == TF_PLY_TEXT)
        fputs("3 ", to->stream);
    else if (!is_text(to))
        fputc(3, to->stream);
    write_indices(to, corner, 3);
    end_item(to);
}

static void write_edge(const encoder *to, const int end[2])
{
    begin_item(to, "l ");
    write_indices(to, end, 2);
    end_item(to);
}

//: Write a mesh
void tf_mesh_write(FILE *stream, const tf_mesh_content *content,
                   tf_mesh_format format)
{
    const tf_mesh *mesh = &content->mesh;
    const encoder to = {stream, format};
    if (format != TF_OBJ)
        write_ply_header(stream, content, format);
    for (int v = 0; v < mesh->vertices; v++)
        write_vertex(&to, content, v);
    for (int t = 0; t < mesh->triangles; t++)
        write_triangle(&to, mesh->triangle + 3 * (size_t)t);
    for (int e = 0; e < mesh->edges; e++)
        write_edge(&to, mesh->edge + 2 * (size_t)e);
}
