#include "shells.h"

#include "allocator.h"
#include "shapes.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

enum {
    LARGE = 200 ///< triangles: surfaces that have more do not grow any more
};

// Creating --------------------------------------------------------------------

/// Spoils a number of the mesh, or an index.
static void spoil_shape(generator *random, call *made, shape *of)
{
    static const int bad[] = {-1, INT_MIN, INT_MAX};
    static const int edge[] = {0, 1};
    tf_mesh *mesh = &of->mesh;
    int fault = below(random, 7);
    if (fault == 0)
        mesh->vertices = bad[below(random, COUNT(bad))];
    if (fault == 1)
        mesh->triangles = bad[below(random, COUNT(bad))];
    if (fault == 2)
        mesh->triangle = NULL;
    expect_fault(made, fault < 3, TF_BAD_COUNT);
    if (fault == 3)
        mesh->axes = wrong_number(random, 3);
    expect_fault(made, fault == 3, TF_BAD_AXES);
    if (fault == 4)
        mesh->triangles = 0;
    expect_fault(made, fault == 4, TF_NO_ELEMENTS);
    if (fault == 5)
        of->triangle[below(random, 3 * mesh->triangles)] =
            one_in(random, 2) ? mesh->vertices : -1 - below(random, 3);
    expect_fault(made, fault == 5, TF_BAD_INDEX);
    if (fault == 6) {
        mesh->edges = 1;
        mesh->edge = edge;
    }
    expect_fault(made, fault == 6, TF_EDGE_NOT_MANIFOLD);
}

/// What may be wrong with any triangles.
static void excuse_shape(call *made)
{
    excuse(made, TF_EDGE_NOT_MANIFOLD);
    excuse(made, TF_VERTEX_NOT_MANIFOLD);
    excuse(made, TF_COLLINEAR);
    excuse(made, TF_NOT_EMBEDDED);
}

/// Requires that a new surface has what it was given.
static void judge_created(const call *made, const shape *of,
                          const tf_adaptive_surface *surface)
{
    const tf_mesh *mesh = tf_adaptive_mesh(surface);
    require(made,
            mesh->vertices == of->mesh.vertices &&
                mesh->triangles == of->mesh.triangles && mesh->axes == 3 &&
                mesh->edges == 0,
            "it has other counts");
    require(made,
            memcmp(mesh->triangle, of->triangle,
                   3 * sizeof(int) * (size_t)mesh->triangles) == 0,
            "it has other triangles");
    require(made,
            memcmp(tf_adaptive_positions(surface), of->position,
                   3 * sizeof(double) * (size_t)mesh->vertices) == 0,
            "it has other positions");
    require(made, tf_adaptive_memory(surface) > 0, "it holds nothing");
    require(made, !tf_adaptive_origins(surface), "it comes from nowhere");
}

void call_adaptive_create(generator *random, shell *of)
{
    shape drawn;
    tf_adaptive_surface *surface;
    results set;
    call made = call_begin("tf_adaptive_create");
    shape_draw(random, &drawn);
    expect_fault(&made, !all_finite(3 * drawn.mesh.vertices, drawn.position),
                 TF_NOT_FINITE);
    if (one_in(random, 4))
        spoil_shape(random, &made, &drawn);
    if (!drawn.embedded)
        excuse_shape(&made);
    break_environment(random, &made);
    results_begin(random, &set, &surface, sizeof surface);
    tf_status status =
        tf_adaptive_create(&drawn.mesh, drawn.position, &surface, &set.error);
    if (!results_judge(random, &made, &set, NULL, status))
        return;
    judge_created(&made, &drawn, surface);
    shell_free(of);
    *of = (shell){.surface = surface, .unit = drawn.unit};
}

void shell_free(shell *of)
{
    tf_flow_free(of->flow);
    tf_adaptive_free(of->surface);
    *of = (shell){0};
}

// What calls leave ------------------------------------------------------------

