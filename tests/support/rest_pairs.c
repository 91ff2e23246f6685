#include "support/rest_pairs.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

const char *const rest_family_names[REST_FAMILIES] = {
    "usual", "lattice", "flat", "long",     "tiny",
    "huge",  "mixed",   "near", "reaching",
};

static double coordinate_of(generator *random, int family, int k)
{
    switch (family) {
    case 1:
        return below(random, 5) - 2;
    case 2: // nearly within a plane
        return uniform(random, -1, 1) * (k % 3 == 2 ? 0x1p-40 : 1);
    case 3: // thin elements
        return uniform(random, -1, 1) * (k % 3 == 0 ? 0x1p30 : 1);
    case 4:
        return uniform(random, -1, 1) * 0x1p-1060;
    case 5:
        return uniform(random, -1, 1) * 0x1.8p1023;
    case 6:
        return ldexp(uniform(random, -1, 1), below(random, 2000) - 1040);
    default:
        return uniform(random, -1, 1);
    }
}

/// Moves a point nearly into the other element, or the second edge so that its
/// middle is nearly on the first one.
static void draw_near(generator *random, rest_pair *pair, int axes)
{
    bool edges = pair->kind == TF_EDGE_EDGE;
    double weight[2] = {uniform(random, 0, 0.5), uniform(random, 0, 0.5)};
    double offset = ldexp(1, -10 - below(random, 40));
    double *x = pair->at;
    for (int k = 0; k < axes; k++) {
        const double *other = edges ? x : x + axes;
        double at = other[k] + weight[0] * (other[axes + k] - other[k]);
        if (pair->kind == TF_POINT_TRIANGLE)
            at += weight[1] * (other[2 * axes + k] - other[k]);
        at += offset * uniform(random, -1, 1);
        if (edges)
            x[9 + k] = 2 * at - x[6 + k];
        else
            x[k] = at;
    }
}

int rest_pair_coordinates(const rest_pair *pair)
{
    return pair->kind == TF_POINT_EDGE ? 6 : 12;
}

void rest_pair_make(generator *random, int family, rest_pair *pair)
{
    static const tf_kind kinds[] = {TF_POINT_EDGE, TF_POINT_TRIANGLE,
                                    TF_EDGE_EDGE};
    pair->kind = kinds[below(random, 3)];
    int axes = pair->kind == TF_POINT_EDGE ? 2 : 3;
    for (int i = 0; i < 12; i++)
        pair->at[i] = coordinate_of(random, family, i);
    if (family == 7)
        draw_near(random, pair, axes);
    // The first vertex is far from everything near.
    for (int k = 0; family == 8 && k < axes; k++)
        pair->at[k] *= 0x1p40;
    // Sometimes two vertices are at one point.
    if (below(random, 8) == 0)
        for (int k = 0; k < axes; k++)
            pair->at[axes * below(random, axes + 1) + k] = pair->at[k];
    for (int v = 0; v < 4; v++)
        pair->x[v] = pair->at + (v <= axes ? axes * v : 0);
}

const char *rest_pair_text(const rest_pair *pair)
{
    static char text[600];
    int length = snprintf(text, sizeof text, "kind %d:", (int)pair->kind);
    for (int i = 0; i < rest_pair_coordinates(pair); i++)
        length += snprintf(text + length, sizeof text - (size_t)length, " %a",
                           pair->at[i]);
    return text;
}
