// Projected Gauss-Seidel on a stack of edges, visit by visit: where the edges
// end, the impulses, and the kinetic energy.
#include "base/require.h"
#include "kit/figures.h"

#include "kit/film.h"
#include "kit/pile.h"
#include "renderer/plot.h"
#include "response/gauss_seidel.h"
#include "response/impulse.h"

#include <math.h>
#include <stdio.h>

enum {
    EDGES = 4,  ///< with the floor
    VISITS = 48 ///< of the whole film
};

/// Of the still.
static const double still = 40.0 / VISITS;

static const double place_of[EDGES][4] = {{-1.5, 0, 1.5, 0},
                                          {-0.74, 0.43, 0.94, 0.36},
                                          {-0.67, 0.84, 0.73, 0.69},
                                          {-0.74, 1.04, 0.96, 1.2}};
static const double displacement_of[EDGES][4] = {{0, 0, 0, 0},
                                                 {0.29, -0.6, 0.29, -0.69},
                                                 {0.34, -0.95, 0.34, -0.78},
                                                 {-0.3, -1.64, -0.3, -1.2}};

static const double left = 96, floor_y = 148, scale = 58, push_scale = 40;

static fig_pile make_stack(void)
{
    fig_pile pile = fig_pile_new(EDGES);
    for (int i = 0; i < EDGES; i++)
        fig_pile_put(&pile, i, place_of[i], displacement_of[i]);
    fig_pile_resolve(&pile, &tf_gauss_seidel, 60, 20);
    return pile;
}

/// Makes visits from impulses of zero; returns the row of the last one, or -1.
/// `energy` gets the kinetic energy before and after each.
static int make_visits(fig_some_zone *some, int visits,
                       double energy[VISITS + 1])
{
    fig_zone_reset(some);
    const tf_bodies bodies = {2, some->inverse_mass, some->displacement};
    energy[0] = fig_zone_energy(some);
    for (int i = 0; i < visits; i++) {
        tf_constraint_visit(&some->row[i % some->zone.constraints], 0, &bodies);
        energy[i + 1] = fig_zone_energy(some);
    }
    return visits > 0 ? (visits - 1) % some->zone.constraints : -1;
}

// The stack --------------------------------------------------------------

static fig_point on_page(const double at[2])
{
    return (fig_point){left + scale * at[0], floor_y - scale * at[1]};
}

static void draw_edges(fig_page *page, const fig_pile *pile,
                       const double displacement[], fig_stroke stroke,
                       bool dots)
{
    for (int i = 1; i < EDGES; i++) {
        fig_point end[2];
        for (int j = 0; j < 2; j++) {
            int v = 2 * i + j;
            double at[2];
            for (int k = 0; k < 2; k++)
                at[k] = pile->start[2 * v + k] + displacement[2 * v + k];
            end[j] = on_page(at);
        }
        fig_page_line(page, 2, end, stroke);
        for (int j = 0; j < 2 && dots; j++)
            fig_page_dot(page, end[j].x, end[j].y, 5, stroke.paint);
    }
}

/// The impulse of a row, at its vertex, as it is displaced.
static void draw_push(fig_page *page, const fig_pile *pile,
                      const fig_some_zone *some, const tf_constraint *row,
                      bool last)
{
    if (!(row->impulse > 0.005) && !last)
        return;
    double at[2], tip[2];
    for (int k = 0; k < 2; k++) {
        int place = 2 * row->vertex[0] + k;
        at[k] = pile->start[place] + some->displacement[place];
        tip[k] = at[k] + push_scale / scale * row->impulse * row->normal[k];
    }
    fig_role role = last ? FIG_ROLE_CONTACT : FIG_ROLE_POINT;
    fig_point arrow[] = {on_page(at), on_page(tip)};
    if (row->impulse > 0.005)
        fig_page_line(
            page, 2, arrow,
            (fig_stroke){.paint = {.role = role}, .width = 1.8, .arrow = true});
    fig_page_dot(page, arrow[0].x, arrow[0].y, 5.5, (fig_paint){.role = role});
}

