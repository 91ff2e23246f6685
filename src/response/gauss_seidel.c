//: Include what projected Gauss-Seidel needs
#include "response/gauss_seidel.h"

#include "base/require.h"
#include "base/watch.h"
#include "response/impulse.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

//: Start from the impulses of the last time
/// The largest violation of some of the constraints.
static double worst(const tf_zone *zone, int begin, int end)
{
    double violation = 0;
    for (int i = begin; i < end && tf_watch_work(zone->watch, 1); i++) {
        const tf_constraint *constraint = &zone->constraint[i];
        double gap_change = tf_constraint_gap_change(zone->axes, constraint,
                                                     zone->displacement);
        violation = fmax(violation, constraint->bound - gap_change);
    }
    return violation;
}

/// Applies the impulses that the constraints have.  Returns the largest
/// violation: of constraints that were solved before as the proposal has it, of
/// the others after these impulses.
static double start(const tf_zone *zone, const tf_bodies *bodies)
{
    double violation = worst(zone, 0, zone->solved);
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1);
         i++) {
        const tf_constraint *constraint = &zone->constraint[i];
        tf_vector normal = tf_vector_at(constraint->normal, 0);
        tf_vector friction = tf_vector_at(constraint->friction, 0);
        tf_vector impulse =
            tf_vector_sum(friction, constraint->impulse, normal);
        if (!tf_vector_equals(impulse, (tf_vector){{0}}))
            tf_constraint_push(constraint, impulse, bodies);
    }
    return fmax(violation, worst(zone, zone->solved, zone->constraints));
}

//: List the constraints of each vertex
/// Which constraints are to be visited, and which constraints push a vertex:
/// those of vertex v are constraint[begin[v]] to constraint[begin[v + 1] - 1].
typedef struct agenda {
    int *begin, *constraint;
    size_t *moved;      ///< of each crowded vertex: when it last moved
    size_t *visited;    ///< of each constraint that asks: when it was visited
    unsigned char *due; ///< of each constraint: a sum of flags
    size_t clock;       ///< how often crowded vertices have moved
} agenda;

static void list_constraints(const tf_zone *zone, const agenda *all)
{
    int *begin = all->begin;
    memset(begin, 0, sizeof *begin * ((size_t)zone->vertices + 2));
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1); i++)
        for (int j = 0; j < 4 && zone->constraint[i].vertex[j] >= 0; j++)
            begin[zone->constraint[i].vertex[j] + 2]++;
    for (int v = 0; v < zone->vertices; v++)
        begin[v + 2] += begin[v + 1];
    for (int i = 0; i < zone->constraints && tf_watch_work(zone->watch, 1); i++)
        for (int j = 0; j < 4 && zone->constraint[i].vertex[j] >= 0; j++)
            all->constraint[begin[zone->constraint[i].vertex[j] + 1]++] = i;
}

//: Tell crowded vertices apart
enum {
    CROWD = 64, ///< constraints of a vertex that are told one by one

    DUE = 1, ///< flags of a constraint
    ASKS = 2 ///< it has a crowded vertex
};

static bool is_crowded(const agenda *all, int vertex)
{
    return all->begin[vertex + 1] - all->begin[vertex] > CROWD;
}

/// Whether one of a constraint's vertices is crowded.
static bool is_in_crowd(const agenda *all, const tf_constraint *constraint)
{
    bool found = false;
    for (int j = 0; j < 4 && constraint->vertex[j] >= 0; j++)
        found |= is_crowded(all, constraint->vertex[j]);
    return found;
}

//: Lay out the agenda
static size_t workspace_for(int axes, int vertices, int constraints)
{
    (void)axes;
    size_t times = (size_t)vertices + (size_t)constraints;
    size_t numbers = (size_t)vertices + 2 + 4 * (size_t)constraints;
    size_t bytes =
        times * sizeof(size_t) + numbers * sizeof(int) + (size_t)constraints;
    return bytes / sizeof(double) + 1;
}

//: Begin the agenda
/// Only new constraints are due.  Those that were solved before need a visit
/// when others have moved their vertices.
static agenda begin_agenda(const tf_zone *zone)
{
    agenda all = {.moved = (void *)zone->workspace};
    all.visited = all.moved + zone->vertices;
    all.begin = (void *)(all.visited + zone->constraints);
    all.constraint = all.begin + zone->vertices + 2;
    all.due = (void *)(all.constraint + 4 * (ptrdiff_t)zone->constraints);
    list_constraints(zone, &all);
    memset(all.moved, 0, sizeof *all.moved * (size_t)zone->vertices);
    memset(all.visited, 0, sizeof *all.visited * (size_t)zone->constraints);
    for (int i = 0; i < zone->constraints; i++)
        all.due[i] = (i >= zone->solved ? DUE : 0) |
                     (is_in_crowd(&all, &zone->constraint[i]) ? ASKS : 0);
    return all;
}

