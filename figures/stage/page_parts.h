// What a page is made of, for the files that draw it.
#ifndef TF_STAGE_PAGE_PARTS_H
#define TF_STAGE_PAGE_PARTS_H

#include "stage/letters.h"
#include "stage/page.h"
#include "stage/scene_parts.h"

#include <cairo.h>

struct tf_panel {
    tf_page *page;
    tf_box box;
    tf_camera camera;
    double margin;
    bool fixed;
    tf_scene scene;
};

typedef enum tf_mark_kind {
    TF_MARK_PANEL,
    TF_MARK_LINE,
    TF_MARK_FILL,
    TF_MARK_DOT,
    TF_MARK_MAP,
    TF_MARK_TEXT,
} tf_mark_kind;

/// Something that is drawn where it was put.
typedef struct tf_mark {
    tf_mark_kind kind;
    const tf_panel *panel; ///< its world holds the points; NULL: the page does
    double (*at)[3];
    int count;
    tf_stroke stroke;
    tf_box box; ///< of a map
    cairo_surface_t *map;
    tf_letters *letters;
    bool upwards;
} tf_mark;

/// Something that looks for its place.
typedef struct tf_tag {
    const tf_panel *panel; ///< NULL: the anchor is on the page
    double at[3];
    tf_label label; ///< its text is not kept
    tf_letters *letters;
    tf_placed placed;
} tf_tag;

struct tf_page {
    tf_page_options options;
    char *family;
    tf_mark *marks;
    tf_tag *tags;
    tf_panel **panels;
    int mark_count, tag_count, panel_count;
    int mark_room, tag_room, panel_room;
    tf_stage_status trouble; ///< the first
};

/// How page points become pixels: x pixels are scale * points + shift.
typedef struct tf_raster {
    double scale;
    int shift_x, shift_y;
    int pixels_x, pixels_y;
} tf_raster;

tf_raster tf_page_raster(const tf_page *page);

/// Remember the first trouble of a page.
void tf_page_note(tf_page *page, tf_stage_status status);

/// Add a mark; NULL (and noted) if there is no memory.
tf_mark *tf_page_add_mark(tf_page *page, tf_mark mark);

/// The panel's view of what is in its scene now.
tf_view tf_panel_view(const tf_panel *panel);

/// A point of a mark or a tag in points of the page.
void tf_page_point(const tf_panel *panel, const double at[3], double point[2]);

/// Draw a mark; `cairo` counts in points of the page.
void tf_mark_draw(const tf_mark *mark, const tf_theme *theme, cairo_t *cairo);
void tf_mark_clear(tf_mark *mark);

/// Choose the places of all tags, then draw them.
bool tf_page_place_tags(tf_page *page);
void tf_page_draw_tags(const tf_page *page, cairo_t *cairo);

/// The box of the ink of a text mark.
tf_box tf_mark_text_box(const tf_mark *mark);

#endif
