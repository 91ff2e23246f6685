#include "base/require.h"
#include "renderer/page_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double tau = 6.283185307179586;

/// An arrow head's length, by the width of its line, and half its width.
static const double head_length = 5.2, head_half = 2.0;

// Recording --------------------------------------------------------------

/// Add a mark with room for points; NULL, and noted, if there is no memory.
static tf_vector *add_with_room(fig_page *page, fig_mark mark, int count)
{
    mark.at = calloc((size_t)count, sizeof *mark.at);
    mark.count = count;
    if (mark.at == NULL) {
        fig_page_note(page, FIG_NO_MEMORY);
        fig_mark_clear(&mark);
        return NULL;
    }
    const fig_mark *added = fig_page_add_mark(page, mark);
    return added != NULL ? added->at : NULL;
}

static void add_on_page(fig_page *page, fig_mark mark, int count,
                        const fig_point at[])
{
    tf_vector *own = add_with_room(page, mark, count);
    for (int i = 0; own != NULL && i < count; i++)
        own[i] = (tf_vector){{at[i].x, at[i].y, 0}};
}

static void add_in_world(fig_panel *panel, fig_mark mark, int count,
                         const tf_vector at[])
{
    mark.panel = panel;
    tf_vector *own = add_with_room(panel->page, mark, count);
    if (own != NULL)
        memcpy(own, at, (size_t)count * sizeof *own);
}

void fig_page_line(fig_page *page, int count, const fig_point at[],
                   fig_stroke stroke)
{
    TF_REQUIRE(count >= 2);
    add_on_page(page, (fig_mark){.kind = FIG_MARK_LINE, .stroke = stroke},
                count, at);
}

void fig_panel_line(fig_panel *panel, int count, const tf_vector at[],
                    fig_stroke stroke)
{
    TF_REQUIRE(count >= 2);
    add_in_world(panel, (fig_mark){.kind = FIG_MARK_LINE, .stroke = stroke},
                 count, at);
}

void fig_page_fill(fig_page *page, int count, const fig_point at[],
                   fig_paint paint)
{
    TF_REQUIRE(count >= 3);
    add_on_page(page, (fig_mark){.kind = FIG_MARK_FILL, .stroke.paint = paint},
                count, at);
}

void fig_panel_fill(fig_panel *panel, int count, const tf_vector at[],
                    fig_paint paint)
{
    TF_REQUIRE(count >= 3);
    add_in_world(panel,
                 (fig_mark){.kind = FIG_MARK_FILL, .stroke.paint = paint},
                 count, at);
}

void fig_page_fill_box(fig_page *page, fig_box box, fig_paint paint)
{
    const fig_point corner[4] = {{box.x, box.y},
                                 {box.x + box.width, box.y},
                                 {box.x + box.width, box.y + box.height},
                                 {box.x, box.y + box.height}};
    fig_page_fill(page, 4, corner, paint);
}

void fig_page_dot(fig_page *page, double x, double y, double diameter,
                  fig_paint paint)
{
    fig_stroke stroke = {.paint = paint, .width = diameter};
    add_on_page(page, (fig_mark){.kind = FIG_MARK_DOT, .stroke = stroke}, 1,
                &(fig_point){x, y});
}

void fig_page_arc(fig_page *page, double x, double y, double radius,
                  double from, double to, fig_stroke stroke)
{
    enum {
        CHORDS = 96
    };
    fig_point at[CHORDS + 1];
    for (int i = 0; i <= CHORDS; i++) {
        double angle = (from + (to - from) * i / CHORDS) / 360 * tau;
        at[i] = (fig_point){x + radius * cos(angle), y - radius * sin(angle)};
    }
    fig_page_line(page, CHORDS + 1, at, stroke);
}

static unsigned char byte_of(double component)
{
    return (unsigned char)lround(255 * fmax(0, fmin(component, 1)));
}

