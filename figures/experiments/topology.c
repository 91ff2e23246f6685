#include "experiments/leave_out.h"
#include "topology/winding.h"

// V, for a ball: how often do triangles go around a vertex?
int __real_tf_winding_part(const double *const corner[3],
                           const double point[3]);
int __wrap_tf_winding_part(const double *const corner[3], const double point[3])
{
    return is_left_out(TF_PASSED_VERTEX)
               ? 0
               : __real_tf_winding_part(corner, point);
}
