//: Describe a collapse in a flow
#include "flow/flow_state.h"

#include "flow/butterfly.h"
#include "flow/patch.h"
#include "remesh/crease.h"
#include "surgery/collapse.h"
#include "surgery/star.h"

/// Which vertex goes, which stays, and where.
typedef struct coarsening {
    int from, to;
    tf_vector place;
} coarsening;

/// The triangles at both ends of an edge, each once.
static tf_patch patch_of_stars(const tf_adaptive_surface *surface, int a, int b,
                               tf_vector apex)
{
    tf_patch patch = tf_patch_of_star(surface, a, apex);
    int c = tf_first_corner(surface, b);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        const int *vertex = tf_triangle(surface, c / 3);
        tf_shape shape = tf_shape_of(surface, c / 3);
        if (vertex[0] != a && vertex[1] != a && vertex[2] != a)
            tf_patch_add(&patch, &shape);
    }
    return patch;
}

//: Choose the place of a collapse inside
/// False if the volume cannot be kept nearby.
static bool choose_inside(const tf_flow_state *flow, int corner,
                          coarsening *chosen)
{
    const tf_adaptive_surface *surface = flow->remesher.surface;
    tf_vector point = tf_butterfly_point(surface, corner);
    tf_patch patch = patch_of_stars(surface, chosen->from, chosen->to, point);
    chosen->place = point;
    if (tf_flow_keeps_volume(flow, TF_COLLAPSE))
        chosen->place = tf_patch_place(&patch, 0);
    tf_vector shift = tf_vector_difference(chosen->place, point);
    return tf_vector_length(shift) <= 0.3 * flow->remesher.edge;
}

//: Choose how the boundary collapses
/// A vertex inside goes to one on the boundary; of two on the boundary the freer
/// one goes to the other.  False if that would change the boundary much.
static bool choose_at_rim(const tf_adaptive_surface *surface, int corner,
                          coarsening *chosen)
{
    bool from = tf_is_boundary_vertex(surface, chosen->from),
         to = tf_is_boundary_vertex(surface, chosen->to);
    tf_freedom own = from ? tf_freedom_of(surface, chosen->from) : TF_FREE;
    tf_freedom other = to ? tf_freedom_of(surface, chosen->to) : TF_FREE;
    if (other > own) {
        int swap = chosen->from;
        chosen->from = chosen->to;
        chosen->to = swap;
        own = other;
    }
    chosen->place = tf_position_of(surface, chosen->to);
    return own == TF_FREE ||
           (own == TF_ALONG_CREASE && tf_is_boundary_edge(surface, corner));
}

static bool choose_coarsening(const tf_flow_state *flow, int corner,
                              coarsening *chosen)
{
    const tf_adaptive_surface *surface = flow->remesher.surface;
    chosen->from = tf_vertex_at(surface, corner);
    chosen->to = tf_vertex_at(surface, tf_corner_after(corner));
    if (tf_is_boundary_vertex(surface, chosen->from) ||
        tf_is_boundary_vertex(surface, chosen->to))
        return choose_at_rim(surface, corner, chosen);
    return choose_inside(flow, corner, chosen);
}

//: Coarsen an edge
static bool is_good(const tf_flow_state *flow, const coarsening *chosen)
{
    const tf_remesher *remesher = &flow->remesher;
    int from = chosen->from, to = chosen->to;
    double most = remesher->edge * 1.5;
    return tf_edges_stay_short(remesher->surface, from, to, chosen->place,
                               most) &&
           tf_edges_stay_short(remesher->surface, to, from, chosen->place,
                               most) &&
           tf_star_stays_good(remesher, from, to, chosen->place) &&
           tf_star_stays_good(remesher, to, from, chosen->place);
}

static tf_status coarsen_edge(tf_flow_state *flow, const tf_edge_row *edge)
{
    tf_adaptive_surface *surface = flow->remesher.surface;
    int corner = tf_find_edge(surface, edge->a, edge->b);
    coarsening chosen;
    if (corner == TF_NONE ||
        tf_length_of(surface, edge->a, edge->b) > edge->length ||
        !choose_coarsening(flow, corner, &chosen) || !is_good(flow, &chosen))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = tf_adaptive_collapse_to(surface, chosen.from, chosen.to,
                                               chosen.place.x, &outcome);
    if (status == TF_OK)
        tf_remesher_count(&flow->remesher, TF_COLLAPSE, outcome);
    return status;
}

//: Coarsen all short edges
tf_status tf_coarsen_pass(tf_flow_state *flow)
{
    tf_remesher *remesher = &flow->remesher;
    if (!tf_remesher_list(remesher, 0, remesher->edge / 2))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = 0; i < remesher->rows && status == TF_OK; i++)
        status = coarsen_edge(flow, &row[i]);
    return status;
}
