// How many products of symbols are tried until one has a factor that is not
// zero, for the vanishing determinants of queries on a small lattice.
#include "figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/perturbed.h"
#include "query/contact.h"
#include "stage/plot.h"

#include <stdint.h>
#include <string.h>

enum {
    QUERIES = 10000,
    VERTICES = 4,
    VALUES = 4,                ///< of a coordinate: 0, 1, 2, 3
    MOST_EVENTS = 2 * TF_AXES, ///< of a determinant
    MOST_PRODUCTS = 228        ///< of at most three symbols of six events
};

// Products ---------------------------------------------------------------

/// The place of an event's symbol among all, as tf_value has it.
static int symbol_of(const tf_event *event, int axis)
{
    return TF_AXES * (2 * event->vertex + event->t) + axis + 1;
}

/// The different events of a determinant of space.
static int collect_events(const tf_differences *d,
                          const tf_event *event[MOST_EVENTS])
{
    int count = 0;
    for (int i = 0; i < 2 * d->n; i++) {
        const tf_event *next = i % 2 == 0 ? d->to[i / 2] : d->from[i / 2];
        bool known = false;
        for (int j = 0; j < count; j++)
            known |= event[j] == next;
        if (!known)
            event[count++] = next;
    }
    return count;
}

/// List the symbols of a product that has the symbol of event[choice[k]] on
/// axis k, none where there is no such event: the smallest symbol, of the
/// latest place, first.  False if an event has two symbols or all have none.
static bool list_symbols(int events, const tf_event *const event[],
                         const int choice[TF_AXES], int symbol[TF_AXES])
{
    int count = 0;
    memset(symbol, 0, TF_AXES * sizeof *symbol);
    for (int k = 0; k < TF_AXES; k++) {
        if (choice[k] == events)
            continue;
        for (int other = 0; other < k; other++)
            if (choice[other] == choice[k])
                return false;
        int next = symbol_of(event[choice[k]], k), place = count++;
        for (; place > 0 && symbol[place - 1] < next; place--)
            symbol[place] = symbol[place - 1];
        symbol[place] = next;
    }
    return count > 0;
}

/// Whether a product is larger than another or the same: alphabetical order.
static bool not_after(const int product[TF_AXES], const int other[TF_AXES])
{
    for (int i = 0; i < TF_AXES; i++)
        if (product[i] != other[i])
            return product[i] < other[i];
    return true;
}

/// How many products of a vanishing determinant are as large as the leading
/// one or larger.
static int count_tried(const tf_differences *d, const int leading[TF_AXES])
{
    const tf_event *event[MOST_EVENTS];
    int events = collect_events(d, event), tried = 0;
    for (int i = 0; i <= events; i++)
        for (int j = 0; j <= events; j++)
            for (int k = 0; k <= events; k++) {
                int symbol[TF_AXES];
                tried +=
                    list_symbols(events, event, (int[]){i, j, k}, symbol) &&
                    not_after(symbol, leading);
            }
    return tried;
}

// An arithmetic that counts ----------------------------------------------

static struct tally {
    long tried[MOST_PRODUCTS + 1], degree[TF_AXES + 1];
    long zeros, sum;
} tally;

static tf_sign counting_sign(const tf_differences *d)
{
    if (tf_exact.sign(d) == TF_ZERO) {
        tf_value value = tf_perturbed.value(d);
        int tried = count_tried(d, value.order), degree = 0;
        for (int i = 0; i < TF_AXES; i++)
            degree += value.order[i] > 0;
        tally.tried[tried]++;
        tally.degree[degree]++;
        tally.zeros++;
        tally.sum += tried;
    }
    return tf_perturbed.sign(d);
}

static tf_value perturbed_value(const tf_differences *d)
{
    return tf_perturbed.value(d);
}

static const tf_arithmetic counting = {
    .name = "counting", .sign = counting_sign, .value = perturbed_value};

// Queries ----------------------------------------------------------------

/// The next of a sequence of integers in 0..VALUES-1 (Steele, Lea and Flood's
/// splitmix64).
static int next_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (int)((z ^ z >> 31) >> 32) & (VALUES - 1);
}

/// Points against triangles and edges against edges in turns.
static void count_terms(void)
{
    memset(&tally, 0, sizeof tally);
    uint64_t state = 1;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        for (int v = 0; v < VERTICES; v++) {
            double x[2][TF_AXES];
            for (int j = 0; j < 2 * TF_AXES; j++)
                x[j / TF_AXES][j % TF_AXES] = next_random(&state);
            vertex[v] = tf_worldline_between(TF_AXES, x[0], x[1]);
            tf_worldline_set_vertex(&vertex[v], v);
        }
        int first = 1 + i % 2;
        tf_contact contact;
        tf_status status = tf_query(&counting, TF_AXES, first, vertex,
                                    VERTICES - first, vertex + first, &contact);
        TF_REQUIRE(status == TF_OK);
    }
}

// The chart --------------------------------------------------------------

static double percent(long count)
{
    return 100 * (double)count / (double)tally.zeros;
}

/// The most products that were tried for a determinant.
static int find_most(void)
{
    int most = MOST_PRODUCTS;
    while (tally.tried[most] == 0)
        most--;
    return most;
}

static void print_numbers(FILE *numbers)
{
    tf_figure_number(numbers, "zeros", (double)tally.zeros);
    tf_figure_number(numbers, "mean", (double)tally.sum / (double)tally.zeros);
    tf_figure_number(numbers, "most", find_most());
    tf_figure_number(numbers, "first_percent", percent(tally.tried[1]));
    tf_figure_number(numbers, "one_percent", percent(tally.degree[1]));
    tf_figure_number(numbers, "two_percent", percent(tally.degree[2]));
    tf_figure_number(numbers, "three_percent", percent(tally.degree[3]));
}

static void draw(tf_page *page, FILE *numbers)
{
    count_terms();
    print_numbers(numbers);
    tf_plot plot = {
        .box = {44, 10, tf_page_width(page) - 60, tf_page_height(page) - 48},
        .x = {0.4, find_most() + 0.6},
        .y = {0, 50},
        .name_x = "products tried",
        .name_y = "percent of them",
        .ticks_x = 10};
    for (int i = 1; i <= find_most(); i++) {
        double foot[2], top[2];
        tf_plot_place(&plot, i - 0.35, 0, foot);
        tf_plot_place(&plot, i + 0.35, percent(tally.tried[i]), top);
        tf_page_fill_box(
            page, (tf_box){foot[0], top[1], top[0] - foot[0], foot[1] - top[1]},
            (tf_paint){.role = TF_ROLE_TRIANGLE});
    }
    tf_plot_frame(page, &plot);
}

const tf_figure tf_figure_leading_terms = {
    .name = "leading-terms",
    .title = "How many products are tried until one tells the sign",
    .width = TF_FIGURE_WIDTH,
    .height = 170,
    .draw = draw,
};
