//: Include what the usual choices need
#include "response/choices.h"

#include "base/sized.h"
#include "fast/vectorized.h"
#include "response/gauss_seidel.h"
#include "surface/tasks.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

//: Read how to respond
tf_status tf_response_options_read(tf_response_options *to,
                                   const tf_response_options *from,
                                   tf_error *error)
{
    tf_status status = tf_options_read(
        to, sizeof *to, from,
        offsetof(tf_response_options, context) + sizeof to->context, error);
    if (!to->narrow_phase)
        to->narrow_phase = &tf_vectorized;
    return status == TF_OK ? tf_parallel_check(to->parallel, error) : status;
}

//: Check the options
typedef struct option_range {
    const char *name, *range;
    double value, least, most;
} option_range;

tf_status tf_response_options_check(const tf_response_options *options,
                                    tf_error *error)
{
    const option_range ranges[] = {
        {"restitution", "from 0 to 1", options->restitution, 0, 1},
        {"restitution_threshold", "finite, 0 or more",
         options->restitution_threshold, 0, DBL_MAX},
        {"thickness", "finite, 0 or more", options->thickness, 0, DBL_MAX},
        {"friction", "finite, 0 or more", options->friction, 0, DBL_MAX},
        {"separation", "finite", options->separation, -DBL_MAX, DBL_MAX},
        {"sweeps", "0 or more", options->sweeps, 0, DBL_MAX},
        {"substeps", options->draft ? "0 or 1 in a draft" : "0 or more",
         options->substeps, 0, options->draft ? 1 : DBL_MAX},
    };
    for (size_t i = 0; i < sizeof ranges / sizeof *ranges; i++) {
        const option_range *own = &ranges[i];
        if (!(own->value >= own->least && own->value <= own->most))
            return tf_fail_option(error, own->name, own->range, own->value);
    }
    return TF_OK;
}

//: Find the mean edge
static double mean_edge(const tf_surface *surface, const tf_step *step)
{
    int count;
    const int *edge = tf_surface_edges(surface, &count);
    double sum = 0;
    for (int i = 0; i < count; i++, edge += 2) {
        tf_vector from = tf_step_position(step, edge[0], step->start);
        tf_vector to = tf_step_position(step, edge[1], step->start);
        sum += tf_vector_length(tf_vector_difference(to, from));
    }
    double mean = count > 0 ? sum / count : 0;
    return isfinite(mean) ? mean : 0;
}

//: Choose what is left to choose
enum {
    USUAL_ROUNDS = 20,
    USUAL_SWEEPS = 30
};

static const double usual_separation = 0.05; // of the mean edge

void tf_response_options_choose(tf_response_options *options,
                                const tf_surface *surface, const tf_step *step)
{
    if (!options->solver)
        options->solver = &tf_gauss_seidel;
    if (options->zone_rounds == 0)
        options->zone_rounds = USUAL_ROUNDS;
    if (options->sweeps == 0)
        options->sweeps = USUAL_SWEEPS;
    if (options->separation == 0)
        options->separation = usual_separation * mean_edge(surface, step);
}
