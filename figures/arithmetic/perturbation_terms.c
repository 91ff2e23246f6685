// How many products of symbols are tried until one has a coefficient that is
// not zero, for the vanishing determinants of queries on a small lattice.
#include "arithmetic/functions.h"
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/perturbed.h"
#include "kit/random.h"
#include "query/query.h"
#include "renderer/plot.h"

#include <math.h>
#include <string.h>

enum {
    QUERIES = 10000,
    VERTICES = 4,
    VALUES = 4,         ///< of a coordinate: 0, 1, 2, 3
    MOST_EVENTS = 5,    ///< of a determinant: a pair has six
    MOST_PRODUCTS = 135 ///< of at most three symbols of five events
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
        TF_REQUIRE(known || count < MOST_EVENTS);
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
static bool not_after(const int product[TF_AXES], const int64_t other[TF_AXES])
{
    for (int i = 0; i < TF_AXES; i++)
        if (product[i] != other[i])
            return product[i] < other[i];
    return true;
}

/// How many products of a vanishing determinant are as large as the leading
/// one or larger.
static int count_tried(const tf_differences *d, const int64_t leading[TF_AXES])
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

static int random_coordinate(uint64_t *state)
{
    return (int)(fig_random_bits(state) >> 32 & (VALUES - 1));
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
                x[j / TF_AXES][j % TF_AXES] = random_coordinate(&state);
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

/// How many products there are of symbols of the first events alone.
static const int products_of[MOST_EVENTS + 1] = {0, 3, 12, 33, 72, 135};

/// The percentage of the determinants that at most so many products decide.
static double decided_by(int products)
{
    long count = 0;
    for (int i = 1; i <= products; i++)
        count += tally.tried[i];
    return percent(count);
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
    fig_number(numbers, "zeros", (double)tally.zeros);
    fig_number(numbers, "mean", (double)tally.sum / (double)tally.zeros);
    fig_number(numbers, "most", find_most());
    fig_number(numbers, "first_percent", percent(tally.tried[1]));
    fig_number(numbers, "one_percent", percent(tally.degree[1]));
    fig_number(numbers, "two_percent", percent(tally.degree[2]));
    fig_number(numbers, "three_percent", percent(tally.degree[3]));
    for (int events = 1; products_of[events - 1] < find_most(); events++) {
        char key[32];
        snprintf(key, sizeof key, "events_%d_percent", events);
        fig_number(numbers, key, decided_by(products_of[events]));
    }
}

/// A band for the products whose smallest symbol is of event number `event`.
static void draw_band(fig_page *page, const fig_plot *plot, int event)
{
    static const char *const name[] = {"1st event", "2nd", "3rd", "4th"};
    double from = fmax(products_of[event] + 0.5, plot->x[0]);
    double to = fmin(products_of[event + 1] + 0.5, plot->x[1]);
    fig_point top = fig_plot_place(plot, from, plot->y[1]);
    fig_point foot = fig_plot_place(plot, to, plot->y[0]);
    fig_box box = {top.x, top.y, foot.x - top.x, foot.y - top.y};
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL,
                                  .opacity = event % 2 == 0 ? 0.2 : 0.09});
    fig_page_text(page, box.x + box.width / 2, box.y - 5, FIG_ALIGN_CENTER,
                  name[event], FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

/// A step at each number of products, and a dot where one decided.
static void draw_steps(fig_page *page, const fig_plot *plot)
{
    int most = find_most(), count = 0;
    fig_point at[2 * MOST_PRODUCTS + 2];
    for (int i = 1; i <= most; i++) {
        at[count++] = (fig_point){i, decided_by(i - 1)};
        at[count++] = (fig_point){i, decided_by(i)};
    }
    at[count++] = (fig_point){plot->x[1], 100};
    fig_plot_curve(
        page, plot, count, at,
        (fig_stroke){.paint = {.role = FIG_ROLE_TRIANGLE}, .width = 1.8});
}

/// Names of numbers of products that matter, below the frame.
static void draw_scale(fig_page *page, const fig_plot *plot)
{
    static const int tick[] = {1, 2, 3, 4, 6, 9, 13, 20, 34};
    for (size_t i = 0; i < sizeof tick / sizeof *tick; i++) {
        char name[8];
        snprintf(name, sizeof name, "%d", tick[i]);
        fig_point at = fig_plot_place(plot, tick[i], plot->y[0]);
        fig_page_line(page, 2, (fig_point[]){at, {at.x, at.y + 3}},
                      (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                   .width = FIG_WIDTH_THIN});
        fig_page_text(page, at.x, at.y + 12, FIG_ALIGN_CENTER, name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    count_terms();
    print_numbers(numbers);
    fig_plot plot = {
        .box = {44, 22, fig_page_width(page) - 60, fig_page_height(page) - 60},
        .x = {0.8, find_most() + 6},
        .y = {0, 100},
        .log_x = true,
        .name_x = "products tried",
        .name_y = "percent decided",
        .ticks_x = -1};
    for (int event = 0; products_of[event] < find_most(); event++)
        draw_band(page, &plot, event);
    draw_steps(page, &plot);
    fig_plot_frame(page, &plot);
    draw_scale(page, &plot);
}

const fig_figure fig_perturbation_terms = {
    .name = "perturbation-terms",
    .title = "How many products are tried until one decides the sign",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
