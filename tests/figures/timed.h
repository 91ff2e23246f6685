// The queries that the library is timed on, and what figures print of them.
#ifndef FIGURES_TIMED_H
#define FIGURES_TIMED_H

#include "figures/numbers.h"

#include "bench/workloads.h"

enum {
    TIMED_WORKLOADS = 8
};

/// The i-th of all workloads of either kind.  The caller frees it.
static inline workload timed_workload(int i)
{
    static workload (*const make[])(int vertices) = {
        workload_soup, workload_near, workload_rest, workload_lattice};
    return make[i / 2](1 + i % 2);
}

/// Whether all coordinates are integers as they are.
static inline bool is_lattice(const workload *w)
{
    return strcmp(w->name, "lattice") == 0;
}

/// The number of a workload that is printed under a name.
static inline double timed_number(const char *text, const workload *w,
                                  const char *name)
{
    char key[80];
    snprintf(key, sizeof key, "%s%s_%s_%s", w->rounded ? "rounded_" : "",
             w->name, w->vertices == 1 ? "pt" : "ee", name);
    return number_of(text, key);
}

/// Expect such a number up to the last printed digit, of weight `unit`.
static inline void expect_timed(const char *text, const workload *w,
                                const char *name, double expected, double unit)
{
    double found = timed_number(text, w, name);
    ck_assert_msg(fabs(found - expected) <= unit / 2,
                  "%s, %s: %s is %g, not %g", w->name, workload_kind(w), name,
                  found, expected);
}

#endif
