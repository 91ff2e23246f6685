//: Orient a tetrahedron
#include "surgery/tetrahedron.h"

tf_tetrahedron tf_tetrahedron_of(const int vertex[4],
                                 const double *const corner[4])
{
    tf_tetrahedron made = {
        .orientation = tf_side(corner[0], corner[1], corner[2], corner[3])};
    for (int i = 0; i < 4; i++) {
        made.vertex[i] = vertex[i];
        made.corner[i] = corner[i];
    }
    return made;
}

//: Find the faces that a point is outside of
/// Whether a point is strictly on the other side of the face opposite to a
/// corner: with the point in the place of the corner, the volume changes its
/// sign.
static bool is_beyond(const tf_tetrahedron *tetrahedron, int corner,
                      const double *p)
{
    const double *x[4];
    for (int i = 0; i < 4; i++)
        x[i] = i == corner ? p : tetrahedron->corner[i];
    return tf_side(x[0], x[1], x[2], x[3]) == -tetrahedron->orientation;
}

unsigned tf_tetrahedron_outside(const tf_tetrahedron *tetrahedron,
                                const double *p)
{
    unsigned outside = 0;
    if (tetrahedron->orientation != TF_ZERO)
        for (int i = 0; i < 4; i++)
            outside |= is_beyond(tetrahedron, i, p) ? 1U << i : 0;
    return outside;
}

//: Separate an element by the plane of a face
int tf_tetrahedron_corner(const tf_tetrahedron *tetrahedron, int vertex)
{
    for (int i = 0; i < 4; i++)
        if (tetrahedron->vertex[i] == vertex)
            return i;
    return -1;
}

/// Whether all vertices are strictly beyond the face opposite to a corner, but
/// for those on it.
static bool is_all_beyond(const tf_tetrahedron *tetrahedron, int corner,
                          int count, const tf_facet *element)
{
    for (int i = 0; i < count; i++) {
        int own = tf_tetrahedron_corner(tetrahedron, element->vertex[i]);
        if (own == corner ||
            (own < 0 && !is_beyond(tetrahedron, corner, element->corner[i])))
            return false;
    }
    return true;
}

bool tf_tetrahedron_is_apart(const tf_tetrahedron *tetrahedron, int count,
                             const tf_facet *element)
{
    for (int i = 0; i < 4 && tetrahedron->orientation != TF_ZERO; i++)
        if (is_all_beyond(tetrahedron, i, count, element))
            return true;
    return false;
}

//: Find the face opposite to a corner
static void face_opposite(const tf_tetrahedron *tetrahedron, int corner,
                          const double *face[3])
{
    for (int i = 0; i < 3; i++)
        face[i] = tetrahedron->corner[(corner + 1 + i) % 4];
}

//: Hold a point
bool tf_tetrahedron_holds(const tf_tetrahedron *tetrahedron, const double *p,
                          unsigned outside)
{
    if (tetrahedron->orientation != TF_ZERO)
        return outside == 0;
    for (int i = 0; i < 4; i++) {
        const double *face[3];
        face_opposite(tetrahedron, i, face);
        if (tf_point_touches_triangle(p, face))
            return true;
    }
    return false;
}

//: Meet a face
static bool meets_face(const tf_tetrahedron *tetrahedron, int corner,
                       const tf_located_edge *edge)
{
    const double *face[3];
    face_opposite(tetrahedron, corner, face);
    return tf_edge_touches_triangle(edge->end[0], edge->end[1], face);
}

//: Meet an edge that starts from a corner
/// An edge leaves its corner for the inside unless its other end is outside of
/// a face at that corner; and it leaves the tetrahedron through the face
/// opposite, if not there, then nowhere.
static bool enters_at(const tf_tetrahedron *tetrahedron, int corner,
                      const tf_located_edge *edge, unsigned outside)
{
    return (outside & ~(1U << corner)) == 0 &&
           meets_face(tetrahedron, corner, edge);
}

//: Meet an edge
bool tf_tetrahedron_meets(const tf_tetrahedron *tetrahedron,
                          const tf_located_edge *edge)
{
    int first = tf_tetrahedron_corner(tetrahedron, edge->vertex[0]);
    int second = tf_tetrahedron_corner(tetrahedron, edge->vertex[1]);
    if (first >= 0 && second >= 0)
        return false;
    if (first >= 0)
        return enters_at(tetrahedron, first, edge, edge->outside[1]);
    if (second >= 0)
        return enters_at(tetrahedron, second, edge, edge->outside[0]);
    if ((edge->outside[0] & edge->outside[1]) != 0)
        return false;
    for (int i = 0; i < 4; i++)
        if (meets_face(tetrahedron, i, edge))
            return true;
    return false;
}
