//: Answer each contact by an impulse
#include "response/impulses.h"

#include "response/impulse.h"

#include <stddef.h>

static void read_displacements(const tf_step *step, double displacement[])
{
    size_t numbers = (size_t)step->axes * (size_t)step->vertices;
    for (size_t i = 0; i < numbers; i++)
        displacement[i] = step->end[i] - step->start[i];
}

void tf_impulses_round(tf_step *step, const tf_contacts *contacts,
                       const tf_contact_rule *rule, double friction,
                       double displacement[], tf_constraint constraint[])
{
    read_displacements(step, displacement);
    tf_bodies bodies = {step->axes, step->inverse_mass, displacement};
    for (size_t i = 0; i < contacts->count && tf_watch_work(step->watch, 4);
         i++) {
        double gap;
        constraint[i] = tf_contact_constraint(step, &contacts->contact[i], rule,
                                              false, &gap);
        tf_constraint_visit(&constraint[i], friction, &bodies);
    }
    for (int v = 0; v < step->vertices; v++)
        tf_step_move(step, v, step->end,
                     displacement + (ptrdiff_t)step->axes * v);
}
