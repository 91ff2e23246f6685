#include "support/careless.h"

#include "flow/butterfly.h"
#include "flow/flow_state.h"
#include "flow/keep_volume.h"
#include "remesh/passes.h"
#include "surgery/draft.h"
#include "surgery/star.h"
#include "topology/passes.h"

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
    tf_status status = tf_draft_begin(&flow->draft, flow->surface, NULL);
    if (status != TF_OK)
        return status;
    flow->remesher.policy = &policy;
    flow->remesher.edge = edge;
    flow->remesher.report = (tf_remesh_report){0};
    status = tf_sharp_edges_find(&flow->remesher.sharp, &flow->draft,
                                 &tf_sharp_boundary, NULL);
    if (status != TF_OK)
        return status;
    status = tf_remesh_round(&flow->remesher);
    flow->remesher.policy = &tf_keep_volume;
    return status;
}

static tf_status reconnect(tf_flow *flow, const tf_flow_options *options)
{
    tf_reconnector *reconnector = &flow->reconnector;
    tf_reconnect_options own, lengths = {.edge = options->edge};
    reconnector->report = (tf_reconnect_report){0};
    if (options->keep_topology)
        return TF_OK;
    tf_status status = tf_reconnect_options_read(
        &own, &lengths, flow->surface->scale, &reconnector->lengths, NULL);
    return status == TF_OK ? tf_reconnect_passes(reconnector) : status;
}

static tf_status move(tf_flow *flow, bool careless,
                      const tf_flow_options *options, double time, double step)
{
    tf_flow_advance *advance = &flow->advance;
    tf_status status = tf_adaptive_compact(&flow->draft, NULL);
    if (status != TF_OK || flow->draft.triangles == 0)
        return status;
    status = tf_advance_begin(advance, options, time, step);
    if (status == TF_OK)
        status = tf_advance_propose(advance);
    if (status == TF_OK && !careless)
        status = tf_advance_restore_volume(advance);
    return status == TF_OK ? tf_advance_resolve(advance, &flow->report.response)
                           : status;
}

tf_status careless_step(tf_flow *flow, unsigned operations, double time,
                        double step, const tf_flow_options *options,
                        const tf_flow_report **report)
{
    flow->report = (tf_flow_report){.reconnected = &flow->reconnector.report,
                                    .response = &flow->no_response};
    tf_status status = improve(flow, operations, options->edge);
    if (status == TF_OK)
        status = reconnect(flow, options);
    if (status == TF_OK)
        status =
            move(flow, operations >> CARELESS_ADVANCE & 1, options, time, step);
    if (status == TF_OK)
        tf_draft_accept(&flow->draft, flow->surface);
    if (report)
        *report = &flow->report;
    return status;
}
