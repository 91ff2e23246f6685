//: Include what sizes need
#include "remesh/sizes.h"

#include "remesh/measure.h"
#include "remesh/reach.h"

#include <string.h>

//: Make room for sizes
void tf_sizes_free(tf_sizes *sizes)
{
    tf_buffer_free(&sizes->target);
    tf_buffer_free(&sizes->error);
    tf_buffer_free(&sizes->worst);
}

static bool make_room(tf_sizes *sizes, tf_remesher *remesher)
{
    size_t vertices = (size_t)remesher->original.surface->vertices;
    if (!tf_buffer_extend(&sizes->target, vertices, sizeof(double)) ||
        !tf_buffer_extend(&sizes->worst, vertices, sizeof(double)))
        return false;
    remesher->target = sizes->target.data;
    return true;
}

//: Let sizes change slowly
/// Lengths differ by the distance over this at most.
static const double grade = 2;

/// Shortens the length at one end of an edge.  Whether it was too long.
static bool grade_edge(const tf_adaptive_surface *surface, int corner,
                       double target[])
{
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    int longer = target[a] > target[b] ? a : b;
    double most = target[a + b - longer] + tf_length_of(surface, a, b) / grade;
    bool shortens = target[longer] > most;
    if (shortens)
        target[longer] = most;
    return shortens;
}

/// Goes forth and back through the edges until nothing changes.  False if the
/// caller cancels.
static bool grade_sizes(const tf_adaptive_surface *surface, double target[],
                        tf_watch *watch)
{
    int corners = 3 * surface->triangles;
    bool changes = true;
    while (changes) {
        changes = false;
        for (int i = 0; i < 2 * corners; i++) {
            int c = i < corners ? i : 2 * corners - 1 - i;
            if (!tf_watch_work(watch, 1))
                return false;
            if (tf_is_triangle(surface, c / 3))
                changes = grade_edge(surface, c, target) || changes;
        }
    }
    return true;
}

//: Begin with given sizes
bool tf_sizes_begin(tf_sizes *sizes, tf_remesher *remesher, const double edge[])
{
    const tf_adaptive_surface *original = remesher->original.surface;
    if (!make_room(sizes, remesher))
        return false;
    double *target = sizes->target.data;
    for (int v = 0; v < original->vertices; v++)
        target[v] = fmin(edge[v] * original->scale, remesher->edge);
    return grade_sizes(original, target, remesher->surface->watch);
}

//: Begin with sizes for a distance
/// How much the surface turns at an edge, by the length across it; 0 if the edge
/// is sharp.
static double curvature_at(const tf_remesher *remesher, int corner)
{
    const tf_adaptive_surface *surface = remesher->original.surface;
    int a = tf_vertex_at(surface, corner);
    int b = tf_vertex_at(surface, tf_corner_after(corner));
    if (tf_find_sharp_edge(&remesher->sharp_before, a, b))
        return 0;
    return tf_turn_at(surface, corner) / tf_height_at(surface, corner);
}

enum {
    EDGE_WORK = 4 ///< units of the watch
};

/// A triangle with edges of the length L is L^2 k / 6 from a sphere of the
/// curvature k.
bool tf_sizes_begin_for(tf_sizes *sizes, tf_remesher *remesher, double error)
{
    const tf_adaptive_surface *original = remesher->original.surface;
    if (!make_room(sizes, remesher))
        return false;
    double *target = sizes->target.data;
    for (int v = 0; v < original->vertices; v++)
        target[v] = remesher->edge;
    for (int c = 0; c < 3 * original->triangles; c++) {
        if (!tf_watch_work(remesher->surface->watch, EDGE_WORK))
            return false;
        if (!tf_is_triangle(original, c / 3))
            continue;
        double length = sqrt(6 * error / curvature_at(remesher, c));
        int end[] = {tf_vertex_at(original, c),
                     tf_vertex_at(original, tf_corner_after(c))};
        for (int i = 0; i < 2; i++)
            target[end[i]] = fmin(target[end[i]], length);
    }
    return grade_sizes(original, target, remesher->surface->watch);
}

