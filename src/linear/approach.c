//: Include what advancement needs
#include "linear/approach.h"

#include <float.h>
#include <math.h>
#include <string.h>

//: Check the limits
bool tf_advance_limits_valid(const tf_advance_limits *limits)
{
    return limits->threshold >= 0 && limits->threshold <= DBL_MAX &&
           limits->fraction >= 0 && limits->fraction < 1 && limits->steps >= 0;
}

//: Look at the elements at a time
/// Sets the distance and the nearest points; returns the bound on the speed.
static double look(const tf_approach *approach, tf_advancement *at)
{
    tf_vector x[TF_MOST_CORNERS];
    approach->positions(approach->motion, at->time, x);
    tf_point_pair nearest =
        tf_nearest_points(approach->vertices, approach->others, x);
    at->distance = fmin(nearest.distance, DBL_MAX);
    memset(at->barycentric, 0, sizeof at->barycentric);
    memcpy(at->barycentric[0], nearest.weight,
           (size_t)approach->vertices * sizeof *nearest.weight);
    memcpy(at->barycentric[1], nearest.weight + approach->vertices,
           (size_t)approach->others * sizeof *nearest.weight);
    return approach->speed(approach->motion, at->time, x, &nearest);
}

//: Take one step
/// Whether there was one: not if there was no time left, or none that counts
/// beside the time.
static bool step(double spend, double speed, tf_advancement *at)
{
    double time = at->time;
    if (spend >= (1 - time) * speed)
        at->time = 1;
    else
        at->time += spend / speed;
    at->steps++;
    return at->time > time;
}

//: Advance the elements
tf_advancement tf_advance(const tf_advance_limits *limits,
                          const tf_approach *approach)
{
    int most = limits->steps > 0 ? limits->steps : 10000;
    tf_advancement at = {.verdict = TF_UNDECIDED};
    double speed = look(approach, &at), target;
    target = fmax(limits->threshold, limits->fraction * at.distance);
    while (at.distance > target && at.time < 1 && at.steps < most &&
           at.distance < DBL_MAX && speed <= DBL_MAX &&
           step(at.distance - target / 2, speed, &at))
        speed = look(approach, &at);
    if (at.distance <= target)
        at.verdict = TF_HIT;
    else if (at.time == 1)
        at.verdict = TF_APART;
    return at;
}
