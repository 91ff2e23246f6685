//: End a stage
#include "topology/stage.h"

void tf_surgery_settle(tf_adaptive_surface *surface)
{
    tf_surgery *surgery = &surface->surgery;
    surgery->settled = surgery->grafts;
    surgery->sweeps = surgery->rims = 0;
}

//: Withdraw a triangle
static bool has_corner(const tf_added_triangle *graft, int vertex)
{
    const int *v = graft->facet.vertex;
    return v[0] == vertex || v[1] == vertex || v[2] == vertex;
}

void tf_surgery_withdraw(tf_adaptive_surface *surface, int a, int b, int c)
{
    tf_surgery *surgery = &surface->surgery;
    tf_added_triangle *graft = surgery->graft.data;
    for (int i = 0; i < surgery->settled; i++)
        if (has_corner(&graft[i], a) && has_corner(&graft[i], b) &&
            has_corner(&graft[i], c)) {
            graft[i] = graft[--surgery->settled];
            surgery->grafts = surgery->settled;
            return;
        }
}
