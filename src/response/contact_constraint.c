//: Include what the constraints of contacts need
#include "response/contact_constraint.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

//: Take the direction of a vector
/// Scales a vector to length 1 and returns the length that it had.  Its largest
/// component is brought near 1 first, so that no square overflows or vanishes.
static double normalize(tf_vector *v)
{
    double most = fmax(fabs(v->x[0]), fmax(fabs(v->x[1]), fabs(v->x[2])));
    if (!(most > 0))
        return 0;
    for (int k = 0; k < TF_AXES; k++)
        v->x[k] /= most;
    double length = tf_vector_length(*v);
    for (int k = 0; k < TF_AXES; k++)
        v->x[k] /= length;
    return most * length;
}

/// The product of two vectors that are given as numbers.
static double dot(const double a[3], const double b[3])
{
    return tf_vector_dot(tf_vector_at(a, 0), tf_vector_at(b, 0));
}

//: Weight the vertices of a contact
static int corners_of_first(tf_kind kind)
{
    return kind == TF_EDGE_EDGE ? 2 : 1;
}

static int corners_of_both(tf_kind kind)
{
    return kind == TF_POINT_EDGE ? 3 : 4;
}

/// The constraint of the two points that meet.
static tf_constraint constraint_of_point(const tf_surface_contact *contact)
{
    int first = corners_of_first(contact->kind);
    int both = corners_of_both(contact->kind);
    tf_constraint constraint = {.vertex = {-1, -1, -1, -1}};
    for (int i = 0; i < both; i++) {
        constraint.vertex[i] = contact->vertex[i];
        constraint.coefficient[i] =
            i < first ? contact->contact.barycentric[0][i]
                      : -contact->contact.barycentric[1][i - first];
    }
    return constraint;
}

//: Take a contact as it is
tf_constraint tf_contact_points(const tf_surface_contact *contact)
{
    tf_constraint constraint = constraint_of_point(contact);
    double turn = contact->contact.normal_velocity > 0 ? -1 : 1;
    for (int k = 0; k < TF_AXES; k++)
        constraint.normal[k] = turn * contact->contact.normal[k];
    return constraint;
}

//: Find where the two points start
/// The vector from the second element's point to the first one's at the start.
/// As the coefficients add up to zero, positions may be taken relative to one
/// of the vertices, which keeps the error small even far from the origin.
static tf_vector vector_at_start(const tf_step *step,
                                 const tf_constraint *constraint)
{
    const double *start = step->start;
    tf_vector origin = tf_step_position(step, constraint->vertex[0], start);
    tf_vector vector = {{0}};
    for (int i = 1; i < 4 && constraint->vertex[i] >= 0; i++) {
        tf_vector own = tf_step_position(step, constraint->vertex[i], start);
        vector = tf_vector_sum(vector, -constraint->coefficient[i],
                               tf_vector_difference(origin, own));
    }
    return vector;
}

/// The size of a rounding error in the coordinates of a constraint's vertices.
static double coordinate_error(const tf_step *step,
                               const tf_constraint *constraint)
{
    double largest = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        for (int k = 0; k < step->axes; k++) {
            ptrdiff_t place = (ptrdiff_t)step->axes * constraint->vertex[i] + k;
            largest = fmax(largest, fabs(step->start[place]));
        }
    return largest * 0x1p-52;
}

//: Choose the normal
/// Sets the normal of a constraint: that of the contact, reversed if need be
/// such that the gap is positive, or, if the gap is too small to tell its sign,
/// the direction between the points that meet.  Returns the gap.
static double choose_normal(const tf_step *step, const tf_contact *contact,
                            tf_constraint *constraint)
{
    tf_vector between = vector_at_start(step, constraint);
    double gap = dot(contact->normal, between.x);
    double side = gap < 0 ? -1 : 1;
    for (int k = 0; k < TF_AXES; k++)
        constraint->normal[k] = side * contact->normal[k];
    gap = fabs(gap);

    double distance = normalize(&between);
    bool tells_side = gap > 0x1p-20 * distance &&
                      gap > 32 * coordinate_error(step, constraint);
    if (tells_side || !(distance > 0))
        return gap;
    memcpy(constraint->normal, between.x, sizeof between.x);
    return distance;
}

//: Take the constraint of the pivots
/// The constraint that keeps the contact's two pivots from approaching each
/// other.  False if they do not move relative to each other.
static bool constraint_of_pivots(const tf_surface_contact *contact,
                                 tf_constraint *constraint, double *gap)
{
    const tf_contact *c = &contact->contact;
    int pivot[2] = {c->pivot[0], corners_of_first(contact->kind) + c->pivot[1]};
    memset(constraint->coefficient, 0, sizeof constraint->coefficient);
    constraint->coefficient[pivot[0]] = 1;
    constraint->coefficient[pivot[1]] = -1;

    bool along_normal = c->normal_velocity != 0;
    double toward = c->normal_velocity > 0 || !along_normal ? -1 : 1;
    tf_vector normal = tf_vector_scaled(
        toward, tf_vector_at(along_normal ? c->normal : c->velocity, 0));
    double length = normalize(&normal);
    memcpy(constraint->normal, normal.x, sizeof normal.x);
    *gap = c->toi_lo * (along_normal ? fabs(c->normal_velocity) : length);
    return length > 0;
}

