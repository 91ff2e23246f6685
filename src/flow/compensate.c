//: Find where volume is given back
#include "flow/flowing.h"

#include "flow/patch.h"
#include "surgery/operations.h"

/// Where a vertex gives 1/6 of `more`; false if that is too far away.
static bool find_place(const tf_flowing *of, int vertex, double more,
                       tf_vector *place)
{
    tf_vector from = tf_position_of(of->remesher.of, vertex);
    tf_patch star = tf_patch_of_star(of->remesher.of, vertex, from);
    *place = tf_patch_place(&star, more);
    double way = tf_vector_length(tf_vector_difference(*place, from));
    return way <= 0.1 * of->remesher.edge;
}

//: Give volume back
tf_status tf_flowing_give(tf_flowing *of, double more, int count,
                          const int vertex[])
{
    tf_status status = TF_OK;
    for (int i = 0; i < count && status == TF_OK; i++) {
        double share = more / (count - i);
        tf_vector place;
        tf_outcome outcome;
        if (!find_place(of, vertex[i], share, &place))
            continue;
        status =
            tf_adaptive_move(of->remesher.of, vertex[i], place.x, &outcome);
        if (status != TF_OK)
            return status;
        of->report->shifted[outcome]++;
        if (outcome == TF_COMMITTED)
            more -= share;
    }
    return status;
}