/// Requires that the surface is what it was.
static void judge_unchanged(const call *made, const shell *of,
                            const state *before)
{
    state after = state_of(of->surface);
    require(made, state_equals(before, &after), "the surface is changed");
    state_free(&after);
}

/// Requires that a new surface can be made of its triangles: the library makes
/// none that is not embedded.
static void judge_embedded(const call *made, const shell *of)
{
    tf_adaptive_surface *other;
    state now = state_of(of->surface);
    int triangles = 0;
    for (int i = 0; i < now.mesh.triangles; i++)
        triangles += now.triangle[3 * i] >= 0;
    if (triangles > 0) {
        tf_status status = state_copy(&now, &other);
        require(made, status == TF_OK, "the surface is not embedded any more");
        tf_adaptive_free(other);
    }
    state_free(&now);
}

// Operations ------------------------------------------------------------------

/// Draws a vertex, most of the time a corner of a triangle that there is.
static int draw_vertex(generator *random, call *made, const tf_mesh *mesh)
{
    static const int bad[] = {-1, INT_MIN, INT_MAX};
    int v = mesh->vertices > 0 ? below(random, mesh->vertices) : 0;
    if (mesh->triangles > 0 && !one_in(random, 8)) {
        int corner = mesh->triangle[below(random, 3 * mesh->triangles)];
        v = corner >= 0 && corner < mesh->vertices ? corner : v;
    }
    if (one_in(random, 32))
        v = one_in(random, 2) ? mesh->vertices : bad[below(random, COUNT(bad))];
    expect_fault(made, v < 0 || v >= mesh->vertices, TF_BAD_INDEX);
    return v;
}

/// Draws the ends of an edge, most of the time of one that there is.
static void draw_edge(generator *random, call *made, const tf_mesh *mesh,
                      int end[2])
{
    if (mesh->triangles > 0 && !one_in(random, 8)) {
        int k = below(random, 3);
        const int *corner =
            mesh->triangle + (size_t)3 * (size_t)below(random, mesh->triangles);
        end[0] = corner[k];
        end[1] = corner[k == 2 ? 0 : k + 1];
        if (corner[0] >= 0)
            return;
    }
    end[0] = draw_vertex(random, made, mesh);
    end[1] = draw_vertex(random, made, mesh);
}

/// Draws positions near those of vertices, or anywhere.
static void draw_places(generator *random, call *made, const shell *of,
                        int count, const int near[], double x[])
{
    int vertices = tf_adaptive_mesh(of->surface)->vertices;
    const double *position = tf_adaptive_positions(of->surface);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            bool known = near[i] >= 0 && near[i] < vertices;
            double from =
                known ? position[(size_t)3 * (size_t)near[i] + (size_t)k] : 0;
            double by = one_in(random, 2) ? 0 : uniform(random, -1, 1);
            x[3 * i + k] = from + of->unit * by;
        }
    if (count > 0 && one_in(random, 16))
        x[below(random, 3 * count)] = any_double(random);
    expect_fault(made, !all_finite(3 * count, x), TF_NOT_FINITE);
}

typedef enum operation {
    SPLIT,
    MOVE,
    COLLAPSE,
    COLLAPSE_TO,
    FLIP,
    MERGE,
    PINCH,
    DROP,
    OPERATIONS
} operation;

static const char *const operation_names[OPERATIONS] = {
    [SPLIT] = "tf_adaptive_split",
    [MOVE] = "tf_adaptive_move",
    [COLLAPSE] = "tf_adaptive_collapse",
    [COLLAPSE_TO] = "tf_adaptive_collapse_to",
    [FLIP] = "tf_adaptive_flip",
    [MERGE] = "tf_adaptive_merge",
    [PINCH] = "tf_adaptive_pinch",
    [DROP] = "tf_adaptive_drop",
};

/// What an operation is about, and what it sets.
typedef struct request {
    operation what;
    int a[3], b[2];
    double position[9];
    int vertex[3];
    tf_outcome outcome;
} request;