//: Find the gap change of some ends
/// By how much the gap of a constraint is wider with these ends.
static double gap_change(const tf_step *step, const tf_constraint *constraint,
                         const double end[])
{
    double sum = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        tf_vector d = tf_step_displacement(step, constraint->vertex[i], end);
        sum += constraint->coefficient[i] * dot(constraint->normal, d.x);
    }
    return sum;
}

//: Bound the gap change
/// Bounds the motion by what restitution returns.
static void set_bound(const tf_contact_rule *rule, double approach,
                      tf_constraint *constraint)
{
    bool returns = rule->restitution > 0 && approach >= rule->threshold;
    constraint->bound = returns ? rule->restitution * approach : 0;
}

//: Measure the room of a pair
/// The part of what is missing by which a pair is pushed apart in one step.
static const double pushed_part = 0.25;

/// How wide a gap may get, as a part of the approach: two elements that are
/// drawn together in each step, such as by gravity, must stay so near that
/// they meet again in the next step, or nothing would hold them there.
static const double most_width = 0.5;

/// Half of what the elements approach each other, or the separation if that is
/// less, is how wide their gap is to be.
static double room_for(const tf_contact_rule *rule, double approach,
                       double width)
{
    double wanted = fmin(rule->separation, most_width * approach);
    return width < wanted ? pushed_part * (wanted - width) : 0;
}

//: Let what is squeezed approach
static const double least_width = 0x1p-9; // of a gap's width at the start

static bool is_squeezed(const tf_contact_rule *rule,
                        const tf_constraint *constraint)
{
    bool any = false;
    for (int i = 0; rule->squeezed && i < 4 && constraint->vertex[i] >= 0; i++)
        any |= rule->squeezed[constraint->vertex[i]];
    return any;
}

//: Set what a contact demands
static void set_demands(const tf_step *step, const tf_contact_rule *rule,
                        tf_constraint *constraint, tf_contact_gap *gap)
{
    gap->room = gap->push = 0;
    if (is_squeezed(rule, constraint)) {
        constraint->bound = (least_width - 1) * gap->start;
        return;
    }
    double approach = fmax(0, -gap_change(step, constraint, rule->base));
    set_bound(rule, approach, constraint);
    gap->room = room_for(rule, approach, gap->start);
}

//: Keep a pair at a distance
/// Whether this is a pair that comes too near, and no contact.
static bool is_near_pair(const tf_surface_contact *contact)
{
    return contact->contact.verdict == TF_APART;
}

/// How much farther apart the two points are to be than elements must, as these
/// may have other nearest points at the end that the constraint leads to.
static const double thickness_margin = 0x1p-6;

/// Along the direction between the nearest points at the end, where the
/// elements are not in contact, their gap must be as wide as the thickness.
/// The motion may narrow a gap that is wider; one that is narrower is up to
/// the push.
static void keep_distance(const tf_step *step, const tf_contact *contact,
                          const tf_contact_rule *rule,
                          tf_constraint *constraint, tf_contact_gap *gap)
{
    tf_vector between = vector_at_start(step, constraint);
    memcpy(constraint->normal, contact->normal, sizeof contact->normal);
    gap->start = dot(constraint->normal, between.x);
    set_demands(step, rule, constraint, gap);
    double missing = rule->thickness * (1 + thickness_margin) - gap->start;
    gap->room = fmax(0, missing);
    if (constraint->bound == 0)
        constraint->bound = fmin(0, missing);
    // The elements, if not these points of theirs, start no nearer.
    gap->start = fmax(gap->start, rule->thickness);
}

//: Drop vertices that a constraint does not push
/// Drops the vertices whose coefficient is 0: a zone must not move them.
static tf_constraint without_idle_vertices(const tf_constraint *constraint)
{
    tf_constraint kept = *constraint;
    int count = 0;
    for (int i = 0; i < 4; i++) {
        if (constraint->vertex[i] < 0 || constraint->coefficient[i] == 0)
            continue;
        kept.vertex[count] = constraint->vertex[i];
        kept.coefficient[count++] = constraint->coefficient[i];
    }
    for (; count < 4; count++) {
        kept.vertex[count] = -1;
        kept.coefficient[count] = 0;
    }
    return kept;
}

//: Make the constraint of a contact
tf_constraint tf_contact_constraint(const tf_step *step,
                                    const tf_surface_contact *contact,
                                    const tf_contact_rule *rule, bool by_pivots,
                                    tf_contact_gap *gap)
{
    tf_constraint constraint = constraint_of_point(contact);
    if (is_near_pair(contact)) {
        keep_distance(step, &contact->contact, rule, &constraint, gap);
        return without_idle_vertices(&constraint);
    }
    gap->start = choose_normal(step, &contact->contact, &constraint);
    set_demands(step, rule, &constraint, gap);

    // The points have to approach each other from the side on which they start,
    // and the constraint must not be satisfied already.
    bool approach = dot(constraint.normal, contact->contact.velocity) <= 0;
    double demand = fmax(constraint.bound, gap->room);
    bool violated = gap_change(step, &constraint, step->end) < demand;
    bool has_normal = dot(constraint.normal, constraint.normal) > 0;
    tf_constraint pivots = constraint;
    double own_width;
    if ((has_normal && approach && violated && !by_pivots) ||
        !constraint_of_pivots(contact, &pivots, &own_width))
        return without_idle_vertices(&constraint);
    gap->start = own_width;
    set_demands(step, rule, &pivots, gap);
    return without_idle_vertices(&pivots);
}
