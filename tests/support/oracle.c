#include "support/oracle.h"

#include "support/dyadic.h"

#include <limits.h>

// The unknowns are the barycentric weights, l of S and m of R, all >= 0:
//     sum l = 1,  sum m = 1,  sum l_i s_i = sum m_j r_j on each axis,
// and the least time, sum l_i t_i, is wanted.  The simplex method is run on
// integers with one common denominator (Edmonds), so that nothing is rounded:
// entry (i, j) of the tableau is number[i][j] / denominator.

enum {
    MOST_ROWS = TF_AXES + 3, // the axes, time and two sums
    MOST_COLUMNS = 2 * ORACLE_EVENTS,
    FEASIBILITY = MOST_ROWS, // row of the cost of phase 1
    TIME,                    // row of the cost of phase 2
    ALL_ROWS,
};

typedef struct tableau {
    int rows, columns; // the right side is in number[i][columns]
    int basis[MOST_ROWS];
    mpz_t number[ALL_ROWS][MOST_COLUMNS + 1];
    mpz_t denominator, scratch;
} tableau;

static void tableau_init(tableau *t)
{
    mpz_init_set_ui(t->denominator, 1);
    mpz_init(t->scratch);
    for (int i = 0; i < ALL_ROWS; i++)
        for (int j = 0; j <= MOST_COLUMNS; j++)
            mpz_init(t->number[i][j]);
}

static void tableau_clear(tableau *t)
{
    mpz_clears(t->denominator, t->scratch, NULL);
    for (int i = 0; i < ALL_ROWS; i++)
        for (int j = 0; j <= MOST_COLUMNS; j++)
            mpz_clear(t->number[i][j]);
}

static int least_exponent(int least, const oracle_simplex *s,
                          const int shift[ORACLE_EVENTS][TF_AXES], int axis)
{
    for (int i = 0; i < s->count; i++) {
        least = dyadic_least(least, s->event[i]->x[axis]);
        if (shift[i][axis] != 0 && -shift[i][axis] < least)
            least = -shift[i][axis];
    }
    return least;
}

/// scaled = (x + 2^-shift, if that is not zero) / 2^exponent.
static void scale_coordinate(mpz_t scaled, double x, int shift, int exponent)
{
    dyadic_scale(scaled, x, exponent);
    if (shift == 0)
        return;
    mpz_t added;
    mpz_init_set_ui(added, 1);
    mpz_mul_2exp(added, added, (mp_bitcnt_t)(-shift - exponent));
    mpz_add(scaled, scaled, added);
    mpz_clear(added);
}

/// Fill in the row of one axis, scaled to integers: this changes no weight.
static void set_axis(tableau *t, int row, const oracle_simplex *s,
                     const oracle_simplex *r, const oracle_moves *moves,
                     int axis)
{
    int exponent = least_exponent(INT_MAX, s, moves->shift[0], axis);
    exponent = least_exponent(exponent, r, moves->shift[1], axis);
    mpz_t *number = t->number[row];
    for (int i = 0; i < s->count; i++)
        scale_coordinate(number[i], s->event[i]->x[axis],
                         moves->shift[0][i][axis], exponent);
    for (int j = 0; j < r->count; j++) {
        mpz_ptr entry = number[s->count + j];
        scale_coordinate(entry, r->event[j]->x[axis], moves->shift[1][j][axis],
                         exponent);
        mpz_neg(entry, entry);
    }
}

static void set_time(tableau *t, int row, const oracle_simplex *s,
                     const oracle_simplex *r)
{
    for (int i = 0; i < s->count; i++) {
        mpz_set_si(t->number[row][i], s->event[i]->t);
        mpz_set_si(t->number[TIME][i], s->event[i]->t);
    }
    for (int j = 0; j < r->count; j++)
        mpz_set_si(t->number[row][s->count + j], -r->event[j]->t);
}

/// The weights of the columns from `first` to before `last` sum to 1.
static void set_sum(tableau *t, int row, int first, int last)
{
    for (int j = first; j < last; j++)
        mpz_set_ui(t->number[row][j], 1);
    mpz_set_ui(t->number[row][t->columns], 1);
}

