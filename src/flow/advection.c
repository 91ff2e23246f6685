//: Include what the advance needs
#include "flow/flow_state.h"

#include "flow/patch.h"
#include "response/resolve.h"
#include "surgery/star.h"

#include <string.h>

//: Hold the points of an advance
/// The vertices, and after them the middles of the edges.
typedef struct advancing {
    tf_flow_state *flow;
    int vertices, edges, points;
    const int *edge; ///< two vertices each
    double time, step;
    double *start;    ///< where the points are
    double *stage;    ///< where a velocity is taken
    double *normal;   ///< there
    double *velocity; ///< there
    double *end;      ///< where the points go
    double *inverse_mass;
    tf_surface *surface;
    tf_resolver *resolver;
} advancing;

//: Begin an advance
/// Room for five vectors of each point, and a mass of each vertex.
static bool reserve_points(advancing *a, tf_buffer *room)
{
    size_t numbers = 3 * (size_t)a->points;
    if (!tf_buffer_extend(room, 5 * numbers + (size_t)a->vertices,
                          sizeof(double)))
        return false;
    double **part[] = {&a->start,    &a->stage, &a->normal,
                       &a->velocity, &a->end,   &a->inverse_mass};
    double *next = room->data;
    for (size_t i = 0; i < 6; i++, next += numbers)
        *part[i] = next;
    return true;
}

//: Place the points of an advance
static void place_points(advancing *a)
{
    const tf_adaptive_surface *surface = a->flow->remesher.surface;
    memcpy(a->start, surface->position.data,
           3 * sizeof *a->start * (size_t)a->vertices);
    for (int e = 0; e < a->edges; e++) {
        const int *end = a->edge + 2 * (ptrdiff_t)e;
        tf_vector middle = tf_middle_of(surface, end[0], end[1]);
        memcpy(a->start + 3 * (ptrdiff_t)(a->vertices + e), middle.x,
               sizeof middle.x);
    }
}

//: Set an advance up
static tf_status begin_advance(advancing *a, tf_buffer *room)
{
    tf_mesh mesh = tf_adaptive_mesh(a->flow->remesher.surface);
    tf_status status = tf_surface_create(&mesh, &a->surface, NULL);
    if (status == TF_OK)
        status = tf_resolver_create(a->surface, &a->resolver);
    if (status != TF_OK)
        return status;
    a->edge = tf_surface_edges(a->surface, &a->edges);
    a->vertices = mesh.vertices;
    a->points = a->vertices + a->edges;
    if (!reserve_points(a, room))
        return TF_OUT_OF_MEMORY;
    place_points(a);
    return TF_OK;
}

//: Compute the normals of an advance
static tf_vector vector_in(const double x[], int point)
{
    x += 3 * (ptrdiff_t)point;
    return (tf_vector){{x[0], x[1], x[2]}};
}

static void put_in(double x[], int point, tf_vector value)
{
    memcpy(x + 3 * (ptrdiff_t)point, value.x, sizeof value.x);
}

/// The sum of the normals of the triangles at each vertex, in any positions.
static void sum_normals(const advancing *a, const double position[],
                        double normal[])
{
    tf_mesh mesh = tf_adaptive_mesh(a->flow->remesher.surface);
    memset(normal, 0, 3 * sizeof *normal * (size_t)a->vertices);
    for (int t = 0; t < mesh.triangles; t++) {
        const int *v = mesh.triangle + 3 * (ptrdiff_t)t;
        tf_shape shape = {{vector_in(position, v[0]), vector_in(position, v[1]),
                           vector_in(position, v[2])}};
        tf_vector own = tf_shape_normal(&shape);
        for (int i = 0; i < 3; i++)
            put_in(normal, v[i],
                   tf_vector_sum(vector_in(normal, v[i]), 1, own));
    }
}

//: Make the normals unit vectors
/// Of length 1, unless it has no length.
static tf_vector unit_of(tf_vector a)
{
    double length = tf_vector_length(a);
    return length > 0 ? tf_vector_scaled(1 / length, a) : a;
}

static void find_normals(advancing *a)
{
    sum_normals(a, a->stage, a->normal);
    for (int e = 0; e < a->edges; e++) {
        const int *end = a->edge + 2 * (ptrdiff_t)e;
        put_in(a->normal, a->vertices + e,
               unit_of(tf_vector_sum(vector_in(a->normal, end[0]), 1,
                                     vector_in(a->normal, end[1]))));
    }
    for (int v = 0; v < a->vertices; v++)
        put_in(a->normal, v, unit_of(vector_in(a->normal, v)));
}

//: Advance by the method of Runge and Kutta
/// Takes the velocities at `part` of the step, having gone so far along the
/// last ones, and goes on by `weight` of the step along them.
static void go_on(advancing *a, double part, double weight)
{
    const tf_flow_options *options = a->flow->options;
    double along = part * a->step;
    for (int i = 0; i < 3 * a->points; i++)
        a->stage[i] = a->start[i] + (part > 0 ? along * a->velocity[i] : 0);
    find_normals(a);
    options->velocity(options->context, a->time + along, a->points, a->stage,
                      a->normal, a->velocity);
    for (int i = 0; i < 3 * a->points; i++)
        a->end[i] += weight * a->step * a->velocity[i];
}

