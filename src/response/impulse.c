//: Include what impulses need
#include "response/impulse.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

//: Find the gap change
/// How one element moves against the other: in all directions.
static tf_vector relative_displacement(int axes,
                                       const tf_constraint *constraint,
                                       const double displacement[])
{
    tf_vector relative = {{0}};
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        const double *d =
            displacement + (ptrdiff_t)axes * constraint->vertex[i];
        tf_vector own = {{d[0], d[1], axes == 3 ? d[2] : 0}};
        relative = tf_vector_sum(relative, constraint->coefficient[i], own);
    }
    return relative;
}

static tf_vector normal_of(const tf_constraint *constraint)
{
    return tf_vector_at(constraint->normal, 0);
}

double tf_constraint_gap_change(int axes, const tf_constraint *constraint,
                                const double displacement[])
{
    return tf_vector_dot(normal_of(constraint),
                         relative_displacement(axes, constraint, displacement));
}

//: Find the compliance of a constraint
/// The farthest that a push may move a vertex, if it widens the gap by 1.
static const double most_leverage = 1024;

double tf_constraint_compliance(const tf_constraint *constraint,
                                const double inverse_mass[])
{
    double sum = 0, farthest = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        double size = fabs(constraint->coefficient[i]);
        double move = inverse_mass[constraint->vertex[i]] * size;
        sum += move * size;
        farthest = move > farthest ? move : farthest;
    }
    return farthest <= most_leverage * sum ? sum : 0;
}

//: Average the friction of an element
static double clamp(double x, double least, double most)
{
    return fmin(fmax(x, least), most);
}

/// The mean of the coefficients of the vertices of one element: of those that
/// have coefficients of this sign in the constraint.
static double mean_friction(const tf_constraint *constraint, double sign,
                            const double own[])
{
    double sum = 0, least = DBL_MAX, most = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        double weight = sign * constraint->coefficient[i];
        if (!(weight > 0))
            continue;
        double friction = own[constraint->vertex[i]];
        sum += weight * friction;
        least = fmin(least, friction);
        most = fmax(most, friction);
    }
    return clamp(sum, least, most);
}

//: Find the friction of a constraint
double tf_constraint_friction(const tf_constraint *constraint,
                              tf_friction friction)
{
    if (!friction.own)
        return friction.all;
    double first = mean_friction(constraint, 1, friction.own);
    double second = mean_friction(constraint, -1, friction.own);
    return clamp(sqrt(first) * sqrt(second), fmin(first, second),
                 fmax(first, second));
}

//: Push the vertices of a constraint
void tf_constraint_push(const tf_constraint *constraint, tf_vector impulse,
                        const tf_bodies *bodies)
{
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        int vertex = constraint->vertex[i];
        double share =
            bodies->inverse_mass[vertex] * constraint->coefficient[i];
        double *d = bodies->displacement + (ptrdiff_t)bodies->axes * vertex;
        for (int k = 0; k < TF_AXES && k < bodies->axes; k++)
            d[k] += share * impulse.x[k];
    }
}

//: Push along the normal
/// Returns by how much the gap changes.
static double push_along(tf_constraint *constraint, double compliance,
                         const tf_bodies *bodies)
{
    double gap_change = tf_constraint_gap_change(bodies->axes, constraint,
                                                 bodies->displacement);
    double wanted =
        constraint->impulse + (constraint->bound - gap_change) / compliance;
    double change = (wanted > 0 ? wanted : 0) - constraint->impulse;
    tf_constraint_push(constraint,
                       tf_vector_scaled(change, normal_of(constraint)), bodies);
    constraint->impulse += change;
    return fabs(change) * compliance;
}

//: Push across the normal
/// Returns by how much the sliding changes.
static double push_across(tf_constraint *constraint, double compliance,
                          double most, const tf_bodies *bodies)
{
    //: Find the impulse that would stop all sliding
    tf_vector normal = normal_of(constraint), wanted;
    tf_vector relative =
        relative_displacement(bodies->axes, constraint, bodies->displacement);
    double gap_change = tf_vector_dot(normal, relative);
    tf_vector sliding = tf_vector_sum(relative, -gap_change, normal);
    for (int k = 0; k < TF_AXES; k++)
        wanted.x[k] = constraint->friction[k] - sliding.x[k] / compliance;

    //: Limit it as Coulomb does
    double size = tf_vector_length(wanted);
    double scale = size > most ? most / size : 1;
    tf_vector change;
    for (int k = 0; k < TF_AXES; k++) {
        // Added up, a rounding error could leave the friction above the limit.
        double limited = scale * wanted.x[k];
        change.x[k] = limited - constraint->friction[k];
        constraint->friction[k] = limited;
    }
    tf_constraint_push(constraint, change, bodies);
    return tf_vector_length(change) * compliance;
}

//: Visit a constraint
double tf_constraint_visit(tf_constraint *constraint, double friction,
                           const tf_bodies *bodies)
{
    double compliance =
        tf_constraint_compliance(constraint, bodies->inverse_mass);
    if (!(compliance > 0))
        return 0;
    double change = push_along(constraint, compliance, bodies);
    if (!(friction > 0))
        return change;
    double sliding = push_across(constraint, compliance,
                                 friction * constraint->impulse, bodies);
    return change > sliding ? change : sliding;
}
