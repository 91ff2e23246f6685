//: Include what requested responses need
#include "program/response_request.h"

//: Take the response from the command line
/// To the library, a separation of 0 is the usual one, and a negative one none.
tf_response_options tf_response_requested(const tf_request *wanted,
                                          tf_progress_line *progress)
{
    bool none =
        tf_request_gave(wanted, "separation") && wanted->separation == 0;
    return (tf_response_options){
        .size = sizeof(tf_response_options),
        .solver = wanted->solver,
        .separation = none ? -1 : wanted->separation,
        .restitution = wanted->restitution,
        .substeps = wanted->substeps,
        .friction = wanted->friction,
        .progress = tf_progress_line_show_stage,
        .context = progress,
        .restitution_threshold = wanted->restitution_threshold,
        .thickness = wanted->thickness,
    };
}
