#include "support/long_solves.h"

#include "support/watches.h"
#include "support/zones.h"

#include <string.h>

enum {
    CONSTRAINTS = 3000,
    SWEEPS = 20
};

static const char *fault_of(zone_case *z, const tf_zone_solver *solver,
                            size_t least)
{
    watched_call call;
    int iterations = zone_solve(z, solver, SWEEPS);
    double first = z->constraint[0].impulse;
    z->zone.watch = watched_begin(&call, 0);
    if (zone_solve(z, solver, SWEEPS) != iterations ||
        z->constraint[0].impulse != first)
        return "watched, it does something else";
    size_t work = watched_work(&call);
    if (work < least * CONSTRAINTS)
        return "it does not ask in all of its loops";
    if ((size_t)call.calls < work / TF_WATCHED_WORK / 2)
        return "the caller is told too rarely";
    for (long last = 1, calls = call.calls; last <= calls; last++) {
        z->zone.watch = watched_begin(&call, last);
        int fewer = zone_solve(z, solver, SWEEPS);
        // Work is spread over the iterations, but for some at the beginning.
        if (call.calls != last || fewer > iterations * last / calls + 2)
            return "cancelled, it goes on";
        if (watched_work_after(&call) > CONSTRAINTS)
            return "cancelled, it asks again and again";
    }
    return NULL;
}

const char *long_solve_fault(const tf_zone_solver *solver, size_t least)
{
    generator random = generator_new(700);
    zone_case z =
        zone_random(&random, 3, CONSTRAINTS / 2, CONSTRAINTS, CONSTRAINTS);
    const char *fault = fault_of(&z, solver, least);
    zone_free(&z);
    return fault;
}
