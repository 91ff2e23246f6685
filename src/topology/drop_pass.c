//: Measure a part
#include "topology/reconnector.h"

#include "topology/component.h"
#include "topology/topology.h"

static double volume_of_part(const tf_adaptive *of, int count,
                             const int triangle[])
{
    tf_vector point = tf_position_of(of, *tf_triangle(of, triangle[0]));
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += tf_volume_below(of, triangle[i], point);
    return sum;
}

//: Drop a part if it is small
static tf_status drop_part(tf_reconnector *of, int count, const int triangle[])
{
    double volume = volume_of_part(of->of, count, triangle);
    if (!(fabs(volume) < of->options.drop))
        return TF_OK;
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_drop(of->of, *tf_triangle(of->of, *triangle), &outcome);
    if (status == TF_OK)
        tf_reconnector_count(of, TF_DROP, outcome, -volume);
    return status;
}

//: Drop all small parts
tf_status tf_drop_pass(tf_reconnector *of)
{
    tf_parts parts = {0};
    bool room = tf_parts_begin(&parts, of->of);
    tf_status status = room ? TF_OK : TF_OUT_OF_MEMORY;
    for (int t = 0; t < of->of->triangles && status == TF_OK; t++) {
        if (!tf_is_triangle(of->of, t) || tf_is_listed(&parts, t))
            continue;
        int before = parts.count, count = tf_parts_add(&parts, of->of, t);
        status = drop_part(of, count, tf_parts_list(&parts) + before);
    }
    tf_parts_free(&parts);
    return status;
}
