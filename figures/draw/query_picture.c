#include "draw/query_picture.h"

#include "draw/query_parts.h"
#include "renderer/figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Layout -----------------------------------------------------------------

static const fig_box left_box = {6, 24, 222, 222};
static const fig_box right_box = {230, 24, 150, 222};
static const double caption_height = 16, caption_from = 264, line = 14;

/// The margin of cameras in small panels.
static const double margin = 14;

enum {
    FRAMES = 4,
    TEXT = 256
};

// Words ------------------------------------------------------------------

static const char *case_name(tf_classification decision)
{
    static const char *const name[] = {[TF_GENERIC] = "generic",
                                       [TF_TOUCHING] = "touching",
                                       [TF_DEGENERATE] = "degenerate"};
    return name[decision];
}

static void write_answer(const fig_shown *shown, char text[TEXT])
{
    if (!fig_shown_hits(shown)) {
        snprintf(text, TEXT, "apart for the whole step");
        return;
    }
    char time[FIG_TIME_TEXT], speed[FIG_NUMBER_TEXT];
    fig_time_text(shown->toi, time);
    fig_number_text(shown->contact.normal_velocity, speed);
    snprintf(text, TEXT, "hit at %s · %s · normal velocity $%s$", time,
             case_name(shown->contact.classification), speed);
}

/// What the axes of the drawing measure.
static void write_scale(const fig_shown *shown, bool alike, char text[TEXT])
{
    char span[3][FIG_NUMBER_TEXT];
    for (int k = 0; k < 3; k++)
        fig_span_text(shown->fit.span[k], span[k]);
    int length =
        snprintf(text, TEXT, "the drawing spans $%s × %s", span[0], span[1]);
    if (shown->kind->axes == 3)
        length +=
            snprintf(text + length, (size_t)(TEXT - length), " × %s", span[2]);
    bool both = shown->fit.alike && alike;
    snprintf(text + length, (size_t)(TEXT - length), "$%s",
             both               ? ""
             : shown->fit.alike ? "; on the right each axis has its own scale"
                                : "; each axis has its own scale");
}

// Numbers ----------------------------------------------------------------

static void print_numbers(const fig_shown *shown, FILE *numbers)
{
    static const char *const normal[TF_AXES] = {"nx", "ny", "nz"};
    const tf_contact *contact = &shown->contact;
    fprintf(numbers, "hit %d\n", fig_shown_hits(shown));
    if (!fig_shown_hits(shown))
        return;
    fig_number(numbers, "toi_lo", contact->toi_lo);
    fig_number(numbers, "toi_hi", contact->toi_hi);
    for (int k = 0; k < TF_AXES; k++)
        if (k < shown->kind->axes)
            fig_number(numbers, normal[k], contact->normal[k]);
    fig_number(numbers, "normal_velocity", contact->normal_velocity);
    fprintf(numbers, "case %s\n", case_name(contact->classification));
}

// The elements -----------------------------------------------------------

/// Thirds of the step; the one nearest to the contact gives way to it.
static void choose_times(const fig_shown *shown, double time[FRAMES])
{
    for (int i = 0; i < FRAMES; i++)
        time[i] = (double)i / (FRAMES - 1);
    if (fig_shown_hits(shown) && shown->toi > 0 && shown->toi < 1)
        time[shown->toi < 0.5 ? 1 : 2] = shown->toi;
}

/// The i-th box of the strip, two by two.
static fig_box frame_box(int i)
{
    double width = left_box.width / 2, height = left_box.height / 2;
    int column = i % 2, row = i / 2;
    return (fig_box){left_box.x + width * column, left_box.y + height * row,
                     width, height - caption_height};
}

/// The one box of a film.
static fig_box film_box(void)
{
    fig_box box = left_box;
    box.height -= caption_height;
    return box;
}

static void draw_frame(fig_page *page, const fig_shown *shown, fig_box box,
                       double t, bool marked)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_margin(panel, margin);
    fig_show_slice(panel, shown, t, marked);
    char text[FIG_TIME_TEXT];
    fig_time_text(t, text);
    fig_page_text(page, box.x + box.width / 2, box.y + box.height + 6,
                  FIG_ALIGN_CENTER, text, FIG_LETTERS_SMALL,
                  marked   ? FIG_ROLE_CONTACT
                  : t == 0 ? FIG_ROLE_START
                  : t == 1 ? FIG_ROLE_END
                           : FIG_ROLE_INK);
}

static void draw_strip(fig_page *page, const fig_shown *shown)
{
    double time[FRAMES];
    choose_times(shown, time);
    for (int i = 0; i < FRAMES; i++)
        draw_frame(page, shown, frame_box(i), time[i],
                   fig_shown_hits(shown) && time[i] == shown->toi);
}

/// `t` < 0: at some times.
static void draw_elements(fig_page *page, const fig_shown *shown, double t)
{
    if (shown->kind->axes == 2)
        fig_show_spacetime(fig_page_panel(page, left_box), shown, t);
    else if (t < 0)
        draw_strip(page, shown);
    else
        draw_frame(page, shown, film_box(), t,
                   fig_shown_hits(shown) && t >= shown->toi);
}

// The page ---------------------------------------------------------------

static const char *difference_title(const tf_query_kind *kind)
{
    return kind->vertices[0] == 2 ? "second edge minus first"
                                  : "seen from the point";
}

static void draw_titles(fig_page *page, const fig_shown *shown)
{
    char text[TEXT];
    snprintf(text, sizeof text, "%s, query %ld", shown->kind->name,
             shown->answered->number);
    if (shown->answered->titled)
        snprintf(text, sizeof text,
                 shown->kind->axes == 2 ? "in space-time" : "in space");
    fig_page_title(page, left_box, text);
    fig_page_title(page, right_box, difference_title(shown->kind));
}

static void draw_captions(fig_page *page, const fig_shown *shown, bool alike)
{
    double middle = fig_page_width(page) / 2;
    char text[TEXT];
    write_answer(shown, text);
    fig_page_text(page, middle, caption_from, FIG_ALIGN_CENTER, text,
                  FIG_LETTERS,
                  fig_shown_hits(shown) ? FIG_ROLE_CONTACT : FIG_ROLE_INK);
    write_scale(shown, alike, text);
    fig_page_text(page, middle, caption_from + line, FIG_ALIGN_CENTER, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_NEUTRAL);
}

static void draw_query(const void *subject, fig_page *page, FILE *numbers)
{
    const fig_answered *answered = subject;
    fig_shown shown = fig_shown_of(answered);
    double t = fig_page_moves(page) ? fig_page_time(page)
               : answered->still    ? answered->time
                                    : -1;
    draw_elements(page, &shown, t);
    if (t < 0 && fig_shown_hits(&shown))
        t = shown.toi;
    fig_panel *panel = fig_page_panel(page, right_box);
    fig_panel_margin(panel, margin);
    bool alike = fig_show_difference(page, panel, &shown, t);

    draw_titles(page, &shown);
    draw_captions(page, &shown, alike);
    if (answered->coordinates)
        fig_show_coordinates(page, &shown, FIG_PAGE_HEIGHT);
    print_numbers(&shown, numbers);
}

fig_drawing fig_query_drawing(const fig_answered *answered)
{
    double more = answered->coordinates ? fig_coordinates_height(answered) : 0;
    return (fig_drawing){FIG_PAGE_WIDTH, FIG_PAGE_HEIGHT + more, answered,
                         draw_query};
}
