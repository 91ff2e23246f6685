#include "support/careless.h"

#include "flow/butterfly.h"
#include "flow/flow_state.h"
#include "flow/keep_volume.h"
#include "remesh/passes.h"
#include "surgery/star.h"
#include "topology/reconnect.h"

// The policy ------------------------------------------------------------------

static bool choose_split(tf_remesher *remesher, int corner, int refused,
                         tf_vector *position, tf_volume_error *error)
{
    bool chosen =
        tf_keep_volume.choose_split(remesher, corner, refused, position, error);
    error->count = 0;
    return chosen;
}

static bool choose_collapse(tf_remesher *remesher, int corner,
                            tf_edge_collapse *collapse)
{
    const tf_adaptive_surface *surface = remesher->surface;
    int from = tf_vertex_at(surface, corner);
    int to = tf_vertex_at(surface, tf_corner_after(corner));
    if (tf_is_boundary_vertex(surface, from) ||
        tf_is_boundary_vertex(surface, to))
        return tf_keep_volume.choose_collapse(remesher, corner, collapse);
    *collapse =
        (tf_edge_collapse){from, to, tf_butterfly_point(surface, corner)};
    return true;
}

static bool choose_flip(tf_remesher *remesher, const tf_diagonals *diagonals,
                        tf_volume_error *error)
{
    bool chosen = tf_keep_volume.choose_flip(remesher, diagonals, error);
    error->count = 0;
    return chosen;
}

static bool choose_move(tf_remesher *remesher, int vertex, tf_vector *position)
{
    bool chosen = tf_keep_volume.choose_move(remesher, vertex, position);
    *position = tf_star_middle(remesher->surface, vertex);
    return chosen;
}

tf_remesh_policy careless_policy(unsigned operations)
{
    tf_remesh_policy policy = tf_keep_volume;
    if (operations >> TF_SPLIT & 1)
        policy.choose_split = choose_split;
    if (operations >> TF_COLLAPSE & 1)
        policy.choose_collapse = choose_collapse;
    if (operations >> TF_FLIP & 1)
        policy.choose_flip = choose_flip;
    if (operations >> TF_SMOOTH & 1)
        policy.choose_move = choose_move;
    return policy;
}

// The step --------------------------------------------------------------------

static tf_status improve(tf_flow *flow, unsigned operations, double edge)
{
    tf_remesh_policy policy = careless_policy(operations);
    flow->remesher.policy = &policy;
    flow->remesher.options = (tf_remesh_options){.edge = edge};
    tf_status status = tf_remesh_round(&flow->remesher);
    flow->remesher.policy = &tf_keep_volume;
    return status;
}

static tf_status move(tf_flow_advance *advance, bool careless,
                      const tf_flow_options *options, double time, double step,
                      tf_flow_report *report)
{
    tf_status status = tf_advance_begin(advance, options, time, step);
    if (status != TF_OK)
        return status;
    tf_advance_propose(advance);
    if (!careless)
        tf_advance_restore_volume(advance);
    return tf_advance_resolve(advance, &report->response);
}

tf_status careless_step(tf_flow *flow, unsigned operations,
                        const tf_flow_options *options, double time,
                        double step, tf_flow_report *report)
{
    tf_adaptive_surface *surface = flow->remesher.surface;
    tf_reconnect_options lengths = {.edge = options->edge};
    *report = (tf_flow_report){0};
    tf_status status = improve(flow, operations, options->edge);
    if (status == TF_OK && !options->keep_topology)
        status = tf_adaptive_reconnect(surface, &lengths, &report->reconnected);
    if (status == TF_OK)
        status = tf_adaptive_compact(surface, NULL);
    return status == TF_OK && surface->triangles > 0
               ? move(&flow->advance, operations >> TF_OPERATIONS & 1, options,
                      time, step, report)
               : status;
}
