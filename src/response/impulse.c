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
static void relative_displacement(int axes, const tf_row *row,
                                  const double displacement[],
                                  double relative[3])
{
    relative[0] = relative[1] = relative[2] = 0;
    for (int i = 0; i < 4 && row->vertex[i] >= 0; i++) {
        const double *d = displacement + (ptrdiff_t)axes * row->vertex[i];
        relative[0] += row->coefficient[i] * d[0];
        relative[1] += row->coefficient[i] * d[1];
        if (axes == 3)
            relative[2] += row->coefficient[i] * d[2];
    }
}

double tf_row_parting(int axes, const tf_row *row, const double displacement[])
{
    double relative[3];
    relative_displacement(axes, row, displacement, relative);
    return dot(row->normal, relative);
}

//: Find the compliance of a row
/// The farthest that a push may move a vertex, if it parts the elements by 1.
static const double most_leverage = 1024;

double tf_row_compliance(const tf_row *row, const double inverse_mass[])
{
    double sum = 0, farthest = 0;
    for (int i = 0; i < 4 && row->vertex[i] >= 0; i++) {
        double size = fabs(row->coefficient[i]);
        double move = inverse_mass[row->vertex[i]] * size;
        sum += move * size;
        farthest = move > farthest ? move : farthest;
    }
    return farthest <= most_leverage * sum ? sum : 0;
}

//: Push the vertices of a row
void tf_row_push(const tf_row *row, const double impulse[3],
                 const tf_bodies *bodies)
{
    for (int i = 0; i < 4 && row->vertex[i] >= 0; i++) {
        int vertex = row->vertex[i];
        double share = bodies->inverse_mass[vertex] * row->coefficient[i];
        double *d = bodies->displacement + (ptrdiff_t)bodies->axes * vertex;
        for (int k = 0; k < 3 && k < bodies->axes; k++)
            d[k] += share * impulse[k];
    }
}

//: Push along the normal
/// Returns by how much the parting changes.
static double push_along(tf_row *row, double compliance,
                         const tf_bodies *bodies)
{
    double parting = tf_row_parting(bodies->axes, row, bodies->displacement);
    double wanted = row->impulse + (row->bound - parting) / compliance;
    double change = (wanted > 0 ? wanted : 0) - row->impulse;
    double push[3];
    for (int k = 0; k < 3; k++)
        push[k] = change * row->normal[k];
    tf_row_push(row, push, bodies);
    row->impulse += change;
    return fabs(change) * compliance;
}

//: Push across the normal
/// Returns by how much the sliding changes.
static double push_across(tf_row *row, double compliance, double most,
                          const tf_bodies *bodies)
{
    //: Find the impulse that would stop all sliding
    double relative[3], wanted[3];
    relative_displacement(bodies->axes, row, bodies->displacement, relative);
    double parting = dot(row->normal, relative);
    for (int k = 0; k < 3; k++)
        wanted[k] = row->friction[k] -
                    (relative[k] - parting * row->normal[k]) / compliance;

    //: Limit it as Coulomb does
    double size = sqrt(dot(wanted, wanted));
    double scale = size > most ? most / size : 1;
    double change[3];
    for (int k = 0; k < 3; k++) {
        change[k] = scale * wanted[k] - row->friction[k];
        row->friction[k] += change[k];
    }
    tf_row_push(row, change, bodies);
    return sqrt(dot(change, change)) * compliance;
}

//: Visit a row
double tf_row_visit(tf_row *row, double friction, const tf_bodies *bodies)
{
    double compliance = tf_row_compliance(row, bodies->inverse_mass);
    if (!(compliance > 0))
        return 0;
    double change = push_along(row, compliance, bodies);
    if (!(friction > 0))
        return change;
    double sliding =
        push_across(row, compliance, friction * row->impulse, bodies);
    return change > sliding ? change : sliding;
}