void fig_page_map(fig_page *page, fig_box box, int columns, int rows,
                  const fig_rgb *cells)
{
    TF_REQUIRE(columns >= 1 && rows >= 1);
    cairo_surface_t *map =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
    if (cairo_surface_status(map) != CAIRO_STATUS_SUCCESS) {
        fig_page_note(page, FIG_NO_MEMORY);
        cairo_surface_destroy(map);
        return;
    }
    unsigned char *bytes = cairo_image_surface_get_data(map);
    int stride = cairo_image_surface_get_stride(map);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const fig_rgb *cell =
                &cells[(size_t)i * (size_t)columns + (size_t)j];
            unsigned pixel = (unsigned)byte_of(cell->r) << 16 |
                             (unsigned)byte_of(cell->g) << 8 | byte_of(cell->b);
            memcpy(bytes + (size_t)i * (size_t)stride + 4 * (size_t)j, &pixel,
                   4);
        }
    cairo_surface_mark_dirty(map);
    fig_page_add_mark(page,
                      (fig_mark){.kind = FIG_MARK_MAP, .box = box, .map = map});
}

static void add_text(fig_page *page, double x, double y, fig_align align,
                     const char *text, double size, fig_role role, bool upwards)
{
    fig_letters *letters = fig_page_letters(page, text, size);
    if (letters == NULL)
        return;
    double back = fig_letters_advance(letters) * 0.5 * (double)align;
    fig_mark mark = {.kind = FIG_MARK_TEXT,
                     .stroke.paint.role = role,
                     .letters = letters,
                     .upwards = upwards};
    fig_point at = {upwards ? x : x - back, upwards ? y + back : y};
    add_on_page(page, mark, 1, &at);
}

void fig_page_text(fig_page *page, double x, double y, fig_align align,
                   const char *text, double size, fig_role role)
{
    add_text(page, x, y, align, text, size, role, false);
}

void fig_page_text_upwards(fig_page *page, double x, double y, fig_align align,
                           const char *text, double size, fig_role role)
{
    add_text(page, x, y, align, text, size, role, true);
}

void fig_page_measure(fig_page *page, const char *text, double size,
                      double *width, double *height)
{
    fig_letters *letters = fig_page_letters(page, text, size);
    *width = *height = 0;
    if (letters == NULL)
        return;
    double x, y;
    fig_letters_ink(letters, &x, &y, width, height);
    *width = fig_letters_advance(letters);
    fig_letters_free(letters);
}

