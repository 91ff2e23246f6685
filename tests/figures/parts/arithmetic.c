// What the figures of arithmetic print.
#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/int128.h"
#include "bench/workloads.h"
#include "query/query.h"
#include "support/matrices.h"
#include "support/moved_simplices.h"
#include "support/rational.h"
#include "support/sums.h"

#include <float.h>

/// Three rows that nearly sum to zero.
static const double flat[9] = {
    0x1.39adc5cd900e1p-2,  -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2,
    -0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2,
    -0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4,  0x1.725a4884d51d7p-2};

// Sums of any length ----------------------------------------------------------

enum {
    WORD_BITS = 64
};

/// How many words of a sum are not zero, and its first and last.
static int count_words(const mpz_t sum, int *first, int *last)
{
    int count = 0, bits = (int)mpz_sizeinbase(sum, 2);
    for (int i = 0; i * WORD_BITS < bits; i++) {
        mp_bitcnt_t low = (mp_bitcnt_t)(i * WORD_BITS);
        if (mpz_scan1(sum, low) >= low + WORD_BITS)
            continue;
        *first = count == 0 && i < *first ? i : *first;
        *last = i > *last ? i : *last;
        count++;
    }
    return count;
}

/// Expect the words of the sums of negative and positive products of a
/// determinant.
static void expect_words(const char *name, const double e[9])
{
    mpz_t sum[2];
    int first = 1000, last = 0;
    mpz_inits(sum[0], sum[1], NULL);
    for (int j = 0; j < 3; j++)
        for (int turn = 1; turn <= 2; turn++) {
            double a = e[j], b = e[3 + (j + turn) % 3];
            double c = e[6 + (j + 2 * turn) % 3];
            bool positive =
                !signbit(a) ^ !signbit(b) ^ !signbit(c) ^ (turn == 2);
            sum_add(sum[positive], fabs(a), fabs(b), fabs(c));
        }
    expect(count_words(sum[0], &first, &last), "%s_negative", name);
    expect(count_words(sum[1], &first, &last), "%s_positive", name);
    // A word above may be in use and zero.
    double extra = number("%s_used", name) - (last - first + 1);
    ck_assert_msg(extra >= 0 && extra <= 1, "%s: %g words more", name, extra);
    mpz_clears(sum[0], sum[1], NULL);
}

static void words_of_sums_are_counted(void)
{
    static const double mixed[9] = {
        DBL_MAX, 1, DBL_TRUE_MIN, DBL_TRUE_MIN, DBL_MAX,
        1,       1, DBL_TRUE_MIN, DBL_MAX};
    expect_words("mixed", mixed);
    expect_words("ordinary", flat);
}

/// The determinant in units of 2^SUM_EXPONENT.
static void bits_and_terms_of_the_determinant_are_counted(void)
{
    mpz_t determinant;
    matrix m = matrix_of(3, flat);
    tf_differences differences = matrix_differences(&m);
    mpz_init(determinant);
    sum_determinant(determinant, &differences);
    int first = (int)mpz_sizeinbase(determinant, 2) + SUM_EXPONENT;
    int last = (int)mpz_scan1(determinant, 0) + SUM_EXPONENT;
    expect(last, "last_bit");
    // A last term that is a power of two may be just above the sum.
    double found = number("first_bit");
    ck_assert_msg(found == first - 1 || found == first, "%g, not %d", found,
                  first - 1);
    ck_assert_double_ge(number("terms"), (first - last) / 53.0);

    long exponent;
    double value = mpz_get_d_2exp(&exponent, determinant);
    value = ldexp(value, (int)exponent + SUM_EXPONENT);
    expect_within(1e-14 * fabs(value), value, "value");
    double bound = number("bound");
    ck_assert_double_lt(fabs(value), bound);
    ck_assert_double_lt(fabs(value - number("estimate")), bound);
    ck_assert_double_gt(value * number("last"), 0);
    mpz_clear(determinant);
}

