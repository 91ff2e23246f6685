#include "kit/film.h"

#include <math.h>

double fig_film_time(const fig_page *page, FILE *numbers, double still,
                     double event)
{
    fig_number(numbers, "film_still", still);
    if (!fig_page_moves(page))
        return still;
    double t = fig_page_time(page), last = FIG_FILM_FRAMES - 1;
    return rint(t * last) == rint(event * last) ? event : t;
}

/// A short upright line across the line of time.
static void draw_tick(fig_page *page, double x, double y, double half,
                      fig_stroke stroke)
{
    fig_point at[] = {{x, y - half}, {x, y + half}};
    fig_page_line(page, 2, at, stroke);
}

void fig_film_clock(fig_page *page, double x, double y, double width, double t,
                    double event, const char *name)
{
    const double letters = 46, left = x + letters, length = width - letters - 2;
    const fig_stroke thin = {.paint = {.role = FIG_ROLE_NEUTRAL},
                             .width = FIG_WIDTH_THIN};
    char text[32];
    snprintf(text, sizeof text, "$t = %.2f$", t);
    fig_page_text(page, x, y + 3, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    fig_page_line(page, 2, (fig_point[]){{left, y}, {left + length, y}}, thin);
    for (int i = 0; i <= 4; i++)
        draw_tick(page, left + i * length / 4, y, i % 4 == 0 ? 4 : 2.5, thin);
    if (event >= 0 && t >= event) {
        double middle = left + event * length;
        fig_page_dot(page, middle, y, FIG_WIDTH_BALL,
                     (fig_paint){.role = FIG_ROLE_CONTACT});
        fig_page_text(page, middle, y - 8, FIG_ALIGN_CENTER, name,
                      FIG_LETTERS_SMALL, FIG_ROLE_CONTACT);
    }
    draw_tick(page, left + t * length, y, 5, (fig_stroke){.width = 1.8});
}

void fig_film_name(fig_page *page, const fig_panel *panel, tf_vector at,
                   double dx, double dy, const char *text, fig_role role)
{
    if (fig_page_is_bare(page))
        return;
    fig_point place = fig_panel_project(panel, at);
    fig_page_text(page, place.x + dx, place.y + dy + 3, FIG_ALIGN_CENTER, text,
                  FIG_LETTERS_SMALL, role);
}