void fig_page_caption(fig_page *page, fig_box box, const char *text)
{
    fig_page_text(page, box.x + box.width / 2,
                  box.y + box.height + 1.2 * FIG_LETTERS_SMALL,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

void fig_page_title(fig_page *page, fig_box box, const char *text)
{
    fig_page_text(page, box.x + box.width / 2, box.y - 0.5 * FIG_LETTERS_TITLE,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_TITLE, FIG_ROLE_INK);
}

// Drawing ----------------------------------------------------------------

static void set_paint(const fig_mark *mark, const fig_theme *theme,
                      cairo_t *cairo)
{
    fig_rgb color = fig_paint_color(theme, mark->stroke.paint);
    cairo_set_source_rgba(cairo, color.r, color.g, color.b,
                          fig_paint_opacity(mark->stroke.paint));
}

/// Draw a head with its tip at `tip`.  Returns where the line ends below it.
static fig_point draw_head(cairo_t *cairo, fig_point before, fig_point tip,
                           double width)
{
    double dx = tip.x - before.x, dy = tip.y - before.y;
    double length = hypot(dx, dy);
    if (length == 0)
        return tip;
    double size = fmin(head_length * width, length);
    dx *= size / length;
    dy *= size / length;
    double side = head_half / head_length;
    fig_point base = {tip.x - dx, tip.y - dy};
    cairo_move_to(cairo, tip.x, tip.y);
    cairo_line_to(cairo, base.x - side * dy, base.y + side * dx);
    cairo_line_to(cairo, base.x + 0.2 * dx, base.y + 0.2 * dy);
    cairo_line_to(cairo, base.x + side * dy, base.y - side * dx);
    cairo_close_path(cairo);
    cairo_fill(cairo);
    return (fig_point){tip.x - 0.7 * dx, tip.y - 0.7 * dy};
}

/// The i-th point of a mark, on the page.
static fig_point point_of(const fig_mark *mark, int i)
{
    return fig_page_point(mark->panel, mark->at[i]);
}

/// The path through a mark's points, whose first and last are given.
static void trace(const fig_mark *mark, cairo_t *cairo, fig_point first,
                  fig_point last)
{
    cairo_move_to(cairo, first.x, first.y);
    for (int i = 1; i + 1 < mark->count; i++) {
        fig_point point = point_of(mark, i);
        cairo_line_to(cairo, point.x, point.y);
    }
    cairo_line_to(cairo, last.x, last.y);
}

static void draw_line(const fig_mark *mark, cairo_t *cairo)
{
    const fig_stroke *stroke = &mark->stroke;
    double width = stroke->width > 0 ? stroke->width : FIG_WIDTH_LINE;
    fig_point first = point_of(mark, 0), last = point_of(mark, mark->count - 1);
    if (stroke->arrow)
        last = draw_head(cairo, point_of(mark, mark->count - 2), last, width);
    if (stroke->both)
        first = draw_head(cairo, point_of(mark, 1), first, width);
    trace(mark, cairo, first, last);
    if (stroke->closed)
        cairo_close_path(cairo);
    cairo_set_line_width(cairo, width);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, stroke->dash > 0 || stroke->arrow
                                  ? CAIRO_LINE_CAP_BUTT
                                  : CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(cairo, &stroke->dash, stroke->dash > 0 ? 1 : 0, 0);
    cairo_stroke(cairo);
}

static void draw_fill(const fig_mark *mark, cairo_t *cairo)
{
    trace(mark, cairo, point_of(mark, 0), point_of(mark, mark->count - 1));
    cairo_fill(cairo);
}

static void draw_map(const fig_mark *mark, cairo_t *cairo)
{
    cairo_save(cairo);
    cairo_translate(cairo, mark->box.x, mark->box.y);
    cairo_scale(cairo,
                mark->box.width / cairo_image_surface_get_width(mark->map),
                mark->box.height / cairo_image_surface_get_height(mark->map));
    cairo_set_source_surface(cairo, mark->map, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
    cairo_pattern_set_extend(cairo_get_source(cairo), CAIRO_EXTEND_PAD);
    cairo_rectangle(cairo, 0, 0, cairo_image_surface_get_width(mark->map),
                    cairo_image_surface_get_height(mark->map));
    cairo_fill(cairo);
    cairo_restore(cairo);
}

static void draw_text(const fig_mark *mark, const fig_theme *theme,
                      cairo_t *cairo)
{
    cairo_save(cairo);
    cairo_translate(cairo, mark->at[0].x[0], mark->at[0].x[1]);
    if (mark->upwards)
        cairo_rotate(cairo, -tau / 4);
    fig_letters_draw(mark->letters, cairo, 0, 0,
                     fig_paint_color(theme, mark->stroke.paint));
    cairo_restore(cairo);
}

void fig_mark_draw(const fig_mark *mark, const fig_theme *theme, cairo_t *cairo)
{
    set_paint(mark, theme, cairo);
    switch (mark->kind) {
    case FIG_MARK_LINE:
        draw_line(mark, cairo);
        break;
    case FIG_MARK_FILL:
        draw_fill(mark, cairo);
        break;
    case FIG_MARK_DOT:
        cairo_arc(cairo, mark->at[0].x[0], mark->at[0].x[1],
                  mark->stroke.width / 2, 0, tau);
        cairo_fill(cairo);
        break;
    case FIG_MARK_MAP:
        draw_map(mark, cairo);
        break;
    case FIG_MARK_TEXT:
        draw_text(mark, theme, cairo);
        break;
    case FIG_MARK_PANEL:
        break;
    }
}

fig_box fig_mark_text_box(const fig_mark *mark)
{
    double x, y, width, height;
    fig_letters_ink(mark->letters, &x, &y, &width, &height);
    fig_point at = point_of(mark, 0);
    if (mark->upwards)
        return (fig_box){at.x + y, at.y - x - width, height, width};
    return (fig_box){at.x + x, at.y + y, width, height};
}
