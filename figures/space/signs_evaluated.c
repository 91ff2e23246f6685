// How many signs a point-triangle query asks for, counted by an arithmetic.
#include "arithmetic/functions.h"
#include "base/require.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/random.h"
#include "query/query.h"
#include "renderer/plot.h"

enum {
    QUERIES = 200000,
    VERTICES = 4,   ///< the point, then the triangle's
    MOST_SIGNS = 18 ///< three steps of six events
};

static const double displacement = 0.1;

// An arithmetic that counts ----------------------------------------------

static long signs_asked;

static tf_sign counting_sign(const tf_differences *differences)
{
    signs_asked++;
    return tf_exact.sign(differences);
}

static tf_value exact_value(const tf_differences *differences)
{
    return tf_exact.value(differences);
}

static const tf_arithmetic counting = {
    .name = "counting", .sign = counting_sign, .value = exact_value};

// Counts -----------------------------------------------------------------

/// How many misses and hits asked for how many signs, those left out that
/// asked for none.
typedef struct tally {
    long count[2][MOST_SIGNS + 1]; ///< [hit][signs]
    long queries[2], signs[2];     ///< [hit]
    long none;
} tally;

static tally count_signs(void)
{
    tally n = {.none = 0};
    uint64_t state = 1;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        tf_contact contact;
        fig_random_vertices(&state, 3, displacement, VERTICES, vertex);
        signs_asked = 0;
        tf_query(&counting, 3, 1, &vertex[0], 3, &vertex[1], &contact);
        TF_REQUIRE(signs_asked <= MOST_SIGNS);
        if (signs_asked == 0) {
            n.none++;
            continue;
        }
        bool hit = contact.verdict == TF_HIT;
        n.count[hit][signs_asked]++;
        n.queries[hit]++;
        n.signs[hit] += signs_asked;
    }
    return n;
}

// The chart --------------------------------------------------------------

static double percent(const tally *n, bool hit, int signs)
{
    return 100 * (double)n->count[hit][signs] / (double)n->queries[hit];
}

/// The misses' bar left of the number, the hits' right of it.
static void draw_bar(fig_page *page, const fig_plot *plot, const tally *n,
                     bool hit, int signs)
{
    double share = percent(n, hit, signs);
    if (share == 0)
        return;
    fig_plot_bar(
        page, plot, signs + (hit ? 0.04 : -0.4), signs + (hit ? 0.4 : -0.04),
        share, (fig_paint){.role = hit ? FIG_ROLE_CONTACT : FIG_ROLE_NEUTRAL});
}

static double mean_signs(const tally *n, bool hit)
{
    return (double)n->signs[hit] / (double)n->queries[hit];
}

static void print_numbers(const tally *n, FILE *numbers)
{
    fig_number(numbers, "queries", QUERIES);
    fig_number(numbers, "hits", (double)n->queries[true]);
    fig_number(numbers, "none_percent", 100 * (double)n->none / QUERIES);
    fig_number(numbers, "miss_mean", mean_signs(n, false));
    fig_number(numbers, "hit_mean", mean_signs(n, true));
}

static void draw(fig_page *page, FILE *numbers)
{
    tally n = count_signs();
    print_numbers(&n, numbers);
    double width = fig_page_width(page), height = fig_page_height(page);
    fig_plot plot = {.box = {44, 10, width - 60, height - 48},
                     .x = {0.4, MOST_SIGNS + 0.6},
                     .y = {0, 30},
                     .name_x = "signs evaluated",
                     .name_y = "percent of queries",
                     .ticks_x = 10};
    for (int hit = 0; hit < 2; hit++)
        for (int i = 1; i <= MOST_SIGNS; i++)
            draw_bar(page, &plot, &n, hit, i);
    fig_plot_frame(page, &plot);
    fig_plot_key(page, 62, 20, "queries that miss", FIG_ROLE_NEUTRAL);
    fig_plot_key(page, 62, 34, "queries that hit", FIG_ROLE_CONTACT);
}

const fig_figure fig_signs_evaluated = {
    .name = "signs-evaluated",
    .title = "How many signs a point-triangle query evaluates",
    .width = FIG_PAGE_WIDTH,
    .height = 180,
    .draw = draw,
};
