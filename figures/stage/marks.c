#include "contract.h"
#include "stage/list.h"
#include "stage/page_parts.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static const double tau = 6.283185307179586;

/// An arrow head's length, by the width of its line, and half its width.
static const double head_length = 5.2, head_half = 2.0;

void tf_mark_clear(tf_mark *mark)
{
    free(mark->at);
    if (mark->map != NULL)
        cairo_surface_destroy(mark->map);
    tf_letters_free(mark->letters);
}

// Recording --------------------------------------------------------------

/// Add a mark with points of `axes` coordinates.
static void add_points(tf_page *page, tf_mark mark, int count, int axes,
                       const double *at)
{
    mark.at = calloc((size_t)count, sizeof *mark.at);
    mark.count = count;
    if (mark.at == NULL) {
        tf_page_note(page, TF_STAGE_NO_MEMORY);
        tf_mark_clear(&mark);
        return;
    }
    for (int i = 0; i < count; i++)
        memcpy(mark.at[i], at + (ptrdiff_t)i * axes, (size_t)axes * sizeof *at);
    tf_page_add_mark(page, mark);
}

void tf_page_line(tf_page *page, int count, const double at[][2],
                  tf_stroke stroke)
{
    TF_REQUIRE(count >= 2);
    add_points(page, (tf_mark){.kind = TF_MARK_LINE, .stroke = stroke}, count,
               2, at[0]);
}

void tf_panel_line(tf_panel *panel, int count, const double at[][3],
                   tf_stroke stroke)
{
    TF_REQUIRE(count >= 2);
    add_points(
        panel->page,
        (tf_mark){.kind = TF_MARK_LINE, .panel = panel, .stroke = stroke},
        count, 3, at[0]);
}

void tf_page_fill(tf_page *page, int count, const double at[][2],
                  tf_paint paint)
{
    TF_REQUIRE(count >= 3);
    add_points(page, (tf_mark){.kind = TF_MARK_FILL, .stroke.paint = paint},
               count, 2, at[0]);
}

void tf_panel_fill(tf_panel *panel, int count, const double at[][3],
                   tf_paint paint)
{
    TF_REQUIRE(count >= 3);
    add_points(
        panel->page,
        (tf_mark){.kind = TF_MARK_FILL, .panel = panel, .stroke.paint = paint},
        count, 3, at[0]);
}

void tf_page_fill_box(tf_page *page, tf_box box, tf_paint paint)
{
    const double corner[4][2] = {{box.x, box.y},
                                 {box.x + box.width, box.y},
                                 {box.x + box.width, box.y + box.height},
                                 {box.x, box.y + box.height}};
    tf_page_fill(page, 4, corner, paint);
}

void tf_page_dot(tf_page *page, double x, double y, double diameter,
                 tf_paint paint)
{
    tf_stroke stroke = {.paint = paint, .width = diameter};
    add_points(page, (tf_mark){.kind = TF_MARK_DOT, .stroke = stroke}, 1, 2,
               (double[]){x, y});
}

void tf_page_arc(tf_page *page, double x, double y, double radius, double from,
                 double to, tf_stroke stroke)
{
    enum {
        CHORDS = 96
    };
    double at[CHORDS + 1][2];
    for (int i = 0; i <= CHORDS; i++) {
        double angle = (from + (to - from) * i / CHORDS) / 360 * tau;
        at[i][0] = x + radius * cos(angle);
        at[i][1] = y - radius * sin(angle);
    }
    tf_page_line(page, CHORDS + 1, (const double(*)[2])at, stroke);
}

static unsigned char byte_of(double component)
{
    return (unsigned char)lround(255 * fmax(0, fmin(component, 1)));
}

