#include "support/judge.h"

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/perturbed.h"
#include "base/require.h"

#include <math.h>
#include <string.h>

void truth_init(truth *known)
{
    known->hit = false;
    mpq_init(known->toi);
}

void truth_clear(truth *known)
{
    mpq_clear(known->toi);
}

void truth_find(const query *q, truth *known)
{
    known->hit = oracle_meet(q->axes, q->vertices, q->vertex, q->others,
                             query_const_others(q), known->toi);
}

// Verdict and time ------------------------------------------------------------

/// Whether toi_lo <= t <= toi_hi.
static bool encloses(const tf_contact *contact, const mpq_t t)
{
    mpq_t end;
    mpq_init(end);
    mpq_set_d(end, contact->toi_lo);
    bool inside = mpq_cmp(end, t) <= 0;
    mpq_set_d(end, contact->toi_hi);
    inside = inside && mpq_cmp(t, end) <= 0;
    mpq_clear(end);
    return inside;
}

static bool sane_times(const tf_contact *contact)
{
    return contact->toi_lo >= 0 && contact->toi_hi <= 1 &&
           contact->toi_lo <= contact->toi_hi;
}

static const char *explain(const tf_arithmetic *arithmetic, const char *fault,
                           const tf_contact *contact, const truth *known)
{
    // The true time may be less than any double.
    mpf_t t;
    mpf_init(t);
    if (known->hit)
        mpf_set_q(t, known->toi);
    static char text[1024];
    gmp_snprintf(
        text, sizeof text, "%s: %s: verdict %d, time [%a, %a]; true: %s %.17Fe",
        arithmetic->name, fault, (int)contact->verdict, contact->toi_lo,
        contact->toi_hi, known->hit ? "hit at" : "apart", t);
    mpf_clear(t);
    return text;
}

/// What no arithmetic may get wrong.
static const char *claim_fault(const tf_contact *contact, const truth *known)
{
    if (contact->verdict == TF_APART)
        return known->hit ? "a contact is missed" : NULL;
    if (contact->verdict == TF_HIT && !known->hit)
        return "a contact is made up";
    if (!sane_times(contact))
        return "the time is no interval within 0 to 1";
    if (known->hit && !encloses(contact, known->toi))
        return "the time is not enclosed";
    return NULL;
}

static const char *certainty_fault(const tf_contact *contact)
{
    if (contact->verdict != TF_APART && contact->verdict != TF_HIT)
        return "there is no verdict";
    if (contact->verdict == TF_HIT &&
        contact->toi_hi - contact->toi_lo > 0x1p-50)
        return "the time is too wide";
    return NULL;
}

static const char *fault_of(const query *q, const tf_arithmetic *arithmetic,
                            const truth *known, bool exact, tf_contact *contact)
{
    *contact = (tf_contact){0};
    tf_status status = tf_query(arithmetic, q->axes, q->vertices, q->vertex,
                                q->others, query_const_others(q), contact);
    const char *fault = status == TF_OK ? claim_fault(contact, known)
                                        : tf_status_message(status);
    if (!fault && exact)
        fault = certainty_fault(contact);
    return fault ? explain(arithmetic, fault, contact, known) : NULL;
}

const char *exact_fault(const query *q, const tf_arithmetic *arithmetic,
                        const truth *known, tf_contact *contact)
{
    return fault_of(q, arithmetic, known, true, contact);
}

const char *sound_fault(const query *q, const tf_arithmetic *arithmetic,
                        const truth *known, tf_contact *contact)
{
    return fault_of(q, arithmetic, known, false, contact);
}

// The rest of a contact -------------------------------------------------------

/// For coordinates that are small integers.
static const double tolerance = 1e-12;

static bool good_coordinates(int vertices, const double barycentric[])
{
    double sum = 0;
    for (int i = 0; i < vertices; i++) {
        if (!(barycentric[i] >= 0))
            return false;
        sum += barycentric[i];
    }
    return fabs(sum - 1) <= tolerance;
}

static bool points_agree(const query *q, const tf_contact *contact)
{
    double point[2][TF_AXES];
    double t = contact->toi_lo + (contact->toi_hi - contact->toi_lo) / 2;
    staircase_point(q->axes, q->vertices, q->vertex, contact->barycentric[0], t,
                    point[0]);
    staircase_point(q->axes, q->others, query_const_others(q),
                    contact->barycentric[1], t, point[1]);
    for (int k = 0; k < q->axes; k++)
        if (!(fabs(point[0][k] - point[1][k]) <= tolerance))
            return false;
    return true;
}

static double dot(int axes, const double a[], const double b[])
{
    double sum = 0;
    for (int k = 0; k < axes; k++)
        sum += a[k] * b[k];
    return sum;
}

/// A generic contact is inside of both elements and of the step.
static bool good_classification(const query *q, const tf_contact *contact)
{
    if (contact->classification != TF_GENERIC)
        return contact->classification == TF_TOUCHING ||
               contact->classification == TF_DEGENERATE;
    for (int i = 0; i < q->vertices; i++)
        if (contact->barycentric[0][i] == 0)
            return false;
    for (int i = 0; i < q->others; i++)
        if (contact->barycentric[1][i] == 0)
            return false;
    return contact->toi_lo > 0 && contact->toi_hi < 1;
}

const char *geometry_fault(const query *q, const tf_contact *contact)
{
    const double *normal = contact->normal;
    double square = dot(q->axes, normal, normal);
    double normal_velocity = dot(q->axes, contact->velocity, normal);
    if (!good_coordinates(q->vertices, contact->barycentric[0]) ||
        !good_coordinates(q->others, contact->barycentric[1]))
        return "the barycentric coordinates are no convex combination";
    if (!points_agree(q, contact))
        return "the two elements' points differ";
    if (square != 0 && !(fabs(square - 1) <= tolerance))
        return "the normal is neither zero nor of length 1";
    if (!(fabs(contact->normal_velocity - normal_velocity) <= tolerance))
        return "the normal velocity is not that along the normal";
    if (!good_classification(q, contact))
        return "the classification contradicts the contact";
    return NULL;
}

// Verdicts of tests -----------------------------------------------------------

void expect_no_fault(const char *fault, const query *q)
{
    if (fault)
        ck_abort_msg("%s\nseed %llu, %s\n%s", fault, (unsigned long long)seed(),
                     query_name(q), query_text(q));
}

tf_contact ask(const tf_arithmetic *arithmetic, const query *q)
{
    tf_contact contact;
    TF_REQUIRE(tf_query(arithmetic, q->axes, q->vertices, q->vertex, q->others,
                        query_const_others(q), &contact) == TF_OK);
    return contact;
}

const char *perturbed_fault(const query *q)
{
    tf_contact exact = ask(&tf_exact, q), perturbed = ask(&tf_perturbed, q);
    bool hit = exact.verdict == TF_HIT;
    tf_classification expected =
        perturbed.verdict == TF_HIT ? TF_GENERIC : TF_UNCLASSIFIED;
    if (perturbed.classification != expected)
        return "a perturbed contact that is not generic";
    if (perturbed.verdict == TF_HIT && !hit)
        return "a contact of the perturbed arithmetic alone";
    if (hit && exact.classification != TF_GENERIC)
        return NULL;
    return memcmp(&exact, &perturbed, sizeof exact) == 0
               ? NULL
               : "not the answer of exact signs";
}

void expect_truth(const query *q, const truth *known)
{
    tf_contact contact;
    expect_no_fault(exact_fault(q, &tf_exact, known, &contact), q);
    expect_no_fault(sound_fault(q, &tf_clamped, known, &contact), q);
}