/// Three vertices, most of the time those of the waist of a tube.
static void draw_loop(generator *random, call *made, const tf_mesh *mesh,
                      int loop[3])
{
    bool tube = mesh->vertices >= 9 && one_in(random, 2);
    for (int k = 0; k < 3; k++)
        loop[k] = tube ? 3 + k : draw_vertex(random, made, mesh);
}

static void draw_request(generator *random, call *made, const shell *of,
                         request *r)
{
    const tf_mesh *mesh = tf_adaptive_mesh(of->surface);
    static const int places[OPERATIONS] = {
        [SPLIT] = 1, [MOVE] = 1, [COLLAPSE_TO] = 1, [PINCH] = 3};
    r->what = (operation)below(random, OPERATIONS);
    if (r->what == SPLIT && mesh->triangles > LARGE)
        r->what = FLIP;
    if (r->what == PINCH)
        draw_loop(random, made, mesh, r->a);
    else if (r->what == MOVE || r->what == DROP)
        r->a[0] = draw_vertex(random, made, mesh);
    else
        draw_edge(random, made, mesh, r->a);
    if (r->what == MERGE)
        draw_edge(random, made, mesh, r->b);
    draw_places(random, made, of, places[r->what], r->a, r->position);
    mark(r->vertex, sizeof r->vertex);
}

static tf_status try_request(tf_adaptive_surface *surface, request *r)
{
    switch (r->what) {
    case SPLIT:
        return tf_adaptive_split(surface, r->a[0], r->a[1], r->position,
                                 r->vertex, &r->outcome);
    case MOVE:
        return tf_adaptive_move(surface, r->a[0], r->position, &r->outcome);
    case COLLAPSE:
        return tf_adaptive_collapse(surface, r->a[0], r->a[1], &r->outcome);
    case COLLAPSE_TO:
        return tf_adaptive_collapse_to(surface, r->a[0], r->a[1], r->position,
                                       &r->outcome);
    case FLIP:
        return tf_adaptive_flip(surface, r->a[0], r->a[1], &r->outcome);
    case MERGE:
        return tf_adaptive_merge(surface, r->a, r->b, &r->outcome);
    case PINCH:
        return tf_adaptive_pinch(surface, r->a, r->position, r->vertex,
                                 &r->outcome);
    default:
        return tf_adaptive_drop(surface, r->a[0], &r->outcome);
    }
}

/// The vertices that an operation adds.
static int added(const request *r)
{
    return r->outcome != TF_COMMITTED ? 0
           : r->what == SPLIT         ? 1
           : r->what == PINCH         ? 3
                                      : 0;
}

static void judge_request(const call *made, const shell *of, tf_status status,
                          const request *r)
{
    int vertices = tf_adaptive_mesh(of->surface)->vertices;
    require(made, (status == TF_OK) == (r->outcome != TF_NO_OUTCOME),
            "the outcome does not fit the status");
    require(made, r->outcome >= 0 && r->outcome <= TF_PASSED_TRIANGLE,
            "there is no such outcome");
    for (int i = 0; i < added(r); i++)
        require(made, r->vertex[i] >= 0 && r->vertex[i] < vertices,
                "the new vertex is none");
    judge_unset(made, r->vertex + added(r),
                sizeof *r->vertex * (size_t)(3 - added(r)));
}

/// Requires that a new surface answers in the same way: both without gaps.
static void judge_alike(generator *random, const call *before, shell *of)
{
    call made = {.name = before->name};
    tf_adaptive_surface *other;
    require(&made, tf_adaptive_compact(of->surface, NULL) == TF_OK,
            "it cannot be compacted");
    if (tf_adaptive_mesh(of->surface)->triangles == 0)
        return;
    state now = state_of(of->surface);
    require(&made, state_copy(&now, &other) == TF_OK, "it is not embedded");
    request own;
    draw_request(random, &made, of, &own);
    request again = own;
    tf_status status = try_request(of->surface, &own);
    require(&made, try_request(other, &again) == status,
            "a new surface has another status");
    require(&made, own.outcome == again.outcome,
            "a new surface has another outcome");
    state others = state_of(other);
    state_free(&now);
    now = state_of(of->surface);
    require(&made, state_equals(&now, &others),
            "a new surface becomes another");
    state_free(&now);
    state_free(&others);
    tf_adaptive_free(other);
}

