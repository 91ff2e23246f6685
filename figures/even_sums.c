// Contacts of an edge and a triangle, alone and with the crossings at both ends
// of the step.
#include "figures.h"

#include "arithmetic/exact.h"
#include "contract.h"
#include "spacetime/meet.h"
#include "stage/plot.h"

#include <stdint.h>
#include <string.h>

enum {
    STEPS = 2000,
    VERTICES = 5, // 0 and 1 of the edge, 2 to 4 of the triangle
    MOST = 16
};

/// How many steps have each number of contacts, and each sum.
typedef struct tally {
    long contacts[MOST + 1], sums[MOST + 1];
} tally;

// Steps ------------------------------------------------------------------

/// The next of a sequence of numbers in -1..1 (Knuth's linear congruences).
static double next_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-52 - 1;
}

/// Vertices that start anywhere in a cube and move by up to its side.
static void make_step(uint64_t *state, tf_worldline vertex[VERTICES])
{
    for (int v = 0; v < VERTICES; v++) {
        double start[TF_AXES], end[TF_AXES];
        for (int k = 0; k < TF_AXES; k++) {
            start[k] = next_random(state);
            end[k] = start[k] + 2 * next_random(state);
        }
        vertex[v] = tf_worldline_between(TF_AXES, start, end);
    }
}

// Contacts ---------------------------------------------------------------

static int count_pairs(int vertices, const tf_worldline first[], int others,
                       const tf_worldline second[])
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    tf_sweep(vertices, first, s);
    tf_sweep(others, second, r);
    int count = 0;
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < others; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], TF_AXES);
            count += tf_meet(&tf_exact, &pair).verdict == TF_HIT;
        }
    return count;
}

static int count_contacts(const tf_worldline vertex[VERTICES])
{
    const tf_worldline *triangle = vertex + 2;
    int count = count_pairs(1, &vertex[0], 3, triangle) +
                count_pairs(1, &vertex[1], 3, triangle);
    for (int i = 0; i < 3; i++)
        for (int j = i + 1; j < 3; j++) {
            tf_worldline side[2] = {triangle[i], triangle[j]};
            count += count_pairs(2, vertex, 2, side);
        }
    return count;
}

static bool cross_at(const tf_worldline vertex[VERTICES], int t)
{
    tf_pair pair = {.count = VERTICES,
                    .early = t == 0 ? VERTICES : 0,
                    .axes = TF_AXES,
                    .axis = {0, 1, 2}};
    for (int v = 0; v < VERTICES; v++) {
        pair.event[v] = &vertex[v].at[t];
        pair.side[v] = v < 2 ? +1 : -1;
    }
    tf_meeting meeting;
    TF_REQUIRE(tf_complementary_meet(&tf_exact, &pair, &meeting));
    return meeting.verdict == TF_HIT;
}

static tally count_steps(void)
{
    tally n;
    memset(&n, 0, sizeof n);
    uint64_t state = 1;
    for (int i = 0; i < STEPS; i++) {
        tf_worldline vertex[VERTICES];
        make_step(&state, vertex);
        int contacts = count_contacts(vertex);
        n.contacts[contacts]++;
        n.sums[contacts + cross_at(vertex, 0) + cross_at(vertex, 1)]++;
    }
    return n;
}

// The chart --------------------------------------------------------------

static double percent(long count)
{
    return 100 * (double)count / STEPS;
}

static void draw_bar(tf_page *page, const tf_plot *plot, const double x[2],
                     double height, tf_role role)
{
    double foot[2], top[2];
    tf_plot_place(plot, x[0], 0, foot);
    tf_plot_place(plot, x[1], height, top);
    if (height > 0)
        tf_page_fill_box(
            page, (tf_box){foot[0], top[1], top[0] - foot[0], foot[1] - top[1]},
            (tf_paint){.role = role});
}

static void draw_key(tf_page *page, double x, double y, const char *text,
                     tf_role role)
{
    tf_page_fill_box(page, (tf_box){x, y - 7, 8, 8}, (tf_paint){.role = role});
    tf_page_text(page, x + 13, y, TF_ALIGN_LEFT, text, TF_LETTERS_SMALL,
                 TF_ROLE_INK);
}

static void print_numbers(const tally *n, int most, FILE *numbers)
{
    long odd_contacts = 0, odd_sums = 0;
    for (int i = 1; i <= MOST; i += 2) {
        odd_contacts += n->contacts[i];
        odd_sums += n->sums[i];
    }
    tf_figure_number(numbers, "steps", STEPS);
    tf_figure_number(numbers, "odd_contacts", (double)odd_contacts);
    tf_figure_number(numbers, "odd_sums", (double)odd_sums);
    tf_figure_number(numbers, "most", most);
    for (int i = 0; i <= most; i++) {
        char key[32];
        snprintf(key, sizeof key, "contacts_%d", i);
        tf_figure_number(numbers, key, (double)n->contacts[i]);
        snprintf(key, sizeof key, "sums_%d", i);
        tf_figure_number(numbers, key, (double)n->sums[i]);
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    tally n = count_steps();
    int most = MOST;
    while (n.sums[most] == 0)
        most--;
    print_numbers(&n, most, numbers);
    tf_plot plot = {
        .box = {44, 10, tf_page_width(page) - 60, tf_page_height(page) - 48},
        .x = {-0.6, most + 0.6},
        .y = {0, 70},
        .name_x = "number",
        .name_y = "percent of the steps",
        .ticks_x = most + 1};
    for (int i = 0; i <= most; i++) {
        draw_bar(page, &plot, (double[2]){i - 0.4, i - 0.04},
                 percent(n.contacts[i]), TF_ROLE_CONTACT);
        draw_bar(page, &plot, (double[2]){i + 0.04, i + 0.4},
                 percent(n.sums[i]), TF_ROLE_TRIANGLE);
    }
    tf_plot_frame(page, &plot);
    double right = plot.box.x + plot.box.width;
    draw_key(page, right - 190, 22, "contacts", TF_ROLE_CONTACT);
    draw_key(page, right - 190, 36, "contacts and crossings at the ends",
             TF_ROLE_TRIANGLE);
}

const tf_figure tf_figure_even_sums = {
    .name = "even-sums",
    .title = "Contacts alone, and with the crossings at the ends",
    .width = TF_FIGURE_WIDTH,
    .height = 180,
    .draw = draw,
};
