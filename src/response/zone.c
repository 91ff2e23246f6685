//: Ask whether to go on
#include "response/zone.h"

#include "base/require.h"
#include "base/watch.h"
#include "response/impulse.h"

#include <string.h>

enum {
    VISIT = 2 ///< units of work
};

bool tf_zone_goes_on(const tf_zone *zone, size_t visits)
{
    TF_REQUIRE(zone);
    return tf_watch_work(zone->watch, VISIT * visits);
}

//: Tell a solver the friction of a constraint
double tf_zone_friction(const tf_zone *zone, const tf_constraint *constraint)
{
    TF_REQUIRE(zone && constraint);
    bool own = zone->friction < 0;
    tf_friction friction = {zone->friction,
                            own ? zone->inverse_mass + zone->vertices : NULL};
    return tf_constraint_friction(constraint, friction);
}

//: Multiply by a zone's matrix
void tf_zone_push(const tf_zone *zone, const double impulse[],
                  double displacement[])
{
    TF_REQUIRE(zone && impulse && displacement);
    tf_bodies bodies = {zone->axes, zone->inverse_mass, displacement};
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1);
         i++) {
        const tf_constraint *constraint = &zone->constraint[i];
        tf_vector normal = tf_vector_at(constraint->normal, 0);
        tf_constraint_push(constraint, tf_vector_scaled(impulse[i], normal),
                           &bodies);
    }
}

void tf_zone_gap_changes(const tf_zone *zone, const double displacement[],
                         double gap_change[])
{
    TF_REQUIRE(zone && displacement && gap_change);
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1); i++)
        gap_change[i] = tf_constraint_gap_change(
            zone->axes, &zone->constraint[i], displacement);
}

void tf_zone_multiply(const tf_zone *zone, const double impulse[],
                      double gap_change[], double workspace[])
{
    TF_REQUIRE(zone && impulse && gap_change && workspace);
    size_t numbers = (size_t)zone->axes * (size_t)zone->vertices;
    memset(workspace, 0, numbers * sizeof *workspace);
    tf_zone_push(zone, impulse, workspace);
    tf_zone_gap_changes(zone, workspace, gap_change);
}