/// Judges a surface after a call that may have changed it, or not.
static void judge_after(generator *random, const call *made, shell *of,
                        bool changed, const state *before)
{
    if (changed)
        judge_embedded(made, of);
    else
        judge_unchanged(made, of, before);
    if (one_in(random, 8))
        judge_alike(random, made, of);
}

void call_operation(generator *random, shell *of)
{
    request r = {.outcome = (tf_outcome)99};
    call made = call_begin("an operation");
    draw_request(random, &made, of, &r);
    made.name = operation_names[r.what];
    state before = state_of(of->surface);
    break_environment(random, &made);
    allocator_fail(random);
    tf_status status = try_request(of->surface, &r);
    end_trouble(&made);
    judge_status(&made, status);
    judge_request(&made, of, status, &r);
    judge_after(random, &made, of, r.outcome == TF_COMMITTED, &before);
    state_free(&before);
}

// Compacting ------------------------------------------------------------------

/// Requires that the map leads each vertex to its position.
static void judge_map(const call *made, const shell *of, const state *before,
                      const int map[])
{
    const double *position = tf_adaptive_positions(of->surface);
    int kept = 0;
    for (int v = 0; v < before->mesh.vertices; v++) {
        if (map[v] < 0)
            continue;
        require(made, map[v] == kept++, "the order of vertices is another");
        require(made,
                memcmp(position + (size_t)3 * (size_t)map[v],
                       before->position + (size_t)3 * (size_t)v,
                       3 * sizeof *position) == 0,
                "a vertex is elsewhere");
    }
    require(made, kept == tf_adaptive_mesh(of->surface)->vertices,
            "there are other vertices");
}

void call_compact(generator *random, shell *of)
{
    static int map[4096];
    call made = call_begin("tf_adaptive_compact");
    state before = state_of(of->surface);
    bool wanted = before.mesh.vertices < COUNT(map) && !one_in(random, 4);
    mark(map, sizeof map);
    allocator_fail(random);
    tf_status status = tf_adaptive_compact(of->surface, wanted ? map : NULL);
    end_trouble(&made);
    if (!judge_status(&made, status)) {
        judge_unset(&made, map, sizeof map);
        judge_unchanged(&made, of, &before);
    } else {
        if (wanted)
            judge_map(&made, of, &before, map);
        judge_embedded(&made, of);
    }
    state_free(&before);
}

// Long calls ------------------------------------------------------------------

/// The largest difference of a coordinate of a triangle's vertex from those of
/// another one; notes coordinates that are above `most`.
static double extent(call *made, const shell *of, double most)
{
    const tf_mesh *mesh = tf_adaptive_mesh(of->surface);
    const double *position = tf_adaptive_positions(of->surface);
    double low = INFINITY, high = -INFINITY;
    for (int c = 0; c < 3 * mesh->triangles; c++)
        for (int k = 0; k < 3 && mesh->triangle[c / 3 * 3] >= 0; k++) {
            double x = position[3 * (ptrdiff_t)mesh->triangle[c] + k];
            expect_fault(made, fabs(x) > most, TF_OUT_OF_RANGE);
            low = fmin(low, x);
            high = fmax(high, x);
        }
    return fmin(fmax(high - low, 0), 2 * most);
}

/// Draws a length of edges: one that leads to few triangles, as most of the
/// time, or one that must be refused.
static double draw_length(generator *random, call *made, const shell *of,
                          double most)
{
    static const double bad[] = {0, -1, NAN, INFINITY, -INFINITY, -0.0};
    double size = fmax(extent(made, of, most), of->unit);
    if (one_in(random, 16)) {
        expect_fault(made, true, TF_BAD_OPTION);
        return bad[below(random, COUNT(bad))];
    }
    return size * uniform(random, 0.2, 2);
}

