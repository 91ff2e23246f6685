#include "support/scenes.h"

scene scene_of(const query *q, const int index[])
{
    scene s = {.axes = q->axes};
    for (int i = 0; i < q->vertices + q->others; i++) {
        s.index[i] = index[i];
        for (int k = 0; k < q->axes; k++) {
            s.start[q->axes * index[i] + k] = q->vertex[i].at[0].x[k];
            s.end[q->axes * index[i] + k] = q->vertex[i].at[1].x[k];
        }
    }
    return s;
}

tf_motion scene_motion(const scene *s)
{
    return (tf_motion){.axes = s->axes,
                       .vertices = SCENE_VERTICES,
                       .start = s->start,
                       .end = s->end};
}

query scene_hit(query_kind kind)
{
    // A point falls on an edge, a point on a triangle, an edge across an edge.
    static const double rows[KINDS][2 * QUERY_VERTICES * TF_AXES] = {
        {0, 1, -1, 0, 2, 0, 0, -1, -1, 0, 2, 0},
        {1, 1, 1,  0, 0, 0, 4, 0, 0, 0, 4, 0,
         1, 1, -1, 0, 0, 0, 4, 0, 0, 0, 4, 0},
        {-1, 0, 1,  2, 0, 1,  0, -1, 0, 0, 3, 0,
         -1, 0, -1, 2, 0, -1, 0, -1, 0, 0, 3, 0},
    };
    query q = query_new(kind);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = rows[kind][i];
    return q;
}
