//: Include what simulated flows need
#include "program/flow_simulated.h"

#include "files/mesh_file.h"
#include "files/mesh_writer.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static tf_flow_simulated *flow_of(tf_simulated *of)
{
    return (tf_flow_simulated *)of;
}

static const tf_flow_simulated *flow_in(const tf_simulated *of)
{
    return (const tf_flow_simulated *)of;
}

//: Make a step of a flow for the user
static void count_report(tf_flow_simulated *f)
{
    const tf_flow_report *last = &f->last;
    f->contacts += last->response.contacts;
    f->failsafes += last->response.rounds[TF_FAILSAFE] > 0;
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        f->reconnected.tried[i][TF_COMMITTED] +=
            last->reconnected.tried[i][TF_COMMITTED];
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        f->seconds[i] += last->seconds[i];
    f->steps++;
}

static tf_status advance_flow(tf_simulated *of, const tf_step_way *way,
                              char words[TF_SIMULATED_NAME])
{
    tf_flow_simulated *f = flow_of(of);
    tf_status status = tf_flow_simulation_step(f->simulation, way, &f->last);
    if (status == TF_OK &&
        !tf_flow_measure(f->simulation->surface, &f->measures))
        status = TF_OUT_OF_MEMORY;
    if (status != TF_OK)
        return status;
    of->step = f->simulation->step;
    count_report(f);
    snprintf(words, TF_SIMULATED_NAME, "%d triangles", f->measures.triangles);
    return TF_OK;
}

//: Write what a step of a flow did
#define OUTCOMES(name)                                                         \
    name "_done," name "_impossible," name "_flattened," name                  \
         "_overlapped," name "_passed_vertex," name "_passed_edge," name       \
         "_passed_triangle,"

static const char flow_columns[] =
    "vertices,triangles,components,genus,rims,area,volume," OUTCOMES("split")
        OUTCOMES("collapse") OUTCOMES("flip") OUTCOMES("smooth")
            OUTCOMES("shift") OUTCOMES("merge") OUTCOMES("pinch")
                OUTCOMES("drop") "merge_gain,pinch_gain,drop_gain,contacts,"
                                 "zone_rounds,failsafe_rounds,moved,"
                                 "improve_seconds,reconnect_seconds,"
                                 "advance_seconds";

//: Write a report of a flow
static void write_outcomes(FILE *table, const size_t tried[TF_OUTCOMES])
{
    for (int i = TF_COMMITTED; i < TF_OUTCOMES; i++)
        fprintf(table, ",%zu", tried[i]);
}

static void write_flow_report(FILE *table, const tf_flow_report *report)
{
    for (int i = 0; i < TF_OPERATIONS; i++)
        write_outcomes(table, report->tried[i]);
    write_outcomes(table, report->shifted);
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        write_outcomes(table, report->reconnected.tried[i]);
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        fprintf(table, ",%.6g", report->reconnected.gained[i]);
    const tf_response_report *response = &report->response;
    fprintf(table, ",%zu,%d,%d,%d", response->contacts,
            response->rounds[TF_ZONES], response->rounds[TF_FAILSAFE],
            response->moved);
}

//: Write a line of a flow
static void write_flow_line(FILE *table, const tf_simulated *of)
{
    const tf_flow_measures *m = &flow_in(of)->measures;
    fprintf(table, ",%d,%d,%d,%d,%d,%.9g,%.12g", m->vertices, m->triangles,
            m->components, m->genus, m->rims, m->area, m->volume);
    write_flow_report(table, &flow_in(of)->last);
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        fprintf(table, ",%.6f", flow_in(of)->last.seconds[i]);
}

//: Sum a flow up
static int summarize_flow(const tf_simulated *of,
                          tf_entry entry[TF_SIMULATED_ENTRIES])
{
    static const char *const parts[] = {"improve seconds", "reconnect seconds",
                                        "advance seconds"};
    static const char *const changes[] = {"merges", "pinches", "drops"};
    const tf_flow_simulated *f = flow_in(of);
    const tf_flow_measures *m = &f->measures;
    int count = 0;
    entry[count++] = tf_entry_count("steps", (size_t)f->steps);
    entry[count++] = tf_entry_count("vertices", (size_t)m->vertices);
    entry[count++] = tf_entry_count("triangles", (size_t)m->triangles);
    entry[count++] = tf_entry_count("components", (size_t)m->components);
    entry[count++] = tf_entry_count("genus", (size_t)m->genus);
    entry[count++] = tf_entry_number("area", m->area);
    entry[count++] = tf_entry_number("volume", m->volume);
    for (int i = 0; i < TF_RECONNECTIONS; i++)
        entry[count++] =
            tf_entry_count(changes[i], f->reconnected.tried[i][TF_COMMITTED]);
    entry[count++] = tf_entry_count("contacts", f->contacts);
    entry[count++] = tf_entry_count("failsafe steps", (size_t)f->failsafes);
    for (int i = 0; i < TF_FLOW_PARTS; i++)
        entry[count++] = tf_entry_number(parts[i], f->seconds[i]);
    return count;
}