//: Note where surfaces are apart
/// A search for distances up to a bound.  Below `enough` they change no size.
typedef struct size_search {
    double fine, enough, most;
} size_search;

/// The worst distances of the triangles at each vertex of the original.
static tf_status note_back(tf_sizes *sizes, tf_remesher *remesher,
                           size_search *search)
{
    const tf_adaptive_surface *before = remesher->original.surface;
    tf_watch *watch = remesher->surface->watch;
    tf_original now = {0};
    double *error = sizes->error.data, *worst = sizes->worst.data;
    tf_reach_each each = {error, search->enough};
    tf_status status = tf_original_begin(&now, remesher->surface, watch);
    if (status == TF_OK)
        search->most = fmax(
            search->most,
            tf_surface_reach(&now, before, search->fine, &each, watch).most);
    tf_original_free(&now);
    if (status == TF_OK && tf_watch_cancelled(watch))
        return TF_CANCELLED;
    for (int c = 0; c < 3 * before->triangles && status == TF_OK; c++)
        if (tf_is_triangle(before, c / 3)) {
            int v = tf_vertex_at(before, c);
            worst[v] = fmax(worst[v], error[c / 3]);
        }
    return status;
}

/// Those of the new triangles, where their vertices come from.
static void note_forth(tf_sizes *sizes, tf_remesher *remesher,
                       size_search *search)
{
    const tf_adaptive_surface *after = remesher->surface;
    const tf_origin *origin = remesher->trace.origin.data;
    double *error = sizes->error.data, *worst = sizes->worst.data;
    tf_reach_each each = {error, search->enough};
    tf_reach all = tf_surface_reach(&remesher->original, after, search->fine,
                                    &each, after->watch);
    search->most = fmax(search->most, all.most);
    if (tf_watch_cancelled(after->watch))
        return;
    for (int c = 0; c < 3 * after->triangles; c++) {
        if (!tf_is_triangle(after, c / 3))
            continue;
        const int *from = tf_triangle(remesher->original.surface,
                                      origin[tf_vertex_at(after, c)].triangle);
        for (int i = 0; i < 3; i++)
            worst[from[i]] = fmax(worst[from[i]], error[c / 3]);
    }
}

//: Adapt sizes to a distance
/// The most by which a length grows.
static const double growth = 1.5;

/// The distance grows with the square of the length.
static double factor_for(double error, double worst, bool shrink)
{
    double factor = sqrt(0.8 * error / worst);
    if (shrink)
        return worst > error ? fmin(fmax(factor, 0.5), 0.8) : 1;
    return fmin(fmax(factor, 0.5), growth);
}

/// How near is near enough for lengths to grow as much as they may, or to stay.
static double enough_for(double error, bool shrink)
{
    return shrink ? error : 0.8 * error / (growth * growth);
}

tf_status tf_sizes_adapt(tf_sizes *sizes, tf_remesher *remesher, double error,
                         bool shrink, double *most)
{
    const tf_adaptive_surface *before = remesher->original.surface;
    size_t triangles = (size_t)(before->triangles > remesher->surface->triangles
                                    ? before->triangles
                                    : remesher->surface->triangles);
    if (!tf_buffer_extend(&sizes->error, triangles, sizeof(double)))
        return TF_OUT_OF_MEMORY;
    double *target = sizes->target.data, *worst = sizes->worst.data;
    memset(worst, 0, sizeof *worst * (size_t)before->vertices);
    size_search search = {error / 100, enough_for(error, shrink), 0};
    note_forth(sizes, remesher, &search);
    tf_status status = tf_watch_cancelled(remesher->surface->watch)
                           ? TF_CANCELLED
                           : note_back(sizes, remesher, &search);
    *most = search.most;
    for (int v = 0; v < before->vertices && status == TF_OK; v++)
        target[v] = fmin(target[v] * factor_for(error, worst[v], shrink),
                         remesher->edge);
    if (status != TF_OK)
        return status;
    return grade_sizes(before, target, remesher->surface->watch) ? TF_OK
                                                                 : TF_CANCELLED;
}
