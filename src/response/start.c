//: Include what the check of a start needs
#include "response/start.h"

#include "arithmetic/exact.h"
#include "query/query.h"

#include <string.h>

//: Check that a start has no intersections
tf_status tf_start_check(tf_surface *surface, const tf_motion *motion,
                         const tf_parallel *parallel, tf_obstacle *obstacle)
{
    tf_crossings found;
    tf_status status =
        tf_surface_check(surface, motion->start, motion->vertices, parallel,
                         &found, &obstacle->flaw);
    if (status != TF_OK || found.count == 0)
        return status;
    obstacle->crossing = found.crossing->kind;
    memcpy(obstacle->vertex, found.crossing->vertex, sizeof obstacle->vertex);
    return TF_START_NOT_CLEAR;
}

//: Check that no contact is there at the start
/// Repeats the query of a contact with all vertices at rest.
static tf_status touch_at_start(const tf_motion *motion, int axes,
                                const tf_surface_contact *contact, bool *touch)
{
    tf_motion rest = {motion->vertices, motion->start, motion->start};
    int first = contact->kind == TF_EDGE_EDGE ? 2 : 1;
    tf_contact at_rest;
    tf_status status =
        tf_query_motion(&tf_exact, axes, &rest, first, contact->vertex,
                        axes + 1 - first, contact->vertex + first, &at_rest);
    *touch = status == TF_OK && at_rest.verdict == TF_HIT;
    return status;
}

tf_status tf_start_check_contacts(const tf_motion *motion, int axes,
                                  const tf_contacts *contacts,
                                  tf_obstacle *obstacle)
{
    for (size_t i = 0; i < contacts->count; i++) {
        const tf_surface_contact *contact = &contacts->contact[i];
        bool touch = false;
        if (contact->contact.toi_lo > 0)
            continue;
        tf_status status = touch_at_start(motion, axes, contact, &touch);
        if (status != TF_OK)
            return status;
        if (!touch)
            continue;
        obstacle->touching = contact->kind;
        memcpy(obstacle->vertex, contact->vertex, sizeof contact->vertex);
        return TF_START_NOT_CLEAR;
    }
    return TF_OK;
}
