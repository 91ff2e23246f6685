// Untangles surfaces, with all rungs and without some: prints lines
// "name,value,unit".
//
// Of each tangle come the triangles, the intersections before and after, those of
// fixed vertices alone, the rounds, the sum of the rungs that moved something, how
// many vertices moved, the farthest and the mean of these displacements and the
// root of the mean square of all in mean edges, the edges that are stretched, in
// percent, the seconds of processor time as a multiple of those of a check, and
// for each rung whether it is clear without that one.  Then come, for all rungs
// and without each, how many tangles are clear; and over those that are clear in
// any case the means of the root mean square and of the stretched edges.

#include "bench/measuring.h"
#include "kit/tangles.h"
#include "surface/check.h"
#include "untangle/untangle.h"

#include <stdio.h>
#include <stdlib.h>

enum {
    CHECKS = 50,
    WAYS = 7 ///< with all rungs, and without each
};

static const struct {
    const char *name;
    int without;
} ways[WAYS] = {{"all", 0},
                {"push", TF_RUNG_PUSH},
                {"smooth", TF_RUNG_SMOOTH},
                {"again", TF_RUNG_AGAIN},
                {"apart", TF_RUNG_APART},
                {"relax", TF_RUNG_RELAX},
                {"return", TF_RUNG_RETURN}};

typedef struct tangle {
    const char *name;
    fig_tangle made;
    tf_surface *surface;
    tf_resolver *resolver;
    double *out;
    tf_untangle_report report; ///< with all rungs
    double seconds;
} tangle;

/// What is summed over all tangles; lengths over those that are clear with any
/// rung left out.
typedef struct sums {
    int clear[WAYS], always;
    double deviation[WAYS], stretched[WAYS];
} sums;

static tf_untangle_report untangle(tangle *t, int without)
{
    tf_untangle_options options = {
        .size = sizeof options, .fixed = t->made.fixed, .without = without};
    tf_untangle_report report;
    double before = processor_seconds();
    require(tf_untangle(t->resolver, t->made.mesh.vertices, t->made.mesh.x,
                        t->out, &options, &report, NULL, NULL));
    t->seconds = processor_seconds() - before;
    return report;
}

static double check_seconds(tangle *t)
{
    tf_crossings found;
    double before = processor_seconds();
    for (int i = 0; i < CHECKS; i++)
        require(tf_surface_check(t->surface, t->made.mesh.vertices,
                                 t->made.mesh.x, NULL, &found, NULL));
    return (processor_seconds() - before) / CHECKS;
}

static void begin(tangle *t)
{
    t->made = fig_tangle_make(t->name);
    tf_mesh mesh = fig_mesh_in_space(&t->made.mesh);
    require(tf_surface_create(&mesh, &t->surface, NULL));
    require(tf_resolver_create(t->surface, &t->resolver));
    t->out = malloc(3 * (size_t)mesh.vertices * sizeof *t->out);
    require(t->out ? TF_OK : TF_OUT_OF_MEMORY);
}

static void end(tangle *t)
{
    free(t->out);
    tf_resolver_free(t->resolver);
    tf_surface_free(t->surface);
    fig_tangle_free(&t->made);
}

static void print(const tangle *t, const char *what, double value,
                  const char *unit)
{
    printf("%s %s,%.4g,%s\n", t->name, what, value, unit);
}

static void print_report(const tangle *t, double check)
{
    const tf_untangle_report *r = &t->report;
    int edges;
    tf_surface_edges(t->surface, &edges);
    print(t, "triangles", t->made.mesh.triangles, "");
    print(t, "before", (double)r->before, "");
    print(t, "left", (double)r->left, "");
    print(t, "beyond", (double)r->beyond, "");
    print(t, "rounds", r->rounds, "");
    print(t, "rungs", r->rungs, "");
    print(t, "moved", r->moved, "");
    print(t, "farthest", r->farthest / r->edge, "edges");
    print(t, "mean", r->mean / r->edge, "edges");
    print(t, "found", r->found / r->edge, "edges");
    print(t, "deviation", r->deviation / r->edge, "edges");
    print(t, "stretched", 100. * r->stretched / edges, "%");
    print(t, "checks", t->seconds / check, "");
}

static void add_lengths(sums *all, const tf_untangle_report report[WAYS],
                        int edges)
{
    for (int way = 0; way < WAYS; way++)
        if (report[way].left > 0)
            return;
    all->always++;
    for (int way = 0; way < WAYS; way++) {
        all->deviation[way] += report[way].deviation / report[way].edge;
        all->stretched[way] += 100.0 * report[way].stretched / edges;
    }
}

/// With all rungs, then without each.
static void measure(tangle *t, sums *all)
{
    tf_untangle_report reports[WAYS];
    int edges;
    begin(t);
    tf_surface_edges(t->surface, &edges);
    for (int way = 0; way < WAYS; way++) {
        tf_untangle_report report = untangle(t, ways[way].without);
        reports[way] = report;
        all->clear[way] += report.left == 0;
        if (way == 0) {
            t->report = report;
            print_report(t, check_seconds(t));
        } else {
            char what[32];
            snprintf(what, sizeof what, "without %s", ways[way].name);
            print(t, what, (double)report.left, "");
        }
        fflush(stdout);
    }
    add_lengths(all, reports, edges);
    end(t);
}

int main(void)
{
    sums all = {0};
    int count = 0;
    while (fig_tangle_name(count)) {
        tangle t = {.name = fig_tangle_name(count++)};
        measure(&t, &all);
    }
    printf("tangles,%d,\n", count);
    printf("always clear,%d,\n", all.always);
    for (int way = 0; way < WAYS; way++) {
        const char *name = ways[way].name;
        printf("clear %s,%d,\n", name, all.clear[way]);
        printf("deviation %s,%.4g,edges\n", name,
               all.deviation[way] / all.always);
        printf("stretched %s,%.4g,%%\n", name, all.stretched[way] / all.always);
    }
    return 0;
}
