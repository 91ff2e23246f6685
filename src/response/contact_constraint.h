//: Declare the constraint of a contact
#pragma once

#include "geometry/step.h"
#include "response/constraint.h"
#include "surface/contacts.h"

/// How contacts become constraints.
typedef struct tf_contact_rule {
    double separation;  ///< pairs that meet and start nearer than this are
                        ///< pushed apart
    double restitution; ///< 0 to 1
    double threshold;   ///< elements that approach each other by less than this
                        ///< have no restitution
    const double *base; ///< the ends from which the response sets out: how far
        ///< elements approach each other with these decides what
        ///< restitution returns, and how much room they get
    const unsigned char *squeezed; ///< whether each vertex is between scripted
        ///< ones that need room: contacts that have one
        ///< demand no more than that a little of their
        ///< gap is left; NULL: none is
    double thickness; ///< the distance of pairs that are no contacts
} tf_contact_rule;

//: Declare the gap of a contact
/// The gap between the elements of a contact, along the constraint's normal.
typedef struct tf_contact_gap {
    double start; ///< its width at the start, between the points of contact or
                  ///< the pivots
    double room;  ///< by how much it is to be wider at the end, 0 or more: what
                  ///< the motion leaves of this is up to the push
    double push;  ///< a second impulse along the normal, 0 or more, that makes
                  ///< room: it moves vertices, and gives them no velocity
} tf_contact_gap;

//: Declare how contacts become constraints

/// The constraint of the two points of a contact as it is, to be listed and not
/// to be solved: along its own normal, if it has one, turned such that the
/// elements do not move apart along it, and without a bound.
tf_constraint tf_contact_points(const tf_surface_contact *contact);

/// Makes the constraint of a contact, with the numbers that its vertices have
/// in the step.  If the constraint of the point of contact is no good, or if
/// `by_pivots`, it is the constraint of the contact's two pivots, as far as
/// they have one.  Sets `*gap`, without a push.
tf_constraint tf_contact_constraint(const tf_step *step,
                                    const tf_surface_contact *contact,
                                    const tf_contact_rule *rule, bool by_pivots,
                                    tf_contact_gap *gap);
