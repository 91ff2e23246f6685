#include "draw/surface_picture.h"

#include "draw/surface_parts.h"
#include "renderer/figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Layout -----------------------------------------------------------------

static const fig_box surface_box = {0, 0, FIG_PAGE_WIDTH, 250};
static const double caption_from = 264, line = 14;

enum {
    TEXT = 160,
    COUNT = 32
};

// What the parts share ---------------------------------------------------

fig_paint fig_part_paint(const fig_shown_surface *shown, int part)
{
    static const fig_role role[] = {FIG_ROLE_EDGE,     FIG_ROLE_OTHER_EDGE,
                                    FIG_ROLE_TRIANGLE, FIG_ROLE_POINT,
                                    FIG_ROLE_START,    FIG_ROLE_END};
    static const double shade[] = {0, -0.4, 0.3};
    static const double pale = -0.2, behind_marks = -0.15;
    fig_paint paint = {.role = role[part % 6],
                       .shade = shade[part / 6 % 3] + pale};
    if (shown->marked && !shown->crosses && shown->marks.count > 0 &&
        shown->shape.axes == 3)
        paint.shade += behind_marks;
    return paint;
}

bool fig_is_marked(const fig_page *page, double toi, double t)
{
    return toi < FIG_NEVER && (!fig_page_moves(page) || toi <= t);
}

fig_paint fig_touching_paint(double toi, double t)
{
    // Times of elements were rounded.
    static const double rounding = 1e-6, now = -0.22, later = -0.55;
    return (fig_paint){.role = FIG_ROLE_CONTACT,
                       .shade = toi <= t + rounding ? now : later};
}

bool fig_is_in_zone(const fig_shown_surface *shown, int facet)
{
    return shown->crosses && shown->tangled.zone[facet] >= 0;
}

fig_paint fig_facet_paint(const fig_shown_surface *shown, int facet, int vertex)
{
    static const double tint = -0.4;
    fig_paint paint = fig_part_paint(shown, shown->shape.part[vertex]);
    if (fig_is_in_zone(shown, facet))
        paint.shade += tint;
    return paint;
}

const fig_paint fig_spot_paint = {.role = FIG_ROLE_CONTACT, .shade = 0.2};

double fig_spot_width(const fig_page *page, const fig_shown_surface *shown,
                      int i, double t)
{
    const fig_marks *marks = &shown->marks;
    double toi = marks->spot[i].toi;
    if (!fig_is_marked(page, toi, t))
        return 0;
    if (!marks->at_rest && toi <= marks->toi_hi)
        return FIG_WIDTH_BALL;
    return marks->count <= 20 ? 4.5 : marks->count <= 80 ? 3.2 : 0;
}

bool fig_shows_edges(const fig_shown_surface *shown)
{
    static const double least_length = 4;
    return shown->shape.edge_length * shown->scale >= least_length;
}

// The view ---------------------------------------------------------------

void fig_shown_surface_look(fig_shown_surface *shown, double time)
{
    const fig_marks *marks = shown->marked ? &shown->marks : NULL;
    bool hits = marks && marks->count > 0;
    shown->time = time >= 0       ? time
                  : !shown->steps ? 0
                  : hits          ? (marks->toi_lo + marks->toi_hi) / 2
                                  : 1;
    fig_camera camera = {.elevation = 90};
    if (shown->shape.axes == 3)
        camera = fig_surface_camera(&shown->shape, marks, shown->time);
    shown->outline_count = fig_surface_outline(&shown->shape, shown->outline);
    shown->camera = fig_camera_fit(&camera, shown->outline_count,
                                   shown->outline, surface_box.width,
                                   surface_box.height, FIG_SURFACE_MARGIN);
    shown->scale = surface_box.height / shown->camera.height;
}

// Words ------------------------------------------------------------------

/// Write a count with commas, and what it counts: "1,234 edges".
static void write_count(int count, const char *one, const char *many,
                        char text[COUNT])
{
    char digits[16];
    int length = snprintf(digits, sizeof digits, "%d", count), at = 0;
    for (int i = 0; i < length; i++) {
        if (i > 0 && (length - i) % 3 == 0)
            text[at++] = ',';
        text[at++] = digits[i];
    }
    snprintf(text + at, (size_t)(COUNT - at), " %s", count == 1 ? one : many);
}

