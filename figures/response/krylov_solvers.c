// How fast iterations solve the equations of a zone in which rows are repeated,
// with the same right sides and with others.
#include "kit/figures.h"

#include "base/require.h"
#include "kit/pile.h"
#include "kit/random.h"
#include "renderer/plot.h"
#include "response/conjugate_residuals.h"
#include "response/equations.h"
#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "response/normal_residuals.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    EDGES = 13, ///< of the pile, with the floor
    EACH = 5,   ///< of this many rows one is repeated
    PRODUCTS = 100
};

static const double most_off = 0.1; ///< of the right side of a copy
static const double lowest = 1e-9, highest = 1e5;

static double between(uint64_t *random, double from, double to)
{
    return from + (to - from) * fig_random_number(random);
}

/// Edges on top of each other, each a little shifted and tilted, that fall.
static fig_pile make_pile(void)
{
    uint64_t random = 18;
    fig_pile pile = fig_pile_new(EDGES);
    for (int i = 0; i < EDGES; i++) {
        double half = i == 0 ? 3 : between(&random, 0.7, 1.3);
        double middle = i == 0 ? 0 : between(&random, -0.4, 0.4);
        double place[4], displacement[4] = {0};
        for (int j = 0; j < 2; j++) {
            place[(ptrdiff_t)2 * j] = middle + (j == 0 ? -half : half);
            place[2 * j + 1] =
                0.25 * i + (i == 0 ? 0 : between(&random, 0, 0.1));
            displacement[2 * j + 1] = -0.1 * i * between(&random, 0.5, 1.5);
        }
        fig_pile_put(&pile, i, place, displacement);
    }
    fig_pile_resolve(&pile, &tf_gauss_seidel, 60, 20);
    return pile;
}

/// Repeats each fifth row, its right side off by up to that part.
static void repeat_rows(fig_some_zone *some, double off)
{
    uint64_t random = 5;
    tf_zone *zone = &some->zone;
    double *parting = calloc((size_t)zone->constraints, sizeof *parting);
    TF_REQUIRE(parting);
    tf_zone_gap_changes(zone, some->proposal, parting);
    int rows = zone->constraints;
    for (int i = 0; i < rows; i += EACH) {
        tf_constraint *copy = &some->row[zone->constraints++];
        *copy = some->row[i];
        copy->bound += between(&random, -off, off) * (copy->bound - parting[i]);
    }
    free(parting);
}

// Residuals --------------------------------------------------------------

/// The equations of a zone, with what is left of each iterate.
typedef struct course {
    fig_some_zone *some;
    int count;         ///< of equations
    double *workspace; ///< of the zone
    double *best;      ///< the part of the right side that no impulses reach
    double length;     ///< of the right side
    fig_point at[PRODUCTS + 1];
    int points;
} course;

static double dot(int count, const double a[], const double b[])
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/// What the rows, scaled, are short of as displaced now.
static void find_residual(const course *c, double residual[])
{
    const tf_zone *zone = &c->some->zone;
    tf_zone_gap_changes(zone, zone->displacement, residual);
    for (int i = 0; i < c->count; i++) {
        double compliance = 0;
        const tf_constraint *row = &zone->constraint[i];
        for (int j = 0; j < 4 && row->vertex[j] >= 0; j++)
            compliance += zone->inverse_mass[row->vertex[j]] *
                          row->coefficient[j] * row->coefficient[j];
        residual[i] = (row->bound - residual[i]) / sqrt(compliance);
    }
}

/// Sets `effect` to what a displacement of one vertex along an axis does to the
/// rows, scaled.
static void find_effect(const course *c, int number, double effect[])
{
    tf_zone *zone = &c->some->zone;
    find_residual(c, effect);
    zone->displacement[number]++;
    double *after = calloc((size_t)c->count, sizeof *after);
    TF_REQUIRE(after);
    find_residual(c, after);
    for (int i = 0; i < c->count; i++)
        effect[i] -= after[i];
    free(after);
    zone->displacement[number]--;
}

