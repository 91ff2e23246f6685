#include "kit/cloth_stills.h"

#include "renderer/figure.h"

static void print_still(FILE *numbers, const fig_cloth_still *still,
                        const fig_cloth_run *run)
{
    char key[64];
    const char *scene = still->plan.scene;
    snprintf(key, sizeof key, "step_%s", scene);
    fig_number(numbers, key, still->plan.steps);
    snprintf(key, sizeof key, "triangles_%s", scene);
    fig_number(numbers, key, run->simulation->base.setup.body.triangles);
}

static void draw_still(fig_page *page, FILE *numbers, fig_box box,
                       const fig_cloth_still *still)
{
    const fig_cloth_run *run = fig_cloth_run_of(&still->plan);
    fig_cloth *cloth = fig_cloth_run_film(run, still->first, 1);
    fig_cloth_draw(cloth, page, box, fig_cloth_frames(cloth) - 1, &still->look);
    fig_page_caption(page, box, still->plan.scene);
    print_still(numbers, still, run);
    fig_cloth_free(cloth);
}

void fig_draw_stills(fig_page *page, FILE *numbers, int count,
                     const fig_cloth_still still[])
{
    double width = fig_page_width(page) / count;
    for (int i = 0; i < count; i++)
        draw_still(page, numbers,
                   (fig_box){width * i, 0, width, fig_page_height(page) - 16},
                   &still[i]);
}
