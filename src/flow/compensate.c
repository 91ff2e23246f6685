//: Find where volume is given back
#include "flow/flow_state.h"

#include "flow/patch.h"
#include "surgery/move.h"

/// Where a vertex gives 1/6 of `more`; false if that is too far away.
static bool find_place(const tf_flow_state *flow, int vertex, double more,
                       tf_vector *place)
{
    tf_vector from = tf_position_of(flow->remesher.surface, vertex);
    tf_patch star = tf_patch_of_star(flow->remesher.surface, vertex, from);
    *place = tf_patch_place(&star, more);
    double way = tf_vector_length(tf_vector_difference(*place, from));
    return way <= 0.1 * flow->remesher.edge;
}

//: Give volume back
tf_status tf_flow_restore_volume(tf_flow_state *flow, double more, int count,
                                 const int vertex[])
{
    tf_status status = TF_OK;
    for (int i = 0; i < count && status == TF_OK; i++) {
        double share = more / (count - i);
        tf_vector place;
        tf_outcome outcome;
        if (!find_place(flow, vertex[i], share, &place))
            continue;
        status = tf_adaptive_move(flow->remesher.surface, vertex[i], place.x,
                                  &outcome);
        if (status != TF_OK)
            return status;
        flow->report->shifted[outcome]++;
        if (outcome == TF_COMMITTED)
            more -= share;
    }
    return status;
}
