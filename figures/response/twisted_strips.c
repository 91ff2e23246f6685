// A strip whose ends are turned, without a response and with one.
#include "base/require.h"
#include "kit/cloth_run.h"
#include "kit/figures.h"
#include "kit/film.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIZE = 10,
    EVERY = 12, ///< steps from frame to frame
    STEPS = 48 * EVERY,
    STRIPS = 2
};

/// How far above the other one the upper strip is drawn.
static const double apart = 0.26;

static const double still = 0.875;

/// Both strips as one surface: first the one that nothing looks after.
typedef struct pair {
    const fig_cloth_run *run[STRIPS];
    tf_surface *surface;
    fig_cloth *cloth;
} pair;

// Running ----------------------------------------------------------------

static tf_surface *surface_of_both(const tf_body *body)
{
    size_t corners = 3 * (size_t)body->triangles;
    int *triangle = malloc(sizeof *triangle * corners * STRIPS);
    TF_REQUIRE(triangle);
    for (size_t i = 0; i < corners; i++) {
        triangle[i] = body->triangle[i];
        triangle[corners + i] = body->triangle[i] + body->vertices;
    }
    const tf_mesh mesh = {.axes = 3,
                          .vertices = STRIPS * body->vertices,
                          .triangles = STRIPS * body->triangles,
                          .triangle = triangle};
    tf_surface *surface;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    free(triangle);
    return surface;
}

static void add_frame(const pair *both, int step, double x[])
{
    size_t numbers = 3 * (size_t)both->run[0]->vertices;
    for (size_t k = 0; k < STRIPS; k++) {
        double *to = x + k * numbers;
        memcpy(to, fig_cloth_run_at(both->run[k], step), sizeof *x * numbers);
        for (size_t i = 2; i < numbers && k == 0; i += 3)
            to[i] += apart;
    }
    TF_REQUIRE(fig_cloth_add(both->cloth, STRIPS * both->run[0]->vertices, x));
}

static pair *run_both(void)
{
    pair *both = malloc(sizeof *both);
    TF_REQUIRE(both);
    for (int k = 0; k < STRIPS; k++)
        both->run[k] = fig_cloth_run_of(&(fig_cloth_plan){.scene = "twist",
                                                          .size = SIZE,
                                                          .steps = STEPS,
                                                          .unresolved = k == 0,
                                                          .check = EVERY});
    both->surface = surface_of_both(&both->run[0]->simulation->base.setup.body);
    both->cloth = fig_cloth_new(both->surface, 3);
    double *x = malloc(sizeof *x * 3 * STRIPS * (size_t)both->run[0]->vertices);
    TF_REQUIRE(x && both->cloth);
    for (int i = 0; i <= STEPS; i += EVERY)
        add_frame(both, i, x);
    TF_REQUIRE(fig_cloth_end(both->cloth));
    free(x);
    return both;
}

/// All frames of a film show the same run.
static const pair *the_pair(void)
{
    static pair *kept;
    if (!kept)
        kept = run_both();
    return kept;
}

// Drawing ----------------------------------------------------------------

static void write_count(fig_page *page, double y, const char *which, int count)
{
    char text[80];
    snprintf(text, sizeof text, "%s: %d intersection%s", which, count,
             count == 1 ? "" : "s");
    fig_page_text(page, 8, y, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  count > 0 ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
}

static int first_crossing(const fig_cloth_run *run)
{
    for (int i = 0; i <= run->steps; i++)
        if (run->step[i].crossings > 0)
            return i;
    return -1;
}

static void print_numbers(FILE *numbers, const pair *both, int step)
{
    int most = 0;
    for (int i = 0; i <= STEPS; i++)
        most += both->run[1]->step[i].crossings;
    fig_number(numbers, "step", step);
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "first_crossing", first_crossing(both->run[0]));
    fig_number(numbers, "crossings", both->run[0]->step[step].crossings);
    fig_number(numbers, "crossings_resolved", most);
    fig_number(numbers, "triangles",
               both->run[0]->simulation->base.setup.body.triangles);
}

static void draw(fig_page *page, FILE *numbers)
{
    const pair *both = the_pair();
    double t = fig_film_time(page, numbers, still, -1);
    int frame = (int)lround(t * STEPS / EVERY), step = EVERY * frame;
    double width = fig_page_width(page), height = fig_page_height(page);
    // No larger than it must be: a film weighs as much as what changes in it.
    fig_box box = {45, 18, width - 90, height - 36};
    fig_cloth_draw(
        both->cloth, page, box, frame,
        &(fig_cloth_look){
            .turned = true, .azimuth = 0, .elevation = 12, .groundless = true});
    write_count(page, 16, "without response",
                both->run[0]->step[step].crossings);
    write_count(page, height - 10, "with response",
                both->run[1]->step[step].crossings);
    print_numbers(numbers, both, step);
}

const fig_figure fig_twisted_strips = {
    .name = "twisted-strips",
    .title = "A strip that is twisted, without a response and with one",
    .width = FIG_PAGE_WIDTH,
    .height = 210,
    .moves = true,
    .draw = draw,
};