typedef struct remesh_options {
    tf_remesh_options own;
    unsigned char later[LATER];
} remesh_options;

static void judge_origin(const call *made, const tf_origin origin[], int count,
                         int triangles)
{
    require(made, origin || count == 0, "the vertices come from nowhere");
    for (int i = 0; i < count; i++) {
        const double *weight = origin[i].barycentric;
        require(made, origin[i].triangle >= 0 && origin[i].triangle < triangles,
                "a vertex comes from no triangle");
        require(made,
                weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0 &&
                    fabs(weight[0] + weight[1] + weight[2] - 1) < 1e-9,
                "weights don't add up to 1");
    }
}

static void judge_origins(const call *made, const shell *of, int triangles)
{
    const tf_mesh *mesh = tf_adaptive_mesh(of->surface);
    judge_origin(made, tf_adaptive_origins(of->surface), mesh->vertices,
                 triangles);
    judge_origin(made, tf_adaptive_corner_origins(of->surface),
                 3 * mesh->triangles, triangles);
}

static void judge_quality(const call *made, double least, double mean)
{
    require(made, least >= 0 && least <= mean + 1e-9 && mean <= 1 + 1e-9,
            "a quality is none");
}

static void draw_remesh_options(generator *random, call *made, const shell *of,
                                remesh_options *options, listener *hearing)
{
    tf_remesh_options *own = &options->own;
    *own = (tf_remesh_options){.context = hearing};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->edge = draw_length(random, made, of, 0x1p1000);
    own->rounds = one_in(random, 8) ? 0 : below(random, 4) - 1;
    own->progress = any_progress(random, made, hearing);
}

void call_remesh(generator *random, shell *of)
{
    static remesh_options options;
    listener hearing;
    const tf_remesh_report *report;
    results set;
    call made = call_begin("tf_adaptive_remesh");
    state before = state_of(of->surface);
    draw_remesh_options(random, &made, of, &options, &hearing);
    break_environment(random, &made);
    results_begin(random, &set, &report, sizeof report);
    tf_status status =
        tf_adaptive_remesh(of->surface, &options.own, &report, &set.error);
    if (results_judge(random, &made, &set, &hearing, status)) {
        require(&made, report->rounds >= 0, "there are no rounds");
        judge_quality(&made, report->least_before, report->mean_before);
        judge_quality(&made, report->least_after, report->mean_after);
        require(&made, report->distance >= 0, "a distance is no number");
        judge_origins(&made, of, before.mesh.triangles);
    }
    judge_after(random, &made, of, status == TF_OK, &before);
    state_free(&before);
}

typedef struct reconnect_options {
    tf_reconnect_options own;
    unsigned char later[LATER];
} reconnect_options;

/// A length beside that of edges: any that is finite will do.
static double draw_share(generator *random, call *made)
{
    double share = one_in(random, 2) ? 0 : uniform(random, -0.5, 2);
    if (one_in(random, 32))
        share = any_double(random);
    expect_fault(made, !all_finite(1, &share), TF_BAD_OPTION);
    return share;
}

static void draw_reconnect_options(generator *random, call *made,
                                   const shell *of, reconnect_options *options,
                                   listener *hearing)
{
    tf_reconnect_options *own = &options->own;
    *own = (tf_reconnect_options){.context = hearing};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->edge = draw_length(random, made, of, 0x1p250);
    own->merge = draw_share(random, made);
    own->patch = draw_share(random, made);
    own->pinch = draw_share(random, made);
    own->drop = draw_share(random, made);
    own->progress = any_progress(random, made, hearing);
}

