//: Include what linear motion needs
#include "linear/linear_pair.h"

#include "base/environment.h"
#include "base/require.h"
#include "intersect/velocity.h"
#include "query/query.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

//: Check the indices of a scene
/// Whether the indices are distinct and name vertices.
static bool indices_name_vertices(const tf_motion *motion, int count,
                                  const int index[])
{
    bool good = true;
    for (int i = 0; i < count; i++) {
        good = good && index[i] >= 0 && index[i] < motion->vertices;
        for (int j = 0; j < i; j++)
            good = good && index[j] != index[i];
    }
    return good;
}

//: Copy the coordinates of a scene
/// False if one is not finite.  Inline, for loops of constant length.
static inline bool copy_positions(int axes, const double x[], int count,
                                  const int index[], tf_vector position[])
{
    bool finite = true;
    for (int i = 0; i < count; i++) {
        const double *from = x + (ptrdiff_t)axes * index[i];
        for (int k = 0; k < axes; k++) {
            position[i].x[k] = from[k];
            finite &= fabs(from[k]) <= DBL_MAX;
        }
        for (int k = axes; k < TF_AXES; k++)
            position[i].x[k] = 0;
    }
    return finite;
}

//: Copy a scene
static bool copy_scene(int axes, const tf_motion *motion, const int index[],
                       tf_linear_pair *taken)
{
    const double *x[] = {motion->start, motion->end};
    bool finite = true;
    for (int t = 0; t < 2; t++)
        finite &= axes == 2 ? copy_positions(2, x[t], 3, index, taken->at[t])
                            : copy_positions(3, x[t], 4, index, taken->at[t]);
    return finite;
}

//: Take two elements in linear motion
tf_status tf_linear_pair_take(int axes, const tf_motion *motion, int vertices,
                              const int first[], int others, const int second[],
                              tf_linear_pair *taken)
{
    TF_REQUIRE(motion && first && second);
    if (!tf_environment_is_ieee())
        return TF_BAD_ENVIRONMENT;
    tf_status status = tf_motion_check(motion, axes);
    if (status != TF_OK)
        return status;
    int index[TF_LINEAR_PAIR_VERTICES];
    for (int i = 0; i < vertices; i++)
        index[i] = first[i];
    for (int i = 0; i < others; i++)
        index[vertices + i] = second[i];
    if (!indices_name_vertices(motion, vertices + others, index))
        return TF_BAD_INDEX;
    taken->axes = axes;
    taken->vertices = vertices;
    taken->others = others;
    return copy_scene(axes, motion, index, taken) ? TF_OK : TF_NOT_FINITE;
}

//: Find positions in linear motion
void tf_linear_pair_positions(const tf_linear_pair *elements, double time,
                              tf_vector x[TF_LINEAR_PAIR_VERTICES])
{
    for (int i = 0; i < elements->vertices + elements->others; i++)
        x[i] = tf_vector_sum(tf_vector_scaled(1 - time, elements->at[0][i]),
                             time, elements->at[1][i]);
}

//: Separate elements by more than a distance
/// +1 or -1: the second element is more than `distance` above or below the
/// first along an axis, at the time 0 or 1; 0: neither.
static int side_of(const tf_linear_pair *elements, int time, int axis,
                   double distance)
{
    const tf_vector *x = elements->at[time];
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < elements->vertices + elements->others; i++) {
        int element = i >= elements->vertices;
        double value = x[i].x[axis];
        low[element] = value < low[element] ? value : low[element];
        high[element] = value > high[element] ? value : high[element];
    }
    return (low[1] - high[0] > distance) - (low[0] - high[1] > distance);
}

//: Test whether an axis separates
/// Whether along some axis the elements are more than `distance` apart, on the
/// same side, at the start and at the end, and so always.
static bool separated(const tf_linear_pair *elements, double distance)
{
    for (int k = 0; k < elements->axes; k++) {
        int side = side_of(elements, 0, k, distance);
        if (side != 0 && side_of(elements, 1, k, distance) == side)
            return true;
    }
    return false;
}

//: Find the normal at a time
/// Of an edge in the plane, of a triangle, or of two edges.
static tf_vector normal_of(const tf_linear_pair *elements, const tf_vector x[])
{
    static const tf_vector up = {{0, 0, 1}};
    if (elements->axes == 2)
        return tf_vector_cross(up, tf_vector_difference(x[2], x[1]));
    if (elements->vertices == 2)
        return tf_vector_cross(tf_vector_difference(x[1], x[0]),
                               tf_vector_difference(x[3], x[2]));
    return tf_vector_cross(tf_vector_difference(x[2], x[1]),
                           tf_vector_difference(x[3], x[1]));
}

//: Scale a normal to length 1
/// Zero if it has none or overflows.
static tf_vector unit_normal(const tf_linear_pair *elements, double time)
{
    tf_vector x[TF_LINEAR_PAIR_VERTICES];
    tf_linear_pair_positions(elements, time, x);
    tf_vector normal = normal_of(elements, x);
    double largest = 0;
    bool finite = true;
    for (int k = 0; k < TF_AXES; k++) {
        largest = fmax(largest, fabs(normal.x[k]));
        finite = finite && fabs(normal.x[k]) <= DBL_MAX;
    }
    if (!finite || largest == 0)
        return (tf_vector){{0}};
    // In two steps, as the square of the length may overflow or underflow.
    for (int k = 0; k < TF_AXES; k++)
        normal.x[k] /= largest;
    return tf_vector_unit(normal);
}

//: Find the velocity of the points that touch
static tf_vector limited(tf_vector v)
{
    for (int k = 0; k < TF_AXES; k++)
        v.x[k] = fmin(fmax(v.x[k], -DBL_MAX), DBL_MAX);
    return v;
}

