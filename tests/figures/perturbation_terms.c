#include "figures/numbers.h"

#include "arithmetic/functions.h"
#include "query/query.h"
#include "support/sums.h"

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
        if (!(product >> i & 1))
            continue;
        int event = 1 << i / TF_AXES, axis = 1 << i % TF_AXES;
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
        if (product >> bit & 1)
            for (int e = 0; e < all->count; e++)
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

static long zeros, tried, first, degrees[TF_AXES + 1];
static long events_needed[MOST_EVENTS + 1];
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

START_TEST(counts_are_right)
{
    static const tf_arithmetic counting = {
        .name = "counting", .sign = counting_sign, .value = any_value};
    generator random = {.state = 1};
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[4];
        for (int v = 0; v < 4; v++) {
            double x[2][TF_AXES];
            for (int j = 0; j < 6; j++)
                x[j / TF_AXES][j % TF_AXES] =
                    (double)(next_bits(&random) >> 32 & 3);
            vertex[v] = tf_worldline_between(TF_AXES, x[0], x[1]);
            tf_worldline_set_vertex(&vertex[v], v);
        }
        int points = 1 + i % 2;
        tf_contact contact;
        ck_assert_int_eq(tf_query(&counting, TF_AXES, points, vertex,
                                  4 - points, vertex + points, &contact),
                         TF_OK);
    }
    char *text = printed(&fig_perturbation_terms);
    expect_number(text, "zeros", (double)zeros);
    expect_number(text, "mean", (double)tried / (double)zeros);
    expect_number(text, "most", most);
    expect_number(text, "first_percent", 100. * (double)first / (double)zeros);
    static const char *const keys[] = {"one_percent", "two_percent",
                                       "three_percent"};
    for (int i = 0; i < 3; i++)
        expect_number(text, keys[i],
                      100. * (double)degrees[i + 1] / (double)zeros);
    long decided = 0;
    for (int i = 1; i <= 4; i++) {
        char key[32];
        snprintf(key, sizeof key, "events_%d_percent", i);
        decided += events_needed[i];
        expect_number(text, key, 100. * (double)decided / (double)zeros);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/perturbation_terms", counts_are_right);
}