void tf_page_map(tf_page *page, tf_box box, int columns, int rows,
                 const tf_rgb *cells)
{
    TF_REQUIRE(columns >= 1 && rows >= 1);
    cairo_surface_t *map =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
    if (cairo_surface_status(map) != CAIRO_STATUS_SUCCESS) {
        tf_page_note(page, TF_STAGE_NO_MEMORY);
        cairo_surface_destroy(map);
        return;
    }
    unsigned char *bytes = cairo_image_surface_get_data(map);
    int stride = cairo_image_surface_get_stride(map);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            const tf_rgb *cell =
                &cells[(size_t)i * (size_t)columns + (size_t)j];
            unsigned pixel = (unsigned)byte_of(cell->r) << 16 |
                             (unsigned)byte_of(cell->g) << 8 | byte_of(cell->b);
            memcpy(bytes + (size_t)i * (size_t)stride + 4 * (size_t)j, &pixel,
                   4);
        }
    cairo_surface_mark_dirty(map);
    tf_page_add_mark(page,
                     (tf_mark){.kind = TF_MARK_MAP, .box = box, .map = map});
}

static void add_text(tf_page *page, double x, double y, tf_align align,
                     const char *text, double size, tf_role role, bool upwards)
{
    tf_letters *letters;
    tf_stage_status status = tf_letters_set(
        page->family, text, size > 0 ? size : TF_LETTERS, &letters);
    if (status != TF_STAGE_OK) {
        tf_page_note(page, status);
        return;
    }
    double back = tf_letters_advance(letters) * 0.5 * (double)align;
    tf_mark mark = {.kind = TF_MARK_TEXT,
                    .stroke.paint.role = role,
                    .letters = letters,
                    .upwards = upwards};
    double at[2] = {upwards ? x : x - back, upwards ? y + back : y};
    add_points(page, mark, 1, 2, at);
}

void tf_page_text(tf_page *page, double x, double y, tf_align align,
                  const char *text, double size, tf_role role)
{
    add_text(page, x, y, align, text, size, role, false);
}

void tf_page_text_upwards(tf_page *page, double x, double y, tf_align align,
                          const char *text, double size, tf_role role)
{
    add_text(page, x, y, align, text, size, role, true);
}

void tf_page_measure(tf_page *page, const char *text, double size,
                     double *width, double *height)
{
    tf_letters *letters;
    tf_stage_status status = tf_letters_set(
        page->family, text, size > 0 ? size : TF_LETTERS, &letters);
    *width = *height = 0;
    if (status != TF_STAGE_OK) {
        tf_page_note(page, status);
        return;
    }
    double x, y;
    tf_letters_ink(letters, &x, &y, width, height);
    *width = tf_letters_advance(letters);
    tf_letters_free(letters);
}

void tf_page_caption(tf_page *page, tf_box box, const char *text)
{
    tf_page_text(page, box.x + box.width / 2,
                 box.y + box.height + 1.2 * TF_LETTERS_SMALL, TF_ALIGN_CENTER,
                 text, TF_LETTERS_SMALL, TF_ROLE_INK);
}

void tf_page_title(tf_page *page, tf_box box, const char *text)
{
    tf_page_text(page, box.x + box.width / 2, box.y - 0.5 * TF_LETTERS_TITLE,
                 TF_ALIGN_CENTER, text, TF_LETTERS_TITLE, TF_ROLE_INK);
}

// Drawing ----------------------------------------------------------------

static void set_paint(const tf_mark *mark, const tf_theme *theme,
                      cairo_t *cairo)
{
    tf_rgb color = tf_paint_color(theme, mark->stroke.paint);
    cairo_set_source_rgba(cairo, color.r, color.g, color.b,
                          tf_paint_opacity(mark->stroke.paint));
}