static void two_doubles_are_the_sum(void)
{
    double hi = number("hi"), lo = number("lo");
    mpz_t sum;
    mpz_init(sum);
    sum_add(sum, 0x1.921fb54442d18p+1, 1, 1);
    sum_add(sum, 0x1.5bf0a8b145769p-23, 1, 1);
    ck_assert(rational_is(sum, SUM_EXPONENT, (tf_value){.number = hi}));
    sum_add(sum, -hi, 1, 1);
    ck_assert(rational_is(sum, SUM_EXPONENT, (tf_value){.number = lo}));
    int first = (int)mpz_sizeinbase(sum, 2) + SUM_EXPONENT - 1;
    ck_assert_int_ge(first, -75);
    expect(first, "lo_first");
    sum_add(sum, -lo, 1, 1);
    ck_assert_int_eq(mpz_sgn(sum), 0);
    mpz_clear(sum);
}

static void last_places_are_odd(void)
{
    ck_assert(fmod(ldexp(0x1.6a09e667f3bcdp-9, -(int)number("last_of_d")), 2) ==
              1);
    ck_assert(
        fmod(ldexp(0x1.72ba43fff3717p-12, -(int)number("last_of_e")), 2) == 1);
}

// Stages ----------------------------------------------------------------------

enum {
    CELLS = 96
};

static double from_half(int i)
{
    return i < 0 ? 0.5 + ldexp(i, -54) : 0.5 + ldexp(i, -53);
}

/// Whether to - from is rounded: in units of 2^-54 all are integers.
static bool is_rounded(double to, double from)
{
    int64_t exact = (int64_t)ldexp(to, 54) - (int64_t)ldexp(from, 54);
    return (int64_t)ldexp(to - from, 54) != exact;
}

static void cells_of_stages_are_counted(void)
{
    int estimate = 0, wholes = 0, tails = 0;
    for (int j = -CELLS / 2; j < CELLS / 2; j++)
        for (int i = -CELLS / 2; i < CELLS / 2; i++) {
            double x = from_half(i), y = from_half(j);
            double down = (1.125 - x) * (1.375 - y);
            double up = (1.125 - y) * (1.375 - x);
            double bound = (3 + 0x1p-40) * DBL_EPSILON / 2 * (down + up);
            bool rounded = is_rounded(1.125, x) || is_rounded(1.125, y) ||
                           is_rounded(1.375, x) || is_rounded(1.375, y);
            bool open = fabs(down - up) <= bound;
            estimate += !open;
            wholes += open && !rounded;
            tails += open && rounded;
        }
    expect(estimate, "estimate");
    expect(wholes, "wholes");
    expect(tails, "tails");
}

// Integers --------------------------------------------------------------------

/// How many bits the largest determinant of differences of `bits`-bit integers
/// has: an extreme one is found among those of extreme differences, because the
/// determinant is linear in each.
static double largest_bits(int n, int bits)
{
    double sign[9] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
    double most = ldexp(1, bits) - 1;
    size_t largest = 0;
    mpz_t determinant;
    mpz_init(determinant);
    generator random = generator_new(0);
    do {
        matrix m = matrix_new(&random, n);
        for (int k = 0; k < n * n; k++) {
            *matrix_coordinate(&m, 2 * k) = sign[k] * most;
            *matrix_coordinate(&m, 2 * k + 1) = -sign[k] * most;
        }
        tf_differences differences = matrix_differences(&m);
        int exponent = rational_determinant(determinant, &differences);
        size_t own = mpz_sizeinbase(determinant, 2) + (size_t)exponent;
        if (mpz_sgn(determinant) != 0 && own > largest)
            largest = own;
    } while (next_signs(n * n, sign));
    mpz_clear(determinant);
    return (double)largest;
}

static void largest_determinants_have_as_many_bits(void)
{
    expect(largest_bits(2, 30), "largest_plane_64");
    expect(largest_bits(3, 19), "largest_space_64");
    expect(largest_bits(2, 53), "largest_plane_128");
    expect(largest_bits(3, 40), "largest_space_128");
}

/// Six times the volume of the tetrahedron that (x, y, 0) makes with three
/// corners of a cube is 4 most^2 (x + y + most): its base has the normal
/// (1, 1, 1).
static void expect_stripes(int bits)
{
    const long across = 255, most = (1L << bits) - 1;
    int wrong = 0;
    double largest = 0;
    for (long i = 0; i < across * across; i++) {
        // C cuts quotients toward zero.
        long x = most * (2 * (i / across) - 254) / 255;
        long y = most * (2 * (i % across) - 254) / 255;
        tf_int128 volume = (tf_int128)(4 * most * most) * (x + y + most);
        // What 64 bits have of it, from -2^63 to 2^63 - 1.
        int64_t around = (int64_t)(uint64_t)volume;
        wrong += (around > 0) - (around < 0) != (volume > 0) - (volume < 0);
        largest = fmax(largest, fabs((double)volume));
    }
    expect(wrong, "wrong_%d", bits);
    expect(wrong / 650.25, "wrong_percent_%d", bits);
    expect(log2(largest), "largest_log2_%d", bits);
}

