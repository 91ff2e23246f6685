#include "support/moved_simplices.h"

#include <limits.h>
#include <stdlib.h>

// The weights -----------------------------------------------------------------

enum {
    MOST_EVENTS = 6,
    SUBSETS = 1 << TF_AXES // of the axes
};

typedef struct weights {
    long weight[MOST_EVENTS][TF_AXES];
} weights;

/// The weights of events by rank: each is one more than the greatest sum of
/// earlier weights of different events on different axes.
static weights make_weights(void)
{
    weights w;
    long greatest[SUBSETS] = {0}; // by the axes used, of the events so far
    for (int e = 0; e < MOST_EVENTS; e++) {
        long with_own[SUBSETS];
        for (int set = 0; set < SUBSETS; set++)
            with_own[set] = greatest[set];
        for (int k = 0; k < TF_AXES; k++) {
            long before = 0;
            for (int set = 0; set < SUBSETS; set++)
                before = with_own[set] > before ? with_own[set] : before;
            w.weight[e][k] = before + 1;
            for (int set = 0; set < SUBSETS; set++) {
                long sum = greatest[set] + w.weight[e][k];
                int also = set | 1 << k;
                if (!(set >> k & 1) && sum > with_own[also])
                    with_own[also] = sum;
            }
        }
        for (int set = 0; set < SUBSETS; set++)
            greatest[set] = with_own[set];
    }
    return w;
}

/// How many of the pair's events are earlier.
static int rank_in_pair(const moved_pair *pair, const tf_event *event)
{
    int rank = 0;
    const oracle_simplex *sides[2] = {&pair->s, &pair->r};
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < sides[side]->count; i++) {
            const tf_event *other = sides[side]->event[i];
            rank += other->vertex < event->vertex ||
                    (other->vertex == event->vertex && other->t < event->t);
        }
    return rank;
}

// Sums of powers of two -------------------------------------------------------

// A term is factor 2^(-bits weight) with bits so many that no sum of factors
// reaches 2^bits: the sum has the sign of its first term, and is that term but
// for a 2^bits-th.
typedef struct term {
    long weight, factor;
} term;

enum {
    MOST_TERMS = 120 * 8 // permutations of 5 columns, choices on 3 axes
};

typedef struct sum {
    int count;
    term term[MOST_TERMS];
} sum;

static int by_weight(const void *a, const void *b)
{
    long one = ((const term *)a)->weight, other = ((const term *)b)->weight;
    return (one > other) - (one < other);
}

/// The first term that is not zero once those of one weight are added up.
static term leading_term(sum *s)
{
    qsort(s->term, (size_t)s->count, sizeof *s->term, by_weight);
    term leading = {0};
    for (int i = 0; i < s->count; i++) {
        if (leading.factor != 0 && s->term[i].weight != leading.weight)
            break;
        leading.weight = s->term[i].weight;
        leading.factor += s->term[i].factor;
    }
    return leading;
}

// Determinants ----------------------------------------------------------------

/// The events of the rows, in homogeneous coordinates: the axes, the time if
/// the pair is timed, and 1.
typedef struct matrix {
    int size, axes;
    bool timed;
    const tf_event *row[MOST_EVENTS];
    const long *weight[MOST_EVENTS];
} matrix;

/// Add up the terms of the rows from `row` on in the columns not in `used`,
/// each times `so_far`.
static void expand(const matrix *m, int row, int used, term so_far, sum *s)
{
    if (so_far.factor == 0)
        return;
    if (row == m->size) {
        s->term[s->count++] = so_far;
        return;
    }
    for (int column = 0, sign = 1; column < m->size; column++) {
        if (used >> column & 1)
            continue;
        long entry = 1;
        if (column < m->axes)
            entry = (long)m->row[row]->x[column];
        else if (column == m->axes && m->timed)
            entry = m->row[row]->t;
        term next = {so_far.weight, so_far.factor * sign * entry};
        expand(m, row + 1, used | 1 << column, next, s);
        if (column < m->axes) {
            next.weight += m->weight[row][column];
            next.factor = so_far.factor * sign;
            expand(m, row + 1, used | 1 << column, next, s);
        }
        sign = -sign;
    }
}

/// The barycentric coordinate of the event `without`, by Cramer's rule.
static term coordinate(const moved_pair *pair, const weights *w, int without)
{
    matrix m = {.axes = pair->axes, .timed = pair->timed};
    const oracle_simplex *sides[2] = {&pair->s, &pair->r};
    int place = 0;
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < sides[side]->count; i++) {
            if (place++ == without)
                continue;
            const tf_event *event = sides[side]->event[i];
            m.weight[m.size] = w->weight[rank_in_pair(pair, event)];
            m.row[m.size++] = event;
        }
    sum s;
    s.count = 0;
    expand(&m, 0, 0, (term){0, without % 2 == 0 ? 1 : -1}, &s);
    return leading_term(&s);
}

int moved_sign(const moved_pair *pair, int event)
{
    weights w = make_weights();
    term c = coordinate(pair, &w, event);
    return (c.factor > 0) - (c.factor < 0);
}

// Meetings --------------------------------------------------------------------

/// The share of the late events of S in its coordinates: of the terms of least
/// weight, all of one sign.
static void find_time(const moved_pair *pair, const term c[MOST_EVENTS],
                      mpq_t toi)
{
    long least = LONG_MAX, all = 0, late = 0;
    for (int i = 0; i < pair->s.count; i++)
        least = c[i].weight < least ? c[i].weight : least;
    for (int i = 0; i < pair->s.count; i++) {
        long factor = c[i].weight == least ? labs(c[i].factor) : 0;
        all += factor;
        late += pair->s.event[i]->t ? factor : 0;
    }
    mpq_set_ui(toi, (unsigned long)late, (unsigned long)all);
    mpq_canonicalize(toi);
}

bool moved_pair_meets(const moved_pair *pair, mpq_t toi)
{
    weights w = make_weights();
    term c[MOST_EVENTS];
    int count = pair->s.count + pair->r.count;
    for (int i = 0; i < count; i++) {
        c[i] = coordinate(pair, &w, i);
        if (c[i].factor == 0)
            abort(); // moved events are in general position
        bool agrees = (c[i].factor > 0) == (c[0].factor > 0);
        if (agrees != (i < pair->s.count))
            return false;
    }
    if (pair->timed)
        find_time(pair, c, toi);
    return true;
}

static bool moved_simplices_meet(int axes, const oracle_simplex *s,
                                 const oracle_simplex *r, mpq_t toi)
{
    moved_pair pair = {.axes = axes, .timed = true, .s = *s, .r = *r};
    return moved_pair_meets(&pair, toi);
}

bool moved_meet(int axes, int vertices, const tf_worldline first[], int others,
                const tf_worldline second[], mpq_t toi)
{
    return oracle_earliest(moved_simplices_meet, axes, vertices, first, others,
                           second, toi);
}

bool moved_pair_meets_by_oracle(const moved_pair *pair, int bits, mpq_t toi)
{
    weights w = make_weights();
    oracle_moves moves = {0};
    const oracle_simplex *sides[2] = {&pair->s, &pair->r};
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < sides[side]->count; i++)
            for (int k = 0; k < TF_AXES; k++) {
                int rank = rank_in_pair(pair, sides[side]->event[i]);
                moves.shift[side][i][k] = (int)(bits * w.weight[rank][k]);
            }
    if (pair->timed)
        return oracle_moved_simplices_meet(pair->axes, &pair->s, &pair->r,
                                           &moves, toi);
    return oracle_moved_slices_meet(pair->axes, &pair->s, &pair->r, &moves);
}