//: Ask whether a constraint is due
/// Whether a constraint is to be visited: because it was told, or because one of
/// its crowded vertices has moved since it was last visited.
static bool is_due(const agenda *all, int constraint, const int vertex[4])
{
    if (all->due[constraint] != ASKS)
        return all->due[constraint] & DUE;
    bool due = false;
    for (int j = 0; !due && j < 4 && vertex[j] >= 0; j++)
        due = all->moved[vertex[j]] > all->visited[constraint];
    return due;
}

static void set_visited(const agenda *all, int constraint)
{
    all->due[constraint] &= ASKS;
    if (all->due[constraint])
        all->visited[constraint] = all->clock;
}

//: Pass over constraints without a flag
/// The first constraint from one on that has a flag, or their number.
static int next_noted(const agenda *all, int constraint, int constraints)
{
    const unsigned char *due = all->due;
    uint64_t eight;
    while (constraint + 8 <= constraints) {
        memcpy(&eight, due + constraint, sizeof eight);
        if (eight != 0)
            break;
        constraint += 8;
    }
    while (constraint < constraints && !due[constraint])
        constraint++;
    return constraint;
}

//: See whether a constraint is off
static const double tolerance = 1e-2;

/// An impulse is taken back only if it pushes too much by this many tolerances:
/// too little lets elements touch, too much does not.
static const double generosity = 3;

/// How the constraints of a zone are swept.
typedef struct sweep_state {
    const tf_zone *zone;
    tf_bodies bodies;
    double least; ///< the tolerance, a length
    agenda all;
} sweep_state;

/// Whether a constraint pushes too little or, so that it can be taken back, too
/// much.
static bool is_off(const sweep_state *state, const tf_constraint *constraint)
{
    const tf_bodies *bodies = &state->bodies;
    double missing =
        constraint->bound - tf_constraint_gap_change(bodies->axes, constraint,
                                                     bodies->displacement);
    return missing > state->least ||
           (constraint->impulse > 0 && missing < -generosity * state->least);
}

//: Visit a constraint that is due
enum {
    NEIGHBORS = 32, ///< that are told in the time of a visit
    VISITS = 32     ///< after which the solver asks whether to go on
};

/// Puts on the agenda all other constraints that share a vertex with a
/// constraint, even one that cannot move: with friction another visit improves
/// such constraints as well.
static void tell_neighbors(sweep_state *state, int constraint)
{
    agenda *all = &state->all;
    const int *vertex = state->zone->constraint[constraint].vertex;
    for (int i = 0; i < 4 && vertex[i] >= 0; i++) {
        int begin = all->begin[vertex[i]], end = all->begin[vertex[i] + 1];
        if (is_crowded(all, vertex[i])) {
            all->moved[vertex[i]] = ++all->clock;
            continue;
        }
        const int *told = all->constraint;
        unsigned char *due = all->due;
        for (int j = begin; j < end; j++)
            due[told[j]] |= DUE;
        tf_zone_goes_on(state->zone, (size_t)(end - begin) / NEIGHBORS);
    }
    set_visited(all, constraint);
}

/// Visits a constraint that is due, if it is new or off; with friction always,
/// as it may be off across the normal.  Returns whether that changes its
/// gap, or its sliding, by more than the tolerance.
static bool visit(sweep_state *state, int constraint, bool is_new)
{
    tf_constraint *own = &state->zone->constraint[constraint];
    double friction = tf_zone_friction(state->zone, own);
    set_visited(&state->all, constraint);
    if (!is_new && !(friction > 0) && !is_off(state, own))
        return false;
    bool changed =
        tf_constraint_visit(own, friction, &state->bodies) > state->least;
    if (changed)
        tell_neighbors(state, constraint);
    return changed;
}

//: Sweep until little changes
/// Returns whether a visit made a change of more than the tolerance; false if the
/// caller has cancelled.
static bool sweep(sweep_state *state, bool is_first)
{
    const tf_zone *zone = state->zone;
    size_t visits = 0;
    bool any = false;
    for (int i = 0; i < zone->constraints; i++) {
        i = next_noted(&state->all, i, zone->constraints);
        if (i == zone->constraints ||
            !is_due(&state->all, i, zone->constraint[i].vertex))
            continue;
        any |= visit(state, i, is_first && i >= zone->solved);
        if (++visits % VISITS == 0 && !tf_zone_goes_on(zone, VISITS))
            return false;
    }
    return tf_zone_goes_on(zone, visits % VISITS) && any;
}

static int solve_by_gauss_seidel(tf_zone *zone)
{
    TF_REQUIRE(zone && zone->constraint && zone->inverse_mass &&
               zone->displacement && zone->workspace);
    sweep_state state = {
        .zone = zone,
        .bodies = {zone->axes, zone->inverse_mass, zone->displacement}};
    state.least = tolerance * start(zone, &state.bodies);
    state.all = begin_agenda(zone);
    int sweeps = 1;
    // An agenda that was not finished must not be followed.
    while (tf_zone_goes_on(zone, 0) && sweep(&state, sweeps == 1) &&
           sweeps < zone->sweeps)
        sweeps++;
    return sweeps;
}

//: Offer projected Gauss-Seidel
const tf_zone_solver tf_gauss_seidel = {.name = "gauss-seidel",
                                        .workspace = workspace_for,
                                        .solve = solve_by_gauss_seidel};
