//: Include what an advance needs
#include "flow/advance.h"

#include "remesh/measure.h"
#include "response/resolve.h"
#include "surface/surface_memory.h"
#include "surgery/star.h"

#include <string.h>

//: Keep the memory of an advance
void tf_advance_free(tf_flow_advance *advance)
{
    tf_resolver_free(advance->resolver);
    tf_surface_free(advance->elements);
    tf_buffer_free(&advance->room);
}

size_t tf_advance_memory(const tf_flow_advance *advance)
{
    size_t bytes = advance->room.bytes;
    if (advance->elements)
        bytes += tf_surface_memory(advance->elements);
    if (advance->resolver)
        bytes += tf_resolver_memory(advance->resolver);
    return bytes;
}

//: Make room for an advance
/// Room for five vectors of each point, and a mass of each vertex.
static bool reserve_points(tf_flow_advance *a)
{
    size_t numbers = 3 * (size_t)a->points;
    if (!tf_buffer_extend(&a->room, 5 * numbers + (size_t)a->vertices,
                          sizeof(double)))
        return false;
    double **part[] = {&a->start,    &a->stage, &a->normal,
                       &a->velocity, &a->end,   &a->inverse_mass};
    double *next = a->room.data;
    for (size_t i = 0; i < 6; i++, next += numbers)
        *part[i] = next;
    return true;
}

//: Place the points of an advance
static void put_point(double x[], int point, tf_vector value)
{
    memcpy(x + 3 * (ptrdiff_t)point, value.x, sizeof value.x);
}

static void place_points(tf_flow_advance *a)
{
    for (int v = 0; v < a->vertices; v++)
        put_point(a->start, v, tf_position_of(a->surface, v));
    for (int e = 0; e < a->edges; e++) {
        const int *end = a->edge + 2 * (ptrdiff_t)e;
        put_point(a->start, a->vertices + e,
                  tf_middle_of(a->surface, end[0], end[1]));
    }
}

//: Take the triangles of a step
/// Gives the response the triangles that the surface has in this step.
static tf_status take_elements(tf_flow_advance *a)
{
    tf_mesh mesh = tf_mesh_of(a->surface);
    tf_status status = TF_OK;
    if (!a->elements)
        status = tf_surface_create(&mesh, &a->elements, NULL);
    else if (!tf_surface_refill(a->elements, &mesh))
        status = TF_OUT_OF_MEMORY;
    return status == TF_OK && !a->resolver
               ? tf_resolver_create(a->elements, &a->resolver)
               : status;
}

//: Begin an advance
static tf_status goes_on(const tf_flow_advance *a)
{
    return tf_watch_done(a->surface->watch, 0) ? TF_OK : TF_CANCELLED;
}

tf_status tf_advance_begin(tf_flow_advance *a, const tf_flow_options *options,
                           double time, double step)
{
    tf_status status = take_elements(a);
    if (status != TF_OK)
        return status;
    a->options = options;
    a->time = time;
    a->step = step;
    a->edge = tf_surface_edges(a->elements, &a->edges);
    a->vertices = a->surface->vertices;
    a->points = a->vertices + a->edges;
    if (!reserve_points(a))
        return TF_OUT_OF_MEMORY;
    place_points(a);
    return goes_on(a);
}

//: Sum up normals
/// The sum of the normals of the triangles at each vertex, in any positions.
static void sum_normals(const tf_flow_advance *a, const double position[],
                        double normal[])
{
    tf_mesh mesh = tf_mesh_of(a->surface);
    memset(normal, 0, 3 * sizeof *normal * (size_t)a->vertices);
    for (int t = 0; t < mesh.triangles; t++) {
        const int *v = mesh.triangle + 3 * (ptrdiff_t)t;
        tf_shape shape = {{tf_vector_at(position, v[0]),
                           tf_vector_at(position, v[1]),
                           tf_vector_at(position, v[2])}};
        tf_vector own = tf_shape_normal(&shape);
        for (int i = 0; i < 3; i++)
            put_point(normal, v[i],
                      tf_vector_sum(tf_vector_at(normal, v[i]), 1, own));
    }
}

//: Make the normals unit vectors
/// Of length 1, unless it has no length.  The normal of a sliver may be so short
/// that its square underflows, so it is multiplied by a power of two first.
static tf_vector unit_of(tf_vector a)
{
    int exponent;
    double most = fmax(fmax(fabs(a.x[0]), fabs(a.x[1])), fabs(a.x[2]));
    frexp(most, &exponent);
    double scale = ldexp(1, exponent < -1000 ? 1000 : -exponent);
    return most > 0 ? tf_vector_unit(tf_vector_scaled(scale, a)) : a;
}

static void find_normals(tf_flow_advance *a)
{
    sum_normals(a, a->stage, a->normal);
    for (int e = 0; e < a->edges; e++) {
        const int *end = a->edge + 2 * (ptrdiff_t)e;
        put_point(a->normal, a->vertices + e,
                  unit_of(tf_vector_sum(tf_vector_at(a->normal, end[0]), 1,
                                        tf_vector_at(a->normal, end[1]))));
    }
    for (int v = 0; v < a->vertices; v++)
        put_point(a->normal, v, unit_of(tf_vector_at(a->normal, v)));
}

//: Advance by the method of Runge and Kutta
/// To the user's unit of length, or from it.
static void scale_all(const tf_flow_advance *a, double x[], double scale)
{
    for (int i = 0; i < 3 * a->points; i++)
        x[i] *= scale;
}

