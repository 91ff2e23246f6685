#include "support/linear_truth.h"

#include "support/dyadic.h"

#include <assert.h>
#include <gmp.h>
#include <limits.h>
#include <math.h>

// Polynomials -----------------------------------------------------------------

enum {
    MOST = 6, // of coefficients, with room for a product
    POOL = 20000
};

/// coefficient[i] t^i; of degree -1 if zero.
typedef struct polynomial {
    int degree;
    mpz_t coefficient[MOST];
} polynomial;

// Polynomials live until a query is answered.
static polynomial pool[POOL];
static int used, made;

static polynomial *new_polynomial(int degree)
{
    assert(used < POOL && degree < MOST);
    polynomial *p = &pool[used++];
    for (int i = 0; used > made && i < MOST; i++)
        mpz_init(p->coefficient[i]);
    made = used > made ? used : made;
    p->degree = degree;
    for (int i = 0; i < MOST; i++)
        mpz_set_ui(p->coefficient[i], 0);
    return p;
}

static const polynomial *trimmed(polynomial *p)
{
    while (p->degree >= 0 && mpz_sgn(p->coefficient[p->degree]) == 0)
        p->degree--;
    return p;
}

/// a + factor b.
static const polynomial *sum(const polynomial *a, int factor,
                             const polynomial *b)
{
    polynomial *p =
        new_polynomial(a->degree > b->degree ? a->degree : b->degree);
    for (int i = 0; i <= p->degree; i++) {
        mpz_mul_si(p->coefficient[i], b->coefficient[i], factor);
        mpz_add(p->coefficient[i], p->coefficient[i], a->coefficient[i]);
    }
    return trimmed(p);
}

static const polynomial *product(const polynomial *a, const polynomial *b)
{
    if (a->degree < 0 || b->degree < 0)
        return new_polynomial(-1);
    polynomial *p = new_polynomial(a->degree + b->degree);
    for (int i = 0; i <= a->degree; i++)
        for (int j = 0; j <= b->degree; j++)
            mpz_addmul(p->coefficient[i + j], a->coefficient[i],
                       b->coefficient[j]);
    return trimmed(p);
}

static const polynomial *derivative(const polynomial *a)
{
    polynomial *p = new_polynomial(a->degree - 1);
    for (int i = 1; i <= a->degree; i++)
        mpz_mul_ui(p->coefficient[i - 1], a->coefficient[i], (unsigned long)i);
    return p;
}

/// Without the common factor of its coefficients.
static const polynomial *primitive(polynomial *p)
{
    mpz_t content;
    mpz_init(content);
    for (int i = 0; i <= p->degree; i++)
        mpz_gcd(content, content, p->coefficient[i]);
    for (int i = 0; i <= p->degree; i++)
        mpz_divexact(p->coefficient[i], p->coefficient[i], content);
    mpz_clear(content);
    return p;
}

/// Divide a by b, up to constant factors; the remainder.
static const polynomial *divide(const polynomial *a, const polynomial *b,
                                const polynomial **quotient)
{
    polynomial *rest = new_polynomial(a->degree);
    polynomial *ratio = new_polynomial(a->degree - b->degree);
    for (int i = 0; i <= a->degree; i++)
        mpz_set(rest->coefficient[i], a->coefficient[i]);
    const mpz_t *lead = &b->coefficient[b->degree];
    mpz_t factor;
    mpz_init(factor);
    for (int shift = a->degree - b->degree; shift >= 0; shift--) {
        mpz_set(factor, rest->coefficient[shift + b->degree]);
        for (int i = 0; i <= a->degree; i++)
            mpz_mul(rest->coefficient[i], rest->coefficient[i], *lead);
        for (int i = 0; i <= ratio->degree; i++)
            mpz_mul(ratio->coefficient[i], ratio->coefficient[i], *lead);
        mpz_add(ratio->coefficient[shift], ratio->coefficient[shift], factor);
        for (int i = 0; i <= b->degree; i++)
            mpz_submul(rest->coefficient[shift + i], factor, b->coefficient[i]);
    }
    mpz_clear(factor);
    trimmed(rest);
    *quotient = primitive(ratio);
    return rest->degree < 0 ? rest : primitive(rest);
}

static const polynomial *common_divisor(const polynomial *a,
                                        const polynomial *b)
{
    const polynomial *unused;
    if (b->degree < 0)
        return a;
    if (a->degree < b->degree)
        return common_divisor(b, a);
    return common_divisor(b, divide(a, b, &unused));
}

