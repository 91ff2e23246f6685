// The volume of four ends in linear motion: a cubic with a zero when they lie
// in a plane.  For the propeller and the bar, in both orders of its ends.
#include "figures.h"

#include "stage/plot.h"
#include "stage/vector.h"

enum {
    CURVE = 98
};

/// Two edges at t = 0 and t = 1.
typedef struct query {
    const char *key, *name;
    double name_y;
    double a[2][2][3], b[2][2][3]; ///< by time and end
} query;

static const query queries[2] = {
    {.key = "up",
     .name = "$a_1$ right",
     .name_y = 1.5,
     .a = {{{-1, 0, 0}, {1, 0, 0}}, {{-1, 0, -1}, {1, 0, 1}}},
     .b = {{{0, -1, 0.375}, {0, 1, 0.375}}, {{0, -1, 0.375}, {0, 1, 0.375}}}},
    {.key = "down",
     .name = "$a_1$ left",
     .name_y = -0.75,
     .a = {{{1, 0, 0}, {-1, 0, 0}}, {{1, 0, 1}, {-1, 0, -1}}},
     .b = {{{1, -1, 0.1875}, {1, 1, 0.1875}},
           {{0, -1, 0.1875}, {0, 1, 0.1875}}}},
};

/// a1 - a0, b1 - b0 and b0 - a0 at the time t.
static void find_differences(const query *q, double t, double d[3][3])
{
    for (int k = 0; k < 3; k++) {
        double a[2], b[2];
        for (int i = 0; i < 2; i++) {
            a[i] = (1 - t) * q->a[0][i][k] + t * q->a[1][i][k];
            b[i] = (1 - t) * q->b[0][i][k] + t * q->b[1][i][k];
        }
        d[0][k] = a[1] - a[0];
        d[1][k] = b[1] - b[0];
        d[2][k] = b[0] - a[0];
    }
}

static double volume(const query *q, double t)
{
    double d[3][3], normal[3];
    find_differences(q, t, d);
    tf_cross(d[0], d[1], normal);
    return tf_dot(normal, d[2]);
}

/// Whether the edges have a point in common at a zero, where their lines do.
static bool edges_meet(const query *q, double t)
{
    double d[3][3], normal[3], across[3];
    find_differences(q, t, d);
    tf_cross(d[0], d[1], normal);
    double square = tf_dot(normal, normal);
    for (int i = 0; i < 2; i++) {
        tf_cross(d[2], d[1 - i], across);
        double along = tf_dot(across, normal) / square;
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

static void draw_zeros(tf_page *page, const tf_plot *plot, const query *q,
                       const double at[CURVE][2], FILE *numbers)
{
    int zeros = 0, met = 0;
    char key[24];
    for (int i = 1; i < CURVE; i++) {
        if ((at[i - 1][1] < 0) == (at[i][1] < 0))
            continue;
        double t = find_zero(q, at[i - 1][0], at[i][0]), place[2];
        bool meet = edges_meet(q, t);
        tf_plot_place(plot, t, 0, place);
        tf_page_dot(
            page, place[0], place[1], 6,
            (tf_paint){.role = meet ? TF_ROLE_CONTACT : TF_ROLE_NEUTRAL});
        snprintf(key, sizeof key, "%s_zero_%d", q->key, zeros++);
        tf_figure_number(numbers, key, t);
        met += meet;
    }
    snprintf(key, sizeof key, "%s_zeros", q->key);
    tf_figure_number(numbers, key, zeros);
    snprintf(key, sizeof key, "%s_met", q->key);
    tf_figure_number(numbers, key, met);
}

static void draw_query(tf_page *page, const tf_plot *plot, const query *q,
                       FILE *numbers)
{
    double at[CURVE][2], place[2];
    for (int i = 0; i < CURVE; i++) {
        at[i][0] = (double)i / (CURVE - 1);
        at[i][1] = volume(q, at[i][0]);
    }
    tf_plot_curve(page, plot, CURVE, (const double(*)[2])at,
                  (tf_stroke){.paint.role = TF_ROLE_EDGE,
                              .width = TF_WIDTH_LINE,
                              .under_labels = true});
    tf_plot_place(plot, 1, q->name_y, place);
    tf_page_text(page, place[0] + 4, place[1] + 3, TF_ALIGN_LEFT, q->name,
                 TF_LETTERS_SMALL, TF_ROLE_EDGE);
    draw_zeros(page, plot, q, (const double(*)[2])at, numbers);
    char key[24];
    for (int i = 0; i <= 2; i++) {
        snprintf(key, sizeof key, "%s_volume_%d", q->key, i);
        tf_figure_number(numbers, key, volume(q, 0.5 * i));
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    tf_plot plot = {.box = {44, 8, tf_page_width(page) - 100, 120},
                    .x = {0, 1},
                    .y = {-1, 2},
                    .name_x = "$t$",
                    .name_y = "determinant"};
    tf_plot_frame(page, &plot);
    double zero[2][2] = {{0, 0}, {1, 0}};
    tf_plot_curve(
        page, &plot, 2, (const double(*)[2])zero,
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_HAIR});
    for (int i = 0; i < 2; i++)
        draw_query(page, &plot, &queries[i], numbers);
}

const tf_figure tf_figure_coplanar_times = {
    .name = "coplanar-times",
    .title = "When the four ends of two straight edges lie in a plane",
    .width = TF_FIGURE_WIDTH,
    .height = 166,
    .draw = draw,
};
