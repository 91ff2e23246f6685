// Many random and adversarial queries, by vectors and by the reference: their
// verdicts with tf_exact and tf_clamped, and the certain ones, of the filter and of
// tf_certain.
//
//     vectors COUNT
//
// tries COUNT random queries, of which TF_SEED decides, and a tenth as many of
// the hard families.  Prints a line a family; fails if a verdict is wrong.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "support/query_batch.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

enum {
    BATCH = 4096
};

/// What was tried of a family.
typedef struct tally {
    long long queries, undecided, wrong;
} tally;

static void show(const batch *b, size_t i, const char *name, const char *fault)
{
    query q = batch_query(b, i);
    fprintf(stderr, "%s, %s, seed %llu, %s\n%s", name, fault,
            (unsigned long long)seed(), query_name(&q), query_text(&q));
}

static void note(tally *sum, const batch *b, size_t wrong, const char *name,
                 const char *fault)
{
    if (wrong == b->queries.count)
        return;
    if (sum->wrong++ == 0)
        show(b, wrong, name, fault);
}

/// Tries a batch; each way in which it is wrong counts once.
static void try_batch(batch *b, const char *name, tally *sum)
{
    size_t undecided = 0;
    note(sum, b, batch_wrong(b, &undecided), name, "a certain verdict");
    note(sum, b, batch_different(b, &tf_exact), name, "exact");
    note(sum, b, batch_different(b, &tf_clamped), name, "clamped");
    note(sum, b, batch_uncertain(b), name, "certain");
    sum->queries += (long long)b->queries.count;
    sum->undecided += (long long)undecided;
}

static tally try_family(batch *b, int family_number, query_kind kind,
                        long long count)
{
    const family *source = &families[family_number];
    generator random =
        generator_new((uint64_t)(1000 + 2 * family_number + (int)kind));
    tally sum = {0};
    while (sum.queries < count) {
        long long left = count - sum.queries;
        batch_fill(b, &random, source, kind,
                   left < BATCH ? (size_t)left : BATCH);
        try_batch(b, source->name, &sum);
    }
    printf("%-22s %-14s %11lld queries %7.3f %% undecided %lld wrong\n",
           source->name, kind == EDGE_EDGE ? "edge-edge" : "point-triangle",
           sum.queries, 100 * (double)sum.undecided / (double)sum.queries,
           sum.wrong);
    fflush(stdout);
    return sum;
}

int main(int argc, char *argv[])
{
    long long count = argc == 2 ? atoll(argv[1]) : 0, wrong = 0;
    if (count < 1) {
        fprintf(stderr, "usage: vectors COUNT\n");
        return 2;
    }
    batch b = batch_new(BATCH);
    for (int i = 0; i < FAMILIES; i++) {
        bool hard = i >= RANDOM_FAMILIES;
        int shares = hard ? 10 * (FAMILIES - RANDOM_FAMILIES) : RANDOM_FAMILIES;
        long long each = (count + 2 * shares - 1) / (2 * shares);
        wrong += try_family(&b, i, POINT_TRIANGLE, each).wrong;
        wrong += try_family(&b, i, EDGE_EDGE, each).wrong;
    }
    batch_free(&b);
    printf("%lld wrong\n", wrong);
    return wrong != 0;
}
