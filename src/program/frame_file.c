//: Include what the frames of a simulation need
#define _GNU_SOURCE // memmem, open_memstream
#include "program/frame_file.h"

#include "files/mesh_writer.h"

#include <errno.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

//: Give a frame three axes
/// In the plane only copies of the coordinates have three axes.
typedef struct frame {
    tf_mesh_file mesh; ///< its elements are those of the simulation
    double *velocity;
} frame;

static double *deepen(int axes, int vertices, const double x[])
{
    double *deep = calloc(3 * (size_t)vertices, sizeof *deep);
    for (int v = 0; v < vertices && deep; v++)
        memcpy(deep + (ptrdiff_t)3 * v, x + (ptrdiff_t)axes * v,
               sizeof *deep * (size_t)axes);
    return deep;
}

static void frame_free(frame *of)
{
    free(of->mesh.position.item);
    free(of->velocity);
}

static bool frame_make(frame *of, const tf_simulation *s)
{
    const tf_body *body = &s->stage.body;
    int axes = body->axes, vertices = body->vertices;
    of->mesh = (tf_mesh_file){
        .position.item = deepen(axes, vertices, s->position),
        .position.count = 3 * (size_t)vertices,
        .triangle.item = body->triangle,
        .edge.item = body->edge,
        .vertex_place.count = (size_t)vertices,
        .triangle_place.count = (size_t)body->triangles,
        .edge_place.count = (size_t)body->edges,
    };
    of->velocity = deepen(axes, vertices, s->velocity);
    return of->mesh.position.item && of->velocity;
}

//: Write a frame of a simulation
#define COMMENT "tanglefree simulate %s --size %d, step %d, of the script %d"

bool tf_frame_write(FILE *stream, const tf_simulation *simulation)
{
    frame made;
    char comment[200];
    bool good = frame_make(&made, simulation);
    snprintf(comment, sizeof comment, COMMENT, simulation->scene->name,
             simulation->size, simulation->step, simulation->scripted);
    if (good)
        tf_mesh_write_state(stream, &made.mesh,
                            &(tf_mesh_state){comment, made.velocity});
    else
        errno = ENOMEM;
    frame_free(&made);
    return good;
}

//: Read a whole frame
typedef struct content {
    char *text;
    size_t size;
} content;

/// What a simulation writes in its present state.
static bool write_content(content *of, const tf_simulation *s)
{
    FILE *stream = open_memstream(&of->text, &of->size);
    bool good = stream && tf_frame_write(stream, s);
    return stream && fclose(stream) == 0 && good;
}

/// Reads no more than `most` bytes; a zero follows them.
static bool read_content(content *of, const char *path, size_t most)
{
    FILE *stream = fopen(path, "rb");
    of->text = stream ? malloc(most + 1) : NULL;
    if (of->text) {
        of->size = fread(of->text, 1, most, stream);
        of->text[of->size] = '\0';
    }
    bool good = of->text && !ferror(stream);
    if (stream)
        fclose(stream);
    return good;
}

//: Take the state of a frame
static double gather_double(const char *bytes)
{
    uint64_t bits = 0;
    for (int i = 0; i < 8; i++)
        bits |= (uint64_t)(unsigned char)bytes[i] << 8 * i;
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/// The vertices follow the header, six numbers each.
static bool take_vertices(tf_simulation *s, const content *read)
{
    static const char mark[] = "\nend_header\n";
    int axes = s->stage.body.axes, vertices = s->stage.body.vertices;
    const char *at = memmem(read->text, read->size, mark, sizeof mark - 1);
    if (!at || (size_t)(read->text + read->size - at) <
                   sizeof mark + 48 * (size_t)vertices)
        return false;
    at += sizeof mark - 1;
    for (int v = 0; v < vertices; v++)
        for (int k = 0; k < axes; k++) {
            const char *place = at + (ptrdiff_t)48 * v + (ptrdiff_t)8 * k;
            s->position[axes * v + k] = gather_double(place);
            s->velocity[axes * v + k] = gather_double(place + 24);
        }
    return true;
}

static bool take_state(tf_simulation *s, const content *read)
{
    return sscanf(
               read->text,
               "ply\nformat binary_little_endian 1.0\ncomment "
               "tanglefree simulate %*s --size %*d, step %d, of the script %d",
               &s->step, &s->scripted) == 2 &&
           s->step >= 0 && s->scripted >= 0 && take_vertices(s, read);
}

//: Read a frame of a simulation
/// It is one if the simulation in that state would write the same bytes.
static tf_frame_fault compare_content(tf_simulation *s, const content *read)
{
    content written = {0};
    if (!take_state(s, read))
        return TF_FRAME_FOREIGN;
    if (!write_content(&written, s)) {
        free(written.text);
        return TF_FRAME_UNREADABLE;
    }
    bool same = written.size == read->size &&
                memcmp(written.text, read->text, read->size) == 0;
    free(written.text);
    return same ? TF_FRAME_GOOD : TF_FRAME_FOREIGN;
}

tf_frame_fault tf_frame_read(tf_simulation *simulation, const char *path)
{
    const tf_body *body = &simulation->stage.body;
    size_t most = 1000 + 48 * (size_t)body->vertices +
                  13 * (size_t)body->triangles + 8 * (size_t)body->edges;
    content read = {0};
    tf_frame_fault fault = read_content(&read, path, most)
                               ? compare_content(simulation, &read)
                               : TF_FRAME_UNREADABLE;
    free(read.text);
    return fault;
}
