//: Include what the frames of a simulation need
#define _GNU_SOURCE // memmem, open_memstream
#include "program/frame_file.h"

#include "formats/mesh_reader.h"
#include "writers/mesh_writer.h"

#include <errno.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

//: Name a simulation
/// With as many digits as it needs.
static void describe_resolution(const tf_simulation *simulation, size_t room,
                                char *text)
{
    int digits = 6;
    do
        snprintf(text, room, " --%s %.*g", simulation->scene->kind->option,
                 digits, simulation->resolution);
    while (strtod(strrchr(text, ' '), NULL) != simulation->resolution &&
           digits++ < 17);
}

void tf_simulation_name(const tf_simulation *simulation,
                        char name[TF_SIMULATION_NAME])
{
    const tf_scene *scene = simulation->scene;
    char resolution[40] = "", checksum[30] = "";
    if (simulation->resolution > 0)
        describe_resolution(simulation, sizeof resolution, resolution);
    if (scene->filed)
        snprintf(checksum, sizeof checksum, " (checksum %08x)",
                 scene->checksum);
    snprintf(name, TF_SIMULATION_NAME, "%s%s%s", scene->name, resolution,
             checksum);
}

//: Write a frame of a simulation
static void write_comment(const tf_simulation *s, const tf_snapshot *now,
                          char comment[TF_SIMULATION_NAME + 100])
{
    char name[TF_SIMULATION_NAME], script[50] = "";
    tf_simulation_name(s, name);
    if (now->velocity)
        snprintf(script, sizeof script, ", of the script %d",
                 now->script_steps);
    snprintf(comment, TF_SIMULATION_NAME + 100,
             "tanglefree simulate %s, step %d%s", name, now->step, script);
}

void tf_frame_write(FILE *stream, const tf_simulation *simulation)
{
    tf_snapshot now = simulation->scene->kind->snapshot(simulation);
    char comment[TF_SIMULATION_NAME + 100];
    write_comment(simulation, &now, comment);
    tf_mesh_write(stream,
                  &(tf_mesh_content){.mesh = now.mesh,
                                     .position = now.position,
                                     .velocity = now.velocity,
                                     .comment = comment,
                                     .notes = simulation->scene->notes},
                  TF_PLY_LITTLE_ENDIAN);
}

//: Read a whole frame
typedef struct frame_content {
    char *text; ///< a zero follows it
    size_t size;
} frame_content;

/// What a simulation writes in its present state.
static bool write_content(frame_content *content, const tf_simulation *s)
{
    FILE *stream = open_memstream(&content->text, &content->size);
    if (stream)
        tf_frame_write(stream, s);
    return stream && fclose(stream) == 0;
}

static bool read_content(frame_content *content, const char *path)
{
    struct stat status;
    FILE *stream = fopen(path, "rb");
    if (stream && fstat(fileno(stream), &status) == 0)
        content->text = malloc((size_t)status.st_size + 1);
    if (content->text) {
        content->size = fread(content->text, 1, (size_t)status.st_size, stream);
        content->text[content->size] = '\0';
    }
    bool good = content->text && !ferror(stream);
    if (stream)
        fclose(stream);
    return good;
}

//: Take the numbers of a frame
/// The bytes of a double, the least significant one first.
static double gather_double(const char *bytes)
{
    uint64_t bits = 0;
    for (int i = 0; i < 8; i++)
        bits |= (uint64_t)(unsigned char)bytes[i] << 8 * i;
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/// Three coordinates follow the header for each vertex, and its velocity if
/// `numbers` is 6.  Takes the numbers from the first one on.  To be freed; NULL:
/// they are not there.
static double *take_numbers(const frame_content *read, const tf_mesh *mesh,
                            int numbers, int first)
{
    static const char mark[] = "\nend_header\n";
    const char *at = memmem(read->text, read->size, mark, sizeof mark - 1);
    size_t size = 8 * (size_t)numbers * (size_t)mesh->vertices;
    int count = mesh->axes * mesh->vertices;
    at = at ? at + sizeof mark - 1 : NULL;
    if (!at || (size_t)(read->text + read->size - at) < size)
        return NULL;
    double *x = malloc(sizeof *x * (size_t)(count + 1));
    for (int i = 0; i < count && x; i++)
        x[i] = gather_double(at + 8 * (ptrdiff_t)(i / mesh->axes * numbers +
                                                  i % mesh->axes + first));
    return x;
}

//: Restore the state of a frame
static bool restore(tf_simulation *s, const frame_content *read,
                    tf_snapshot *state)
{
    int numbers = state->velocity ? 6 : 3;
    double *position = take_numbers(read, &state->mesh, numbers, 0);
    double *velocity = take_numbers(read, &state->mesh, numbers, numbers - 3);
    state->position = position;
    state->velocity = velocity;
    bool good =
        position && velocity && s->scene->kind->restore(s, state) == TF_OK;
    free(position);
    free(velocity);
    return good;
}

static bool take_state(tf_simulation *s, const frame_content *read)
{
    tf_fault unused;
    tf_mesh_file file = {0};
    tf_snapshot state = s->scene->kind->snapshot(s);
    bool good = sscanf(read->text,
                       "ply\nformat binary_little_endian 1.0\ncomment "
                       "tanglefree simulate %*[^,], step %d, of the script %d",
                       &state.step, &state.script_steps) > 0 &&
                state.step >= 0 && state.script_steps >= 0 &&
                tf_mesh_file_parse(&file, "frame", read->text, read->size, NULL,
                                   &unused);
    state.mesh = tf_mesh_file_elements(&file, state.mesh.axes);
    good = good && restore(s, read, &state);
    tf_mesh_file_free(&file);
    return good;
}

//: Read a frame of a simulation
/// It is one if the simulation in that state would write the same bytes.
static tf_frame_fault compare_content(tf_simulation *s,
                                      const frame_content *read)
{
    frame_content written = {0};
    if (!take_state(s, read))
        return TF_FRAME_FOREIGN;
    bool good = write_content(&written, s);
    bool same = good && written.size == read->size &&
                memcmp(written.text, read->text, read->size) == 0;
    free(written.text);
    return same ? TF_FRAME_GOOD : good ? TF_FRAME_FOREIGN : TF_FRAME_UNREADABLE;
}

tf_frame_fault tf_frame_read(tf_simulation *simulation, const char *path)
{
    frame_content read = {0};
    tf_frame_fault fault = read_content(&read, path)
                               ? compare_content(simulation, &read)
                               : TF_FRAME_UNREADABLE;
    free(read.text);
    return fault;
}
