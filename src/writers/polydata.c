//: Include what PolyData needs
#include "writers/polydata.h"

#include "writers/encoder.h"

#include <inttypes.h>
#include <string.h>

//: Make PolyData
tf_polydata_cells tf_polydata_cells_of(size_t cells, int corners,
                                       const int corner[])
{
    return (tf_polydata_cells){.points = {.type = TF_INT,
                                          .components = corners,
                                          .rows = cells,
                                          .integer = corner,
                                          .step = 1},
                               .ends = {.type = TF_INT,
                                        .components = 1,
                                        .rows = cells,
                                        .first = corners,
                                        .step = corners}};
}

tf_polydata tf_polydata_of(size_t points, const double position[], int axes)
{
    const tf_polydata_cells none = tf_polydata_cells_of(0, 1, NULL);
    return (tf_polydata){.position = {.type = TF_DOUBLE,
                                      .components = 3,
                                      .rows = points,
                                      .number = position,
                                      .stride = (size_t)axes},
                         .verts = none,
                         .lines = none,
                         .polys = none};
}

void tf_polydata_add(tf_polydata *data, const tf_polydata_array *array)
{
    if (data->arrays < TF_MOST_ARRAYS)
        data->array[data->arrays++] = *array;
}

//: List the arrays of PolyData
enum {
    ALL_ARRAYS = TF_MOST_ARRAYS + 7
};

/// In the order in which they are written.
static int list_arrays(const tf_polydata *data,
                       const tf_polydata_array *list[ALL_ARRAYS])
{
    int count = 0;
    for (int i = 0; i < data->arrays; i++)
        list[count++] = &data->array[i];
    list[count++] = &data->position;
    const tf_polydata_cells *cells[] = {&data->verts, &data->lines,
                                        &data->polys};
    for (int i = 0; i < 3; i++) {
        list[count++] = &cells[i]->points;
        list[count++] = &cells[i]->ends;
    }
    return count;
}

static uint64_t bytes_of(const tf_polydata_array *array)
{
    return (uint64_t)array->rows * (uint64_t)array->components *
           (uint64_t)tf_number_bytes(array->type);
}

//: Describe an array
typedef struct describer {
    FILE *stream;
    uint64_t offset; ///< of the next array
} describer;

/// As the value of an attribute; what is beyond printable ASCII becomes _.
static void write_escaped(FILE *stream, const char *text)
{
    for (; *text; text++)
        if (strchr("&<>\"", *text))
            fprintf(stream, "&#%d;", *text);
        else
            fputc(*text >= ' ' && *text < 127 ? *text : '_', stream);
}

/// The points of cells are in a row.
static void describe(describer *d, const tf_polydata_array *array,
                     const char *name, int components)
{
    static const char *const types[] = {
        [TF_CHAR] = "Int8",     [TF_UCHAR] = "UInt8",   [TF_SHORT] = "Int16",
        [TF_USHORT] = "UInt16", [TF_INT] = "Int32",     [TF_UINT] = "UInt32",
        [TF_FLOAT] = "Float32", [TF_DOUBLE] = "Float64"};
    fprintf(d->stream, "<DataArray type=\"%s\" Name=\"", types[array->type]);
    write_escaped(d->stream, name);
    fprintf(d->stream,
            "\" NumberOfComponents=\"%d\" format=\"appended\" "
            "offset=\"%" PRIu64 "\"/>\n",
            components, d->offset);
    d->offset += sizeof(uint64_t) + bytes_of(array);
}

static void describe_cells(describer *d, const char *kind,
                           const tf_polydata_cells *cells)
{
    fprintf(d->stream, "<%s>\n", kind);
    describe(d, &cells->points, "connectivity", 1);
    describe(d, &cells->ends, "offsets", 1);
    fprintf(d->stream, "</%s>\n", kind);
}

//: Describe PolyData
static void write_head(FILE *stream, const tf_polydata *data)
{
    describer d = {.stream = stream};
    fprintf(stream,
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
            "<PolyData>\n<Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"%zu\" "
            "NumberOfLines=\"%zu\" NumberOfStrips=\"0\" "
            "NumberOfPolys=\"%zu\">\n<PointData>\n",
            data->position.rows, data->verts.ends.rows, data->lines.ends.rows,
            data->polys.ends.rows);
    for (int i = 0; i < data->arrays; i++)
        describe(&d, &data->array[i], data->array[i].name,
                 data->array[i].components);
    fputs("</PointData>\n<Points>\n", stream);
    describe(&d, &data->position, "Points", 3);
    fputs("</Points>\n", stream);
    describe_cells(&d, "Verts", &data->verts);
    describe_cells(&d, "Lines", &data->lines);
    describe_cells(&d, "Polys", &data->polys);
    fputs("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_", stream);
}

//: Write the numbers of an array
static void write_number(const tf_encoder *to, const tf_polydata_array *array,
                         size_t row, size_t component)
{
    size_t place = row * (size_t)array->components + component;
    if (array->number)
        tf_encode(to, array->type,
                  component < array->stride
                      ? array->number[row * array->stride + component]
                      : 0);
    else
        tf_encode_integer(to,
                          array->integer
                              ? array->integer[place]
                              : array->first + (int64_t)place * array->step,
                          tf_number_bytes(array->type));
}

static void write_array(const tf_encoder *to, const tf_polydata_array *array)
{
    tf_encode_integer(to, (int64_t)bytes_of(array), sizeof(uint64_t));
    for (size_t row = 0; row < array->rows; row++)
        for (int i = 0; i < array->components; i++)
            write_number(to, array, row, (size_t)i);
}

//: Write PolyData
void tf_polydata_write(FILE *stream, const tf_polydata *data)
{
    const tf_encoder to = {.stream = stream};
    const tf_polydata_array *list[ALL_ARRAYS];
    int count = list_arrays(data, list);
    write_head(stream, data);
    for (int i = 0; i < count; i++)
        write_array(&to, list[i]);
    fputs("\n</AppendedData>\n</VTKFile>\n", stream);
}
