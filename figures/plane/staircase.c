// The events that each simplex of a sweep has, as paths that climb one step.
#include "kit/figures.h"

#include "geometry/sweep.h"

static const double column = 24, row = 30, first_top = 34, gap = 28;

/// An event's place in a diagram that begins at `x`.
static fig_point place_event(double x, int vertex, int t)
{
    return (fig_point){x + vertex * column, first_top + (1 - t) * row};
}

/// An element that tells of each event whose it is.
static void make_element(int vertices, tf_worldline element[])
{
    for (int i = 0; i < vertices; i++)
        element[i] =
            tf_worldline_between(2, (double[]){i, 0}, (double[]){i, 0});
}

/// All events of an element, pale where the simplex does not have them.
static void draw_events(fig_page *page, double x, int vertices)
{
    for (int i = 0; i < vertices; i++)
        for (int t = 0; t < 2; t++) {
            fig_point at = place_event(x, i, t);
            fig_page_dot(page, at.x, at.y, 4.5,
                         (fig_paint){.role = FIG_ROLE_NEUTRAL, .shade = -0.5});
            char name[16];
            snprintf(name, sizeof name, "$v_%d%s$", i, t ? "'" : "");
            fig_page_text(page, at.x, at.y + (t ? -8 : 16), FIG_ALIGN_CENTER,
                          name, FIG_LETTERS_SMALL, FIG_ROLE_INK);
        }
}

/// The path of a simplex through its events.
static void draw_path(fig_page *page, double x, const tf_simplex *simplex)
{
    fig_point at[TF_EVENTS];
    for (int i = 0; i < simplex->count; i++) {
        const tf_event *event = simplex->event[i];
        at[i] = place_event(x, (int)event->x[0], event->t);
    }
    fig_page_line(page, simplex->count, at,
                  (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                               .width = FIG_WIDTH_TUBE});
    for (int i = 0; i < simplex->count; i++) {
        fig_role role = simplex->event[i]->t ? FIG_ROLE_END : FIG_ROLE_START;
        fig_page_dot(page, at[i].x, at[i].y, FIG_WIDTH_BALL,
                     (fig_paint){.role = role});
    }
}

/// The staircases of an element, the last pivot first, and count them; returns
/// where they end.
static double draw_element(fig_page *page, double x, int vertices,
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
        snprintf(text, sizeof text, "$S_%d$", sweep[i].pivot);
        fig_page_text(page, x + width / 2, first_top + row + 38,
                      FIG_ALIGN_CENTER, text, FIG_LETTERS, FIG_ROLE_INK);
        x += width + gap;
        ++*drawn;
    }
    fig_page_text(page, (begin + x - gap) / 2, 12, FIG_ALIGN_CENTER, name,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    return x;
}

static void draw(fig_page *page, FILE *numbers)
{
    double x = 16;
    int drawn = 0;
    x = draw_element(page, x, 1, "*point*", &drawn) + 10;
    x = draw_element(page, x, 2, "*edge*", &drawn) + 10;
    draw_element(page, x, 3, "*triangle*", &drawn);
    fig_number(numbers, "staircases", drawn);
}

const fig_figure fig_staircase = {
    .name = "staircase",
    .title = "The staircases of a point, an edge and a triangle",
    .width = FIG_PAGE_WIDTH,
    .height = 112,
    .draw = draw,
};
