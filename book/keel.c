#include "arithmetic/clamped.h"
#include "query/edge_edge.h"
#include "query/narrow_phase.h"

#include <stdio.h>

// The keel, 0 1, sinks; the ridge, 2 3, and an edge of the gable, 3 4, rest.
static const double start[] = {-2, 0, 1, 2, 0, 1, 0, -2, 0, 0, 2, 0, 1, 2, -2};
static const double end[] = {-2, 0, -1, 2, 1, -2, 0, -2, 0, 0, 2, 0, 1, 2, -2};
static const tf_motion motion = {
    .axes = 3, .vertices = 5, .start = start, .end = end};

static void describe(const int first[2], const int second[2])
{
    tf_contact contact;
    if (tf_edge_edge(&tf_clamped, &motion, first, second, &contact) == TF_OK)
        printf("%d %d and %d %d: t = %.3f, normal velocity %g\n", first[0],
               first[1], second[0], second[1], contact.toi_lo,
               contact.normal_velocity);
}

int main(void)
{
    const int list[] = {0, 1, 2, 3, 0, 1, 3, 4};
    tf_queries queries = {TF_EDGE_EDGE, &motion, 2, list};
    tf_verdict verdict[2];
    size_t separated = 0;
    tf_status status =
        tf_reference.decide(NULL, &tf_clamped, &queries, verdict, &separated);
    for (int i = 0; status == TF_OK && i < 2; i++)
        if (verdict[i] != TF_APART)
            describe(list + 4 * i, list + 4 * i + 2);
    return status != TF_OK;
}