/// "12 intersections along 2 curves, in 1 zone".
static void write_tangle(const fig_shown_surface *shown, char text[TEXT])
{
    const fig_tangled *tangled = &shown->tangled;
    char count[COUNT], curves[COUNT], zones[COUNT];
    write_count(shown->marks.count, "intersection", "intersections", count);
    write_count(tangled->curves.curves, "curve", "curves", curves);
    write_count(tangled->zones, "zone", "zones", zones);
    if (tangled->curves.curves > 0)
        snprintf(text, TEXT, "%s along %s, in %s", count, curves, zones);
    else
        snprintf(text, TEXT, "%s in %s", count, zones);
}

static void write_marks(const fig_shown_surface *shown, char text[TEXT])
{
    const fig_marks *marks = &shown->marks;
    char count[COUNT], time[FIG_TIME_TEXT];
    if (marks->at_rest)
        write_count(marks->count, "intersection", "intersections", count);
    else
        write_count(marks->count, "contact", "contacts", count);
    snprintf(text, TEXT, "%s",
             marks->count > 0 ? count
             : marks->at_rest ? "no intersections"
                              : "no contacts");
    if (marks->at_rest || marks->count == 0)
        return;
    fig_time_text((marks->toi_lo + marks->toi_hi) / 2, time);
    snprintf(text, TEXT, "%s%s at %s", count,
             marks->count > 1 ? ", the first" : "", time);
}

/// What there is, and at which time of the step.
static void write_surface(const fig_page *page, const fig_shown_surface *shown,
                          double t, char text[TEXT])
{
    const fig_shape *shape = &shown->shape;
    char elements[COUNT], time[FIG_TIME_TEXT];
    if (shape->triangles > 0)
        write_count(shape->triangles, "triangle", "triangles", elements);
    else
        write_count(shape->edges, "edge", "edges", elements);
    const char *zones =
        shape->axes == 3 ? ", fainter in zones" : ", broader in zones";
    bool zoned = shown->crosses && shown->tangled.zones > 0;
    snprintf(text, TEXT, "%s%s", elements, zoned ? zones : "");
    if (!shown->steps)
        return;
    // In films, digits that come and go would make the line tremble.
    if (fig_page_moves(page))
        snprintf(time, sizeof time, "$t = %.2f$", t);
    else
        fig_time_text(t, time);
    snprintf(text, TEXT, "%s at %s", elements, time);
}

static void draw_captions(fig_page *page, const fig_shown_surface *shown,
                          double t)
{
    double middle = fig_page_width(page) / 2;
    char text[TEXT];
    if (shown->marked) {
        if (shown->crosses && shown->marks.count > 0)
            write_tangle(shown, text);
        else
            write_marks(shown, text);
        fig_page_text(page, middle, caption_from, FIG_ALIGN_CENTER, text,
                      FIG_LETTERS,
                      shown->marks.count > 0 ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
    }
    write_surface(page, shown, t, text);
    fig_page_text(page, middle, caption_from + line, FIG_ALIGN_CENTER, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_NEUTRAL);
}

// Numbers ----------------------------------------------------------------

static void print_numbers(const fig_shown_surface *shown, FILE *numbers)
{
    const fig_shape *shape = &shown->shape;
    fig_number(numbers, "vertices", shape->vertices);
    fig_number(numbers, "triangles", shape->triangles);
    fig_number(numbers, "edges", shape->edges);
    fig_number(numbers, "parts", shape->parts);
    if (shown->steps)
        fig_number(numbers, "time", shown->time);
    if (!shown->marked)
        return;
    const fig_marks *marks = &shown->marks;
    fig_number(numbers, marks->at_rest ? "intersections" : "contacts",
               marks->count);
    if (shown->crosses) {
        fig_number(numbers, "curves", shown->tangled.curves.curves);
        fig_number(numbers, "zones", shown->tangled.zones);
    }
    if (marks->at_rest || marks->count == 0)
        return;
    fig_number(numbers, "toi_lo", marks->toi_lo);
    fig_number(numbers, "toi_hi", marks->toi_hi);
}

// The page ---------------------------------------------------------------

static void draw_surface(const void *subject, fig_page *page, FILE *numbers)
{
    const fig_shown_surface *shown = subject;
    double t = fig_page_moves(page) ? fig_page_time(page) : shown->time;
    if (shown->shape.axes == 3)
        fig_show_surface(page, surface_box, shown, t);
    else
        fig_show_curve(page, surface_box, shown, t);
    draw_captions(page, shown, t);
    print_numbers(shown, numbers);
}

fig_drawing fig_surface_drawing(const fig_shown_surface *shown)
{
    return (fig_drawing){FIG_PAGE_WIDTH, FIG_PAGE_HEIGHT, shown, draw_surface};
}