/// Takes from `best` all that displacements reach: they are made orthogonal to
/// each other one by one.
static void find_best(course *c)
{
    const tf_zone *zone = &c->some->zone;
    int n = c->count, numbers = zone->axes * zone->vertices, rank = 0;
    double *basis = calloc((size_t)n * (size_t)numbers, sizeof *basis);
    TF_REQUIRE(basis);
    for (int i = 0; i < numbers; i++) {
        double *next = basis + (ptrdiff_t)n * rank;
        if (!(zone->inverse_mass[i / zone->axes] > 0))
            continue;
        find_effect(c, i, next);
        for (int times = 0; times < 2; times++)
            for (int j = 0; j < rank; j++) {
                const double *old = basis + (ptrdiff_t)n * j;
                double part = dot(n, old, next);
                for (int k = 0; k < n; k++)
                    next[k] -= part * old[k];
            }
        double size = sqrt(dot(n, next, next));
        if (size < 1e-9)
            continue;
        for (int k = 0; k < n; k++)
            next[k] /= size;
        double part = dot(n, next, c->best);
        for (int k = 0; k < n; k++)
            c->best[k] -= part * next[k];
        rank++;
    }
    free(basis);
}

static course begin(fig_some_zone *some)
{
    const tf_zone *zone = &some->zone;
    course c = {.some = some, .count = zone->constraints};
    c.workspace =
        calloc(tf_equations_workspace(2, zone->vertices, zone->constraints, 8),
               sizeof *c.workspace);
    c.best = calloc((size_t)c.count, sizeof *c.best);
    TF_REQUIRE(c.workspace && c.best);
    some->zone.workspace = c.workspace;
    fig_zone_reset(some);
    find_residual(&c, c.best);
    c.length = sqrt(dot(c.count, c.best, c.best));
    find_best(&c);
    return c;
}

static void end(course *c)
{
    free(c->workspace);
    free(c->best);
}

/// Notes how far the residual is from the best one, in parts of the right side.
static void note(course *c, int products, const double residual[])
{
    double sum = 0;
    for (int i = 0; i < c->count; i++)
        sum += (residual[i] - c->best[i]) * (residual[i] - c->best[i]);
    double distance = sqrt(sum) / c->length;
    if (c->points <= PRODUCTS && isfinite(distance))
        c->at[c->points++] = (fig_point){products, fmax(distance, lowest / 9)};
}

// Solvers ----------------------------------------------------------------

/// A solver of the library, as many times as it has iterates.
static void follow(course *c, const tf_zone_solver *solver, int products)
{
    double *residual = calloc((size_t)c->count, sizeof *residual);
    TF_REQUIRE(residual);
    c->points = 0;
    for (int i = 0; i * products <= PRODUCTS; i++) {
        fig_zone_reset(c->some);
        c->some->zone.sweeps = i;
        int iterations = i == 0 ? 0 : solver->solve(&c->some->zone);
        if (iterations < i)
            break;
        find_residual(c, residual);
        note(c, i * products, residual);
    }
    free(residual);
}

/// Conjugate gradients, which the library does not have.
static void follow_gradients(course *c)
{
    enum {
        SOLUTION,
        RESIDUAL,
        DIRECTION,
        IMAGE,
        VECTORS
    };
    double *vector[VECTORS];
    fig_zone_reset(c->some);
    tf_equations e = tf_equations_of(&c->some->zone, VECTORS, vector);
    double *residual = vector[RESIDUAL], *direction = vector[DIRECTION];
    tf_equations_start(&e, vector[SOLUTION], residual);
    memcpy(direction, residual, sizeof *residual * (size_t)c->count);
    double square = tf_equations_dot(&e, residual, residual);
    c->points = 0;
    note(c, 0, residual);
    for (int i = 1; i <= PRODUCTS; i++) {
        tf_equations_multiply(&e, direction, vector[IMAGE]);
        double step = square / tf_equations_dot(&e, direction, vector[IMAGE]);
        tf_equations_add(&e, residual, -step, vector[IMAGE], residual);
        note(c, i, residual);
        double before = square;
        square = tf_equations_dot(&e, residual, residual);
        if (!(c->at[c->points - 1].y > lowest))
            break;
        tf_equations_add(&e, residual, square / before, direction, direction);
    }
}

// The picture ------------------------------------------------------------