static void signs_go_around_from_twenty_bits_on(void)
{
    for (int bits = 19; bits <= 21; bits++)
        expect_stripes(bits);
}

// Rounded coordinates ---------------------------------------------------------

/// The nearest multiple of 16, in sixteenths; none of the places is in the
/// middle.
static int snap(int sixteenths)
{
    return (sixteenths + 8) / 16 * 16;
}

/// Twice the area of the triangle in cells, by the surveyor's formula.
static double double_area(bool rounded)
{
    static const int triangle[3][2] = {{6, 6}, {58, 41}, {25, 23}};
    int x[3][2], sum = 0;
    for (int i = 0; i < 6; i++) {
        int place = triangle[i / 2][i % 2];
        x[i / 2][i % 2] = rounded ? snap(place) : place;
    }
    for (int i = 0; i < 3; i++) {
        const int *a = x[i], *b = x[(i + 1) % 3];
        sum += a[0] * b[1] - b[0] * a[1];
    }
    return sum / 256.0;
}

static bool edges_meet(bool rounded)
{
    static const int edges[4][2] = {{6, 7}, {57, 41}, {7, 9}, {52, 39}};
    tf_event end[4] = {{.t = 0}};
    for (int i = 0; i < 8; i++) {
        int place = edges[i / 2][i % 2];
        end[i / 2].x[i % 2] = rounded ? snap(place) : place;
    }
    end[3].x[1] += rounded ? 0 : 0.5;
    oracle_simplex first = {2, {&end[0], &end[1]}};
    oracle_simplex second = {2, {&end[2], &end[3]}};
    return oracle_slices_meet(2, &first, &second);
}

static void rounding_turns_and_crosses(void)
{
    expect(double_area(false), "double_area");
    expect(double_area(true), "double_area_rounded");
    expect(edges_meet(false), "cross");
    expect(edges_meet(true), "cross_rounded");
}

enum {
    SIDE = 7,
    VERTICES = SIDE * SIDE
};

/// A sheet at rest, rotated by a matrix over 157, rounded to nearest with
/// halves away from zero or not.
static void make_sheet(int sheet, const int rotation[3][3], bool rounded,
                       tf_worldline vertex[VERTICES])
{
    for (int i = 0; i < VERTICES; i++) {
        // Twice the place.
        const int place[3] = {8 * (i / SIDE) - 24 + 4 * sheet,
                              8 * (i % SIDE) - 24 + 2 * sheet, 2 * sheet - 1};
        double x[3];
        for (int k = 0; k < 3; k++) {
            int sum = 0;
            for (int j = 0; j < 3; j++)
                sum += rotation[k][j] * place[j];
            x[k] = rounded ? (sum < 0 ? -1 : 1) * ((abs(sum) + 157) / 314)
                           : sum / 314.0;
        }
        vertex[i] = tf_worldline_between(3, x, x);
    }
}

/// Whether a vertex of a sheet has another one a step to its right, above it,
/// or both.
static bool has_step(int vertex, int step)
{
    return vertex % SIDE + step % SIDE < SIDE && vertex + step < VERTICES;
}

/// How many triangles of a sheet an edge meets.
static int count_triangles(const tf_worldline edge[2],
                           const tf_worldline sheet[VERTICES])
{
    int count = 0;
    for (int i = 0; i < 2 * VERTICES; i++) {
        int a = i / 2, beside = i % 2 ? 1 : SIDE;
        if (!has_step(a, SIDE + 1))
            continue;
        const tf_worldline corner[3] = {sheet[a], sheet[a + SIDE + 1],
                                        sheet[a + beside]};
        count += !boxes_apart(3, 2, edge, 3, corner) &&
                 meet_at(0, 3, 2, edge, 3, corner);
    }
    return count;
}

