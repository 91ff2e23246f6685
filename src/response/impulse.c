//: Include what impulses need
#include "response/impulse.h"

#include <math.h>
#include <stddef.h>

//: See how elements part
static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// How one element moves against the other: in all directions.
static void relative_displacement(int axes, const tf_constraint *constraint,
                                  const double displacement[],
                                  double relative[3])
{
    relative[0] = relative[1] = relative[2] = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        const double *d =
            displacement + (ptrdiff_t)axes * constraint->vertex[i];
        relative[0] += constraint->coefficient[i] * d[0];
        relative[1] += constraint->coefficient[i] * d[1];
        if (axes == 3)
            relative[2] += constraint->coefficient[i] * d[2];
    }
}

double tf_constraint_separation(int axes, const tf_constraint *constraint,
                                const double displacement[])
{
    double relative[3];
    relative_displacement(axes, constraint, displacement, relative);
    return dot(constraint->normal, relative);
}

//: Find the compliance of a constraint
/// The farthest that a push may move a vertex, if it parts the elements by 1.
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

//: Push the vertices of a constraint
void tf_constraint_push(const tf_constraint *constraint,
                        const double impulse[3], const tf_bodies *bodies)
{
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        int vertex = constraint->vertex[i];
        double share =
            bodies->inverse_mass[vertex] * constraint->coefficient[i];
        double *d = bodies->displacement + (ptrdiff_t)bodies->axes * vertex;
        for (int k = 0; k < 3 && k < bodies->axes; k++)
            d[k] += share * impulse[k];
    }
}

//: Push along the normal
/// Returns by how much the separation changes.
static double push_along(tf_constraint *constraint, double compliance,
                         const tf_bodies *bodies)
{
    double separation = tf_constraint_separation(bodies->axes, constraint,
                                                 bodies->displacement);
    double wanted =
        constraint->impulse + (constraint->bound - separation) / compliance;
    double change = (wanted > 0 ? wanted : 0) - constraint->impulse;
    double push[3];
    for (int k = 0; k < 3; k++)
        push[k] = change * constraint->normal[k];
    tf_constraint_push(constraint, push, bodies);
    constraint->impulse += change;
    return fabs(change) * compliance;
}

//: Push across the normal
/// Returns by how much the sliding changes.
static double push_across(tf_constraint *constraint, double compliance,
                          double most, const tf_bodies *bodies)
{
    //: Find the impulse that would stop all sliding
    double relative[3], wanted[3];
    relative_displacement(bodies->axes, constraint, bodies->displacement,
                          relative);
    double separation = dot(constraint->normal, relative);
    for (int k = 0; k < 3; k++)
        wanted[k] =
            constraint->friction[k] -
            (relative[k] - separation * constraint->normal[k]) / compliance;

    //: Limit it as Coulomb does
    double size = sqrt(dot(wanted, wanted));
    double scale = size > most ? most / size : 1;
    double change[3];
    for (int k = 0; k < 3; k++) {
        change[k] = scale * wanted[k] - constraint->friction[k];
        constraint->friction[k] += change[k];
    }
    tf_constraint_push(constraint, change, bodies);
    return sqrt(dot(change, change)) * compliance;
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