/// Draw a head with its tip at `tip`, and move `tip` back to where the line
/// ends below the head.
static void draw_head(cairo_t *cairo, const double before[2], double tip[2],
                      double width)
{
    double dx = tip[0] - before[0], dy = tip[1] - before[1];
    double length = hypot(dx, dy);
    if (length == 0)
        return;
    double size = fmin(head_length * width, length);
    dx *= size / length;
    dy *= size / length;
    double side = head_half / head_length;
    double base[2] = {tip[0] - dx, tip[1] - dy};
    cairo_move_to(cairo, tip[0], tip[1]);
    cairo_line_to(cairo, base[0] - side * dy, base[1] + side * dx);
    cairo_line_to(cairo, base[0] + 0.2 * dx, base[1] + 0.2 * dy);
    cairo_line_to(cairo, base[0] + side * dy, base[1] - side * dx);
    cairo_close_path(cairo);
    cairo_fill(cairo);
    tip[0] -= 0.7 * dx;
    tip[1] -= 0.7 * dy;
}

/// The path through a mark's points, whose first and last are given.
static void trace(const tf_mark *mark, cairo_t *cairo, const double first[2],
                  const double last[2])
{
    cairo_move_to(cairo, first[0], first[1]);
    for (int i = 1; i + 1 < mark->count; i++) {
        double point[2];
        tf_page_point(mark->panel, mark->at[i], point);
        cairo_line_to(cairo, point[0], point[1]);
    }
    cairo_line_to(cairo, last[0], last[1]);
}

static void draw_line(const tf_mark *mark, cairo_t *cairo)
{
    const tf_stroke *stroke = &mark->stroke;
    double width = stroke->width > 0 ? stroke->width : TF_WIDTH_LINE;
    double first[2], last[2], near[2];
    tf_page_point(mark->panel, mark->at[0], first);
    tf_page_point(mark->panel, mark->at[mark->count - 1], last);
    if (stroke->arrow) {
        tf_page_point(mark->panel, mark->at[mark->count - 2], near);
        draw_head(cairo, near, last, width);
    }
    if (stroke->both) {
        tf_page_point(mark->panel, mark->at[1], near);
        draw_head(cairo, near, first, width);
    }
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

static void draw_fill(const tf_mark *mark, cairo_t *cairo)
{
    double first[2], last[2];
    tf_page_point(mark->panel, mark->at[0], first);
    tf_page_point(mark->panel, mark->at[mark->count - 1], last);
    trace(mark, cairo, first, last);
    cairo_fill(cairo);
}

static void draw_map(const tf_mark *mark, cairo_t *cairo)
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

static void draw_text(const tf_mark *mark, const tf_theme *theme,
                      cairo_t *cairo)
{
    cairo_save(cairo);
    cairo_translate(cairo, mark->at[0][0], mark->at[0][1]);
    if (mark->upwards)
        cairo_rotate(cairo, -tau / 4);
    tf_letters_draw(mark->letters, cairo, 0, 0,
                    tf_paint_color(theme, mark->stroke.paint));
    cairo_restore(cairo);
}

void tf_mark_draw(const tf_mark *mark, const tf_theme *theme, cairo_t *cairo)
{
    set_paint(mark, theme, cairo);
    switch (mark->kind) {
    case TF_MARK_LINE:
        draw_line(mark, cairo);
        break;
    case TF_MARK_FILL:
        draw_fill(mark, cairo);
        break;
    case TF_MARK_DOT:
        cairo_arc(cairo, mark->at[0][0], mark->at[0][1], mark->stroke.width / 2,
                  0, tau);
        cairo_fill(cairo);
        break;
    case TF_MARK_MAP:
        draw_map(mark, cairo);
        break;
    case TF_MARK_TEXT:
        draw_text(mark, theme, cairo);
        break;
    case TF_MARK_PANEL:
        break;
    }
}

tf_box tf_mark_text_box(const tf_mark *mark)
{
    double x, y, width, height;
    tf_letters_ink(mark->letters, &x, &y, &width, &height);
    const double *at = mark->at[0];
    if (mark->upwards)
        return (tf_box){at[0] + y, at[1] - x - width, height, width};
    return (tf_box){at[0] + x, at[1] + y, width, height};
}
