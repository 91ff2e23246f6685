//: Include what the report of remeshing needs
#include "program/remesh_output.h"

//: List the fields about remeshing
#define TRIED(name, operation, outcome)                                        \
    TF_FIELD(name, TF_COUNT, tf_remeshed, report.tried[operation][outcome])

#define OUTCOMES(names, operation)                                             \
    TRIED(names, operation, TF_COMMITTED),                                     \
        TRIED("impossible " names, operation, TF_IMPOSSIBLE),                  \
        TRIED("collinear " names, operation, TF_FLATTENED),                    \
        TRIED("overlapping " names, operation, TF_OVERLAPPED),                 \
        TRIED(names " past vertices", operation, TF_PASSED_VERTEX),            \
        TRIED(names " past edges", operation, TF_PASSED_EDGE),                 \
        TRIED(names " past triangles", operation, TF_PASSED_TRIANGLE)

static const tf_field fields[] = {
    TF_FIELD("triangles before", TF_INTEGER, tf_remeshed, triangles_before),
    TF_FIELD("triangles", TF_INTEGER, tf_remeshed, triangles_after),
    TF_FIELD("edge", TF_NUMBER, tf_remeshed, edge),
    TF_FIELD("least quality before", TF_NUMBER, tf_remeshed,
             report.least_before),
    TF_FIELD("least quality", TF_NUMBER, tf_remeshed, report.least_after),
    TF_FIELD("mean quality before", TF_NUMBER, tf_remeshed, report.mean_before),
    TF_FIELD("mean quality", TF_NUMBER, tf_remeshed, report.mean_after),
    TF_FIELD("distance", TF_NUMBER, tf_remeshed, report.distance),
    TF_FIELD("rounds", TF_INTEGER, tf_remeshed, report.rounds),
    TF_FIELD("seconds", TF_NUMBER, tf_remeshed, seconds),
    OUTCOMES("splits", TF_SPLIT),
    OUTCOMES("collapses", TF_COLLAPSE),
    OUTCOMES("flips", TF_FLIP),
    OUTCOMES("moves", TF_SMOOTH),
    {0},
};

//: Write the report of remeshing
bool tf_remesh_output_write(FILE *stream, tf_format format,
                            const tf_remeshed *remeshed)
{
    return tf_report_write(stream, format, fields, remeshed);
}
