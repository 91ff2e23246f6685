// Contacts of an edge and a triangle, alone and with the crossings at both ends
// of the step.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "base/require.h"
#include "intersect/cascade.h"
#include "kit/random.h"
#include "renderer/plot.h"

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

/// The next number of a sequence, -1 to 1.
static double next_random(uint64_t *state)
{
    return (double)(fig_congruent_bits(state) >> 11) * 0x1p-52 - 1;
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
            count +=
                tf_intersect(&tf_exact, &pair, TF_WITH_POINT).verdict == TF_HIT;
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
                    .start_count = t == 0 ? VERTICES : 0,
                    .axes = TF_AXES,
                    .axis = {0, 1, 2}};
    for (int v = 0; v < VERTICES; v++) {
        pair.event[v] = &vertex[v].at[t];
        pair.operand[v] = v < 2 ? +1 : -1;
    }
    tf_intersection meeting;
    TF_REQUIRE(
        tf_complementary_intersect(&tf_exact, &pair, TF_WITH_POINT, &meeting));
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

static void draw_bar(fig_page *page, const fig_plot *plot, double from,
                     double to, double height, fig_role role)
{
    if (height > 0)
        fig_plot_bar(page, plot, from, to, height, (fig_paint){.role = role});
}

static void print_numbers(const tally *n, int most, FILE *numbers)
{
    long odd_contacts = 0, odd_sums = 0;
    for (int i = 1; i <= MOST; i += 2) {
        odd_contacts += n->contacts[i];
        odd_sums += n->sums[i];
    }
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "odd_contacts", (double)odd_contacts);
    fig_number(numbers, "odd_sums", (double)odd_sums);
    fig_number(numbers, "most", most);
    for (int i = 0; i <= most; i++) {
        char key[32];
        snprintf(key, sizeof key, "contacts_%d", i);
        fig_number(numbers, key, (double)n->contacts[i]);
        snprintf(key, sizeof key, "sums_%d", i);
        fig_number(numbers, key, (double)n->sums[i]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    tally n = count_steps();
    int most = MOST;
    while (n.sums[most] == 0)
        most--;
    print_numbers(&n, most, numbers);
    fig_plot plot = {
        .box = {44, 10, fig_page_width(page) - 60, fig_page_height(page) - 48},
        .x = {-0.6, most + 0.6},
        .y = {0, 70},
        .name_x = "how many in a step",
        .name_y = "percent of the steps",
        .ticks_x = most + 1};
    for (int i = 0; i <= most; i++) {
        draw_bar(page, &plot, i - 0.4, i - 0.04, percent(n.contacts[i]),
                 FIG_ROLE_CONTACT);
        draw_bar(page, &plot, i + 0.04, i + 0.4, percent(n.sums[i]),
                 FIG_ROLE_NEUTRAL);
    }
    fig_plot_frame(page, &plot);
    double right = plot.box.x + plot.box.width;
    fig_plot_key(page, right - 190, 22, "contacts", FIG_ROLE_CONTACT);
    fig_plot_key(page, right - 190, 36, "contacts and crossings at the ends",
                 FIG_ROLE_NEUTRAL);
}

const fig_figure fig_contact_parity = {
    .name = "contact-parity",
    .title = "Contacts of a step, alone and with crossings at its ends",
    .width = FIG_PAGE_WIDTH,
    .height = 180,
    .draw = draw,
};
