//: Include what methods need
#include "program/methods.h"

#include "linear/additive.h"
#include "linear/cubic.h"
#include "linear/quadratic.h"
#include "query/edge_edge.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"

#include <stddef.h>

//: Number the vertices of a row
// The first element's, then the second's.
static const int row[] = {0, 1, 2, 3};

//: Answer by space-time simplices
static tf_status answer_spacetime(const tf_method_options *options,
                                  const tf_query_kind *kind,
                                  const tf_motion *motion, tf_contact *contact)
{
    const tf_arithmetic *arithmetic = options->arithmetic;
    if (kind->axes == 2)
        return tf_point_edge(arithmetic, motion, 0, row + 1, contact);
    if (kind->vertices[0] == 1)
        return tf_point_triangle(arithmetic, motion, 0, row + 1, contact);
    return tf_edge_edge(arithmetic, motion, row, row + 2, contact);
}

//: Answer by the quadratic or the cubic
static tf_status answer_cubic(const tf_method_options *options,
                              const tf_query_kind *kind,
                              const tf_motion *motion, tf_contact *contact)
{
    tf_tolerances tolerances = {.distance = options->tolerance};
    if (kind->axes == 2)
        return tf_quadratic_point_edge(&tolerances, motion, 0, row + 1,
                                       contact);
    if (kind->vertices[0] == 1)
        return tf_cubic_point_triangle(&tolerances, motion, 0, row + 1,
                                       contact);
    return tf_cubic_edge_edge(&tolerances, motion, row, row + 2, contact);
}

//: Answer by additive advancement
static tf_status answer_advancement(const tf_method_options *options,
                                    const tf_query_kind *kind,
                                    const tf_motion *motion,
                                    tf_contact *contact)
{
    tf_advance_limits limits = {.threshold = options->threshold};
    if (kind->axes == 2)
        return tf_additive_point_edge(&limits, motion, 0, row + 1, contact,
                                      NULL);
    if (kind->vertices[0] == 1)
        return tf_additive_point_triangle(&limits, motion, 0, row + 1, contact,
                                          NULL);
    return tf_additive_edge_edge(&limits, motion, row, row + 2, contact, NULL);
}

//: Name the methods
struct tf_method {
    const char *option;
    tf_status (*answer)(const tf_method_options *options,
                        const tf_query_kind *kind, const tf_motion *motion,
                        tf_contact *contact);
};

static const tf_method spacetime = {"arithmetic", answer_spacetime};
static const tf_method cubic = {"tolerance", answer_cubic};
static const tf_method advancement = {"threshold", answer_advancement};

const tf_choice tf_methods[] = {
    {"spacetime", &spacetime},
    {"cubic", &cubic},
    {"advancement", &advancement},
    {NULL, NULL},
};

const char *tf_method_option(const tf_method *method)
{
    return method->option;
}

//: Answer a query of a file
tf_status tf_method_answer(const tf_method *method,
                           const tf_method_options *options,
                           const tf_query_kind *kind,
                           const tf_query_rows *query, tf_contact *contact)
{
    tf_motion motion = {.axes = kind->axes,
                        .vertices = kind->vertices[0] + kind->vertices[1],
                        .start = query->x[0],
                        .end = query->x[1]};
    return method->answer(options, kind, &motion, contact);
}