/// Start at artificial unknowns, one a row, whose sum is to become zero.
/// Their columns are left out: once at zero they stay there.
static void set_basis(tableau *t)
{
    for (int i = 0; i < t->rows; i++) {
        t->basis[i] = t->columns + i;
        for (int j = 0; j <= t->columns; j++)
            mpz_sub(t->number[FEASIBILITY][j], t->number[FEASIBILITY][j],
                    t->number[i][j]);
    }
}

static void tableau_fill(tableau *t, int axes, bool timed,
                         const oracle_simplex *s, const oracle_simplex *r,
                         const oracle_moves *moves)
{
    t->rows = 0;
    t->columns = s->count + r->count;
    while (t->rows < axes) {
        set_axis(t, t->rows, s, r, moves, t->rows);
        t->rows++;
    }
    if (timed)
        set_time(t, t->rows++, s, r);
    set_sum(t, t->rows++, 0, s->count);
    set_sum(t, t->rows++, s->count, t->columns);
    set_basis(t);
}

/// Take a multiple of the pivot's row off row i, over the next denominator.
static void eliminate(tableau *t, int i, int row, int column)
{
    mpz_srcptr lead = t->number[row][column];
    mpz_set(t->scratch, t->number[i][column]);
    for (int j = 0; j <= t->columns; j++) {
        mpz_ptr entry = t->number[i][j];
        mpz_mul(entry, entry, lead);
        mpz_submul(entry, t->scratch, t->number[row][j]);
        mpz_divexact(entry, entry, t->denominator);
    }
}

/// Bring the unknown `column` into the basis, at a row with a positive entry.
static void pivot(tableau *t, int row, int column)
{
    for (int i = 0; i < t->rows; i++)
        if (i != row)
            eliminate(t, i, row, column);
    eliminate(t, FEASIBILITY, row, column);
    eliminate(t, TIME, row, column);
    mpz_set(t->denominator, t->number[row][column]);
    t->basis[row] = column;
}

/// The sign of ratio(a) - ratio(b), ratio(i) = right side / entry in row i.
static int compare_ratios(tableau *t, int a, int b, int column)
{
    mpz_t across;
    mpz_init(across);
    mpz_mul(t->scratch, t->number[a][t->columns], t->number[b][column]);
    mpz_mul(across, t->number[b][t->columns], t->number[a][column]);
    int sign = mpz_cmp(t->scratch, across);
    mpz_clear(across);
    return sign;
}

static int leaving_row(tableau *t, int column)
{
    int best = -1;
    for (int i = 0; i < t->rows; i++) {
        if (mpz_sgn(t->number[i][column]) <= 0)
            continue;
        int order = best < 0 ? -1 : compare_ratios(t, i, best, column);
        if (order < 0 || (order == 0 && t->basis[i] < t->basis[best]))
            best = i;
    }
    return best;
}

static int entering_column(const tableau *t, int cost)
{
    for (int j = 0; j < t->columns; j++)
        if (mpz_sgn(t->number[cost][j]) < 0)
            return j;
    return -1;
}

/// Minimise a cost by Bland's rule, which never runs in a circle.  The weights
/// are bounded, so that there always is a row to leave.
static void minimise(tableau *t, int cost)
{
    int column;
    while ((column = entering_column(t, cost)) >= 0)
        pivot(t, leaving_row(t, column), column);
}

/// Change an artificial unknown that is still in the basis, at zero, for a
/// weight.  A row without any is redundant: it is zero, and stays so.
static void drive_out(tableau *t, int row)
{
    for (int j = 0; j < t->columns; j++) {
        int sign = mpz_sgn(t->number[row][j]);
        if (sign == 0)
            continue;
        for (int k = 0; sign < 0 && k <= t->columns; k++)
            mpz_neg(t->number[row][k], t->number[row][k]);
        pivot(t, row, j);
        return;
    }
}

