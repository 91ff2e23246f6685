#include "stage/page.h"

#include "contract.h"
#include "stage/list.h"
#include "stage/page_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool good_size(int pixels)
{
    return pixels >= TF_PIXELS_LEAST && pixels <= TF_PIXELS_MOST;
}

tf_stage_status tf_page_new(const tf_page_options *options, tf_page **page)
{
    TF_REQUIRE(options->width > 0 && options->height > 0);
    TF_REQUIRE(options->time >= 0 && options->time <= 1);
    *page = NULL;
    const char *family =
        options->family != NULL ? options->family : TF_LETTERS_FAMILY;
    if (!good_size(options->pixels_x) || !good_size(options->pixels_y))
        return TF_STAGE_BAD_SIZE;
    if (!tf_letters_known(family))
        return TF_STAGE_NO_FONT;
    tf_page *made = calloc(1, sizeof *made);
    if (made == NULL)
        return TF_STAGE_NO_MEMORY;
    made->options = *options;
    if (options->theme == NULL)
        made->options.theme = &tf_theme_light;
    made->family = tf_list_copy(family, (int)strlen(family) + 1, 1);
    if (made->family == NULL) {
        free(made);
        return TF_STAGE_NO_MEMORY;
    }
    *page = made;
    return TF_STAGE_OK;
}

void tf_page_free(tf_page *page)
{
    if (page == NULL)
        return;
    for (int i = 0; i < page->mark_count; i++)
        tf_mark_clear(&page->marks[i]);
    for (int i = 0; i < page->tag_count; i++)
        tf_letters_free(page->tags[i].letters);
    for (int i = 0; i < page->panel_count; i++) {
        tf_scene_clear(&page->panels[i]->scene);
        free(page->panels[i]);
    }
    free(page->marks);
    free(page->tags);
    free(page->panels);
    free(page->family);
    free(page);
}

double tf_page_width(const tf_page *page)
{
    return page->options.width;
}

double tf_page_height(const tf_page *page)
{
    return page->options.height;
}

const tf_theme *tf_page_theme(const tf_page *page)
{
    return page->options.theme;
}

bool tf_page_moves(const tf_page *page)
{
    return page->options.moves;
}

double tf_page_time(const tf_page *page)
{
    return page->options.time;
}

void tf_page_note(tf_page *page, tf_stage_status status)
{
    if (page->trouble == TF_STAGE_OK)
        page->trouble = status;
}

tf_mark *tf_page_add_mark(tf_page *page, tf_mark mark)
{
    if (!tf_list_room(&page->marks, page->mark_count, 1, &page->mark_room,
                      sizeof *page->marks)) {
        tf_page_note(page, TF_STAGE_NO_MEMORY);
        tf_mark_clear(&mark);
        return NULL;
    }
    page->marks[page->mark_count] = mark;
    return &page->marks[page->mark_count++];
}

tf_raster tf_page_raster(const tf_page *page)
{
    const tf_page_options *o = &page->options;
    tf_raster raster = {.pixels_x = o->pixels_x, .pixels_y = o->pixels_y};
    raster.scale = fmin(o->pixels_x / o->width, o->pixels_y / o->height);
    raster.shift_x = (int)((o->pixels_x - raster.scale * o->width) / 2);
    raster.shift_y = (int)((o->pixels_y - raster.scale * o->height) / 2);
    return raster;
}

int tf_page_labels(const tf_page *page)
{
    return page->tag_count;
}

tf_placed tf_page_placed(const tf_page *page, int i)
{
    TF_REQUIRE(i >= 0 && i < page->tag_count);
    return page->tags[i].placed;
}