/// The same roots, each once.
static const polynomial *squarefree(const polynomial *p)
{
    const polynomial *quotient = p;
    if (p->degree > 0)
        divide(p, common_divisor(p, derivative(p)), &quotient);
    return quotient;
}

// Roots -----------------------------------------------------------------------

/// The only root of `p`, which is square-free, in the open interval of `from`
/// and `from` + 1, times 2^-shift; or, if `exact`, `from` 2^-shift itself.
typedef struct root {
    const polynomial *p;
    mpz_t from;
    unsigned shift;
    bool exact;
} root;

/// p((from + u) 2^-shift), up to a positive factor, as a polynomial in u.
static const polynomial *shifted(const polynomial *p, const mpz_t from,
                                 unsigned shift)
{
    polynomial *s = new_polynomial(p->degree);
    for (int i = 0; i <= p->degree; i++)
        mpz_mul_2exp(s->coefficient[i], p->coefficient[i],
                     (mp_bitcnt_t)shift * (unsigned)(p->degree - i));
    for (int i = 0; i < p->degree; i++)
        for (int j = p->degree - 1; j >= i; j--)
            mpz_addmul(s->coefficient[j], s->coefficient[j + 1], from);
    return s;
}

/// How many roots p(u) has in (0, 1), if that is 0 or 1; else no less.
static int variations(const polynomial *p)
{
    // Descartes' rule for (1 + x)^degree p(1 / (1 + x)).
    polynomial *r = new_polynomial(p->degree);
    for (int i = 0; i <= p->degree; i++)
        mpz_set(r->coefficient[i], p->coefficient[p->degree - i]);
    mpz_t one;
    mpz_init_set_ui(one, 1);
    const polynomial *s = shifted(r, one, 0);
    mpz_clear(one);
    int count = 0, last = 0;
    for (int i = 0; i <= s->degree; i++) {
        int sign = mpz_sgn(s->coefficient[i]);
        count += sign * last < 0;
        last = sign != 0 ? sign : last;
    }
    return count;
}

static int sign_at_start(const polynomial *p, const mpz_t from, unsigned shift)
{
    return p->degree < 0 ? 0 : mpz_sgn(shifted(p, from, shift)->coefficient[0]);
}

static void move_to(root *r, const mpz_t from, unsigned shift, bool exact)
{
    mpz_set(r->from, from);
    r->shift = shift;
    r->exact = exact;
}

/// Halve the interval.
static void refine(root *r)
{
    mpz_t from;
    mpz_init(from);
    mpz_mul_2exp(from, r->from, 1);
    if (variations(shifted(r->p, from, r->shift + 1)) == 1) {
        move_to(r, from, r->shift + 1, false);
    } else {
        mpz_add_ui(from, from, 1);
        bool exact = sign_at_start(r->p, from, r->shift + 1) == 0;
        move_to(r, from, r->shift + 1, exact);
    }
    mpz_clear(from);
}

/// The sign of p near a root, if it is the same on all of the interval; else 0.
static int sign_near(const polynomial *p, const root *r)
{
    const polynomial *s = shifted(p, r->from, r->shift);
    mpz_t others;
    mpz_init(others);
    for (int i = 1; i <= s->degree; i++)
        if (mpz_sgn(s->coefficient[i]) > 0)
            mpz_add(others, others, s->coefficient[i]);
        else
            mpz_sub(others, others, s->coefficient[i]);
    bool same = mpz_cmpabs(s->coefficient[0], others) > 0;
    mpz_clear(others);
    return same ? mpz_sgn(s->coefficient[0]) : 0;
}

/// Whether p, which divides what the root is of, has other signs at the ends of
/// the interval, and so the root is its.
static bool changes_sign(const polynomial *p, const root *r)
{
    mpz_t next;
    mpz_init(next);
    mpz_add_ui(next, r->from, 1);
    int ends =
        sign_at_start(p, r->from, r->shift) * sign_at_start(p, next, r->shift);
    mpz_clear(next);
    return ends < 0;
}

/// The sign of p at a root.
static int sign_at(const polynomial *p, root *r)
{
    int mark = used, sign = 0;
    if (p->degree < 0)
        return 0;
    const polynomial *common = r->exact ? p : common_divisor(r->p, p);
    for (int kept = used; !r->exact; refine(r), used = kept)
        if ((sign = sign_near(p, r)) != 0 || changes_sign(common, r))
            break;
    if (r->exact)
        sign = sign_at_start(p, r->from, r->shift);
    used = mark;
    return sign;
}