/// Whether the tableau has a solution; if so `least` is its least time.
static bool tableau_solve(tableau *t, mpq_t least)
{
    minimise(t, FEASIBILITY);
    if (mpz_sgn(t->number[FEASIBILITY][t->columns]) != 0)
        return false;
    for (int i = 0; i < t->rows; i++)
        if (t->basis[i] >= t->columns)
            drive_out(t, i);
    minimise(t, TIME);
    mpz_neg(mpq_numref(least), t->number[TIME][t->columns]);
    mpz_set(mpq_denref(least), t->denominator);
    mpq_canonicalize(least);
    return true;
}

static void extent(const oracle_simplex *s, int axis, double *lo, double *hi)
{
    *lo = *hi = s->event[0]->x[axis];
    for (int i = 1; i < s->count; i++) {
        double x = s->event[i]->x[axis];
        *lo = x < *lo ? x : *lo;
        *hi = x > *hi ? x : *hi;
    }
}

static bool boxes_meet(int axes, const oracle_simplex *s,
                       const oracle_simplex *r)
{
    for (int k = 0; k < axes; k++) {
        double s_lo, s_hi, r_lo, r_hi;
        extent(s, k, &s_lo, &s_hi);
        extent(r, k, &r_lo, &r_hi);
        if (s_hi < r_lo || r_hi < s_lo)
            return false;
    }
    return true;
}

static const oracle_moves no_moves;

// Moves are too small to bring boxes together.
static bool solve(int axes, bool timed, const oracle_simplex *s,
                  const oracle_simplex *r, const oracle_moves *moves,
                  mpq_t least)
{
    if (!boxes_meet(axes, s, r))
        return false;
    tableau t;
    tableau_init(&t);
    tableau_fill(&t, axes, timed, s, r, moves);
    bool hit = tableau_solve(&t, least);
    tableau_clear(&t);
    return hit;
}

bool oracle_moved_simplices_meet(int axes, const oracle_simplex *s,
                                 const oracle_simplex *r,
                                 const oracle_moves *moves, mpq_t toi)
{
    return solve(axes, true, s, r, moves, toi);
}

bool oracle_moved_slices_meet(int axes, const oracle_simplex *s,
                              const oracle_simplex *r,
                              const oracle_moves *moves)
{
    mpq_t unused;
    mpq_init(unused);
    bool hit = solve(axes, false, s, r, moves, unused);
    mpq_clear(unused);
    return hit;
}

bool oracle_simplices_meet(int axes, const oracle_simplex *s,
                           const oracle_simplex *r, mpq_t toi)
{
    return oracle_moved_simplices_meet(axes, s, r, &no_moves, toi);
}

bool oracle_slices_meet(int axes, const oracle_simplex *s,
                        const oracle_simplex *r)
{
    return oracle_moved_slices_meet(axes, s, r, &no_moves);
}

oracle_simplex oracle_step(int vertices, const tf_worldline element[],
                           int pivot)
{
    oracle_simplex s = {.count = vertices + 1};
    for (int i = 0; i < s.count; i++)
        s.event[i] = i <= pivot ? &element[i].at[0] : &element[i - 1].at[1];
    return s;
}

bool oracle_earliest(oracle_test *meet, int axes, int vertices,
                     const tf_worldline first[], int others,
                     const tf_worldline second[], mpq_t toi)
{
    bool hit = false;
    mpq_t time;
    mpq_init(time);
    for (int i = 0; i < vertices * others; i++) {
        oracle_simplex s = oracle_step(vertices, first, i / others);
        oracle_simplex r = oracle_step(others, second, i % others);
        if (!meet(axes, &s, &r, time))
            continue;
        if (!hit || mpq_cmp(time, toi) < 0)
            mpq_set(toi, time);
        hit = true;
    }
    mpq_clear(time);
    return hit;
}

bool oracle_meet(int axes, int vertices, const tf_worldline first[], int others,
                 const tf_worldline second[], mpq_t toi)
{
    return oracle_earliest(oracle_simplices_meet, axes, vertices, first, others,
                           second, toi);
}
