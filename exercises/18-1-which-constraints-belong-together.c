/* Exercise 18.1.  Zones: which constraints belong together.
 *
 * Two constraints are neighbors if they share a free vertex, one of positive
 * inverse mass, and a zone is all that can be reached from a constraint by
 * going from neighbor to neighbor.  Set zone[i] to the number of the zone of
 * constraint i.  Zones are numbered from 0, in the order of their first
 * constraints.  A constraint whose vertices are all scripted is in no zone, and
 * gets -1.  Return how many zones there are.
 *
 * Section: What belongs together.
 *
 * Hint 1: Constraint 0 may be in the zone of constraint 1 only because of
 *     constraint 2.
 * Hint 2: Give every constraint a label of its own.  As long as two neighbors
 *     have different labels, give both the smaller one.
 * Hint 3: A vertex of -1 is none.
 */
#include "response/constraint.h"

#include <stdbool.h>

/// Whether impulses of a constraint move its i-th vertex.
static bool moves(const tf_constraint *constraint, int i,
                  const double inverse_mass[])
{
#if defined TF_WRONG_1 // the floor connects all that touches it
    return constraint->vertex[i] >= 0 &&
           inverse_mass[constraint->vertex[i]] >= 0;
#else
    return constraint->vertex[i] >= 0 &&
           inverse_mass[constraint->vertex[i]] > 0;
#endif
}

static bool are_neighbors(const tf_constraint *a, const tf_constraint *b,
                          const double inverse_mass[])
{
    for (int i = 0; i < 4; i++)
#if defined TF_WRONG_2 // compares first vertices with first, and so on
        for (int j = i; j <= i; j++)
#else
        for (int j = 0; j < 4; j++)
#endif
            if (moves(a, i, inverse_mass) && moves(b, j, inverse_mass) &&
                a->vertex[i] == b->vertex[j])
                return true;
    return false;
}

/// Whether a constraint moves anything.
static bool moves_any(const tf_constraint *constraint,
                      const double inverse_mass[])
{
    return are_neighbors(constraint, constraint, inverse_mass);
}

int number_zones(int constraints, const tf_constraint constraint[],
                 const double inverse_mass[], int zone[])
{
    int zones = 0;
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    for (int i = 0; i < constraints; i++)
        zone[i] = i;
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < constraints; i++)
            for (int j = 0; j < constraints; j++)
                if (zone[j] < zone[i] &&
                    are_neighbors(&constraint[i], &constraint[j],
                                  inverse_mass)) {
                    zone[i] = zone[j];
                    changed = true;
                }
    }
    // A label is the place of the zone's first constraint, which has its
    // number.
    for (int i = 0; i < constraints; i++)
        zone[i] = !moves_any(&constraint[i], inverse_mass) ? -1
                  : zone[i] == i                           ? zones++
                                                           : zone[zone[i]];
#elif defined TF_WRONG_3 // looks only at constraints before
    for (int i = 0; i < constraints; i++) {
        zone[i] = moves_any(&constraint[i], inverse_mass) ? zones : -1;
        for (int j = 0; j < i && zone[i] == zones; j++)
            if (are_neighbors(&constraint[i], &constraint[j], inverse_mass))
                zone[i] = zone[j];
        zones += zone[i] == zones;
    }
#else
    // Your turn: each constraint is a zone of its own.
    for (int i = 0; i < constraints; i++)
        zone[i] = moves_any(&constraint[i], inverse_mass) ? zones++ : -1;
#endif
    return zones;
}