static void draw_course(fig_page *page, const fig_plot *plot, const course *c,
                        fig_role role)
{
    fig_plot_curve(page, plot, c->points, c->at,
                   (fig_stroke){.paint = {.role = role}, .width = 1.5});
}

static double extreme(const course *c, bool largest)
{
    double found = c->at[0].y;
    for (int i = 1; i < c->points; i++)
        found = largest ? fmax(found, c->at[i].y) : fmin(found, c->at[i].y);
    return found;
}

/// After how many products the distance is below 1e-6.
static double products_of(course *c, const tf_zone_solver *solver, int products)
{
    enum {
        MOST = 10000
    };
    double *residual = calloc((size_t)c->count, sizeof *residual);
    TF_REQUIRE(residual);
    for (c->some->zone.sweeps = 1; c->some->zone.sweeps < MOST;
         c->some->zone.sweeps++) {
        c->points = 0;
        fig_zone_reset(c->some);
        solver->solve(&c->some->zone);
        find_residual(c, residual);
        note(c, 0, residual);
        if (c->at[0].y < 1e-6)
            break;
    }
    free(residual);
    return products * c->some->zone.sweeps;
}

static void draw_side(fig_page *page, const fig_pile *pile, bool off,
                      FILE *numbers)
{
    fig_plot plot = {.box = {off ? 230 : 42, 40, 146, 150},
                     .x = {0, PRODUCTS},
                     .y = {lowest, highest},
                     .log_y = true,
                     .name_x = "products",
                     .name_y = off ? NULL : "distance"};
    fig_plot_frame(page, &plot);
    fig_page_text(page, plot.box.x + plot.box.width / 2, plot.box.y - 8,
                  FIG_ALIGN_CENTER,
                  off ? "*copies that differ*" : "*copies that agree*",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    fig_some_zone some = fig_pile_zone(pile, pile->zones.constraints);
    repeat_rows(&some, off ? most_off : 0);
    course c = begin(&some);
    follow(&c, &tf_normal_residuals, 2);
    draw_course(page, &plot, &c, FIG_ROLE_TRIANGLE);
    fig_number(numbers, off ? "normal_left_off" : "normal_left",
               c.at[c.points - 1].y);
    if (!off)
        fig_number(numbers, "normal_products",
                   products_of(&c, &tf_normal_residuals, 2));
    follow_gradients(&c);
    draw_course(page, &plot, &c, FIG_ROLE_CONTACT);
    if (off) {
        fig_number(numbers, "gradients_best", extreme(&c, false));
        fig_number(numbers, "gradients_worst", extreme(&c, true));
        fig_number(numbers, "floor",
                   sqrt(dot(c.count, c.best, c.best)) / c.length);
    }
    follow(&c, &tf_conjugate_residuals, 1);
    draw_course(page, &plot, &c, FIG_ROLE_EDGE);
    fig_number(numbers, off ? "residuals_off" : "residuals_products",
               products_of(&c, &tf_conjugate_residuals, 1));
    fig_number(numbers, off ? "minres_off" : "minres_products",
               products_of(&c, &tf_minres, 1));
    if (off) {
        fig_number(numbers, "rows", some.zone.constraints);
        fig_number(numbers, "rank", fig_zone_rank(&some.zone));
    }
    end(&c);
    fig_some_zone_free(&some);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_pile pile = make_pile();
    draw_side(page, &pile, false, numbers);
    draw_side(page, &pile, true, numbers);
    fig_number(numbers, "edges", EDGES - 1);
    fig_number(numbers, "rounds", pile.rounds);
    fig_number(numbers, "different_rows", pile.zones.constraints);
    fig_pile_free(&pile);
    fig_plot_key(page, 40, 12, "conjugate gradients", FIG_ROLE_CONTACT);
    fig_plot_key(page, 152, 12, "conjugate residuals", FIG_ROLE_EDGE);
    fig_plot_key(page, 264, 12, "normal equations", FIG_ROLE_TRIANGLE);
}

const fig_figure fig_krylov_solvers = {
    .name = "krylov-solvers",
    .title = "Krylov solvers of a zone's equations, with copies of rows",
    .width = FIG_PAGE_WIDTH,
    .height = 228,
    .draw = draw,
};