/// How often an edge of one of two sheets meets a triangle of the other.
static int count_crossings(const int rotation[3][3], bool rounded)
{
    static const int steps[] = {1, SIDE, SIDE + 1};
    tf_worldline sheet[2][VERTICES];
    int count = 0;
    for (int i = 0; i < 2; i++)
        make_sheet(i, rotation, rounded, sheet[i]);
    for (int i = 0; i < 2 * 3 * VERTICES; i++) {
        int own = i % 2, a = i / 6, step = steps[i / 2 % 3];
        const tf_worldline *v = sheet[own] + a;
        if (has_step(a, step))
            count += count_triangles((tf_worldline[]){v[0], v[step]},
                                     sheet[1 - own]);
    }
    return count;
}

/// The rotation is that of the quaternion 4 - 4 i - 5 j - 10 k.
static void crossings_of_the_sheets_are_counted(void)
{
    static const int rotated[3][3] = {
        {-93, 120, 40}, {-40, -75, 132}, {120, 68, 75}};
    static const int upright[3][3] = {{157, 0, 0}, {0, 157, 0}, {0, 0, 157}};
    expect(count_crossings(upright, true), "upright_rounded");
    expect(count_crossings(rotated, false), "rotated");
    expect(count_crossings(rotated, true), "rotated_rounded");
}

// Perturbed points ------------------------------------------------------------

/// The sign of (b - a) x (c - a), exactly.
static int turn_of(double x[3][2])
{
    matrix m = matrix_of(2, x[1]);
    for (int i = 0; i < 4; i++)
        *matrix_coordinate(&m, 2 * i + 1) = x[0][i % 2];
    tf_differences differences = matrix_differences(&m);
    return oracle_arithmetic.sign(&differences);
}

/// The symbols may be any numbers that shrink so fast: a moves by the first
/// two, b and c by these divided by `ratio` once and twice.
static void moved_points_turn_as_printed(void)
{
    const double first[2] = {number("first"), number("second")};
    for (double ratio = 16; ratio < 0x1p40; ratio *= 2) {
        double x[3][2];
        for (int i = 0; i < 6; i++)
            x[i / 2][i % 2] =
                (i % 2 == 0 ? i / 2 : 0) + first[i % 2] / pow(ratio, i / 2);
        expect(turn_of(x), "turn");
    }
    // By hand: the points themselves are in a row.
    ck_assert_int_eq(turn_of((double[3][2]){{0, 0}, {1, 0}, {2, 0}}), 0);
}

/// The triangles of a box, its corner i at the bits of i: all diagonals start
/// at corner 0 or 7.
static const int facet[12][3] = {
    {0, 1, 3}, {0, 2, 3}, {0, 1, 5}, {0, 4, 5}, {0, 2, 6}, {0, 4, 6},
    {7, 6, 4}, {7, 5, 4}, {7, 6, 2}, {7, 3, 2}, {7, 5, 1}, {7, 3, 1},
};

/// Needles through the same triangles as the figure's, but in eighths.
static const struct {
    const char *key;
    double end[2][3];
} needles[] = {
    {"inside", {{2, 6, -4}, {6, 2, 12}}},
    {"diagonal", {{4, 4, -4}, {4, 4, 12}}},
    {"corner", {{-2, -2, -2}, {10, 10, 10}}},
};

static void needles_meet_as_many_triangles(void)
{
    for (int n = 0; n < 3; n++) {
        int exact = 0, perturbed = 0;
        tf_event corner[8], end[2];
        for (int i = 0; i < 8; i++)
            corner[i] =
                (tf_event){.x = {(i & 1) * 8, (i >> 1 & 1) * 8, (i >> 2) * 8},
                           .vertex = i};
        for (int i = 0; i < 2; i++) {
            end[i] = (tf_event){.vertex = 8 + i};
            memcpy(end[i].x, needles[n].end[i], sizeof end[i].x);
        }
        for (int i = 0; i < 12; i++) {
            const int *f = facet[i];
            moved_pair pair = {
                .axes = 3,
                .s = {2, {&end[0], &end[1]}},
                .r = {3, {&corner[f[0]], &corner[f[1]], &corner[f[2]]}}};
            exact += oracle_slices_meet(3, &pair.s, &pair.r);
            perturbed += moved_pair_meets_by_oracle(&pair, 24, NULL);
        }
        expect(exact, "exact_%s", needles[n].key);
        expect(perturbed, "perturbed_%s", needles[n].key);
    }
}

// Perturbed signs by counting.  Number a determinant's symbols from the largest
// on and write a product as the bits of its symbols: since each symbol is
// smaller than any product of those before, a greater number is a smaller
// product.

