//: Include what following scripts needs
#include "response/follow.h"

#include <math.h>
#include <string.h>

//: Hold a company that is held back
enum {
    HALVINGS = 7,     ///< of the interval of a company
    MOST_TRIALS = 24, ///< of all companies
    RETREATS = 4      ///< the most trials after these, where companies go back
};

/// Scripted vertices that are held back together.
typedef struct company {
    double low, high; ///< fractions: it could go so far, and could not
    double fraction;  ///< of this trial
    double next;      ///< of the next one
    int halvings;
    bool rested; ///< it has been tried at rest, with the fraction 0
    bool stuck;  ///< in this trial the failsafe has united it with others
    bool held;   ///< in this trial
    bool grown;  ///< by vertices that were to go farther in this trial
} company;

/// The number of a company, or -1.
typedef struct numbers {
    int *own;   ///< of each vertex: of the company with which it was held back
    int *limit; ///< of each vertex: of the company that limits how far it goes
    int *group; ///< by root: of a company in this group of the failsafe
} numbers;

static numbers numbers_of(const tf_follow *follow, const tf_step *step)
{
    int *all = follow->number.data;
    return (numbers){all, all + step->vertices,
                     all + 2 * (ptrdiff_t)step->vertices};
}

//: Begin to follow scripts
bool tf_follow_begin(tf_follow *follow, const tf_step *step)
{
    size_t vertices = (size_t)step->vertices;
    size_t bytes = (size_t)step->axes * vertices * sizeof(double);
    follow->companies = follow->trials = 0;
    follow->retreats = 0;
    if (!tf_buffer_reserve(&follow->company, vertices, sizeof(company)) ||
        !tf_buffer_reserve(&follow->number, 3 * vertices, sizeof(int)) ||
        !tf_buffer_reserve(&follow->fraction, vertices, sizeof(double)) ||
        !tf_buffer_reserve(&follow->squeezed, vertices, 1) ||
        !tf_buffer_reserve(&follow->proposed, bytes, 1))
        return false;
    numbers all = numbers_of(follow, step);
    double *fraction = follow->fraction.data;
    memset(follow->squeezed.data, 0, vertices);
    for (int v = 0; v < step->vertices; v++) {
        all.own[v] = all.limit[v] = -1;
        fraction[v] = 1;
    }
    return true;
}

//: Find the vertices that were held back
static bool is_held(const tf_step *step, int vertex)
{
    ptrdiff_t place = (ptrdiff_t)step->axes * vertex;
    return !(step->inverse_mass[vertex] > 0) &&
           memcmp(step->end + place, step->proposed + place,
                  sizeof(double) * (size_t)step->axes) != 0;
}

bool tf_follow_is_held(const tf_step *step)
{
    bool any = false;
    for (int v = 0; v < step->vertices && !any; v++)
        any = is_held(step, v);
    return any;
}

/// Notes which companies are in which groups of the failsafe.
static void note_groups(const tf_step *step, tf_groups *groups, numbers all)
{
    for (int v = 0; v < step->vertices; v++)
        all.group[v] = -1;
    for (int v = 0; v < step->vertices; v++) {
        int *group = &all.group[tf_groups_find(groups, v)];
        if (*group < 0 && is_held(step, v))
            *group = all.limit[v];
    }
}

//: Add a vertex to a company
/// Adds a vertex that was held back.  If it was to go farther than the company,
/// that may be why, and the fraction of the company is to be tried again.
static void add_vertex(tf_follow *follow, int vertex, int number, int *own)
{
    const double *fraction = follow->fraction.data;
    company *to = (company *)follow->company.data + number;
    bool farther =
        *own != number && fraction[vertex] - to->fraction > ldexp(1, -HALVINGS);
    to->grown |= farther;
    to->held |= !farther;
    *own = number;
}

