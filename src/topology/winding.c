//: Cross a line in the plane
#include "topology/winding.h"

// A ray goes from the point along the axis 2.  It starts not quite there: by
// less than any coordinate can tell it is further along the axis 0, and by much
// less than that along the axis 1.  So it passes beside every edge.
static const int floor_plane[] = {0, 1};

/// Whether the ray, looked at along it, has an edge before it in the direction
/// of the axis 0: 1 if that leads along the axis 1, -1 if it leads back, else
/// 0.
static int passing(const double point[3], const double *from, const double *to)
{
    bool from_low = from[1] <= point[1], to_low = to[1] <= point[1];
    if (from_low == to_low)
        return 0;
    // If the edge and the point are in line, the ray is beyond the edge.
    tf_sign turn = from_low ? tf_turn(floor_plane, from, to, point)
                            : tf_turn(floor_plane, to, from, point);
    return turn == TF_POSITIVE ? from_low - to_low : 0;
}

//: Cross a triangle
/// Whether the line of the ray pierces a triangle: 1 if it leaves through it
/// what is behind the triangle, -1 if it enters, else 0.
static int piercing(const double point[3], const double *const corner[3])
{
    int sum = 0;
    for (int i = 0; i < 3; i++)
        sum += passing(point, corner[i], corner[(i + 1) % 3]);
    return sum;
}

/// Whether the triangle is before the point: then this is behind it if the ray
/// leaves there.
static bool is_ahead(const double point[3], const double *const corner[3],
                     int pierced)
{
    return (int)tf_side(corner[0], corner[1], corner[2], point) == -pierced;
}

int tf_winding_part(const double *const corner[3], const double point[3])
{
    int pierced = piercing(point, corner);
    return pierced != 0 && is_ahead(point, corner, pierced) ? pierced : 0;
}