/// Takes the velocities at `part` of the step, having gone so far along the
/// last ones, and goes on by `weight` of the step along them.
static tf_status go_on(tf_flow_advance *a, double part, double weight)
{
    const tf_flow_options *options = a->options;
    double along = part * a->step;
    for (int i = 0; i < 3 * a->points; i++)
        a->stage[i] = a->start[i] + (part > 0 ? along * a->velocity[i] : 0);
    find_normals(a);
    scale_all(a, a->stage, 1 / a->surface->scale);
    options->velocity(options->context, a->time + along, a->points, a->stage,
                      a->normal, a->velocity);
    scale_all(a, a->velocity, a->surface->scale);
    for (int i = 0; i < 3 * a->points; i++)
        a->end[i] += weight * a->step * a->velocity[i];
    return goes_on(a);
}

tf_status tf_advance_propose(tf_flow_advance *a)
{
    static const double part[] = {0, 0.5, 0.5, 1};
    static const double weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    tf_status status = TF_OK;
    memcpy(a->end, a->start, 3 * sizeof *a->end * (size_t)a->points);
    for (int i = 0; i < 4 && status == TF_OK; i++)
        status = go_on(a, part[i], weight[i]);
    return status;
}

//: Find what chords lose
/// The middle of an edge leaves the chord between its ends.  A triangle whose
/// three sides do so encloses less, by the sum over its sides of a third of its
/// area times their rise; each of its vertices is to restore a third of that.
static void add_errors(const tf_flow_advance *a, int corner, tf_vector rise,
                       double error[])
{
    if (corner == TF_NONE)
        return;
    const int *v = tf_triangle(a->surface, corner / 3);
    tf_shape shape = {{tf_vector_at(a->end, v[0]), tf_vector_at(a->end, v[1]),
                       tf_vector_at(a->end, v[2])}};
    double lost = tf_vector_dot(tf_shape_normal(&shape), rise);
    for (int i = 0; i < 3; i++)
        error[v[i]] += lost / 3;
}

/// The volume error of each vertex, times 6.
static tf_status find_errors(const tf_flow_advance *a, double error[])
{
    memset(error, 0, sizeof *error * (size_t)a->vertices);
    for (int e = 0; e < a->edges; e++) {
        if (e % 1024 == 0 && goes_on(a) != TF_OK)
            return TF_CANCELLED;
        const int *end = a->edge + 2 * (ptrdiff_t)e;
        tf_vector middle =
            tf_vector_scaled(0.5, tf_vector_sum(tf_vector_at(a->end, end[0]), 1,
                                                tf_vector_at(a->end, end[1])));
        tf_vector rise =
            tf_vector_difference(tf_vector_at(a->end, a->vertices + e), middle);
        add_errors(a, tf_find_edge(a->surface, end[0], end[1]), rise, error);
        add_errors(a, tf_find_edge(a->surface, end[1], end[0]), rise, error);
    }
    return TF_OK;
}

//: Restore what chords lose
tf_status tf_advance_restore_volume(tf_flow_advance *a)
{
    double *error = a->velocity,
           most = 0.1 * a->options->edge * a->surface->scale;
    if (find_errors(a, error) != TF_OK)
        return TF_CANCELLED;
    sum_normals(a, a->end, a->normal);
    for (int v = 0; v < a->vertices; v++) {
        tf_vector normal = tf_vector_at(a->normal, v);
        double square = tf_vector_dot(normal, normal);
        double rise = error[v] / square;
        if (fabs(rise) * sqrt(square) <= most)
            put_point(a->end, v,
                      tf_vector_sum(tf_vector_at(a->end, v), rise, normal));
    }
    return goes_on(a);
}

//: Hold what may not move
/// An isolated triangle could turn over without touching anything.
static void hold_isolated_triangles(tf_flow_advance *a)
{
    for (int v = 0; v < a->vertices; v++)
        a->inverse_mass[v] = 1;
    for (int t = 0; t < a->surface->triangles; t++) {
        const int *v = tf_triangle(a->surface, t);
        for (int i = 0, count = tf_is_isolated(a->surface, t) ? 3 : 0;
             i < count; i++) {
            a->inverse_mass[v[i]] = 0;
            put_point(a->end, v[i], tf_vector_at(a->start, v[i]));
        }
    }
}

//: Move the vertices to their ends
static tf_status put_ends(const tf_flow_advance *a)
{
    memcpy(a->surface->position.data, a->end,
           3 * sizeof *a->end * (size_t)a->vertices);
    return tf_stars_build(a->surface, a->surface->box.data) ? TF_OK
                                                            : TF_CANCELLED;
}

tf_status tf_advance_resolve(tf_flow_advance *a,
                             const tf_response_report **report)
{
    tf_response_options options = {.parallel = a->options->parallel,
                                   .progress = a->options->progress,
                                   .context = a->options->context};
    scale_all(a, a->end, 1 / a->surface->scale);
    memcpy(a->start, a->surface->position.data,
           3 * sizeof *a->start * (size_t)a->vertices);
    hold_isolated_triangles(a);
    tf_status status = goes_on(a);
    if (status == TF_OK)
        status = tf_step_resolve(a->resolver, a->vertices, a->start, a->end,
                                 a->inverse_mass, &options, report, NULL);
    return status == TF_OK ? put_ends(a) : status;
}
