//: Declare contacts
#ifndef TF_QUERY_CONTACT_H
#define TF_QUERY_CONTACT_H

#include "contract.h"
#include "spacetime/complementary.h"

//: Declare a contact
/// What a query tells.  Where the verdict is TF_APART only `verdict` is set.
///
/// `normal` is the cross product of the edges that the two simplices in
/// contact have within t = 0 and within t = 1 (in the plane: the edge, turned
/// left by 90 degrees), scaled to length 1: for a point and a triangle it
/// follows the triangle's orientation, for two edges it is first x second.  It
/// is zero where those edges are dependent (an edge of no length, two parallel
/// edges, a triangle of no area) and where a rounded arithmetic overflows.
typedef struct tf_contact {
    tf_verdict verdict;
    tf_decision decision;
    double toi_lo, toi_hi; ///< enclose the earliest time of contact, 0 to 1
    /// The common point, as weights of the first element's vertices and of the
    /// second's.
    double weight[2][TF_VERTICES];
    double normal[TF_AXES];
    double velocity[TF_AXES]; ///< of the first relative to the second, a step
    double speed;             ///< velocity . normal; saturates at +-DBL_MAX
} tf_contact;

//: Declare the query of any two elements
/// Whether, when and how two moving elements first meet.  axes = 2: 1 + 2
/// vertices, axes = 3: 1 + 3 or 2 + 2.  Touching counts as meeting: elements
/// that touch at the start meet at t = 0, at rest or not.
///
/// An element is swept in the order of its vertices' indices, in whatever order
/// it lists them; vertices without index count in the order of the list (but
/// tf_perturbed needs indices).
///
/// No case is special.  An edge of no length is a point and a triangle of no
/// area an edge or a point, and is met as such; motion within a line or a plane
/// finds the first time at which the shapes within it meet; a normal that does
/// not exist is zero, and so is the speed then.
///
/// TF_NOT_FINITE or TF_OUT_OF_RANGE leave *contact unset.
tf_status tf_query(const tf_arithmetic *arithmetic, int axes, int vertices,
                   const tf_worldline first[], int others,
                   const tf_worldline second[], tf_contact *contact);

//: Close contacts
#endif
