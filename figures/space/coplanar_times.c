// The volume of four ends in linear motion: a cubic with a zero when they lie
// in a plane.  For the propeller and the bar, in both orders of its ends.
#include "kit/figures.h"

#include "renderer/plot.h"

enum {
    CURVE = 98
};

/// Two edges at t = 0 and t = 1.
typedef struct query {
    const char *key, *name;
    double name_y;
    tf_vector a[2][2], b[2][2]; ///< by time and end
} query;

static const query queries[2] = {
    {.key = "up",
     .name = "$a_1$ right",
     .name_y = 1.5,
     .a = {{{{-1, 0, 0}}, {{1, 0, 0}}}, {{{-1, 0, -1}}, {{1, 0, 1}}}},
     .b = {{{{0, -1, 0.375}}, {{0, 1, 0.375}}},
           {{{0, -1, 0.375}}, {{0, 1, 0.375}}}}},
    {.key = "down",
     .name = "$a_1$ left",
     .name_y = -0.75,
     .a = {{{{1, 0, 0}}, {{-1, 0, 0}}}, {{{1, 0, 1}}, {{-1, 0, -1}}}},
     .b = {{{{1, -1, 0.1875}}, {{1, 1, 0.1875}}},
           {{{0, -1, 0.1875}}, {{0, 1, 0.1875}}}}},
};

/// a1 - a0, b1 - b0 and b0 - a0 at the time t.
static void find_differences(const query *q, double t, tf_vector d[3])
{
    tf_vector a[2], b[2];
    for (int i = 0; i < 2; i++) {
        a[i] = fig_lerp(q->a[0][i], q->a[1][i], t);
        b[i] = fig_lerp(q->b[0][i], q->b[1][i], t);
    }
    d[0] = fig_difference(a[1], a[0]);
    d[1] = fig_difference(b[1], b[0]);
    d[2] = fig_difference(b[0], a[0]);
}

static double volume(const query *q, double t)
{
    tf_vector d[3];
    find_differences(q, t, d);
    return tf_vector_dot(fig_cross(d[0], d[1]), d[2]);
}

/// Whether the edges have a point in common at a zero, where their lines do.
static bool edges_meet(const query *q, double t)
{
    tf_vector d[3];
    find_differences(q, t, d);
    tf_vector normal = fig_cross(d[0], d[1]);
    double square = tf_vector_dot(normal, normal);
    for (int i = 0; i < 2; i++) {
        double along =
            tf_vector_dot(fig_cross(d[2], d[1 - i]), normal) / square;
        if (along < 0 || along > 1)
            return false;
    }
    return true;
}

/// The zero between two times with different signs.
static double find_zero(const query *q, double low, double high)
{
    bool negative = volume(q, low) < 0;
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        if ((volume(q, middle) < 0) == negative)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}

static void draw_zeros(fig_page *page, const fig_plot *plot, const query *q,
                       const fig_point at[CURVE], FILE *numbers)
{
    int zeros = 0, met = 0;
    char key[24];
    for (int i = 1; i < CURVE; i++) {
        if ((at[i - 1].y < 0) == (at[i].y < 0))
            continue;
        double t = find_zero(q, at[i - 1].x, at[i].x);
        bool meet = edges_meet(q, t);
        fig_plot_dot(page, plot, t, 0, 6,
                     meet ? FIG_ROLE_CONTACT : FIG_ROLE_NEUTRAL);
        snprintf(key, sizeof key, "%s_zero_%d", q->key, zeros++);
        fig_number(numbers, key, t);
        met += meet;
    }
    snprintf(key, sizeof key, "%s_zeros", q->key);
    fig_number(numbers, key, zeros);
    snprintf(key, sizeof key, "%s_met", q->key);
    fig_number(numbers, key, met);
}

static void draw_query(fig_page *page, const fig_plot *plot, const query *q,
                       FILE *numbers)
{
    fig_point at[CURVE];
    for (int i = 0; i < CURVE; i++) {
        at[i].x = (double)i / (CURVE - 1);
        at[i].y = volume(q, at[i].x);
    }
    fig_plot_curve(page, plot, CURVE, at,
                   (fig_stroke){.paint.role = FIG_ROLE_EDGE,
                                .width = FIG_WIDTH_LINE,
                                .under_labels = true});
    fig_point place = fig_plot_place(plot, 1, q->name_y);
    fig_page_text(page, place.x + 4, place.y + 3, FIG_ALIGN_LEFT, q->name,
                  FIG_LETTERS_SMALL, FIG_ROLE_EDGE);
    draw_zeros(page, plot, q, at, numbers);
    char key[24];
    for (int i = 0; i <= 2; i++) {
        snprintf(key, sizeof key, "%s_volume_%d", q->key, i);
        fig_number(numbers, key, volume(q, 0.5 * i));
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {44, 8, fig_page_width(page) - 100, 120},
                     .x = {0, 1},
                     .y = {-1, 2},
                     .name_x = "$t$",
                     .name_y = "determinant"};
    fig_plot_frame(page, &plot);
    fig_plot_level(page, &plot, 0);
    for (int i = 0; i < 2; i++)
        draw_query(page, &plot, &queries[i], numbers);
}

const fig_figure fig_coplanar_times = {
    .name = "coplanar-times",
    .title = "When the four ends of two straight edges lie in a plane",
    .width = FIG_PAGE_WIDTH,
    .height = 166,
    .draw = draw,
};
