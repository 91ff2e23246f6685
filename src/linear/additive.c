//: Include what additive advancement needs
#include "linear/additive.h"

#include "base/require.h"
#include "linear/approach.h"
#include "linear/linear_pair.h"

#include <math.h>
#include <string.h>

//: Hold elements that deform
typedef struct deforming_pair {
    tf_linear_pair elements;
    double speed; ///< of approach, at most
} deforming_pair;

static void deforming_positions(const void *motion, double time, tf_vector x[])
{
    const deforming_pair *d = motion;
    tf_linear_pair_positions(&d->elements, time, x);
}

static double deforming_speed(const void *motion, double time,
                              const tf_vector x[], const tf_point_pair *nearest)
{
    (void)time;
    (void)x;
    (void)nearest;
    const deforming_pair *d = motion;
    return d->speed;
}

//: Find the displacements from the mean
/// The displacements of all vertices, less their mean: what all have in common
/// changes no distance.
static void find_displacements(const tf_linear_pair *elements,
                               tf_vector displacement[])
{
    int count = elements->vertices + elements->others;
    tf_vector mean = {{0}};
    for (int i = 0; i < count; i++) {
        displacement[i] =
            tf_vector_difference(elements->at[1][i], elements->at[0][i]);
        for (int k = 0; k < TF_AXES; k++)
            mean.x[k] += displacement[i].x[k] / count;
    }
    for (int i = 0; i < count; i++)
        displacement[i] = tf_vector_difference(displacement[i], mean);
}

//: Bound the speed of deforming elements
static double speed_of(const tf_linear_pair *elements)
{
    tf_vector displacement[TF_LINEAR_PAIR_VERTICES];
    find_displacements(elements, displacement);
    double greatest[2] = {0};
    for (int i = 0; i < elements->vertices + elements->others; i++) {
        double *most = &greatest[i >= elements->vertices];
        *most = fmax(*most, tf_vector_dot(displacement[i], displacement[i]));
    }
    return sqrt(greatest[0]) + sqrt(greatest[1]);
}

//: Describe where additive advancement ended
static tf_contact contact_at(const tf_linear_pair *elements,
                             const tf_advancement *at)
{
    if (at->verdict == TF_APART)
        return (tf_contact){.verdict = TF_APART};
    tf_point_pair nearest = {.distance = at->distance};
    memcpy(nearest.weight, at->barycentric[0],
           (size_t)elements->vertices * sizeof *nearest.weight);
    memcpy(nearest.weight + elements->vertices, at->barycentric[1],
           (size_t)elements->others * sizeof *nearest.weight);
    tf_contact contact =
        tf_linear_pair_contact(elements, at->time, &nearest, TF_TOUCHING);
    contact.verdict = at->verdict;
    return contact;
}

//: Advance deforming elements
static tf_status advance_additively(const tf_advance_limits *limits, int axes,
                                    const tf_motion *motion, int vertices,
                                    const int first[], int others,
                                    const int second[], tf_contact *contact,
                                    tf_advancement *advancement)
{
    TF_REQUIRE(limits && contact);
    if (!tf_advance_limits_valid(limits))
        return TF_BAD_OPTION;
    deforming_pair pair;
    tf_status status = tf_linear_pair_take(axes, motion, vertices, first,
                                           others, second, &pair.elements);
    if (status != TF_OK)
        return status;
    pair.speed = speed_of(&pair.elements);
    tf_approach approach = {.motion = &pair,
                            .vertices = vertices,
                            .others = others,
                            .positions = deforming_positions,
                            .speed = deforming_speed};
    tf_advancement at = tf_advance(limits, &approach);
    *contact = contact_at(&pair.elements, &at);
    if (advancement)
        *advancement = at;
    return TF_OK;
}

//: Answer the queries by additive advancement
tf_status tf_additive_point_edge(const tf_advance_limits *limits,
                                 const tf_motion *motion, int point,
                                 const int edge[2], tf_contact *contact,
                                 tf_advancement *advancement)
{
    return advance_additively(limits, 2, motion, 1, &point, 2, edge, contact,
                              advancement);
}

tf_status tf_additive_point_triangle(const tf_advance_limits *limits,
                                     const tf_motion *motion, int point,
                                     const int triangle[3], tf_contact *contact,
                                     tf_advancement *advancement)
{
    return advance_additively(limits, 3, motion, 1, &point, 3, triangle,
                              contact, advancement);
}

tf_status tf_additive_edge_edge(const tf_advance_limits *limits,
                                const tf_motion *motion, const int first[2],
                                const int second[2], tf_contact *contact,
                                tf_advancement *advancement)
{
    return advance_additively(limits, 3, motion, 2, first, 2, second, contact,
                              advancement);
}
