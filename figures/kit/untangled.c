#include "kit/untangled.h"

#include "base/require.h"

#include <stdlib.h>
#include <string.h>

fig_untangled fig_untangle(const fig_tangle *tangle, int rounds, int without)
{
    tf_mesh mesh = fig_mesh_in_space(&tangle->mesh);
    tf_untangle_options options = {.size = sizeof options,
                                   .fixed = tangle->fixed,
                                   .rounds = rounds,
                                   .without = without};
    tf_surface *surface;
    tf_resolver *resolver;
    fig_untangled made = {
        .x = malloc(3 * (size_t)mesh.vertices * sizeof *made.x)};
    TF_REQUIRE(made.x);
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_untangle(resolver, mesh.vertices, tangle->mesh.x, made.x,
                           &options, &made.report, NULL, NULL) == TF_OK);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return made;
}

void fig_untangled_free(fig_untangled *untangled)
{
    free(untangled->x);
    *untangled = (fig_untangled){0};
}

// States -----------------------------------------------------------------------

static void add_state(fig_untangling *all, int rounds, fig_untangled state)
{
    TF_REQUIRE(all->states < FIG_UNTANGLING_STATES);
    all->rounds[all->states] = rounds;
    all->state[all->states++] = state;
}

static fig_untangled untouched(const fig_tangle *tangle, size_t crossings)
{
    size_t size = 3 * (size_t)tangle->mesh.vertices * sizeof(double);
    fig_untangled state = {.x = malloc(size),
                           .report = {.before = crossings, .left = crossings}};
    TF_REQUIRE(state.x);
    memcpy(state.x, tangle->mesh.x, size);
    return state;
}

/// After up to so many rounds each state is kept, later only some.
static int next_rounds(int rounds)
{
    return rounds < 20 ? rounds + 1 : rounds + (rounds + 7) / 8;
}

/// The states of the first attempt, and then what comes of all rungs.
static void find_states(fig_untangling *all)
{
    const int first = TF_RUNG_APART | TF_RUNG_AGAIN | TF_RUNG_RELAX;
    fig_untangled last = fig_untangle(&all->tangle, 0, 0);
    int rounds = 0;
    add_state(all, rounds, untouched(&all->tangle, last.report.before));
    while (all->state[all->states - 1].report.left > last.report.left &&
           next_rounds(rounds) < last.report.rounds) {
        rounds = next_rounds(rounds);
        add_state(all, rounds,
                  fig_untangle(&all->tangle, rounds, first | TF_RUNG_RETURN));
    }
    if (all->state[all->states - 1].report.left > last.report.left) {
        rounds = last.report.rounds;
        add_state(all, rounds, fig_untangle(&all->tangle, 0, TF_RUNG_RETURN));
    }
    add_state(all, rounds, last);
}

const fig_untangling *fig_untangling_of(const char *name)
{
    static struct kept {
        const char *name;
        fig_untangling all;
        struct kept *next;
    } * first;
    for (const struct kept *one = first; one; one = one->next)
        if (strcmp(one->name, name) == 0)
            return &one->all;
    struct kept *one = calloc(1, sizeof *one);
    TF_REQUIRE(one);
    one->name = name;
    one->all.tangle = fig_tangle_make(name);
    find_states(&one->all);
    one->next = first;
    return &(first = one)->all;
}