static void propose_advance(advancing *a)
{
    memcpy(a->end, a->start, 3 * sizeof *a->end * (size_t)a->points);
    go_on(a, 0, 1.0 / 6);
    go_on(a, 0.5, 1.0 / 3);
    go_on(a, 0.5, 1.0 / 3);
    go_on(a, 1, 1.0 / 6);
}

//: Find out what an advance loses
/// The middle of an edge leaves the chord between its ends.  A triangle whose
/// three sides do so encloses less, by the sum over its sides of a third of its
/// area times their rise; each of its vertices owes a third of that, times 6.
static void add_debts(const advancing *a, int corner, tf_vector rise,
                      double owed[])
{
    if (corner == TF_NONE)
        return;
    const int *v = tf_triangle(a->flow->remesher.surface, corner / 3);
    tf_shape shape = {{vector_in(a->end, v[0]), vector_in(a->end, v[1]),
                       vector_in(a->end, v[2])}};
    double lost = tf_vector_dot(tf_shape_normal(&shape), rise);
    for (int i = 0; i < 3; i++)
        owed[v[i]] += lost / 3;
}

static void find_debts(const advancing *a, double owed[])
{
    memset(owed, 0, sizeof *owed * (size_t)a->vertices);
    for (int e = 0; e < a->edges; e++) {
        const int *end = a->edge + 2 * (ptrdiff_t)e;
        tf_vector middle =
            tf_vector_scaled(0.5, tf_vector_sum(vector_in(a->end, end[0]), 1,
                                                vector_in(a->end, end[1])));
        tf_vector rise =
            tf_vector_difference(vector_in(a->end, a->vertices + e), middle);
        const tf_adaptive_surface *surface = a->flow->remesher.surface;
        add_debts(a, tf_find_edge(surface, end[0], end[1]), rise, owed);
        add_debts(a, tf_find_edge(surface, end[1], end[0]), rise, owed);
    }
}

//: Pay what an advance loses
/// Shifts the ends along their normals, by a tenth of an edge at most.
static void pay_debts(advancing *a)
{
    double *owed = a->velocity, most = 0.1 * a->flow->remesher.edge;
    find_debts(a, owed);
    sum_normals(a, a->end, a->normal);
    for (int v = 0; v < a->vertices; v++) {
        tf_vector normal = vector_in(a->normal, v);
        double square = tf_vector_dot(normal, normal);
        double rise = owed[v] / square;
        if (fabs(rise) * sqrt(square) <= most)
            put_in(a->end, v,
                   tf_vector_sum(vector_in(a->end, v), rise, normal));
    }
}

//: Hold what may not move
/// A lone triangle could turn over without touching anything.
static void hold_lone_triangles(advancing *a)
{
    const tf_adaptive_surface *surface = a->flow->remesher.surface;
    for (int v = 0; v < a->vertices; v++)
        a->inverse_mass[v] = 1;
    for (int t = 0; t < surface->triangles; t++) {
        const int *v = tf_triangle(surface, t);
        for (int i = 0, count = tf_is_isolated(surface, t) ? 3 : 0; i < count;
             i++) {
            a->inverse_mass[v[i]] = 0;
            put_in(a->end, v[i], vector_in(a->start, v[i]));
        }
    }
}

//: Make an advance
static void put_ends(const advancing *a)
{
    tf_adaptive_surface *surface = a->flow->remesher.surface;
    memcpy(surface->position.data, a->end,
           3 * sizeof *a->end * (size_t)a->vertices);
    tf_stars_build(surface, surface->box.data);
}

static tf_status make_advance(advancing *a)
{
    tf_response_options options = {.parallel = a->flow->options->parallel};
    propose_advance(a);
    if (tf_flow_keeps_volume(a->flow, (tf_operation)TF_OPERATIONS))
        pay_debts(a);
    hold_lone_triangles(a);
    tf_status status = tf_step_resolve(a->resolver, a->vertices, a->start,
                                       a->end, a->inverse_mass, &options,
                                       &a->flow->report->response, NULL);
    if (status == TF_OK)
        put_ends(a);
    return status;
}

//: Advance a surface that flows
tf_status tf_advect(tf_flow_state *flow, double time, double step)
{
    advancing a = {.flow = flow, .time = time, .step = step};
    tf_buffer room = {0};
    tf_status status = tf_adaptive_compact(flow->remesher.surface, NULL);
    if (status != TF_OK || flow->remesher.surface->triangles == 0)
        return status;
    status = begin_advance(&a, &room);
    if (status == TF_OK)
        status = make_advance(&a);
    tf_buffer_free(&room);
    tf_resolver_free(a.resolver);
    tf_surface_free(a.surface);
    return status;
}