void call_reconnect(generator *random, shell *of)
{
    static reconnect_options options;
    listener hearing;
    const tf_reconnect_report *report;
    results set;
    call made = call_begin("tf_adaptive_reconnect");
    state before = state_of(of->surface);
    draw_reconnect_options(random, &made, of, &options, &hearing);
    break_environment(random, &made);
    results_begin(random, &set, &report, sizeof report);
    tf_status status =
        tf_adaptive_reconnect(of->surface, &options.own, &report, &set.error);
    results_judge(random, &made, &set, &hearing, status);
    judge_after(random, &made, of, status == TF_OK, &before);
    state_free(&before);
}

// Flows -----------------------------------------------------------------------

void call_flow(generator *random, shell *of)
{
    call made = call_begin("tf_flow_create");
    bool before = of->flow;
    tf_flow_free(of->flow);
    of->flow = NULL;
    if (before && one_in(random, 2))
        return;
    tf_flow *flow;
    mark(&flow, sizeof flow);
    allocator_fail(random);
    tf_status status = tf_flow_create(of->surface, &flow);
    end_trouble(&made);
    if (!judge_status(&made, status)) {
        judge_unset(&made, &flow, sizeof flow);
        return;
    }
    of->flow = flow;
    require(&made, tf_flow_memory(flow) > 0, "it holds nothing");
}

typedef struct flow_options {
    tf_flow_options own;
    unsigned char later[LATER];
} flow_options;

/// What a flow's callbacks share.
typedef struct current {
    listener hearing; ///< first, as `hear` expects it
    double speed;
    bool broken; ///< whether a velocity is not finite
    double seconds;
} current;

/// Away from the origin, and around it.
static void find_velocity(void *context, double time, int points,
                          const double point[], const double normal[],
                          double velocity[])
{
    current *flow = context;
    (void)time;
    for (int i = 0; i < points; i++, point += 3, normal += 3, velocity += 3) {
        velocity[0] = flow->speed * normal[0] + point[1] / 8;
        velocity[1] = flow->speed * normal[1] - point[0] / 8;
        velocity[2] = flow->speed * normal[2];
    }
    if (flow->broken && points > 0)
        velocity[-1] = NAN;
}

static double tell_time(void *context)
{
    current *flow = context;
    return flow->seconds += 0.25;
}

static void draw_flow_options(generator *random, call *made, const shell *of,
                              flow_options *options, current *flow,
                              crew *workers)
{
    tf_flow_options *own = &options->own;
    *flow = (current){.speed = of->unit * uniform(random, -1, 1),
                      .broken = one_in(random, 16)};
    *own = (tf_flow_options){.velocity = find_velocity, .context = flow};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->edge = draw_length(random, made, of, 0x1p250);
    own->keep_topology = one_in(random, 2);
    own->parallel = any_parallel(random, made, workers);
    own->clock = one_in(random, 2) ? tell_time : NULL;
    own->progress = any_progress(random, made, &flow->hearing);
}

/// Makes a flow if there is none.
static void need_flow(shell *of)
{
    call made = call_begin("tf_flow_create");
    if (!of->flow)
        judge_status(&made, tf_flow_create(of->surface, &of->flow));
}

void call_flow_step(generator *random, shell *of)
{
    static flow_options options;
    current flow;
    crew workers;
    const tf_flow_report *report;
    results set;
    need_flow(of);
    call made = call_begin("tf_flow_step");
    state before = state_of(of->surface);
    draw_flow_options(random, &made, of, &options, &flow, &workers);
    double step =
        one_in(random, 32) ? any_double(random) : uniform(random, -1, 1);
    // Nothing may be left that could move, or the step be harmless.
    if (flow.broken || !(fabs(step) <= 1))
        excuse(&made, TF_NOT_FINITE);
    break_environment(random, &made);
    results_begin(random, &set, &report, sizeof report);
    tf_status status =
        tf_flow_step(of->flow, 0, step, &options.own, &report, &set.error);
    if (results_judge(random, &made, &set, &flow.hearing, status))
        require(&made, report->reconnected && report->response,
                "a report is missing");
    judge_after(random, &made, of, status == TF_OK, &before);
    state_free(&before);
}
