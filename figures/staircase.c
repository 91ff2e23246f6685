// The events that each simplex of a sweep has, as paths that climb one step.
#include "figures.h"

#include "spacetime/sweep.h"

static const double column = 24, row = 30, first_top = 34, gap = 28;

/// An event's place in a diagram that begins at `x`.
static void place_event(double x, int vertex, int t, double at[2])
{
    at[0] = x + vertex * column;
    at[1] = first_top + (1 - t) * row;
}

/// An element that tells of each event whose it is.
static void make_element(int vertices, tf_worldline element[])
{
    for (int i = 0; i < vertices; i++)
        element[i] =
            tf_worldline_between(2, (double[]){i, 0}, (double[]){i, 0});
}

/// All events of an element, pale where the simplex does not have them.
static void draw_events(tf_page *page, double x, int vertices)
{
    for (int i = 0; i < vertices; i++)
        for (int t = 0; t < 2; t++) {
            double at[2];
            place_event(x, i, t, at);
            tf_page_dot(page, at[0], at[1], 4.5,
                        (tf_paint){.role = TF_ROLE_NEUTRAL, .shade = -0.5});
            char name[16];
            snprintf(name, sizeof name, "$v_%d%s$", i, t ? "'" : "");
            tf_page_text(page, at[0], at[1] + (t ? -8 : 16), TF_ALIGN_CENTER,
                         name, TF_LETTERS_SMALL, TF_ROLE_INK);
        }
}

/// The path of a simplex through its events.
static void draw_path(tf_page *page, double x, const tf_simplex *simplex)
{
    double at[TF_EVENTS][2];
    for (int i = 0; i < simplex->count; i++) {
        const tf_event *event = simplex->event[i];
        place_event(x, (int)event->x[0], event->t, at[i]);
    }
    tf_page_line(page, simplex->count, (const double(*)[2])at,
                 (tf_stroke){.paint = {.role = TF_ROLE_NEUTRAL},
                             .width = TF_WIDTH_TUBE});
    for (int i = 0; i < simplex->count; i++) {
        tf_role role = simplex->event[i]->t ? TF_ROLE_END : TF_ROLE_START;
        tf_page_dot(page, at[i][0], at[i][1], TF_WIDTH_BALL,
                    (tf_paint){.role = role});
    }
}

/// The staircases of an element, the last mover first, and count them; returns
/// where they end.
static double draw_element(tf_page *page, double x, int vertices,
                           const char *name, int *drawn)
{
    tf_worldline element[TF_VERTICES];
    tf_simplex sweep[TF_VERTICES];
    make_element(vertices, element);
    tf_sweep(vertices, element, sweep);
    double begin = x, width = (vertices - 1) * column;
    for (int i = 0; i < vertices; i++) {
        draw_events(page, x, vertices);
        draw_path(page, x, &sweep[i]);
        char text[16];
        snprintf(text, sizeof text, "$S_%d$", sweep[i].mover);
        tf_page_text(page, x + width / 2, first_top + row + 38, TF_ALIGN_CENTER,
                     text, TF_LETTERS, TF_ROLE_INK);
        x += width + gap;
        ++*drawn;
    }
    tf_page_text(page, (begin + x - gap) / 2, 12, TF_ALIGN_CENTER, name,
                 TF_LETTERS_SMALL, TF_ROLE_INK);
    return x;
}

static void draw(tf_page *page, FILE *numbers)
{
    double x = 16;
    int drawn = 0;
    x = draw_element(page, x, 1, "*point*", &drawn) + 10;
    x = draw_element(page, x, 2, "*edge*", &drawn) + 10;
    draw_element(page, x, 3, "*triangle*", &drawn);
    tf_figure_number(numbers, "staircases", drawn);
}

const tf_figure tf_figure_staircase = {
    .name = "staircase",
    .title = "The staircases of a point, an edge and a triangle",
    .width = TF_FIGURE_WIDTH,
    .height = 112,
    .draw = draw,
};