enum {
    QUERIES = 10000,
    MOST_EVENTS = 5
};

typedef struct events {
    int count;
    const tf_event *event[MOST_EVENTS]; ///< the first moves most
} events;

static bool moves_more(const tf_event *a, const tf_event *b)
{
    return a->vertex != b->vertex ? a->vertex < b->vertex : a->t < b->t;
}

static void add_event(events *all, const tf_event *event)
{
    int place = all->count;
    for (int i = 0; i < all->count; i++)
        if (all->event[i] == event)
            return;
    for (; place > 0 && moves_more(event, all->event[place - 1]); place--)
        all->event[place] = all->event[place - 1];
    all->event[place] = event;
    all->count++;
}

/// The degree of a product; 0 if two symbols are of one event or one axis, or
/// if there are none.
static int degree_of(int product, int symbols)
{
    int degree = 0, used_events = 0, used_axes = 0;
    for (int i = 0; i < symbols; i++) {
        int event = 1 << i / TF_AXES, axis = 1 << i % TF_AXES;
        if (!(product >> i & 1))
            continue;
        if ((used_events & event) || (used_axes & axis))
            return 0;
        used_events |= event;
        used_axes |= axis;
        degree++;
    }
    return degree;
}

/// The event with the symbol of bit 3 e + k is 1 on axis k and the others 0.
static tf_sign coefficient_of(const tf_differences *d, const events *all,
                              int product)
{
    tf_event moved[MOST_EVENTS];
    tf_differences row = *d;
    for (int e = 0; e < all->count; e++)
        moved[e] = *all->event[e];
    for (int bit = 0; bit < TF_AXES * all->count; bit++)
        for (int e = 0; e < all->count && (product >> bit & 1); e++)
            moved[e].x[bit % TF_AXES] = e == bit / TF_AXES;
    for (int e = 0; e < all->count; e++)
        for (int i = 0; i < d->n; i++) {
            if (d->to[i] == all->event[e])
                row.to[i] = &moved[e];
            if (d->from[i] == all->event[e])
                row.from[i] = &moved[e];
        }
    mpz_t sum;
    mpz_init(sum);
    sum_determinant(sum, &row);
    tf_sign sign = sum_sign(sum);
    mpz_clear(sum);
    return sign;
}

static double zeros, tried, first, degrees[TF_AXES + 1];
static double events_needed[MOST_EVENTS + 1];
static int most;

static tf_sign counting_sign(const tf_differences *d)
{
    events all = {.count = 0};
    tf_sign sign = coefficient_of(d, &all, 0);
    if (sign != TF_ZERO)
        return sign;
    for (int i = 0; i < d->n; i++) {
        add_event(&all, d->to[i]);
        add_event(&all, d->from[i]);
    }
    int count = 0, degree = 0, last = 0;
    for (int product = 1; sign == TF_ZERO; product++) {
        degree = degree_of(product, TF_AXES * all.count);
        if (degree == 0)
            continue;
        count++;
        while (product >> (last + 1))
            last++; // the bit of the smallest symbol
        sign = coefficient_of(d, &all, product);
    }
    zeros++;
    tried += count;
    first += count == 1;
    degrees[degree]++;
    events_needed[last / TF_AXES + 1]++;
    most = count > most ? count : most;
    return sign;
}

/// No verdict depends on values.
static tf_value any_value(const tf_differences *d)
{
    (void)d;
    return (tf_value){.number = 1};
}

static void ask(const tf_arithmetic *arithmetic, int vertices,
                const tf_worldline vertex[4])
{
    tf_contact contact;
    ck_assert_int_eq(tf_query(arithmetic, TF_AXES, vertices, vertex,
                              4 - vertices, vertex + vertices, &contact),
                     TF_OK);
}

