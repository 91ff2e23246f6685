// What a page is made of, for the files that draw it.
#ifndef FIG_RENDERER_PAGE_PARTS_H
#define FIG_RENDERER_PAGE_PARTS_H

#include "renderer/letters.h"
#include "renderer/page.h"
#include "renderer/scene_parts.h"

#include <cairo.h>

struct fig_panel {
    fig_page *page;
    fig_box box;
    fig_camera camera;
    double margin;
    bool fixed;
    fig_scene scene;
};

typedef enum fig_mark_kind {
    FIG_MARK_PANEL,
    FIG_MARK_LINE,
    FIG_MARK_FILL,
    FIG_MARK_DOT,
    FIG_MARK_MAP,
    FIG_MARK_TEXT,
} fig_mark_kind;

/// Something that is drawn where it was put.
typedef struct fig_mark {
    fig_mark_kind kind;
    const fig_panel *panel; ///< its world holds the points; NULL: the page does
    tf_vector *at;          ///< of which the page has x[0] and x[1] only
    int count;
    fig_stroke stroke;
    fig_box box; ///< of a map
    cairo_surface_t *map;
    fig_letters *letters;
    bool upwards;
} fig_mark;

/// Something that looks for its place.
typedef struct fig_tag {
    const fig_panel *panel; ///< NULL: the anchor is on the page
    tf_vector at;
    fig_label label; ///< its text is not kept
    fig_letters *letters;
    fig_placed placed;
} fig_tag;

struct fig_page {
    fig_page_options options;
    char *family;
    fig_mark *marks;
    fig_tag *tags;
    fig_panel **panels;
    fig_box *plots; ///< the frames of plots
    int mark_count, tag_count, panel_count, plot_count;
    int mark_room, tag_room, panel_room, plot_room;
    fig_box shown;        ///< what the picture shows of the page
    fig_box content;      ///< the same without the heading
    bool cropped;         ///< to the content
    fig_letters *heading; ///< NULL: there is none
    fig_status trouble;   ///< the first
};

/// How page points become pixels: x pixels are scale * points + shift.
typedef struct fig_raster {
    double scale;
    int shift_x, shift_y;
    int pixels_x, pixels_y;
} fig_raster;

// A file of the renderer uses only those before it in figures/rules.mk, and so
// do the functions here.

// page.c -----------------------------------------------------------------

/// Remember the first trouble of a page.
void fig_page_note(fig_page *page, fig_status status);

/// Set text in letters of the page's family; a size of 0 is FIG_LETTERS.  NULL
/// (and noted) if that fails.
fig_letters *fig_page_letters(fig_page *page, const char *text, double size);

/// Add a mark, which the page then owns.  NULL (and noted) if there is no
/// memory; the mark is cleared then.
fig_mark *fig_page_add_mark(fig_page *page, fig_mark mark);
void fig_mark_clear(fig_mark *mark);

fig_raster fig_page_raster(const fig_page *page);

/// Note the frame of a plot.
void fig_page_add_plot(fig_page *page, fig_box box);

// panel.c ----------------------------------------------------------------

/// The panel's view of what is in its scene now.
fig_view fig_panel_view(const fig_panel *panel);

/// A point of a mark or a tag in points of the page.
fig_point fig_page_point(const fig_panel *panel, tf_vector at);

// marks.c ----------------------------------------------------------------

/// Draw a mark; `cairo` counts in points of the page.
void fig_mark_draw(const fig_mark *mark, const fig_theme *theme,
                   cairo_t *cairo);

/// The box of the ink of a text mark.
fig_box fig_mark_text_box(const fig_mark *mark);

// parts.c ----------------------------------------------------------------

/// Draw the heading; `cairo` counts in points of the page.
void fig_page_draw_heading(const fig_page *page, cairo_t *cairo);

// labels.c ---------------------------------------------------------------

/// Choose the places of all tags, then draw them.
bool fig_page_place_tags(fig_page *page);
void fig_page_draw_tags(const fig_page *page, cairo_t *cairo);

#endif
