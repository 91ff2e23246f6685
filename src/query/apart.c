//: List the differences of two elements
#include "query/apart.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"

#include <math.h>

void tf_list_differences(int corners, int others, const double *const x[],
                         tf_difference_list *list)
{
    double share = 1.0 / (corners * others);
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
/// Repeats the first difference up to a multiple of four, so that loops over the
/// list need no branch; returns how many there are then.
static int fill(tf_difference_list *list)
{
    int places = (list->count + 3) / 4 * 4;
    for (int i = list->count; i < places; i++)
        for (int k = 0; k < TF_AXES; k++)
            list->x[k][i] = list->x[k][0];
    return places;
}

static tf_vector difference_at(const tf_difference_list *list, int i)
{
    return (tf_vector){{list->x[0][i], list->x[1][i], list->x[2][i]}};
}

//: Measure how far differences certainly are ahead
/// How far each difference is ahead in a direction, less what rounding may have
/// added: if that is positive, so is the dot product with the exact difference
/// of the vertices.  A NaN if a product overflows.  Whether all are ahead.
static bool measure(const tf_difference_list *list, int places, tf_vector along,
                    double ahead[TF_MOST_DIFFERENCES])
{
    int all = 1;
    for (int i = 0; i < places; i++) {
        double a = along.x[0] * list->x[0][i];
        double b = along.x[1] * list->x[1][i];
        double c = along.x[2] * list->x[2][i];
        double size = fabs(a) + fabs(b) + fabs(c);
        // Rounding loses less than 5 u size, with u = 2^-53, and underflow less
        // than 2^-1000.
        ahead[i] = a + b + c - (0x1p-49 * size + 0x1p-1000);
        all &= ahead[i] > 0;
    }
    return all;
}

static int find_least(int places, const double ahead[])
{
    int least = 0;
    for (int i = 1; i < places; i++)
        least = ahead[i] < ahead[least] ? i : least;
    return least;
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

//: Look for a direction that separates
bool tf_certainly_apart(tf_difference_list *list)
{
    enum {
        MOST_TURNS = 6
    };
    int places = fill(list);
    tf_vector along = list->center;
    double ahead[TF_MOST_DIFFERENCES];
    for (int turn = 0; turn < MOST_TURNS; turn++) {
        if (measure(list, places, along, ahead))
            return true;
        int least = find_least(places, ahead);
        along = nearest_between(along, difference_at(list, least));
    }
    return false;
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
