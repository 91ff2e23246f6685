//: List the differences of two elements
#include "query/apart.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"
#include "query/shape.h"

#include <math.h>

void tf_list_differences(int corners, int others, const double *const x[],
                         tf_difference_list *list)
{
    double share = 1.0 / (corners * others);
    list->corners = corners;
    list->others = others;
    list->vertex = x;
    list->center = (tf_vector){{0}};
    for (int i = 0; i < corners; i++)
        for (int j = corners; j < corners + others; j++) {
            for (int k = 0; k < TF_AXES; k++) {
                double difference = x[j][k] - x[i][k];
                list->x[k][list->count] = difference;
                list->center.x[k] += share * difference;
            }
            list->count++;
        }
}

//: Fill the list of differences
/// Repeats the first difference, so that loops over all places need no branch.
static void fill(tf_difference_list *list)
{
    for (int i = list->count; i < TF_MOST_DIFFERENCES; i++)
        for (int k = 0; k < TF_AXES; k++)
            list->x[k][i] = list->x[k][0];
}

static tf_vector difference_at(const tf_difference_list *list, int i)
{
    return (tf_vector){{list->x[0][i], list->x[1][i], list->x[2][i]}};
}

/// Whether no product overflows, nor any of the filter by lanes: the differences
/// that it sees are at most twice as large, and it adds up three.  A NaN, too, is
/// over the limit.
static bool is_limited(const tf_difference_list *list)
{
    bool limited = true;
    for (int k = 0; k < TF_AXES; k++)
        for (int i = 0; i < TF_MOST_DIFFERENCES; i++)
            limited &= fabs(list->x[k][i]) <= 0x1p297;
    return limited;
}

//: Find the difference that is least certainly ahead
/// How far a difference is ahead in a direction, less what rounding may have
/// added: if that is positive, so is the dot product, from the exact difference of
/// the vertices on.  Sets `least` to the first difference for which it is least.
static double find_least(const tf_difference_list *list, tf_vector along,
                         int *least)
{
    double ahead[TF_MOST_DIFFERENCES];
    for (int i = 0; i < TF_MOST_DIFFERENCES; i++) {
        double a = along.x[0] * list->x[0][i];
        double b = along.x[1] * list->x[1][i];
        double c = along.x[2] * list->x[2][i];
        double size = fabs(a) + fabs(b) + fabs(c);
        // Rounding loses less than 5 u size, with u = 2^-53, and underflow less
        // than 2^-1000.
        ahead[i] = a + b + c - (0x1p-49 * size + 0x1p-1000);
    }
    *least = 0;
    for (int i = 1; i < TF_MOST_DIFFERENCES; i++)
        *least = ahead[i] < ahead[*least] ? i : *least;
    return ahead[*least];
}

//: Turn a direction toward a difference
/// The point nearest to the origin between two points.
static tf_vector nearest_between(tf_vector from, tf_vector to)
{
    tf_vector step = tf_vector_difference(to, from);
    double square = tf_vector_dot(step, step);
    double share = -tf_vector_dot(from, step) / square;
    return share > 0 ? tf_vector_sum(from, share < 1 ? share : 1, step) : from;
}

//: Look across two elements
static tf_vector from_to(const tf_difference_list *list, int i, int j)
{
    return tf_vector_difference(tf_vector_at(list->vertex[j], 0),
                                tf_vector_at(list->vertex[i], 0));
}

/// The normal of a triangle, or a direction across both edges: the one in which
/// elements lie one above the other.
static tf_vector direction_across(const tf_difference_list *list)
{
    int last = list->corners + list->others - 1;
    tf_vector first =
        list->others == 3 ? from_to(list, last, last - 2) : from_to(list, 0, 1);
    return tf_vector_cross(first, from_to(list, last, last - 1));
}

//: Look for a direction that separates
static bool separates(const tf_difference_list *list, tf_vector along)
{
    int least;
    return find_least(list, along, &least) > 0;
}

bool tf_certainly_apart(tf_difference_list *list)
{
    enum {
        MOST_TURNS = 8
    };
    tf_vector along = list->center;
    fill(list);
    if (!is_limited(list))
        return false;
    for (int turn = 0; turn < MOST_TURNS; turn++) {
        int least;
        if (find_least(list, along, &least) > 0)
            return true;
        along = nearest_between(along, difference_at(list, least));
    }
    along = direction_across(list);
    return separates(list, along) ||
           separates(list, tf_vector_scaled(-1, along));
}

//: Look for a direction that separates a query
bool tf_query_certainly_apart(const tf_queries *queries, size_t query)
{
    const tf_query_shape *shape = tf_query_shape_of(queries->kind);
    const int *vertex = queries->vertices + 4 * query;
    tf_difference_list list = {.count = 0};
    const double *x[4];
    for (int t = 0; t < 2; t++) {
        const double *at = t ? queries->motion->end : queries->motion->start;
        for (int v = 0; v < 4; v++)
            x[v] = at + (ptrdiff_t)3 * vertex[v];
        tf_list_differences(shape->vertices, shape->others, x, &list);
    }
    return tf_certainly_apart(&list);
}

//: Be certain
static tf_sign certain_sign(const tf_differences *differences)
{
    return tf_clamped.sign(differences);
}

static tf_value certain_value(const tf_differences *differences)
{
    return tf_clamped.value(differences);
}

const tf_arithmetic tf_certain = {
    .name = "certain", .sign = certain_sign, .value = certain_value};
