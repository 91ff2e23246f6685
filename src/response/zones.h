//: Declare what zones are made of
#pragma once

#include "base/status.h"
#include "response/contact_constraint.h"
#include "response/groups.h"
#include "response/impulse.h"
#include "response/zone.h"
#include "surface/contacts.h"

#include <stddef.h>

/// The constraints of all rounds of a step, and workspace to divide them into
/// zones.
typedef struct tf_zones {
    int constraints;      ///< how many constraints have been kept so far
    int old;              ///< how many there were when zones were last solved
    tf_buffer constraint; ///< the constraints, with the vertices of the step
    tf_buffer gap;        ///< of each constraint
    tf_buffer entry;      ///< the ends, with all pushes, when the level began
    tf_buffer returns;    ///< how often contacts have come back
    tf_groups groups;     ///< of vertices: the zones
    tf_buffer by_vertex, by_constraint; ///< numbers for each of them
    tf_buffer zone_constraint, mass, displacement, workspace; ///< of one zone
    tf_buffer pushed; ///< its vertices' displacements with the pushes
} tf_zones;

/// How zones are solved.
typedef struct tf_zone_options {
    const tf_zone_solver *solver;
    tf_friction friction;
    int sweeps;
} tf_zone_options;

/// What it took to solve zones.
typedef struct tf_zone_statistics {
    size_t zones, largest, iterations;
    double violation;    ///< the largest that was left
    double smallest_gap; ///< of all contacts
} tf_zone_statistics;

//: Declare how zones grow and are solved
/// Forgets the constraints of the last step, and begins with this one.  False
/// if there is no memory.
bool tf_zones_begin(tf_zones *zones, const tf_step *step);

/// Adds a constraint for each contact.  False if there is no memory, or if the
/// caller has cancelled.
bool tf_zones_add(tf_zones *zones, const tf_step *step,
                  const tf_contacts *contacts, const tf_contact_rule *rule,
                  tf_zone_statistics *statistics);

/// Solves all zones that have a new constraint, taking the rule's base as the
/// proposal, pushes pairs apart, and moves the vertices.  False if there is no
/// memory, or if the caller has cancelled.
bool tf_zones_solve(tf_zones *zones, tf_step *step, const tf_contact_rule *rule,
                    const tf_zone_options *options,
                    tf_zone_statistics *statistics);

size_t tf_zones_memory(const tf_zones *zones);
void tf_zones_free(tf_zones *zones);
