//: Answer each contact by an impulse
#include "response/impulses.h"

#include <stddef.h>

static void read_displacements(const tf_step *step, const double end[],
                               double displacement[])
{
    size_t numbers = (size_t)step->axes * (size_t)step->vertices;
    for (size_t i = 0; i < numbers; i++)
        displacement[i] = end[i] - step->start[i];
}

//: Make room for a pair
/// Gives the vertices the impulse of a constraint where they are with all pushes,
/// and pushes them until the gap has its room.
static void make_room(const tf_constraint *constraint, const tf_bodies *pushed,
                      tf_contact_gap *gap)
{
    tf_vector normal = tf_vector_at(constraint->normal, 0);
    tf_vector friction = tf_vector_at(constraint->friction, 0);
    tf_constraint_push(constraint,
                       tf_vector_sum(friction, constraint->impulse, normal),
                       pushed);
    tf_constraint pushing = *constraint;
    pushing.bound = gap->room;
    pushing.impulse = 0;
    tf_constraint_visit(&pushing, 0, pushed);
    gap->push = pushing.impulse;
}

//: Go through the contacts once
void tf_impulses_round(tf_step *step, const tf_contacts *contacts,
                       const tf_contact_rule *rule, tf_friction friction,
                       double displacement[], tf_constraint constraint[],
                       tf_contact_gap gap[])
{
    double *pushed = displacement + (size_t)step->axes * (size_t)step->vertices;
    read_displacements(step, step->unpushed, displacement);
    read_displacements(step, step->end, pushed);
    tf_bodies bodies = {step->axes, step->inverse_mass, displacement};
    tf_bodies pushed_bodies = {step->axes, step->inverse_mass, pushed};
    for (size_t i = 0; i < contacts->count && tf_watch_work(step->watch, 4);
         i++) {
        constraint[i] = tf_contact_constraint(step, &contacts->contact[i], rule,
                                              false, &gap[i]);
        tf_constraint_visit(&constraint[i],
                            tf_constraint_friction(&constraint[i], friction),
                            &bodies);
        make_room(&constraint[i], &pushed_bodies, &gap[i]);
    }
    for (int v = 0; v < step->vertices; v++) {
        ptrdiff_t place = (ptrdiff_t)step->axes * v;
        tf_step_move(step, v, step->unpushed, displacement + place,
                     step->unpushed);
        tf_step_move(step, v, step->end, pushed + place, step->end);
    }
}
