//: End a stage
#include "topology/stage.h"

void tf_surgery_end_stage(tf_adaptive_surface *surface)
{
    tf_surgery *surgery = &surface->surgery;
    surgery->earlier = surgery->additions;
    surgery->sweeps = surgery->boundary_edges = 0;
}

//: Withdraw a triangle
static bool has_corner(const tf_added_triangle *added, int vertex)
{
    const int *v = added->facet.vertex;
    return v[0] == vertex || v[1] == vertex || v[2] == vertex;
}

void tf_surgery_withdraw(tf_adaptive_surface *surface, int a, int b, int c)
{
    tf_surgery *surgery = &surface->surgery;
    tf_added_triangle *added = surgery->added.data;
    for (int i = 0; i < surgery->earlier; i++)
        if (has_corner(&added[i], a) && has_corner(&added[i], b) &&
            has_corner(&added[i], c)) {
            added[i] = added[--surgery->earlier];
            surgery->additions = surgery->earlier;
            return;
        }
}
