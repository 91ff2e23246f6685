// How many signs a point-triangle query asks for, counted by an arithmetic.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_triangle.h"
#include "stage/plot.h"

#include <stdint.h>

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

// Random queries ---------------------------------------------------------

/// The next of a sequence of numbers in 0..1 (Steele, Lea and Flood's
/// splitmix64).
static double next_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

static void make_query(uint64_t *state, tf_worldline vertex[VERTICES])
{
    for (int i = 0; i < VERTICES; i++) {
        double start[3], end[3];
        for (int k = 0; k < 3; k++) {
            start[k] = next_random(state);
            end[k] = start[k] + displacement * (2 * next_random(state) - 1);
        }
        vertex[i] = tf_worldline_between(3, start, end);
    }
}

/// How many misses and hits asked for how many signs, those left out that
/// asked for none.
typedef struct tally {
    long of[2][MOST_SIGNS + 1]; ///< [hit][signs]
    long queries[2], signs[2];  ///< [hit]
    long none;
} tally;

static tally count_signs(void)
{
    tally n = {.none = 0};
    uint64_t state = 1;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        tf_contact contact;
        make_query(&state, vertex);
        signs_asked = 0;
        tf_point_triangle(&counting, &vertex[0], &vertex[1], &contact);
        TF_REQUIRE(signs_asked <= MOST_SIGNS);
        if (signs_asked == 0) {
            n.none++;
            continue;
        }
        bool hit = contact.verdict == TF_HIT;
        n.of[hit][signs_asked]++;
        n.queries[hit]++;
        n.signs[hit] += signs_asked;
    }
    return n;
}

// The chart --------------------------------------------------------------

static double percent(const tally *n, bool hit, int signs)
{
    return 100 * (double)n->of[hit][signs] / (double)n->queries[hit];
}

/// The misses' bar left of the number, the hits' right of it.
static void draw_bar(tf_page *page, const tf_plot *plot, const tally *n,
                     bool hit, int signs)
{
    double foot[2], top[2], share = percent(n, hit, signs);
    if (share == 0)
        return;
    tf_plot_place(plot, signs + (hit ? 0.04 : -0.4), 0, foot);
    tf_plot_place(plot, signs + (hit ? 0.4 : -0.04), share, top);
    tf_page_fill_box(
        page, (tf_box){foot[0], top[1], top[0] - foot[0], foot[1] - top[1]},
        (tf_paint){.role = hit ? TF_ROLE_CONTACT : TF_ROLE_TRIANGLE});
}

static void draw_key(tf_page *page, double x, double y, const char *text,
                     tf_role role)
{
    tf_page_fill_box(page, (tf_box){x, y - 7, 8, 8}, (tf_paint){.role = role});
    tf_page_text(page, x + 13, y, TF_ALIGN_LEFT, text, TF_LETTERS_SMALL,
                 TF_ROLE_INK);
}

static double mean_signs(const tally *n, bool hit)
{
    return (double)n->signs[hit] / (double)n->queries[hit];
}

static void print_numbers(const tally *n, FILE *numbers)
{
    tf_figure_number(numbers, "queries", QUERIES);
    tf_figure_number(numbers, "hits", (double)n->queries[true]);
    tf_figure_number(numbers, "none_percent", 100 * (double)n->none / QUERIES);
    tf_figure_number(numbers, "miss_mean", mean_signs(n, false));
    tf_figure_number(numbers, "hit_mean", mean_signs(n, true));
}

static void draw(tf_page *page, FILE *numbers)
{
    tally n = count_signs();
    print_numbers(&n, numbers);
    double width = tf_page_width(page), height = tf_page_height(page);
    tf_plot plot = {.box = {44, 10, width - 60, height - 48},
                    .x = {0.4, MOST_SIGNS + 0.6},
                    .y = {0, 30},
                    .name_x = "signs asked for",
                    .name_y = "percent of them",
                    .ticks_x = 10};
    for (int hit = 0; hit < 2; hit++)
        for (int i = 1; i <= MOST_SIGNS; i++)
            draw_bar(page, &plot, &n, hit, i);
    tf_plot_frame(page, &plot);
    draw_key(page, 62, 20, "queries that miss", TF_ROLE_TRIANGLE);
    draw_key(page, 62, 34, "queries that hit", TF_ROLE_CONTACT);
}

const tf_figure tf_figure_signs_spent = {
    .name = "signs-spent",
    .title = "How many signs a point-triangle query asks for",
    .width = TF_FIGURE_WIDTH,
    .height = 180,
    .draw = draw,
};