/// Adds the vertices that were held back to their companies, or to new ones.
static void add_held(tf_follow *follow, const tf_step *step, tf_groups *groups)
{
    numbers all = numbers_of(follow, step);
    company *companies = follow->company.data;
    note_groups(step, groups, all);
    for (int v = 0; v < step->vertices; v++) {
        if (!is_held(step, v))
            continue;
        int *group = &all.group[tf_groups_find(groups, v)];
        int number = all.limit[v] >= 0 ? all.limit[v] : *group;
        if (number < 0) {
            number = *group = follow->companies++;
            companies[number] = (company){.high = 1, .fraction = 1};
        }
        add_vertex(follow, v, number, &all.own[v]);
    }
    unsigned char *squeezed = follow->squeezed.data;
    for (int v = 0; v < step->vertices; v++)
        squeezed[v] |= all.group[tf_groups_find(groups, v)] >= 0;
}

//: Find companies that are stuck
/// Notes the companies of which a vertex is in a group of the failsafe, with
/// other vertices.
static void note_stuck(tf_follow *follow, const tf_step *step,
                       tf_groups *groups)
{
    numbers all = numbers_of(follow, step);
    company *companies = follow->company.data;
    for (int v = 0; v < step->vertices; v++)
        all.group[v] = -1;
    for (int v = 0; v < step->vertices; v++)
        if (all.own[v] >= 0)
            all.group[tf_groups_find(groups, v)] = all.own[v];
    for (int v = 0; v < step->vertices; v++) {
        int root = tf_groups_find(groups, v);
        if (root != v && all.group[root] >= 0)
            companies[all.group[root]].stuck = true;
    }
}

//: Narrow the intervals of companies
/// Narrows the interval of a company; returns whether it is to be narrowed
/// further.  The first trial has it rest: if even then the failsafe has to answer
/// what is between its vertices, it goes nowhere.
static bool narrow(company *own)
{
    own->next = own->fraction;
    if (own->grown)
        return true;
    bool rests = own->rested && own->fraction == 0;
    *(own->held ? &own->high : &own->low) = own->fraction;
    own->next = own->rested ? (own->low + own->high) / 2 : 0;
    own->rested = true;
    if (rests && own->stuck)
        own->next = own->high = 0;
    return own->next > 0 ? own->halvings++ < HALVINGS : !rests;
}

static bool narrow_all(tf_follow *follow)
{
    company *all = follow->company.data;
    bool wanted = false;
    for (int i = 0; i < follow->companies; i++)
        wanted |= narrow(&all[i]);
    return wanted;
}

//: Go back to where companies could go
/// Has each company go as far as it could before, and where it cannot together
/// with the others half of that or, the last time, nowhere.  Returns whether that
/// is another trial.
static bool retreat(tf_follow *follow)
{
    company *all = follow->company.data;
    bool differs = false, is_first = follow->retreats++ == 0;
    for (int i = 0; i < follow->companies; i++) {
        company *own = &all[i];
        if (!is_first && (own->held || own->grown))
            own->low = follow->retreats < RETREATS ? own->low / 2 : 0;
        own->next = own->low;
        differs |= own->next != own->fraction;
    }
    return differs;
}

//: Learn from a trial
bool tf_follow_learn(tf_follow *follow, const tf_step *step, tf_groups *groups)
{
    add_held(follow, step, groups);
    note_stuck(follow, step, groups);
    follow->trials++;
    bool more = follow->retreats == 0 && narrow_all(follow) &&
                follow->trials < MOST_TRIALS;
    if (!more)
        more = follow->retreats < RETREATS && retreat(follow);
    company *all = follow->company.data;
    for (int i = 0; i < follow->companies; i++) {
        all[i].fraction = all[i].next;
        all[i].held = all[i].grown = all[i].stuck = false;
    }
    return more;
}

//: Find how far an edge may bend
static double length_of(const tf_step *step, const int edge[2],
                        const double position[])
{
    tf_vector a = tf_step_position(step, edge[0], position);
    tf_vector b = tf_step_position(step, edge[1], position);
    return tf_vector_length(tf_vector_difference(a, b));
}

