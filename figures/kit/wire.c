#include "kit/wire.h"

#include "base/require.h"
#include "response/impulse.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

enum {
    MOST_ROWS = 16384,
    MOST_ROUNDS = 16384
};

typedef struct wire {
    int beads;
    double gap;
    double inverse_mass[FIG_WIRE_BEADS + 1];
    double displacement[2 * (FIG_WIRE_BEADS + 1)];
    int rows;
    tf_constraint row[MOST_ROWS];
} wire;

static void propose(wire *w)
{
    memset(w->displacement, 0, sizeof w->displacement);
    w->displacement[0] = 1;
}

static wire *thread(int beads, double gap)
{
    static wire w;
    TF_REQUIRE(beads > 0 && beads <= FIG_WIRE_BEADS);
    w = (wire){.beads = beads, .gap = gap};
    for (int i = 0; i < beads; i++)
        w.inverse_mass[i] = 1;
    propose(&w);
    return &w;
}

/// Whether a bead and its neighbor to the right meet.
static bool meets(const wire *w, int bead)
{
    return bead * w->gap + w->displacement[(ptrdiff_t)2 * bead] >=
           (bead + 1) * w->gap + w->displacement[2 * bead + 2];
}

static tf_constraint row_of(int bead)
{
    return (tf_constraint){.vertex = {bead + 1, bead, -1, -1},
                           .coefficient = {1, -1},
                           .normal = {1}};
}

/// Notes what is proposed now; whether anything meets.
static bool look(const wire *w, fig_wire *course)
{
    int met = 0;
    while (met < w->beads && !meets(w, met))
        met++;
    if (met == w->beads)
        met = -1;
    if (course->rounds < FIG_WIRE_SEEN) {
        for (int i = 0; i < w->beads; i++)
            course->seen[course->rounds][i] = w->displacement[(ptrdiff_t)2 * i];
        course->met[course->rounds] = met;
    }
    return met >= 0;
}

fig_wire fig_wire_alone(int beads, double gap)
{
    wire *w = thread(beads, gap);
    const tf_bodies bodies = {2, w->inverse_mass, w->displacement};
    fig_wire course = {0};
    for (; look(w, &course); course.rounds++) {
        TF_REQUIRE(course.rounds < MOST_ROUNDS);
        bool met[FIG_WIRE_BEADS];
        for (int i = 0; i < beads; i++)
            met[i] = meets(w, i);
        for (int i = 0; i < beads; i++)
            if (met[i]) {
                tf_constraint row = row_of(i);
                tf_constraint_visit(&row, 0, &bodies);
                course.visits++;
            }
    }
    return course;
}

/// Sweeps, from the impulses that the rows have, until next to nothing changes;
/// returns how often.
static int solve(wire *w, int sweeps)
{
    const tf_bodies bodies = {2, w->inverse_mass, w->displacement};
    for (int i = 0; i < w->rows; i++)
        tf_constraint_push(&w->row[i], (tf_vector){{w->row[i].impulse}},
                           &bodies);
    for (int sweep = 1; sweep <= sweeps; sweep++) {
        double change = 0;
        for (int i = 0; i < w->rows; i++)
            change = fmax(change, tf_constraint_visit(&w->row[i], 0, &bodies));
        if (change < 1e-9)
            return sweep;
    }
    return sweeps;
}

fig_wire fig_wire_kept(int beads, double gap, int sweeps)
{
    wire *w = thread(beads, gap);
    fig_wire course = {0};
    for (; look(w, &course); course.rounds++) {
        for (int i = 0; i < beads; i++)
            if (meets(w, i)) {
                TF_REQUIRE(w->rows < MOST_ROWS);
                w->row[w->rows++] = row_of(i);
            }
        propose(w);
        course.visits += (long)solve(w, sweeps) * w->rows;
    }
    return course;
}