static tf_vector velocity_between(const tf_linear_pair *elements,
                                  const double weight[])
{
    tf_vector velocity = {{0}};
    for (int i = 0; i < elements->vertices + elements->others; i++) {
        tf_vector displacement = limited(
            tf_vector_difference(elements->at[1][i], elements->at[0][i]));
        double part = i < elements->vertices ? weight[i] : -weight[i];
        velocity = tf_vector_sum(velocity, part, displacement);
    }
    return limited(velocity);
}

//: Describe a contact in linear motion
tf_contact tf_linear_pair_contact(const tf_linear_pair *elements, double time,
                                  const tf_point_pair *nearest,
                                  tf_classification classification)
{
    tf_contact contact = {.verdict = TF_HIT,
                          .classification = classification,
                          .toi_lo = time,
                          .toi_hi = time};
    int vertices = elements->vertices;
    for (int i = 0; i < vertices; i++)
        contact.barycentric[0][i] = nearest->weight[i];
    for (int i = 0; i < elements->others; i++)
        contact.barycentric[1][i] = nearest->weight[vertices + i];
    tf_vector normal = unit_normal(elements, time);
    tf_vector velocity = velocity_between(elements, nearest->weight);
    for (int k = 0; k < TF_AXES; k++) {
        // Adding zero turns -0 into 0.
        contact.normal[k] = normal.x[k] + 0.0;
        contact.velocity[k] = velocity.x[k] + 0.0;
    }
    contact.normal_velocity = tf_normal_velocity(velocity, normal) + 0.0;
    return contact;
}

//: Check the tolerances
static bool is_tolerance(double value)
{
    return value >= 0 && value <= DBL_MAX;
}

bool tf_tolerances_valid(const tf_tolerances *tolerances)
{
    return is_tolerance(tolerances->distance) &&
           is_tolerance(tolerances->barycentric);
}

//: Bound the area that the polynomial measures
/// The height of one element over the plane of the other, times this, is at
/// least the polynomial's absolute value, at every time.
static double longest(const tf_linear_pair *elements, int from, int to)
{
    double length2 = 0;
    for (int t = 0; t < 2; t++) {
        const tf_vector *x = elements->at[t];
        tf_vector edge = tf_vector_difference(x[to], x[from]);
        length2 = fmax(length2, tf_vector_dot(edge, edge));
    }
    return sqrt(length2);
}

static double greatest_area(const tf_linear_pair *elements)
{
    if (elements->axes == 2)
        return longest(elements, 1, 2);
    if (elements->vertices == 2)
        return longest(elements, 0, 1) * longest(elements, 2, 3);
    return longest(elements, 1, 2) * longest(elements, 1, 3);
}

//: Hold a search for the first touch
typedef struct search {
    const tf_linear_pair *elements;
    const tf_tolerances *tolerances;
    double greatest; ///< what the polynomial may be where they touch
    bool degenerate; ///< it is zero
    tf_contact contact;
} search;

//: Test the elements at a root
static bool cross_at(const search *s, const tf_vector x[], tf_point_pair *found)
{
    const tf_linear_pair *elements = s->elements;
    int vertices = elements->vertices, others = elements->others;
    return tf_crossing_weights(vertices, others, x, found->weight) &&
           tf_weights_reach(vertices + others, found->weight,
                            -s->tolerances->barycentric);
}

//: Test the elements at a time
/// Whether they touch at a time; if so describes how.
static bool touch_at(search *s, double time, bool root)
{
    const tf_linear_pair *elements = s->elements;
    tf_vector x[TF_LINEAR_PAIR_VERTICES];
    tf_point_pair crossing;
    tf_linear_pair_positions(elements, time, x);
    bool crosses = root && cross_at(s, x, &crossing);
    if (crosses && tf_weights_reach(elements->vertices + elements->others,
                                    crossing.weight, 0)) {
        s->contact =
            tf_linear_pair_contact(elements, time, &crossing,
                                   s->degenerate ? TF_DEGENERATE : TF_GENERIC);
        return true;
    }
    tf_point_pair nearest =
        tf_nearest_points(elements->vertices, elements->others, x);
    if (!crosses && !(nearest.distance <= s->tolerances->distance))
        return false;
    s->contact = tf_linear_pair_contact(
        elements, time, &nearest, s->degenerate ? TF_DEGENERATE : TF_TOUCHING);
    return true;
}

//: Find the first touch
tf_contact tf_linear_pair_touch(const tf_linear_pair *elements,
                                const tf_polynomial *polynomial,
                                const tf_tolerances *tolerances)
{
    search s = {.elements = elements, .tolerances = tolerances};
    s.contact = (tf_contact){.verdict = TF_APART};
    s.greatest = tolerances->distance * greatest_area(elements);
    if (!tf_polynomial_can_reach(polynomial, s.greatest) ||
        (tolerances->barycentric == 0 &&
         separated(elements, tolerances->distance)))
        return s.contact;
    s.degenerate = tf_polynomial_is_zero(polynomial);
    double cut[TF_MOST_CUTS], value = 0;
    int count = tf_polynomial_cuts(polynomial, cut);
    for (int i = 0; i < count; i++) {
        //: Find a root before the cut
        double before = value;
        value = tf_polynomial_value(polynomial, cut[i]);
        if ((before < 0 && value > 0) || (before > 0 && value < 0)) {
            double root = tf_polynomial_root(polynomial, cut[i - 1], cut[i]);
            if (touch_at(&s, root, true))
                break;
        }

        //: Test the elements at the cut
        if (fabs(value) <= s.greatest && touch_at(&s, cut[i], value == 0))
            break;
    }
    return s.contact;
}
