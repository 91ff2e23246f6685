#include "renderer/page.h"

#include "base/require.h"
#include "renderer/list.h"
#include "renderer/page_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool good_size(int pixels)
{
    return pixels >= FIG_PIXELS_LEAST && pixels <= FIG_PIXELS_MOST;
}

fig_status fig_page_new(const fig_page_options *options, fig_page **page)
{
    TF_REQUIRE(options->width > 0 && options->height > 0);
    TF_REQUIRE(options->time >= 0 && options->time <= 1);
    *page = NULL;
    const char *family =
        options->family != NULL ? options->family : FIG_LETTERS_FAMILY;
    if (!good_size(options->pixels_x) || !good_size(options->pixels_y))
        return FIG_BAD_SIZE;
    if (!fig_letters_known(family))
        return FIG_NO_FONT;
    fig_page *made = calloc(1, sizeof *made);
    if (made == NULL)
        return FIG_NO_MEMORY;
    made->options = *options;
    made->shown = made->content =
        (fig_box){0, 0, options->width, options->height};
    if (options->theme == NULL)
        made->options.theme = &fig_theme_light;
    made->family = fig_list_copy(family, (int)strlen(family) + 1, 1);
    if (made->family == NULL) {
        free(made);
        return FIG_NO_MEMORY;
    }
    *page = made;
    return FIG_OK;
}

void fig_mark_clear(fig_mark *mark)
{
    free(mark->at);
    if (mark->map != NULL)
        cairo_surface_destroy(mark->map);
    fig_letters_free(mark->letters);
}

void fig_page_free(fig_page *page)
{
    if (page == NULL)
        return;
    for (int i = 0; i < page->mark_count; i++)
        fig_mark_clear(&page->marks[i]);
    for (int i = 0; i < page->tag_count; i++)
        fig_letters_free(page->tags[i].letters);
    for (int i = 0; i < page->panel_count; i++) {
        fig_scene_clear(&page->panels[i]->scene);
        free(page->panels[i]);
    }
    free(page->marks);
    free(page->tags);
    free(page->panels);
    free(page->plots);
    fig_letters_free(page->heading);
    free(page->family);
    free(page);
}

double fig_page_width(const fig_page *page)
{
    return page->options.width;
}

double fig_page_height(const fig_page *page)
{
    return page->options.height;
}

const fig_theme *fig_page_theme(const fig_page *page)
{
    return page->options.theme;
}

bool fig_page_moves(const fig_page *page)
{
    return page->options.moves;
}

double fig_page_time(const fig_page *page)
{
    return page->options.time;
}

bool fig_page_is_bare(const fig_page *page)
{
    return page->options.bare;
}

void fig_page_note(fig_page *page, fig_status status)
{
    if (page->trouble == FIG_OK)
        page->trouble = status;
}

fig_mark *fig_page_add_mark(fig_page *page, fig_mark mark)
{
    if (!fig_list_room(&page->marks, page->mark_count, 1, &page->mark_room,
                       sizeof *page->marks)) {
        fig_page_note(page, FIG_NO_MEMORY);
        fig_mark_clear(&mark);
        return NULL;
    }
    page->marks[page->mark_count] = mark;
    return &page->marks[page->mark_count++];
}

void fig_page_add_plot(fig_page *page, fig_box box)
{
    if (fig_list_room(&page->plots, page->plot_count, 1, &page->plot_room,
                      sizeof *page->plots))
        page->plots[page->plot_count++] = box;
    else
        fig_page_note(page, FIG_NO_MEMORY);
}

fig_letters *fig_page_letters(fig_page *page, const char *text, double size)
{
    fig_letters *letters;
    fig_status status = fig_letters_set(
        page->family, text, size > 0 ? size : FIG_LETTERS, &letters);
    if (status != FIG_OK)
        fig_page_note(page, status);
    return letters;
}

fig_raster fig_page_raster(const fig_page *page)
{
    const fig_page_options *o = &page->options;
    fig_raster raster = {.pixels_x = o->pixels_x, .pixels_y = o->pixels_y};
    const fig_box *box = &page->shown;
    raster.scale = fmin(o->pixels_x / box->width, o->pixels_y / box->height);
    raster.shift_x = (int)((o->pixels_x - raster.scale * box->width) / 2 -
                           raster.scale * box->x);
    raster.shift_y = (int)((o->pixels_y - raster.scale * box->height) / 2 -
                           raster.scale * box->y);
    return raster;
}

int fig_page_labels(const fig_page *page)
{
    return page->tag_count;
}

fig_placed fig_page_placed(const fig_page *page, int i)
{
    TF_REQUIRE(i >= 0 && i < page->tag_count);
    return page->tags[i].placed;
}
