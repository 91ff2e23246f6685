//: Include what the check of a start needs
#include "response/start.h"

#include "arithmetic/exact.h"
#include "base/fail.h"
#include "query/query.h"
#include "surface/check.h"
#include "surface/crossing_error.h"

//: Check that a start has no intersections
tf_status tf_start_check(tf_surface *surface, const tf_motion *motion,
                         const tf_parallel *parallel, tf_error *error)
{
    tf_crossings found;
    tf_check_options options = {.parallel = parallel};
    tf_status status = tf_surface_check(surface, motion->vertices,
                                        motion->start, &options, &found, error);
    return status == TF_OK && found.count > 0
               ? tf_fail_crossing(error, TF_START_NOT_CLEAR, found.crossing, 0)
               : status;
}

//: Repeat the query of a contact at rest
enum {
    QUERY_WORK = 64 ///< units of work that a query takes, at most
};

/// Repeats the query of a contact with all vertices at rest.
static tf_status touch_at_start(const tf_motion *motion,
                                const tf_surface_contact *contact, bool *touch)
{
    int axes = motion->axes, first = contact->kind == TF_EDGE_EDGE ? 2 : 1;
    tf_motion rest = {axes, motion->vertices, motion->start, motion->start};
    tf_contact at_rest;
    tf_status status =
        tf_query_motion(&tf_exact, axes, &rest, first, contact->vertex,
                        axes + 1 - first, contact->vertex + first, &at_rest);
    *touch = status == TF_OK && at_rest.verdict == TF_HIT;
    return status;
}

//: Check that no contact is there at the start
static tf_status fail_at_contact(tf_error *error,
                                 const tf_surface_contact *contact)
{
    static const tf_subject subjects[] = {
        [TF_POINT_EDGE] = TF_POINT_EDGE_PAIR,
        [TF_POINT_TRIANGLE] = TF_POINT_TRIANGLE_PAIR,
        [TF_EDGE_EDGE] = TF_EDGE_EDGE_PAIR,
    };
    return tf_fail_pair(error, TF_START_NOT_CLEAR, subjects[contact->kind], 4,
                        contact->vertex, 0);
}

tf_status tf_start_check_contacts(const tf_motion *motion,
                                  const tf_contacts *contacts, tf_watch *watch,
                                  tf_error *error)
{
    for (size_t i = 0; i < contacts->count; i++) {
        const tf_surface_contact *contact = &contacts->contact[i];
        bool touch = false, is_late = contact->contact.toi_lo > 0;
        if (!tf_watch_work(watch, is_late ? 1 : QUERY_WORK))
            return tf_fail(error, TF_CANCELLED);
        if (is_late)
            continue;
        tf_status status = touch_at_start(motion, contact, &touch);
        if (status != TF_OK)
            return tf_fail(error, status);
        if (touch)
            return fail_at_contact(error, contact);
    }
    return TF_OK;
}