// Elements --------------------------------------------------------------------

enum {
    AXES = 3,
    SEGMENTS = 4,
    INSIDES = 4
};

typedef struct vector {
    const polynomial *x[AXES];
} vector;

static vector difference(const vector *a, const vector *b)
{
    vector d;
    for (int k = 0; k < AXES; k++)
        d.x[k] = sum(a->x[k], -1, b->x[k]);
    return d;
}

static vector cross(const vector *a, const vector *b)
{
    vector c;
    for (int k = 0; k < AXES; k++) {
        int l = (k + 1) % AXES, m = (k + 2) % AXES;
        c.x[k] = sum(product(a->x[l], b->x[m]), -1, product(a->x[m], b->x[l]));
    }
    return c;
}

static const polynomial *dot(const vector *a, const vector *b)
{
    const polynomial *d = product(a->x[0], b->x[0]);
    for (int k = 1; k < AXES; k++)
        d = sum(d, 1, product(a->x[k], b->x[k]));
    return d;
}

/// A point is on a segment: `across` is zero and `along` is not positive.
typedef struct on_segment {
    vector across;
    const polynomial *along;
} on_segment;

static on_segment segment_of(const vector *p, const vector *a, const vector *b)
{
    vector from = difference(a, p), to = difference(b, p);
    return (on_segment){cross(&from, &to), dot(&from, &to)};
}

/// What it takes to meet: `coplanar` is zero, and, where `normal` is not, all
/// of `inside` are at least zero, else a point is on a segment.
typedef struct conditions {
    const polynomial *coplanar;
    vector normal;
    int insides, segments;
    const polynomial *inside[INSIDES];
    on_segment segment[SEGMENTS];
} conditions;

static void require_edges(const vector x[4], conditions *c)
{
    vector u = difference(&x[1], &x[0]), v = difference(&x[3], &x[2]);
    vector way = difference(&x[2], &x[0]);
    c->normal = cross(&u, &v);
    c->coplanar = dot(&way, &c->normal);
    const polynomial *area2 = dot(&c->normal, &c->normal);
    vector by_v = cross(&way, &v), by_u = cross(&way, &u);
    c->inside[0] = dot(&by_v, &c->normal);
    c->inside[1] = sum(area2, -1, c->inside[0]);
    c->inside[2] = dot(&by_u, &c->normal);
    c->inside[3] = sum(area2, -1, c->inside[2]);
    c->insides = c->segments = 4;
    for (int i = 0; i < 2; i++) {
        c->segment[i] = segment_of(&x[i], &x[2], &x[3]);
        c->segment[2 + i] = segment_of(&x[2 + i], &x[0], &x[1]);
    }
}

static void require_triangle(const vector x[4], conditions *c)
{
    vector u = difference(&x[2], &x[1]), v = difference(&x[3], &x[1]);
    vector way = difference(&x[1], &x[0]);
    c->normal = cross(&u, &v);
    c->coplanar = dot(&way, &c->normal);
    c->insides = c->segments = 3;
    for (int i = 0; i < 3; i++) {
        const vector *b = &x[1 + (i + 1) % 3], *a = &x[1 + i];
        vector to_a = difference(a, &x[0]), to_b = difference(b, &x[0]);
        vector area = cross(&to_a, &to_b);
        c->inside[i] = dot(&area, &c->normal);
        c->segment[i] = segment_of(&x[0], a, b);
    }
}

static void require_plane(const vector x[3], conditions *c)
{
    c->segments = 1;
    c->segment[0] = segment_of(&x[0], &x[1], &x[2]);
    c->coplanar = c->segment[0].across.x[2];
    for (int k = 0; k < AXES; k++)
        c->normal.x[k] = new_polynomial(-1);
}

// Truth -----------------------------------------------------------------------

static bool vanishes(const vector *v, root *at)
{
    for (int k = 0; k < AXES; k++)
        if (sign_at(v->x[k], at) != 0)
            return false;
    return true;
}

static bool meet_at(const conditions *c, root *at)
{
    if (sign_at(c->coplanar, at) != 0)
        return false;
    if (vanishes(&c->normal, at)) {
        for (int i = 0; i < c->segments; i++)
            if (vanishes(&c->segment[i].across, at) &&
                sign_at(c->segment[i].along, at) <= 0)
                return true;
        return false;
    }
    for (int i = 0; i < c->insides; i++)
        if (sign_at(c->inside[i], at) < 0)
            return false;
    return true;
}

