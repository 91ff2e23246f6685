//: Find the triangles on an edge
#include "topology/merge.h"

#include "base/require.h"
#include "surgery/request.h"
#include "surgery/star.h"
#include "surgery/surgery.h"
#include "topology/walls.h"

enum {
    MERGE_ROOM = 8 ///< for the lists of the surgery
};

/// Two triangles on an edge, and the corners around both, against the clock.
typedef struct tf_quad {
    int triangle[2];
    int corner[4];
} tf_quad;

/// False if the edge does not have two triangles, or is frozen.
static bool find_quad(const tf_adaptive_surface *surface, const int edge[2],
                      tf_quad *quad)
{
    int forth = tf_find_edge(surface, edge[0], edge[1]);
    int back = tf_find_edge(surface, edge[1], edge[0]);
    if (forth == TF_NONE || back == TF_NONE ||
        tf_is_frozen_edge(surface, edge[0], edge[1]))
        return false;
    quad->triangle[0] = forth / 3;
    quad->triangle[1] = back / 3;
    quad->corner[0] = edge[0];
    quad->corner[1] = tf_vertex_at(surface, tf_corner_before(back));
    quad->corner[2] = edge[1];
    quad->corner[3] = tf_vertex_at(surface, tf_corner_before(forth));
    return true;
}

//: Find out whether two quads may merge
static bool are_linked(const tf_adaptive_surface *surface, int a, int b)
{
    return a == b || tf_find_edge(surface, a, b) != TF_NONE ||
           tf_find_edge(surface, b, a) != TF_NONE;
}

/// The new edges must not exist yet, nor triangles within one quad.
static bool may_merge(const tf_adaptive_surface *surface, const tf_quad quad[2])
{
    for (int i = 0; i < 2; i++)
        if (are_linked(surface, quad[i].corner[1], quad[i].corner[3]))
            return false;
    for (int i = 0; i < 16; i++)
        if (are_linked(surface, quad[0].corner[i / 4], quad[1].corner[i % 4]))
            return false;
    return true;
}

//: Match the corners of two quads
/// The power of two by which the quads' greatest coordinate gets nearest below 1:
/// a merge by itself knows no unit of the surface.
static double scale_of(const tf_adaptive_surface *surface,
                       const tf_quad quad[2])
{
    tf_aabb first = tf_aabb_of(surface, 4, quad[0].corner);
    tf_aabb second = tf_aabb_of(surface, 4, quad[1].corner);
    tf_aabb both = tf_aabb_union(first, &second);
    return tf_aabb_scale(&both);
}

static double length_between(const tf_adaptive_surface *surface, double scale,
                             int a, int b)
{
    tf_vector from = tf_vector_at(tf_vertex_coordinates(surface, a), 0);
    tf_vector to = tf_vector_at(tf_vertex_coordinates(surface, b), 0);
    return tf_vector_length(tf_vector_difference(tf_vector_scaled(scale, from),
                                                 tf_vector_scaled(scale, to)));
}

static double squared_length(const tf_adaptive_surface *surface, double scale,
                             int a, int b)
{
    double length = length_between(surface, scale, a, b);
    return length * length;
}

/// The corner of the second quad that faces a corner of the first, if that one
/// faces its corner `turned`: the second goes around with the clock.
static int partner(const tf_quad quad[2], int turned, int corner)
{
    return quad[1].corner[(turned + 8 - corner) % 4];
}

/// How the second quad is turned so that the corners are nearest.
static int best_turn(const tf_adaptive_surface *surface, double scale,
                     const tf_quad quad[2])
{
    int best = 0;
    double least = INFINITY;
    for (int turned = 0; turned < 4; turned++) {
        double sum = 0;
        for (int i = 0; i < 4; i++)
            sum += squared_length(surface, scale, quad[0].corner[i],
                                  partner(quad, turned, i));
        if (sum < least) {
            least = sum;
            best = turned;
        }
    }
    return best;
}

//: Describe the tube
/// Adds two triangles between edges that face each other, p[0] to p[1] and q[0]
/// to q[1], with the shorter diagonal.
static void add_side(tf_adaptive_surface *surface, double scale, const int p[2],
                     const int q[2])
{
    if (length_between(surface, scale, p[0], q[1]) <
        length_between(surface, scale, p[1], q[0])) {
        tf_surgery_add(surface, p[0], p[1], q[1]);
        tf_surgery_add(surface, p[0], q[1], q[0]);
    } else {
        tf_surgery_add(surface, p[0], p[1], q[0]);
        tf_surgery_add(surface, p[1], q[1], q[0]);
    }
}

static void add_tube(tf_adaptive_surface *surface, const tf_quad quad[2])
{
    double scale = scale_of(surface, quad);
    int turned = best_turn(surface, scale, quad);
    for (int i = 0; i < 4; i++) {
        const int p[] = {quad[0].corner[i], quad[0].corner[(i + 1) % 4]};
        const int q[] = {partner(quad, turned, i),
                         partner(quad, turned, i + 1)};
        add_side(surface, scale, p, q);
    }
}

//: Describe a merge
static tf_outcome try_merge(tf_adaptive_surface *surface, const tf_quad quad[2])
{
    tf_walls walls = {0};
    for (int i = 0; i < 4; i++) {
        int gone = quad[i / 2].triangle[i % 2];
        const int *v = tf_triangle(surface, gone);
        tf_surgery_remove(surface, gone);
        tf_walls_add(&walls, surface, v[0], v[1], v[2]);
    }
    add_tube(surface, quad);
    return tf_walls_try(&walls, surface);
}

//: Merge two edges
tf_status tf_adaptive_merge(tf_adaptive_surface *surface, const int first[2],
                            const int second[2], tf_outcome *outcome)
{
    TF_REQUIRE(first && second);
    tf_status status =
        tf_request_check(surface, first[0], first[1], NULL, outcome);
    if (status == TF_OK)
        status = tf_request_check(surface, second[0], second[1], NULL, outcome);
    if (status != TF_OK)
        return status;
    if (!tf_surgery_begin(surface, MERGE_ROOM))
        return TF_OUT_OF_MEMORY;
    tf_quad quad[2];
    *outcome = TF_IMPOSSIBLE;
    if (!find_quad(surface, first, &quad[0]) ||
        !find_quad(surface, second, &quad[1]) || !may_merge(surface, quad))
        return TF_OK;
    *outcome = try_merge(surface, quad);
    if (*outcome == TF_COMMITTED)
        tf_surgery_commit(surface);
    return TF_OK;
}
