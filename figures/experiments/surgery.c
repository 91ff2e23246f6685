#include "surgery/surgery.h"
#include "experiments/leave_out.h"
#include "surgery/tetrahedron.h"

static unsigned left_out;

void leave_out(unsigned outcomes)
{
    left_out = outcomes;
}

bool is_left_out(tf_outcome outcome)
{
    return (left_out >> outcome & 1) != 0;
}

// What each test asks, and what it hears if it is left out --------------------

// D: is a new triangle collinear?
bool __real_tf_are_collinear(const double *a, const double *b, const double *c);
bool __wrap_tf_are_collinear(const double *a, const double *b, const double *c)
{
    return !is_left_out(TF_FLATTENED) && __real_tf_are_collinear(a, b, c);
}

// S: does a new triangle overlap another?
bool __real_tf_facets_overlap(const tf_facet *a, const tf_facet *b);
bool __wrap_tf_facets_overlap(const tf_facet *a, const tf_facet *b)
{
    return !is_left_out(TF_OVERLAPPED) && __real_tf_facets_overlap(a, b);
}

// V: is a vertex in a tetrahedron?
bool __real_tf_tetrahedron_holds(const tf_tetrahedron *tetrahedron,
                                 const double *p, unsigned outside);
bool __wrap_tf_tetrahedron_holds(const tf_tetrahedron *tetrahedron,
                                 const double *p, unsigned outside)
{
    return !is_left_out(TF_PASSED_VERTEX) &&
           __real_tf_tetrahedron_holds(tetrahedron, p, outside);
}

// E: does an edge meet a tetrahedron?
bool __real_tf_tetrahedron_meets(const tf_tetrahedron *tetrahedron,
                                 const tf_located_edge *edge);
bool __wrap_tf_tetrahedron_meets(const tf_tetrahedron *tetrahedron,
                                 const tf_located_edge *edge)
{
    return !is_left_out(TF_PASSED_EDGE) &&
           __real_tf_tetrahedron_meets(tetrahedron, edge);
}

// X: which vertex moves, and so may pass through triangles?
void __real_tf_surgery_move(tf_adaptive_surface *surface, int from, int to);
void __wrap_tf_surgery_move(tf_adaptive_surface *surface, int from, int to)
{
    if (!is_left_out(TF_PASSED_TRIANGLE))
        __real_tf_surgery_move(surface, from, to);
}