static double start_of(const root *r)
{
    signed long exponent;
    double fraction = mpz_get_d_2exp(&exponent, r->from);
    return ldexp(fraction, (int)exponent - (int)r->shift);
}

static double time_of(root *r)
{
    while (!r->exact && r->shift < 60)
        refine(r);
    return start_of(r);
}

static void take_earlier(const conditions *c, root *at, double *toi)
{
    // What cannot be earlier need not be judged.
    if (start_of(at) < *toi && meet_at(c, at))
        *toi = fmin(*toi, time_of(at));
}

/// Judge all roots in the open interval, the first ones first.
static void judge_roots(const conditions *c, const polynomial *p,
                        const mpz_t from, unsigned shift, double *toi)
{
    int count = variations(shifted(p, from, shift));
    if (count == 0)
        return;
    root r = {.p = p, .shift = shift};
    mpz_init_set(r.from, from);
    if (count == 1) {
        take_earlier(c, &r, toi);
    } else {
        mpz_mul_2exp(r.from, from, 1);
        judge_roots(c, p, r.from, shift + 1, toi);
        mpz_add_ui(r.from, r.from, 1);
        move_to(&r, r.from, shift + 1, true);
        if (sign_at_start(p, r.from, r.shift) == 0)
            take_earlier(c, &r, toi);
        judge_roots(c, p, r.from, shift + 1, toi);
    }
    mpz_clear(r.from);
}

static void judge_polynomial(const conditions *c, const polynomial *p,
                             double *toi)
{
    mpz_t zero;
    mpz_init(zero);
    if (p->degree > 0)
        judge_roots(c, squarefree(p), zero, 0, toi);
    mpz_clear(zero);
}

/// Where the elements are always coplanar, they begin to meet where some
/// condition changes.
static void judge_conditions(const conditions *c, double *toi)
{
    for (int i = 0; i < c->insides; i++)
        judge_polynomial(c, c->inside[i], toi);
    for (int k = 0; k < AXES; k++)
        judge_polynomial(c, c->normal.x[k], toi);
    for (int i = 0; i < c->segments; i++) {
        judge_polynomial(c, c->segment[i].along, toi);
        for (int k = 0; k < AXES; k++)
            judge_polynomial(c, c->segment[i].across.x[k], toi);
    }
}

static void judge_end(const conditions *c, unsigned long t, double *toi)
{
    root at = {.p = new_polynomial(-1), .exact = true};
    mpz_init_set_ui(at.from, t);
    take_earlier(c, &at, toi);
    mpz_clear(at.from);
}

static const polynomial *path(double start, double end, int exponent)
{
    polynomial *p = new_polynomial(1);
    dyadic_scale(p->coefficient[0], start, exponent);
    dyadic_scale(p->coefficient[1], end, exponent);
    mpz_sub(p->coefficient[1], p->coefficient[1], p->coefficient[0]);
    return trimmed(p);
}

static void take_paths(int axes, const double start[], const double end[],
                       vector x[])
{
    for (int k = 0; k < AXES; k++) {
        int exponent = INT_MAX;
        for (int i = k; k < axes && i < axes * (axes + 1); i += axes)
            exponent = dyadic_least(dyadic_least(exponent, start[i]), end[i]);
        for (int i = 0; i <= axes; i++) {
            int at = axes * i + k;
            x[i].x[k] = k >= axes || exponent == INT_MAX
                            ? new_polynomial(-1)
                            : path(start[at], end[at], exponent);
        }
    }
}

bool linear_truth(int axes, int vertices, const double start[],
                  const double end[], double *toi)
{
    used = 0;
    vector x[AXES + 1];
    conditions c = {0};
    take_paths(axes, start, end, x);
    if (axes == 2)
        require_plane(x, &c);
    else if (vertices == 2)
        require_edges(x, &c);
    else
        require_triangle(x, &c);
    double first = INFINITY;
    judge_end(&c, 0, &first);
    if (c.coplanar->degree >= 0)
        judge_polynomial(&c, c.coplanar, &first);
    else
        judge_conditions(&c, &first);
    judge_end(&c, 1, &first);
    if (first <= 1)
        *toi = first;
    return first <= 1;
}
