//: Include what the way home needs
#include "untangle/way_home.h"

#include "fast/detect.h"
#include "response/resolve.h"

#include <string.h>

enum {
    MOST_STEPS = 40,   ///< towards the input, in parts of the way
    MOST_FAILURES = 3, ///< steps that bring next to nothing
    LAST_STEPS = 4     ///< of the vertices that meet nothing
};

//: Make room for the way home
static size_t coordinates(const tf_tangle *tangle)
{
    return (size_t)tangle->near.axes * (size_t)tangle->near.vertices;
}

static bool reserve(tf_way_home *way, const tf_tangle *tangle)
{
    size_t vertices = (size_t)tangle->near.vertices;
    size_t numbers = coordinates(tangle) + vertices;
    if (!tf_buffer_reserve(&way->storage, numbers * sizeof(double) + vertices,
                           1))
        return false;
    way->end = way->storage.data;
    way->mass = way->end + coordinates(tangle);
    way->meets = (void *)(way->mass + vertices);
    for (size_t v = 0; v < vertices; v++)
        way->mass[v] = tangle->fixed[v] ? 0 : 1;
    way->steps = 0;
    return true;
}

void tf_way_home_free(tf_way_home *way)
{
    tf_buffer_free(&way->storage);
}

//: Measure how far the vertices are from home
/// The sum of the squares of all distances.
static double squares(const tf_tangle *tangle, const double x[])
{
    double sum = 0;
    for (size_t i = 0; i < coordinates(tangle); i++) {
        double way = x[i] - tangle->in[i];
        sum += way * way;
    }
    return sum;
}

//: Take a step towards home
/// Resolves the step from x to the proposed end, and takes it if the sum of
/// squares falls below `*sum`; otherwise x stays, and `*gain` is 0.  The gain
/// is by which part the sum falls.
static tf_status take_step(tf_way_home *way, tf_resolver *resolver,
                           const tf_tangle *tangle, double x[], double *sum,
                           double *gain)
{
    tf_response_options options = {.size = sizeof options,
                                   .parallel = tangle->parallel};
    tf_status status =
        tf_step_resolve(resolver, tangle->near.vertices, x, way->end, way->mass,
                        &options, NULL, NULL);
    *gain = 0;
    if (status != TF_OK)
        return status;
    double next = squares(tangle, way->end);
    if (next >= *sum)
        return TF_OK;
    memcpy(x, way->end, coordinates(tangle) * sizeof *x);
    *gain = 1 - next / *sum;
    *sum = next;
    way->steps++;
    return TF_OK;
}

//: Go part of the way
static void propose(tf_way_home *way, const tf_tangle *tangle, const double x[],
                    double part)
{
    for (size_t i = 0; i < coordinates(tangle); i++)
        way->end[i] =
            part == 1 ? tangle->in[i] : x[i] + part * (tangle->in[i] - x[i]);
}

/// Goes a tenth of the way again and again, or less if that fails, and at last
/// all of it, until little is gained.
static tf_status go_by_parts(tf_way_home *way, tf_resolver *resolver,
                             const tf_tangle *tangle, double x[], double *sum)
{
    double part = 0.1, gain = 0;
    int failures = 0;
    for (int i = 0; i < MOST_STEPS && failures <= MOST_FAILURES && *sum > 0;
         i++) {
        propose(way, tangle, x, part);
        tf_status status = take_step(way, resolver, tangle, x, sum, &gain);
        if (status != TF_OK)
            return status;
        failures += gain < 0.005;
        if (gain == 0)
            part /= 2;
    }
    propose(way, tangle, x, 1);
    return take_step(way, resolver, tangle, x, sum, &gain);
}

//: Find the vertices that meet something on the way
static tf_status find_meeting(tf_way_home *way, const tf_tangle *tangle,
                              const double x[])
{
    tf_motion motion = {tangle->near.axes, tangle->near.vertices, x,
                        tangle->in};
    tf_detect_options options = {.size = sizeof options,
                                 .parallel = tangle->parallel};
    tf_contacts contacts;
    tf_status status =
        tf_surface_detect(tangle->surface, &motion, &options, &contacts, NULL);
    if (status != TF_OK)
        return status;
    memset(way->meets, 0, (size_t)tangle->near.vertices * sizeof *way->meets);
    for (size_t i = 0; i < contacts.count; i++)
        for (int c = 0; c <= tangle->near.axes; c++)
            way->meets[contacts.contact[i].vertex[c]] = true;
    return TF_OK;
}

//: Go home where nothing is met
static tf_status go_where_free(tf_way_home *way, tf_resolver *resolver,
                               const tf_tangle *tangle, double x[], double *sum)
{
    double gain = 1;
    for (int i = 0; i < LAST_STEPS && gain > 0 && *sum > 0; i++) {
        tf_status status = find_meeting(way, tangle, x);
        if (status != TF_OK)
            return status;
        memcpy(way->end, x, coordinates(tangle) * sizeof *x);
        for (int v = 0; v < tangle->near.vertices; v++)
            if (!way->meets[v])
                tf_put(&tangle->near, way->end, v,
                       tf_place(&tangle->near, tangle->in, v));
        status = take_step(way, resolver, tangle, x, sum, &gain);
        if (status != TF_OK)
            return status;
    }
    return TF_OK;
}

//: Take the way home
tf_status tf_way_home_take(tf_way_home *way, tf_resolver *resolver,
                           const tf_tangle *tangle, double x[])
{
    if (!reserve(way, tangle))
        return TF_OUT_OF_MEMORY;
    double sum = squares(tangle, x);
    tf_status status = go_by_parts(way, resolver, tangle, x, &sum);
    if (status != TF_OK)
        return status;
    return go_where_free(way, resolver, tangle, x, &sum);
}
