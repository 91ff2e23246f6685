//: Find out whether a star is smooth
#include "flow/flow_state.h"

#include "flow/patch.h"
#include "surgery/move.h"
#include "surgery/star.h"

/// Whether the normals at a vertex differ so little that it is on no feature:
/// whether the mean square of their sines to the mean normal is small.
static bool is_smooth(const tf_adaptive_surface *surface, int vertex)
{
    tf_vector mean =
        tf_patch_of_star(surface, vertex, tf_position_of(surface, vertex))
            .normal;
    double along = 0, all = 0, square = tf_vector_dot(mean, mean);
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        tf_vector normal = tf_shape_normal(&shape);
        double area = tf_vector_length(normal);
        double cosine = tf_vector_dot(normal, mean);
        along += cosine * cosine / (area * square);
        all += area;
    }
    return all - along <= 0.1 * along;
}

//: Relax a vertex
/// Moves it towards the middle of its star, but so that the volume is kept.
static tf_status relax_vertex(tf_flow_state *flow, int vertex)
{
    tf_remesher *remesher = &flow->remesher;
    tf_vector place = tf_star_middle(remesher->surface, vertex);
    if (tf_flow_keeps_volume(flow, TF_SMOOTH)) {
        tf_patch star = tf_patch_of_star(remesher->surface, vertex, place);
        place = tf_patch_place(&star, 0);
    }
    if (!tf_is_worth_a_move(remesher, vertex, place) ||
        !tf_star_stays_good(remesher, vertex, TF_NONE, place))
        return TF_OK;
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_move(remesher->surface, vertex, place.x, &outcome);
    if (status == TF_OK)
        tf_remesher_count(remesher, TF_SMOOTH, outcome);
    return status;
}

//: Relax all vertices
tf_status tf_relax_pass(tf_flow_state *flow)
{
    const tf_adaptive_surface *surface = flow->remesher.surface;
    tf_status status = TF_OK;
    for (int v = 0; v < surface->vertices && status == TF_OK; v++)
        if (tf_first_corner(surface, v) != TF_NONE &&
            !tf_is_boundary_vertex(surface, v) && is_smooth(surface, v))
            status = relax_vertex(flow, v);
    return status;
}
