#include "kit/flow_film.h"

#include "kit/film.h"

#include <math.h>

static void print_numbers(const fig_flow_film *film, FILE *numbers)
{
    const fig_flow_run *run = film->run;
    const tf_flow_measures *last = &run->frame[run->frames - 1].measures;
    fig_number(numbers, "edge", film->plan.edge);
    fig_number(numbers, "steps", film->plan.steps);
    fig_number(numbers, "merge", run->first[TF_MERGE]);
    fig_number(numbers, "pinch", run->first[TF_PINCH]);
    fig_number(numbers, "triangles", last->triangles);
    fig_number(numbers, "parts", last->components);
}

void fig_flow_film_draw(fig_flow_film *film, fig_page *page, fig_box box,
                        FILE *numbers)
{
    if (!film->cloth) {
        film->run = fig_flow_run_new(&film->plan);
        film->cloth = fig_flow_run_films(1, &film->run);
    }
    double t = fig_film_time(page, numbers, film->still, -1);
    int frame = (int)lround(t * (film->run->frames - 1));
    fig_cloth_draw(film->cloth[frame], page, box, 0, &film->look);
    print_numbers(film, numbers);
}
