//: Declare the points of contacts
#pragma once

#include "query/motion.h"
#include "response/options.h"
#include "surface/contacts.h"
#include "writers/polydata.h"

/// Contacts as points, to look at.  All zero: there are none.
typedef struct tf_contact_points {
    tf_columns row; ///< a row for each
    bool answered;  ///< whether they are those of a response
} tf_contact_points;

void tf_contact_points_free(tf_contact_points *points);

/// Sets the points where elements touch, at the time when they do.  False: there
/// is no memory.
bool tf_contact_points_found(tf_contact_points *points, const tf_motion *motion,
                             const tf_contacts *contacts);

/// Sets the points of the first elements that were pushed, at the end of the
/// step.  False: there is no memory.
/// @param motion that to the resolved end
/// @param push of each contact
bool tf_contact_points_answered(tf_contact_points *points,
                                const tf_motion *motion, size_t count,
                                const tf_answered_contact contact[],
                                const double push[]);

/// The PolyData, which borrows the points: a vertex for each, with arrays normal,
/// time, kind (a tf_kind) and vertices; of contacts that were found also
/// normal_velocity, and of those that were answered impulse, push, level and
/// round.
tf_polydata tf_contact_points_data(const tf_contact_points *points);