static void draw_stack(fig_page *page, const fig_pile *pile,
                       const fig_some_zone *some, int last)
{
    static const double rest[4 * EDGES];
    draw_edges(page, pile, rest,
               (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL, .shade = -0.5},
                            .width = 1.6},
               false);
    draw_edges(page, pile, some->proposal,
               (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                            .width = FIG_WIDTH_LINE,
                            .dash = 3},
               false);
    draw_edges(
        page, pile, some->displacement,
        (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}, .width = FIG_WIDTH_TUBE},
        true);
    fig_point ends[] = {on_page(pile->start), on_page(pile->start + 2)};
    fig_page_line(page, 2, ends, (fig_stroke){.width = FIG_WIDTH_TUBE});
    for (int i = 0; i < some->zone.constraints; i++)
        if (i != last)
            draw_push(page, pile, some, &some->row[i], false);
    if (last >= 0)
        draw_push(page, pile, some, &some->row[last], true);
}

// The energy -------------------------------------------------------------

static void draw_energy(fig_page *page, int visits, int rows,
                        const double energy[])
{
    fig_plot plot = {.box = {232, 22, 142, 156},
                     .x = {0, VISITS},
                     .y = {0, 1},
                     .name_x = "visits",
                     .name_y = "kinetic energy"};
    fig_plot_frame(page, &plot);
    for (int i = rows; i < VISITS; i += rows) {
        fig_point sweep[] = {fig_plot_place(&plot, i, 0),
                             fig_plot_place(&plot, i, 1)};
        fig_page_line(page, 2, sweep,
                      (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL},
                                   .width = FIG_WIDTH_HAIR,
                                   .dash = 2});
    }
    fig_point at[VISITS + 1];
    for (int i = 0; i <= visits; i++)
        at[i] = (fig_point){i, energy[i] / energy[0]};
    if (visits > 0)
        fig_plot_curve(page, &plot, visits + 1, at,
                       (fig_stroke){.paint = {.role = FIG_ROLE_EDGE}});
    for (int i = 0; i <= visits; i++)
        fig_plot_dot(page, &plot, at[i].x, at[i].y, i == visits ? 5.5 : 2.6,
                     i == visits ? FIG_ROLE_CONTACT : FIG_ROLE_EDGE);
}

// Numbers ----------------------------------------------------------------

/// How many impulses were there after some visit and are zero in the end.
static int count_taken_back(fig_some_zone *some)
{
    double energy[VISITS + 1];
    int taken_back = 0;
    for (int row = 0; row < some->zone.constraints; row++) {
        double most = 0;
        for (int visits = row + 1; visits <= VISITS; visits++) {
            make_visits(some, visits, energy);
            most = fmax(most, some->row[row].impulse);
        }
        taken_back += most > 0.1 && !(some->row[row].impulse > 0);
    }
    return taken_back;
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_pile pile = make_stack();
    fig_some_zone some = fig_pile_zone(&pile, 0);
    fig_number(numbers, "rows", some.zone.constraints);
    fig_number(numbers, "rounds", pile.rounds);
    fig_number(numbers, "taken_back", count_taken_back(&some));
    double t = fig_film_time(page, numbers, still, -1), energy[VISITS + 1];
    make_visits(&some, VISITS, energy);
    for (int i = 0; i < VISITS; i++)
        TF_REQUIRE(energy[i + 1] <= energy[i] * (1 + 1e-12));
    int shown = (int)rint(still * VISITS), visits = (int)rint(t * VISITS);
    fig_number(numbers, "shown", shown);
    fig_number(numbers, "left", energy[shown] / energy[0]);
    int last = make_visits(&some, visits, energy);
    draw_stack(page, &pile, &some, last);
    draw_energy(page, visits, some.zone.constraints, energy);
    char text[32];
    snprintf(text, sizeof text, "visit %d", visits);
    fig_page_text(page, 8, 14, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_CONTACT);
    fig_some_zone_free(&some);
    fig_pile_free(&pile);
}

const fig_figure fig_gauss_seidel_sweeps = {
    .name = "gauss-seidel-sweeps",
    .title = "Projected Gauss-Seidel on a stack of edges, visit by visit",
    .width = FIG_PAGE_WIDTH,
    .height = 214,
    .moves = true,
    .draw = draw,
};
