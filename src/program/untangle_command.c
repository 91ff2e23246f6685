//: Include what the command untangle needs
#include "files/masses.h"
#include "program/command.h"
#include "program/mesh_output.h"
#include "program/progress.h"
#include "program/reports.h"
#include "program/surface_output.h"
#include "response/resolver.h"
#include "scenes/flaws.h"
#include "scenes/frames.h"
#include "threads/threads.h"
#include "untangle/untangle.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

//: Hold what untangle does
typedef struct untangling {
    const tf_request *request;
    tf_threads *threads;
    tf_frames frames;
    tf_columns columns; ///< what the vertices of the file have
    tf_source source;   ///< the file itself
    bool *fixed;        ///< of each vertex, or NULL
    double *in, *best;  ///< positions: the file's, and those with the fewest
                        ///< intersections
    tf_untangled done;
    tf_destination out;
    tf_progress_line progress;
} untangling;

static const tf_mesh_file *file_of(const untangling *u)
{
    return tf_frames_file(&u->frames);
}

//: Read the fixed vertices
static bool read_fixed(untangling *u)
{
    size_t vertices = (size_t)tf_mesh_file_vertices(file_of(u));
    if (!u->request->fixed)
        return true;
    double *mass = malloc((vertices + 1) * sizeof *mass);
    u->fixed = calloc(vertices + 1, sizeof *u->fixed);
    bool good = mass && u->fixed;
    if (!good)
        tf_mesh_file_fault_in_memory(file_of(u));
    for (size_t v = 0; v < vertices && good; v++)
        mass[v] = 1;
    good = good && tf_fixed_read(u->request->fixed, (int)vertices, mass,
                                 &u->frames.fault);
    for (size_t v = 0; v < vertices && good; v++)
        u->fixed[v] = mass[v] == 0;
    free(mass);
    return good;
}

//: Show the progress of untangling
static bool show_progress(void *context, const tf_stage *stage)
{
    char things[64];
    snprintf(things, sizeof things, "%s", stage->name);
    tf_progress_line_show(context, (long)stage->done, things);
    return true;
}

//: Untangle the surface of a file
static size_t bytes_of(const untangling *u)
{
    tf_motion rest = tf_frames_motion(&u->frames);
    return (size_t)rest.axes * (size_t)rest.vertices * sizeof(double);
}

/// From the positions of the file, with the triangles that its polygons have by
/// now.
static bool untangle(untangling *u, tf_untangle_report *report)
{
    tf_untangle_options how = {.size = sizeof how,
                               .fixed = u->fixed,
                               .parallel = tf_threads_parallel(u->threads),
                               .progress = show_progress,
                               .context = &u->progress};
    tf_motion rest = tf_frames_motion(&u->frames);
    tf_resolver *resolver = NULL;
    tf_error error;
    tf_status status = tf_resolver_create(u->frames.surface, &resolver);
    if (status != TF_OK)
        return tf_status_fault(file_of(u), status);
    status = tf_untangle(resolver, rest.vertices, u->in,
                         tf_frames_end(&u->frames), &how, report, NULL, &error);
    tf_resolver_free(resolver);
    return status == TF_OK || tf_frames_fault(&u->frames, &error);
}

//: Divide polygons where vertices are now
static bool count_left(untangling *u, size_t *left)
{
    tf_motion rest = tf_frames_motion(&u->frames);
    tf_check_options how = {.parallel = tf_threads_parallel(u->threads)};
    tf_crossings found;
    tf_error error;
    tf_status status = tf_surface_check(u->frames.surface, rest.vertices,
                                        rest.end, &how, &found, &error);
    *left = status == TF_OK ? found.count : 0;
    return status == TF_OK || tf_frames_fault(&u->frames, &error);
}

/// Then counts what is left, as it is for those who read the file.
static bool divide(untangling *u, size_t *left)
{
    tf_frames_change(&u->frames);
    return (tf_mesh_file_polygons(file_of(u)) == 0 ||
            tf_frames_divide(&u->frames)) &&
           count_left(u, left);
}

//: Untangle until the divided polygons are clear
enum {
    PASSES = 10
};

