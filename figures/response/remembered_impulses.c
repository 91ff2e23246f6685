// Two stones hit a plate from below.  Impulses push the slow one back before
// the fast one carries the plate away; with a memory that push is taken back.
#include "kit/figures.h"

#include "renderer/plot.h"
#include "response/impulse.h"

#include <string.h>

enum {
    BODIES = 3, ///< the slow stone, the fast one, the plate
    ROWS = 2,
    VISITS = 6
};

static const double proposed[BODIES] = {1, 3, 0};

/// The displacements after each visit; the rows take turns.
typedef struct history {
    double at[VISITS + 1][BODIES];
    double impulse[ROWS];
} history;

static history visit_rows(bool remember)
{
    const double inverse_mass[BODIES] = {1, 1, 1};
    double move[2 * BODIES] = {0};
    tf_constraint row[ROWS];
    for (int i = 0; i < BODIES; i++)
        move[2 * i + 1] = proposed[i];
    for (int i = 0; i < ROWS; i++)
        row[i] = (tf_constraint){
            .vertex = {2, i, -1, -1}, .coefficient = {1, -1}, .normal = {0, 1}};
    history h = {{{0}}, {0}};
    memcpy(h.at[0], proposed, sizeof proposed);
    for (int visit = 1; visit <= VISITS; visit++) {
        tf_constraint *now = &row[(visit - 1) % ROWS];
        if (!remember)
            now->impulse = 0;
        tf_constraint_visit(now, 0, &(tf_bodies){2, inverse_mass, move});
        for (int i = 0; i < BODIES; i++)
            h.at[visit][i] = move[2 * i + 1];
    }
    for (int i = 0; i < ROWS; i++)
        h.impulse[i] = row[i].impulse;
    return h;
}

// Drawing ----------------------------------------------------------------

static const fig_role role[BODIES] = {FIG_ROLE_POINT, FIG_ROLE_NEUTRAL,
                                      FIG_ROLE_EDGE};

static void draw_body(fig_page *page, const fig_plot *plot, const history *h,
                      int body)
{
    static const char *const name[BODIES] = {"slow stone", "fast stone",
                                             "plate"};
    // The plate is drawn upon the fast stone, with which it ends.
    double width = body == 1 ? 3 : 1.4;
    fig_point at[VISITS + 1];
    for (int i = 0; i <= VISITS; i++)
        at[i] = (fig_point){i, h->at[i][body]};
    fig_plot_curve(page, plot, VISITS + 1, at,
                   (fig_stroke){.paint = {.role = role[body]}, .width = width});
    for (int i = 0; i <= VISITS; i++)
        fig_plot_dot(page, plot, at[i].x, at[i].y, width + 1.9, role[body]);
    // The fast stone is named where it is alone, the others at the end.
    fig_point name_at = body == 1 ? fig_plot_place(plot, 1, at[1].y)
                                  : fig_plot_place(plot, VISITS, at[VISITS].y);
    fig_page_text(page, name_at.x + (body == 1 ? 8 : 0),
                  name_at.y + (body == 1   ? 3
                               : body == 2 ? -6
                                           : 13),
                  body == 1 ? FIG_ALIGN_LEFT : FIG_ALIGN_RIGHT, name[body],
                  FIG_LETTERS_SMALL, role[body]);
}

static void draw_history(fig_page *page, fig_box box, const history *h,
                         const char *title, const char *name_y)
{
    fig_plot plot = {.box = box,
                     .x = {-0.4, VISITS + 0.4},
                     .y = {-0.2, 3.3},
                     .name_x = "visits",
                     .name_y = name_y,
                     .ticks_x = 4,
                     .ticks_y = 4};
    fig_plot_frame(page, &plot);
    fig_page_text(page, box.x + box.width / 2, box.y - 4, FIG_ALIGN_CENTER,
                  title, FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int i = 0; i < BODIES; i++)
        draw_body(page, &plot, h, i);
}

static void print_numbers(FILE *numbers, const char *scene, const history *h)
{
    static const char *const name[BODIES] = {"slow", "fast", "plate"};
    for (int i = 0; i < BODIES; i++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%s", name[i], scene);
        fig_number(numbers, key, h->at[VISITS][i]);
        snprintf(key, sizeof key, "%s_%s_first", name[i], scene);
        fig_number(numbers, key, h->at[1][i]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    double left = 36, width = (fig_page_width(page) - left - 34) / 2;
    double height = fig_page_height(page) - 54;
    history loop = visit_rows(false), memory = visit_rows(true);
    draw_history(page, (fig_box){left, 16, width, height}, &loop,
                 "*impulses are final*", "displacement");
    draw_history(page, (fig_box){left + width + 30, 16, width, height}, &memory,
                 "*impulses are remembered*", NULL);
    print_numbers(numbers, "loop", &loop);
    print_numbers(numbers, "memory", &memory);
}

const fig_figure fig_remembered_impulses = {
    .name = "remembered-impulses",
    .title = "Impulses that are final, and impulses that are remembered",
    .width = FIG_PAGE_WIDTH,
    .height = 184,
    .draw = draw,
};