static void terms_of_perturbed_signs_are_counted(void)
{
    static const tf_arithmetic counting = {
        .name = "counting", .sign = counting_sign, .value = any_value};
    static const char *const keys[] = {"one", "two", "three"};
    generator random = {.state = 1};
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[4];
        for (int v = 0; v < 4; v++) {
            double x[2 * TF_AXES];
            for (int j = 0; j < 2 * TF_AXES; j++)
                x[j] = (double)(next_bits(&random) >> 32 & 3);
            make_vertices(TF_AXES, 1, x, &vertex[v]);
            tf_worldline_set_vertex(&vertex[v], v);
        }
        ask(&counting, 1 + i % 2, vertex);
    }
    expect(zeros, "zeros");
    expect(tried / zeros, "mean");
    expect(most, "most");
    expect(100 * first / zeros, "first_percent");
    for (int i = 0; i < 3; i++)
        expect(100 * degrees[i + 1] / zeros, "%s_percent", keys[i]);
    double decided = 0;
    for (int i = 1; i <= 4; i++) {
        decided += events_needed[i];
        expect(100 * decided / zeros, "events_%d_percent", i);
    }
}

// The queries that the library is timed on ------------------------------------

enum {
    WORKLOADS = 8
};

/// The i-th of all workloads of either kind.  The caller frees it.
static workload new_workload(int i)
{
    static workload (*const make[])(int vertices) = {
        workload_soup, workload_near, workload_rest, workload_lattice};
    return make[i / 2](1 + i % 2);
}

static bool is_named(const workload *w, const char *name)
{
    return strcmp(w->name, name) == 0;
}

/// The beginning of its keys.
static const char *key_of(const workload *w)
{
    static char key[64];
    snprintf(key, sizeof key, "%s%s_%s", w->rounded ? "rounded_" : "", w->name,
             w->vertices == 1 ? "pt" : "ee");
    return key;
}

/// Whether two moving elements meet, in one sense or another, and when.
typedef bool meet_test(int axes, int vertices, const tf_worldline first[],
                       int others, const tf_worldline second[], mpq_t toi);

static double count_hits(const workload *w, meet_test *meet)
{
    double hits = 0;
    mpq_t unused;
    mpq_init(unused);
    for (long i = 0; i < w->count; i++) {
        const tf_worldline *v = w->queries[i].vertex;
        hits += meet(TF_AXES, w->vertices, v, 4 - w->vertices, v + w->vertices,
                     unused);
    }
    mpq_clear(unused);
    return hits;
}

/// Expect as many hits as the oracle has, and times that are possible: no
/// processor decides a query in less than a nanosecond.
static void expect_costs(const workload *w, bool integers)
{
    static const char *const arithmetics[] = {
        "exact", "integer64", "integer128", "clamped", "perturbed"};
    double hits = count_hits(w, oracle_meet);
    for (int i = 0; i < 5; i++) {
        if (!integers && (i == 1 || i == 2))
            continue;
        if (i < 3)
            expect_within(0, hits, "%s_%s_hits", key_of(w), arithmetics[i]);
        expect_within(0, (double)w->count, "%s_%s_queries", key_of(w),
                      arithmetics[i]);
        ck_assert_double_gt(number("%s_%s", key_of(w), arithmetics[i]), 1);
    }
    // What is left open counts as a hit.
    ck_assert_double_ge(number("%s_clamped_hits", key_of(w)), hits);
    // Moved by little, elements apart stay apart, and in general position those
    // that meet still do; the lattice's are moved by explicit numbers.
    if (w->rounded)
        return;
    double moved = integers ? count_hits(w, moved_meet) : hits;
    expect_within(0, moved, "%s_perturbed_hits", key_of(w));
    ck_assert_double_le(moved, hits);
}

static void hits_are_the_oracles(void)
{
    for (int i = 0; i < WORKLOADS; i++) {
        workload w = new_workload(i);
        expect_costs(&w, is_named(&w, "lattice"));
        if (!is_named(&w, "lattice")) {
            workload grid = workload_rounded(&w);
            expect_costs(&grid, true);
            workload_free(&grid);
        }
        workload_free(&w);
    }
}

/// The sum of the absolute values of all products of a determinant.
static double sum_of_sizes(const tf_differences *d)
{
    double e[TF_AXES][TF_AXES] = {{0}}, sum = 0;
    for (int i = 0; i < d->n; i++)
        for (int j = 0; j < d->n; j++) {
            int k = d->axis[j];
            e[i][j] = fabs(d->to[i]->x[k] - d->from[i]->x[k]);
        }
    if (d->n == 2)
        return e[0][0] * e[1][1] + e[0][1] * e[1][0];
    for (int j = 0; j < 3; j++) {
        int a = (j + 1) % 3, b = (j + 2) % 3;
        sum += e[0][j] * (e[1][a] * e[2][b] + e[1][b] * e[2][a]);
    }
    return sum;
}