static bool begin(untangling *u)
{
    size_t bytes = bytes_of(u);
    u->in = malloc(bytes + 1);
    u->best = malloc(bytes + 1);
    if (!u->in || !u->best)
        return tf_mesh_file_fault_in_memory(file_of(u));
    memcpy(u->in, tf_frames_end(&u->frames), bytes);
    memcpy(u->best, u->in, bytes);
    return count_left(u, &u->done.before);
}

/// Each pass untangles with the triangles that the last one has led to.  Without
/// polygons there is but one.
static bool untangle_all(untangling *u)
{
    size_t least = u->done.before + 1, left = least;
    int passes = tf_mesh_file_polygons(file_of(u)) > 0 ? PASSES : 1;
    for (int pass = 0; pass < passes && least > 0; pass++) {
        tf_untangle_report report;
        if (!untangle(u, &report) || !divide(u, &left))
            return false;
        if (left >= least)
            continue;
        least = left;
        u->done.report = report;
        memcpy(u->best, tf_frames_end(&u->frames), bytes_of(u));
    }
    memcpy(tf_frames_end(&u->frames), u->best, bytes_of(u));
    return divide(u, &u->done.left);
}

//: List the intersections that are left
/// Where the mesh is not.
static bool list(untangling *u)
{
    tf_motion rest = tf_frames_motion(&u->frames);
    FILE *stream =
        tf_destination_is_standard(u->request->out) ? stderr : stdout;
    tf_crossings found;
    return u->done.left == 0 ||
           (tf_surface_check(u->frames.surface, rest.vertices, rest.end, NULL,
                             &found, NULL) == TF_OK &&
            tf_surface_output_append(stream, *u->request->format, file_of(u),
                                     u->request->out, &found)) ||
           tf_fault_set_unwritten(&u->frames.fault, "the list", errno);
}

//: Name the rungs that moved something
static void name_rungs(tf_untangled *done)
{
    static const char *const names[] = {"push",  "smooth", "again",
                                        "apart", "relax",  "return"};
    done->rungs[0] = '\0';
    for (int i = 0; i < 6; i++)
        if (done->report.rungs >> i & 1) {
            strcat(done->rungs, done->rungs[0] ? " " : "");
            strcat(done->rungs, names[i]);
        }
    done->rung_names = done->rungs[0] ? done->rungs : "none";
}

//: Untangle and write
static bool write(untangling *u)
{
    const tf_mesh_file *file = file_of(u);
    tf_mesh_content content = {.mesh = tf_mesh_file_elements(file, 3),
                               .position = file->position.item,
                               .columns = &u->columns,
                               .from = file};
    tf_mesh_report report = {*u->request->format, tf_untangled_fields,
                             &u->done};
    u->done.status = u->done.left > 0     ? "tangled"
                     : u->done.before > 0 ? "untangled"
                                          : "clear";
    name_rungs(&u->done);
    return tf_mesh_output_write(&u->out, &content, file, &report) && list(u);
}

static bool do_all(untangling *u)
{
    u->frames.columns = &u->columns;
    u->frames.source = &u->source;
    if (!tf_frames_next(&u->frames, u->request->operand[0]) || !read_fixed(u) ||
        !tf_mesh_output_begin(&u->out, u->request->out, file_of(u),
                              &u->frames.fault) ||
        !begin(u))
        return false;
    double start = tf_clock_seconds();
    bool good = untangle_all(u);
    u->done.seconds = tf_clock_seconds() - start;
    tf_progress_line_end(&u->progress);
    return good && write(u);
}

//: Run the command untangle
static int run(const tf_request *request)
{
    untangling u = {.request = request,
                    .progress = tf_progress_line_begin(true)};
    tf_threads_create(request->threads, &u.threads);
    bool good = do_all(&u);
    tf_fault_print(&u.frames.fault, "tanglefree");
    tf_destination_end(&u.out);
    free(u.fixed);
    free(u.in);
    free(u.best);
    tf_frames_free(&u.frames);
    tf_columns_free(&u.columns);
    tf_source_free(&u.source);
    tf_threads_free(u.threads);
    return !good ? 2 : u.done.left > 0;
}

const tf_command tf_untangle_command = {
    .set = TF_UNTANGLE,
    .name = "untangle",
    .purpose = "make a mesh clear that intersects itself",
    .operands = "IN",
    .least = 1,
    .most = 1,
    .wanted = "one file is required: IN",
    .description = tf_untangle_description,
    .run = run,
};
