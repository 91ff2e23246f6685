#include "support/answers.h"

#include "response/gauss_seidel.h"
#include "support/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double length(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

static double product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Rows ------------------------------------------------------------------------

/// @param in_parts whether levels and rounds begin anew in each part of a step
static bool is_sorted(const tf_answered_contact *a,
                      const tf_answered_contact *b, bool in_parts)
{
    if (a->kind != b->kind)
        return a->kind < b->kind;
    for (int i = 0; i < 4; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return in_parts || a->level < b->level ||
           (a->level == b->level && a->round < b->round);
}

static const char *coefficient_fault(const tf_answered_contact *row)
{
    int first = row->kind == TF_EDGE_EDGE ? 2 : 1;
    double sum[2] = {0};
    for (int i = 0; i < 4; i++)
        sum[i >= first] += row->coefficient[i];
    if (row->vertex[3] < 0 && row->coefficient[3] != 0)
        return "no vertex, but a coefficient";
    return fabs(sum[0] - 1) < 1e-9 && fabs(sum[1] + 1) < 1e-9
               ? NULL
               : "coefficients do not add up";
}

/// What rounding may add to an impulse that is one of many.
static double impulse_error(const tf_answered_contact row[], size_t count)
{
    double largest = 0;
    for (size_t i = 0; i < count; i++)
        largest = fmax(largest, fabs(row[i].impulse));
    return 1e-12 * largest;
}

static const char *friction_fault(const tf_answered_contact *row,
                                  double coefficient, double error)
{
    double size = length(row->friction);
    if (size > coefficient * row->impulse * (1 + 1e-9))
        return "friction outside of Coulomb's cone";
    if (fabs(product(row->friction, row->normal)) >
        1e-7 * (size + row->impulse) + error)
        return "friction is not across the normal";
    return NULL;
}

/// Coulomb's coefficient of a contact, as the options have it.
static double friction_of(const tf_answered_contact *row,
                          const tf_response_options *options)
{
    int first = row->kind == TF_EDGE_EDGE ? 2 : 1;
    double mean[2] = {0};
    if (!options->vertex_friction)
        return options->friction;
    for (int i = 0; i < 4 && row->vertex[i] >= 0; i++)
        mean[i >= first] += fabs(row->coefficient[i]) *
                            options->vertex_friction[row->vertex[i]];
    return sqrt(mean[0]) * sqrt(mean[1]);
}

static const char *impulse_fault(const tf_answered_contact *row, double error,
                                 const answered_step *step)
{
    const tf_zone_solver *solver = step->options->solver;
    bool pushes = row->level == TF_IMPULSES || row->level == TF_ZONES;
    bool pulls = row->level == TF_ZONES && solver && solver != &tf_gauss_seidel;
    double friction = length(row->friction);
    if (!pushes && (row->impulse != 0 || friction != 0))
        return "an impulse of a level that has none";
    if (pulls)
        return friction == 0 ? NULL : "friction of a solver that has none";
    if (row->impulse < 0)
        return "an impulse below 0";
    if (row->impulse > 0 && fabs(length(row->normal) - 1) > 1e-9)
        return "a normal is not of length 1";
    return friction_fault(row, friction_of(row, step->options), error);
}

static const char *row_fault(const tf_answered_contact *row, double error,
                             const answered_step *step)
{
    if (row->round < 0 || row->round >= step->report->rounds[row->level])
        return "a round that there was not";
    if (!(row->toi >= 0 && row->toi <= 1))
        return "no time of impact";
    if (row->reserved != 0)
        return "something that is reserved";
    const char *fault = coefficient_fault(row);
    return fault ? fault : impulse_fault(row, error, step);
}

static const char *rows_fault(const tf_answered_contact *row, size_t count,
                              const answered_step *step)
{
    size_t zones = 0;
    double error = impulse_error(row, count);
    for (size_t i = 0; i < count; i++) {
        const char *fault = row_fault(&row[i], error, step);
        if (fault)
            return fault;
        if (i > 0 &&
            !is_sorted(&row[i - 1], &row[i], step->options->substeps > 1))
            return "rows are not sorted";
        zones += row[i].level == TF_ZONES;
    }
    if (zones != step->report->constraints)
        return "the report counts other constraints";
    return count < step->report->contacts ? "the report counts more contacts"
                                          : NULL;
}

// Sums of pushes --------------------------------------------------------------

/// What pushes add to a vertex, and how large they are.
typedef struct push_sum {
    double sum[3], size;
} push_sum;

static void add_push(const tf_answered_contact *row, double push,
                     double inverse_mass, double coefficient, push_sum *to)
{
    double share = inverse_mass * coefficient;
    for (int k = 0; k < 3; k++) {
        double own =
            share * ((row->impulse + push) * row->normal[k] + row->friction[k]);
        to->sum[k] += own;
        to->size += fabs(own);
    }
}

/// How far vertices would go, but for factors.
static double longest_way(const answered_step *step)
{
    double longest = 0;
    for (ptrdiff_t i = 0; i < (ptrdiff_t)step->axes * step->vertices; i++)
        longest = fmax(longest, fabs(step->proposed[i] - step->start[i]));
    return longest;
}

/// Where only impulses and pushes move a vertex, they move it to its end; unless
/// numbers are near the ends of their range, where sums overflow or lose all
/// digits.
/// @param end of all vertices: that of the step, or that without pushes
/// @param error what pushes that are taken back may leave
static bool is_explained(const answered_step *step, const double end[],
                         int vertex, const push_sum *pushes, double error)
{
    for (int k = 0; k < step->axes; k++) {
        ptrdiff_t place = (ptrdiff_t)step->axes * vertex + k;
        double change = end[place] - step->proposed[place];
        double far = fabs(step->start[place]) + fabs(step->proposed[place]);
        double wrong = fabs(change - pushes->sum[k]);
        if (far > 0x1p1000 || far < 0x1p-1000)
            continue;
        if (wrong > 1e-9 * pushes->size + 1e-13 * far + error &&
            isfinite(wrong))
            return false;
    }
    return true;
}

/// @param push of each row; or NULL, if `end` is that without pushes
static const char *sums_fault(const tf_answered_contact *row, size_t count,
                              const double push[], const unsigned char flags[],
                              const answered_step *step, const double end[],
                              int *pushed)
{
    const char *fault = NULL;
    double error = 1e-12 * longest_way(step);
    push_sum *sums = allocate((size_t)step->vertices, sizeof *sums);
    for (size_t i = 0; i < count; i++)
        for (int j = 0; j < 4 && row[i].vertex[j] >= 0; j++) {
            int v = row[i].vertex[j];
            add_push(&row[i], push ? push[i] : 0,
                     step->inverse_mass ? step->inverse_mass[v] : 1,
                     row[i].coefficient[j], &sums[v]);
        }
    for (int v = 0; v < step->vertices && !fault; v++) {
        if (flags[v] & (TF_VERTEX_GROUPED | TF_VERTEX_RIGID | TF_VERTEX_HELD))
            continue;
        if (pushed)
            *pushed += sums[v].size > 0;
        if (!is_explained(step, end, v, &sums[v], error))
            fault = "pushes do not add up to where a vertex ends";
    }
    free(sums);
    return fault;
}

// Flags -----------------------------------------------------------------------

static const char *flags_fault(const unsigned char flags[],
                               const answered_step *step)
{
    const tf_response_report *report = step->report;
    int moved = 0, held = 0, grouped = 0, resting = 0, rigid = 0;
    for (int v = 0; v < step->vertices; v++) {
        size_t bytes = sizeof(double) * (size_t)step->axes;
        ptrdiff_t place = (ptrdiff_t)step->axes * v;
        bool differs =
            memcmp(step->end + place, step->proposed + place, bytes) != 0;
        if (differs != (flags[v] & TF_VERTEX_MOVED))
            return "a vertex was moved, but is not said to be; or vice versa";
        moved += differs;
        held += (flags[v] & TF_VERTEX_HELD) != 0;
        grouped += (flags[v] & TF_VERTEX_GROUPED) != 0;
        resting += (flags[v] & TF_VERTEX_RESTING) != 0;
        rigid += (flags[v] & TF_VERTEX_RIGID) != 0;
    }
    if (moved != report->moved || held != report->held ||
        grouped != report->grouped || resting != report->resting)
        return "the report counts other flags";
    return rigid > 0 && report->rounds[TF_RIGID] == 0 ? "rigid without a round"
                                                      : NULL;
}

// Pushes apart ----------------------------------------------------------------

static const char *pushes_fault(const tf_answered_contact row[],
                                const double push[], size_t count,
                                const answered_step *step)
{
    const tf_zone_solver *solver = step->options->solver;
    for (size_t i = 0; i < count; i++) {
        bool has = row[i].level == TF_IMPULSES || row[i].level == TF_ZONES;
        bool pulls =
            row[i].level == TF_ZONES && solver && solver != &tf_gauss_seidel;
        if (!has && push[i] != 0)
            return "a push of a level that has none";
        if (!(push[i] >= 0 || pulls))
            return "a push below 0";
        if (step->options->separation < 0 && row[i].level == TF_ZONES &&
            step->report->rounds[TF_IMPULSES] == 0 && push[i] != 0)
            return "a push without a separation";
    }
    return NULL;
}

const char *answers_fault(tf_resolver *resolver, const answered_step *given,
                          int *pushed)
{
    static const tf_response_options usual;
    answered_step with_options = *given, *step = &with_options;
    step->options = given->options ? given->options : &usual;
    const tf_answered_contact *row = NULL;
    size_t count = 0;
    const unsigned char *flags = tf_resolver_vertices(resolver);
    const double *unpushed = tf_resolver_unpushed(resolver), *push = NULL;
    size_t pushes = 0;
    if (tf_resolver_contacts(resolver, &count, &row) != TF_OK || !flags ||
        tf_resolver_pushes(resolver, &pushes, &push) != TF_OK || !unpushed)
        return "nothing is lent";
    const char *fault = flags_fault(flags, step);
    if (!fault && pushes != count)
        fault = "there are not as many pushes as contacts";
    if (!fault)
        fault = rows_fault(row, count, step);
    if (!fault)
        fault = pushes_fault(row, push, count, step);
    if (!fault && step->options->substeps <= 1)
        fault = sums_fault(row, count, NULL, flags, step, unpushed, NULL);
    if (step->options->substeps > 1 && step->options->restitution > 0)
        return fault;
    return fault ? fault
                 : sums_fault(row, count, push, flags, step, step->end, pushed);
}