static int signs, cancelled;

static tf_sign noting_sign(const tf_differences *differences)
{
    tf_sign sign = tf_exact.sign(differences);
    signs++;
    cancelled += sign == TF_ZERO && sum_of_sizes(differences) > 0;
    return sign;
}

/// Whether all of one element is beyond all of the other on an axis, as far as
/// two steps of their staircases go, at both times in the same sense.
static bool beside(const oracle_simplex *s, const oracle_simplex *r, int axis)
{
    bool above = true, below = true;
    for (int i = 0; i < s->count; i++)
        for (int j = 0; j < r->count; j++) {
            double x = s->event[i]->x[axis], y = r->event[j]->x[axis];
            bool together = s->event[i]->t == r->event[j]->t;
            above &= !together || x > y;
            below &= !together || x < y;
        }
    return above || below;
}

/// Whether an axis separates every pair of steps, so that nothing is computed.
static bool needs_no_sign(int vertices, const tf_worldline v[4])
{
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < 4 - vertices; j++) {
            oracle_simplex s = oracle_step(vertices, v, i);
            oracle_simplex r = oracle_step(4 - vertices, v + vertices, j);
            if (!beside(&s, &r, 0) && !beside(&s, &r, 1) && !beside(&s, &r, 2))
                return false;
        }
    return true;
}

/// The signs that estimates leave open are those near zero.  Of small integers
/// these are zero, but for those all of whose products are zero too; of random
/// numbers there are none, and of vertices of one plane all are.  All of them
/// are on a grid.
static void expect_stages(const workload *w)
{
    static const tf_arithmetic noting = {
        .name = "noting", .sign = noting_sign, .value = any_value};
    const double unit = 0.001 + 1e-9; // the last digit of percents
    long none = 0, open = 0, expected = 0;
    for (long i = 0; i < w->count; i++) {
        const tf_worldline *v = w->queries[i].vertex;
        signs = cancelled = 0;
        ask(&noting, w->vertices, v);
        none += signs == 0;
        open += cancelled > 0;
        expected += needs_no_sign(w->vertices, v);
    }
    ck_assert_int_eq(none, expected);
    bool rest = is_named(w, "rest");
    double none_percent = 100. * (double)none / (double)w->count;
    double open_percent = rest ? 100 : 100. * (double)open / (double)w->count;
    const char *key = key_of(w);
    expect_within(unit / 2, none_percent, "%s_none", key);
    expect_within(unit / 2, open_percent, "%s_grid", key);
    expect_within(0, 0, "%s_accumulator", key);
    expect_within(unit, 100 - none_percent - open_percent, "%s_estimate", key);
    // Differences of small integers are not rounded; those of the tilted cloth
    // are, sometimes.
    double tails = number("%s_tails", key), heads = number("%s_heads", key);
    ck_assert_msg((tails > 0) == rest, "%s: %g percent of tails", key, tails);
    ck_assert_msg(0 <= heads && heads <= tails && tails <= 100,
                  "%s: %g percent of heads, %g of tails", key, heads, tails);
}

static void shares_of_stages_are_those_of_the_queries(void)
{
    for (int i = 0; i < WORKLOADS; i++) {
        workload w = new_workload(i);
        expect_stages(&w);
        workload_free(&w);
    }
}

const figure_test arithmetic_tests[] = {
    {&fig_accumulator_words, words_of_sums_are_counted},
    {&fig_determinant_bits, largest_determinants_have_as_many_bits},
    {&fig_coordinates_on_grid, last_places_are_odd},
    {&fig_exact_stages, cells_of_stages_are_counted},
    {&fig_expansion_terms, bits_and_terms_of_the_determinant_are_counted},
    {&fig_grid_rounding, rounding_turns_and_crosses},
    {&fig_integer_overflow, signs_go_around_from_twenty_bits_on},
    {&fig_perturbation_terms, terms_of_perturbed_signs_are_counted},
    {&fig_perturbed_points, moved_points_turn_as_printed},
    {&fig_needle_through_box, needles_meet_as_many_triangles},
    {&fig_rounded_sheets, crossings_of_the_sheets_are_counted},
    {&fig_sign_costs, hits_are_the_oracles},
    {&fig_sign_stages, shares_of_stages_are_those_of_the_queries},
    {&fig_two_sum, two_doubles_are_the_sum},
    {NULL, NULL}};
