//: Find the near pairs of a surface
#include "distance/near_pairs.h"

#include "base/fail.h"
#include "base/require.h"
#include "base/sized.h"
#include "distance/near_search.h"
#include "surface/surface_memory.h"

#include <math.h>

static tf_status check_and_search(const tf_near_search *search,
                                  tf_near_pairs *found, tf_error *error)
{
    tf_status status = tf_parallel_check(search->parallel, error);
    if (status != TF_OK)
        return status;
    if (!(search->length > 0 && isfinite(search->length)))
        return tf_fail_option(error, "length", "finite, more than 0",
                              search->length);
    return tf_near_search_run(search, found, error);
}

tf_status tf_surface_near(tf_surface *surface, int vertices,
                          const double position[], double length,
                          const tf_check_options *options, tf_near_pairs *found,
                          tf_error *error)
{
    TF_REQUIRE(surface && position && found);
    tf_check_options own;
    size_t first = offsetof(tf_check_options, context) + sizeof own.context;
    tf_status status = tf_options_read(&own, sizeof own, options, first, error);
    if (status != TF_OK)
        return status;
    tf_near_search search = {.surface = surface,
                             .vertices = vertices,
                             .position = position,
                             .length = length,
                             .parallel = own.parallel};
    tf_watch watch, *outer = tf_workers_watch(&surface->workers, &watch,
                                              own.progress, own.context);
    status = check_and_search(&search, found, error);
    surface->workers.watch = outer;
    return status;
}