/// The most by which the fractions of two vertices may differ: by how much the
/// script stretches their edge, as a fraction of the longer way.  1 if there is
/// none, or if one of them stays where it is.
static double most_difference(const tf_step *step, const int edge[2],
                              const double proposed[])
{
    tf_vector a = tf_step_displacement(step, edge[0], proposed);
    tf_vector b = tf_step_displacement(step, edge[1], proposed);
    double ways[] = {tf_vector_length(a), tf_vector_length(b)};
    double stretch = fabs(length_of(step, edge, proposed) -
                          length_of(step, edge, step->start));
    bool both = ways[0] > 0 && ways[1] > 0 && isfinite(stretch);
    return both ? stretch / fmax(ways[0], ways[1]) : 1;
}

//: Limit vertices by their neighbors
/// Limits how far the vertex `to` of an edge goes by how far the vertex `from`
/// does; returns whether that changes anything.
static bool limit_by(tf_follow *follow, const tf_step *step, numbers all,
                     int from, int to, const double proposed[])
{
    double *fraction = follow->fraction.data;
    if (fraction[from] >= fraction[to])
        return false;
    double most =
        fraction[from] + most_difference(step, (int[]){from, to}, proposed);
    if (most >= fraction[to])
        return false;
    fraction[to] = most;
    all.limit[to] = all.limit[from];
    return true;
}

static bool limit_all(tf_follow *follow, const tf_step *step,
                      const double proposed[], const tf_elements *edges)
{
    const double *inverse_mass = step->inverse_mass;
    numbers all = numbers_of(follow, step);
    bool changed = false;
    for (int i = 0; i < edges->count && tf_watch_work(step->watch, 1); i++) {
        const int *edge = edges->corner + 2 * (ptrdiff_t)i;
        if (inverse_mass[edge[0]] > 0 || inverse_mass[edge[1]] > 0)
            continue;
        changed |= limit_by(follow, step, all, edge[0], edge[1], proposed);
        changed |= limit_by(follow, step, all, edge[1], edge[0], proposed);
    }
    return changed;
}

//: Find the fraction of each vertex
static void find_fractions(tf_follow *follow, const tf_step *step,
                           const double proposed[], const tf_elements *edges)
{
    numbers all = numbers_of(follow, step);
    const company *companies = follow->company.data;
    double *fraction = follow->fraction.data;
    for (int v = 0; v < step->vertices; v++) {
        all.limit[v] = all.own[v];
        fraction[v] = all.own[v] < 0 ? 1 : companies[all.own[v]].fraction;
    }
    while (limit_all(follow, step, proposed, edges) &&
           !tf_watch_cancelled(step->watch))
        ;
}

//: Propose a shorter step
const double *tf_follow_propose(tf_follow *follow, const tf_step *step,
                                const double proposed[],
                                const tf_elements *edges)
{
    find_fractions(follow, step, proposed, edges);
    if (tf_watch_cancelled(step->watch))
        return NULL;
    const double *fraction = follow->fraction.data;
    double *to = follow->proposed.data;
    for (int v = 0; v < step->vertices; v++)
        for (int k = 0; k < step->axes; k++) {
            ptrdiff_t i = (ptrdiff_t)step->axes * v + k;
            to[i] = fraction[v] < 1
                        ? tf_step_part(step->start[i], proposed[i], fraction[v])
                        : proposed[i];
        }
    return to;
}

//: Account for the memory of following
size_t tf_follow_memory(const tf_follow *follow)
{
    return follow->company.bytes + follow->number.bytes +
           follow->fraction.bytes + follow->squeezed.bytes +
           follow->proposed.bytes;
}

void tf_follow_free(tf_follow *follow)
{
    tf_buffer_free(&follow->company);
    tf_buffer_free(&follow->number);
    tf_buffer_free(&follow->fraction);
    tf_buffer_free(&follow->squeezed);
    tf_buffer_free(&follow->proposed);
}
