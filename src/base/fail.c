//: Set an error
#include "base/fail.h"

tf_status tf_fail(tf_error *error, tf_status status)
{
    if (error)
        *error = (tf_error){
            .status = status, .vertex = {-1, -1, -1, -1, -1}, .time = -1};
    return status;
}

tf_status tf_fail_element(tf_error *error, tf_status status, tf_subject subject,
                          size_t index, int vertex)
{
    tf_fail(error, status);
    if (error) {
        error->subject = subject;
        error->index = index;
        error->vertex[0] = vertex;
    }
    return status;
}

tf_status tf_fail_index(tf_error *error, tf_subject subject, size_t index,
                        int vertex, int vertices)
{
    tf_fail_element(error, TF_BAD_INDEX, subject, index, vertex);
    if (error)
        error->vertices = vertices;
    return TF_BAD_INDEX;
}

tf_status tf_fail_vertex(tf_error *error, tf_status status, int vertex,
                         int time)
{
    tf_fail_element(error, status, TF_VERTEX, (size_t)vertex, vertex);
    if (error)
        error->time = time;
    return status;
}

tf_status tf_fail_query(tf_error *error, tf_status status, size_t index,
                        int vertex, int time)
{
    tf_fail_element(error, status, TF_BATCH_QUERY, index, vertex);
    if (error)
        error->time = time;
    return status;
}

//: Set an error about an option
tf_status tf_fail_option(tf_error *error, const char *option, const char *range,
                         double value)
{
    tf_fail(error, TF_BAD_OPTION);
    if (error) {
        error->subject = TF_OPTION;
        error->option = option;
        error->range = range;
        error->value = value;
    }
    return TF_BAD_OPTION;
}

tf_status tf_fail_vertex_option(tf_error *error, const char *option,
                                const char *range, int vertex, double value)
{
    tf_fail_option(error, option, range, value);
    if (error) {
        error->subject = TF_VERTEX;
        error->index = (size_t)vertex;
        error->vertex[0] = vertex;
    }
    return TF_BAD_OPTION;
}

//: Set an error about a pair
tf_status tf_fail_pair(tf_error *error, tf_status status, tf_subject pair,
                       int most, const int vertex[], int time)
{
    tf_fail(error, status);
    if (!error)
        return status;
    error->subject = pair;
    error->time = time;
    for (int i = 0; i < most && vertex[i] >= 0; i++)
        error->vertex[i] = vertex[i];
    return status;
}
