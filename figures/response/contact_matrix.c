// Three edges of equal length that fall straight onto a floor, and the matrix
// of their contacts.
#include "kit/figures.h"

#include "kit/pile.h"
#include "response/gauss_seidel.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

enum {
    EDGES = 4 // with the floor
};

static const double half = 1, apart = 0.3, floor_half = 1.5;
static const double scale = 92; ///< of heights and displacements
static const double fall[EDGES] = {0, 0.6, 0.95, 1.3};

static fig_pile make_stack(void)
{
    fig_pile pile = fig_pile_new(EDGES);
    for (int i = 0; i < EDGES; i++) {
        double x = i == 0 ? floor_half : half, y = i * apart;
        const double place[4] = {-x, y, x, y};
        const double displacement[4] = {0, -fall[i], 0, -fall[i]};
        fig_pile_put(&pile, i, place, displacement);
    }
    return pile;
}

// The edges --------------------------------------------------------------

static fig_point place(const double at[2])
{
    return (fig_point){84 + 46 * at[0], 136 - scale * at[1]};
}

static void draw_edges(fig_page *page, const fig_pile *pile)
{
    for (int i = 0; i < EDGES; i++) {
        fig_point end[2];
        for (int j = 0; j < 2; j++)
            end[j] = place(pile->start + (ptrdiff_t)2 * (2 * i + j));
        fig_role role = i == 0 ? FIG_ROLE_INK : FIG_ROLE_EDGE;
        fig_page_line(
            page, 2, end,
            (fig_stroke){.paint = {.role = role}, .width = FIG_WIDTH_TUBE});
        for (int j = 0; j < 2; j++)
            fig_page_dot(page, end[j].x, end[j].y, 5.5,
                         (fig_paint){.role = role});
        fig_point inner = {end[0].x + 12 * i - 4, end[0].y};
        for (int j = 0; j < 2 && i > 0; j++) {
            fig_point arrow[] = {inner, {inner.x, inner.y + scale * fall[i]}};
            fig_page_line(page, 2, arrow,
                          (fig_stroke){.paint = {.role = FIG_ROLE_POINT},
                                       .width = FIG_WIDTH_LINE,
                                       .arrow = true});
            inner.x = end[1].x - (12 * i - 4);
        }
    }
    fig_point below = place((double[]){1.35, 0});
    fig_page_text(page, below.x, below.y + 15, FIG_ALIGN_CENTER, "floor",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

// The matrix -------------------------------------------------------------

/// Whether a row is about the left ends.
static bool is_left(const tf_constraint *row)
{
    return row->vertex[0] % 2 == 0;
}

/// The rows by sides, and then by pairs of heights.
static int compare(const void *a, const void *b)
{
    const tf_constraint *row[] = {a, b};
    int key[2];
    for (int i = 0; i < 2; i++) {
        int low = row[i]->vertex[1] / 2, high = row[i]->vertex[0] / 2;
        if (low > high) {
            int swapped = low;
            low = high;
            high = swapped;
        }
        key[i] = 100 * !is_left(row[i]) + 10 * low + high;
    }
    return key[0] - key[1];
}

static void draw_matrix(fig_page *page, fig_some_zone *some)
{
    const int n = some->zone.constraints;
    qsort(some->row, (size_t)n, sizeof *some->row, compare);
    double *entry = fig_zone_matrix(&some->zone);
    const fig_box box = {186, 12, 188, 188};
    double side = box.width / n;
    fig_page_fill_box(page, box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double x = entry[n * i + j];
            if (fabs(x) < 1e-9)
                continue;
            fig_page_fill_box(page,
                              (fig_box){box.x + j * side + 0.5,
                                        box.y + i * side + 0.5, side - 1,
                                        side - 1},
                              (fig_paint){.role = x > 0 ? FIG_ROLE_POSITIVE
                                                        : FIG_ROLE_NEGATIVE,
                                          .opacity = 0.3 + 0.35 * fabs(x)});
        }
    free(entry);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_pile pile = make_stack();
    fig_pile_resolve(&pile, &tf_gauss_seidel, 60, 1);
    fig_some_zone some = fig_pile_zone(&pile, 0);
    fig_number(numbers, "rows", some.zone.constraints);
    fig_number(numbers, "zones", pile.zones_solved);
    fig_number(numbers, "rank", fig_zone_rank(&some.zone));
    draw_edges(page, &pile);
    draw_matrix(page, &some);
    fig_some_zone_free(&some);
    fig_pile_free(&pile);
}

const fig_figure fig_contact_matrix = {
    .name = "contact-matrix",
    .title = "Edges that fall on a floor, and the matrix of contacts",
    .width = FIG_PAGE_WIDTH,
    .height = 212,
    .draw = draw,
};