//: Copy the surface of a flow
static bool copy_surface(const tf_adaptive_surface *surface, tf_mesh_file *copy)
{
    tf_mesh mesh = tf_adaptive_mesh(surface);
    size_t numbers = 3 * (size_t)mesh.vertices;
    size_t corners = 3 * (size_t)mesh.triangles;
    *copy = (tf_mesh_file){
        .position = {.item = malloc(numbers * sizeof(double)),
                     .count = numbers},
        .triangle = {.item = malloc(corners * sizeof(int)), .count = corners},
        .vertex_place.count = (size_t)mesh.vertices,
        .triangle_place.count = (size_t)mesh.triangles,
    };
    if (!copy->position.item || !copy->triangle.item)
        return false;
    memcpy(copy->position.item, tf_adaptive_positions(surface),
           numbers * sizeof(double));
    memcpy(copy->triangle.item, mesh.triangle, corners * sizeof(int));
    return true;
}

//: Write a frame of a flow
#define FLOW_COMMENT "tanglefree simulate %s, step %d"

static bool write_flow_frame(FILE *stream, const tf_simulated *of)
{
    tf_mesh_file copy;
    char comment[TF_SIMULATED_NAME + 60];
    snprintf(comment, sizeof comment, FLOW_COMMENT, of->name, of->step);
    bool good = copy_surface(flow_in(of)->simulation->surface, &copy);
    if (good)
        tf_mesh_write_state(stream, &copy, &(tf_mesh_state){comment, NULL});
    else
        errno = ENOMEM;
    tf_mesh_file_free(&copy);
    return good;
}

//: Read a frame of a flow
/// The step in the comment of a frame, if it is one of this scene; or -1, with
/// errno if it could not be read.
static int read_step(const tf_simulated *of, const char *path)
{
    char head[TF_SIMULATED_NAME + 150] = "", expected[sizeof head];
    FILE *stream = fopen(path, "rb");
    if (!stream)
        return -1;
    errno = 0;
    size_t size = fread(head, 1, sizeof head - 1, stream);
    int cause = ferror(stream) ? errno : 0, step = -1;
    fclose(stream);
    head[size] = '\0';
    const char *mark = strstr(head, ", step ");
    if (mark)
        step = (int)strtol(mark + 7, NULL, 10);
    snprintf(expected, sizeof expected,
             "ply\nformat binary_little_endian 1.0\ncomment " FLOW_COMMENT "\n",
             of->name, step);
    errno = cause;
    return strncmp(head, expected, strlen(expected)) == 0 ? step : -1;
}

//: Go on from a frame of a flow
static tf_status restore_flow(tf_flow_simulation *s, int step,
                              const tf_mesh_file *file)
{
    tf_mesh mesh = {.axes = 3,
                    .vertices = tf_mesh_file_vertices(file),
                    .triangles = tf_mesh_file_triangles(file),
                    .triangle = file->triangle.item,
                    .edges = tf_mesh_file_edges(file),
                    .edge = file->edge.item};
    return tf_flow_simulation_restore(s, step, &mesh, file->position.item);
}

static tf_frame_fault read_flow_frame(tf_simulated *of, const char *path)
{
    tf_flow_simulated *f = flow_of(of);
    int step = read_step(of, path);
    if (step < 0)
        return errno ? TF_FRAME_UNREADABLE : TF_FRAME_FOREIGN;
    tf_mesh_file file;
    bool good = tf_mesh_file_read(&file, path) &&
                restore_flow(f->simulation, step, &file) == TF_OK &&
                tf_flow_measure(f->simulation->surface, &f->measures);
    of->step = step;
    tf_mesh_file_free(&file);
    return good ? TF_FRAME_GOOD : TF_FRAME_FOREIGN;
}

//: Describe what simulated flows do
static void free_flow(tf_simulated *of)
{
    tf_flow_simulation_free(flow_of(of)->simulation);
    free(of);
}

static const tf_simulated_kind flow_kind = {
    .columns = flow_columns,
    .advance = advance_flow,
    .write_line = write_flow_line,
    .write_frame = write_flow_frame,
    .read_frame = read_flow_frame,
    .summarize = summarize_flow,
    .free = free_flow,
};

//: Simulate a flow
/// Names a scene with as many digits as the length needs.
static void name_flow(tf_simulated *of, const char *scene, double edge)
{
    int digits = 1;
    do
        snprintf(of->name, sizeof of->name, "%s --edge %.*g", scene, digits,
                 edge);
    while (strtod(strrchr(of->name, ' '), NULL) != edge && digits++ < 17);
}

tf_status tf_flow_simulate(const tf_flow_scene *scene, double edge,
                           tf_simulated **simulated)
{
    tf_flow_simulated *f = calloc(1, sizeof *f);
    if (!f)
        return TF_OUT_OF_MEMORY;
    f->base = (tf_simulated){.kind = &flow_kind, .length = scene->step};
    name_flow(&f->base, scene->name, edge);
    tf_status status = tf_flow_simulation_create(scene, edge, &f->simulation);
    if (status == TF_OK &&
        !tf_flow_measure(f->simulation->surface, &f->measures))
        status = TF_OUT_OF_MEMORY;
    if (status == TF_OK)
        *simulated = &f->base;
    else
        free_flow(&f->base);
    return status;
}
