#include "draw/query_picture.h"

#include "draw/query_parts.h"
#include "stage/figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Layout -----------------------------------------------------------------

static const tf_box left_box = {6, 24, 222, 222};
static const tf_box right_box = {230, 24, 150, 222};
static const double caption_height = 16, caption_from = 264, line = 14;

/// The margin of cameras in small panels.
static const double margin = 14;

enum {
    FRAMES = 4,
    TEXT = 256,
    TIME = 64
};

// Words ------------------------------------------------------------------

static const char *case_name(tf_decision decision)
{
    static const char *const name[] = {[TF_GENERIC] = "generic",
                                       [TF_TOUCHING] = "touching",
                                       [TF_DEGENERATE] = "degenerate"};
    return name[decision];
}

/// "t = 0.5", or "t ≈ 0.3333" where more digits follow.
static void write_time(double t, char text[TIME])
{
    char digits[TF_NUMBER_TEXT];
    bool whole = tf_number_text(t, digits);
    snprintf(text, TIME, "$t %s %s$", whole ? "=" : "≈", digits);
}

static void write_answer(const tf_shown *shown, char text[TEXT])
{
    if (!tf_shown_hits(shown)) {
        snprintf(text, TEXT, "apart for the whole step");
        return;
    }
    char time[TIME], speed[TF_NUMBER_TEXT];
    write_time(shown->toi, time);
    tf_number_text(shown->contact.speed, speed);
    snprintf(text, TEXT, "hit at %s · %s · normal speed $%s$", time,
             case_name(shown->contact.decision), speed);
}

/// What the axes of the drawing measure.
static void write_scale(const tf_shown *shown, bool alike, char text[TEXT])
{
    char span[3][TF_NUMBER_TEXT];
    for (int k = 0; k < 3; k++)
        tf_span_text(shown->fit.span[k], span[k]);
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

static void print_numbers(const tf_shown *shown, FILE *numbers)
{
    static const char *const normal[TF_AXES] = {"nx", "ny", "nz"};
    const tf_contact *contact = &shown->contact;
    fprintf(numbers, "hit %d\n", tf_shown_hits(shown));
    if (!tf_shown_hits(shown))
        return;
    tf_figure_number(numbers, "toi_lo", contact->toi_lo);
    tf_figure_number(numbers, "toi_hi", contact->toi_hi);
    for (int k = 0; k < TF_AXES; k++)
        if (k < shown->kind->axes)
            tf_figure_number(numbers, normal[k], contact->normal[k]);
    tf_figure_number(numbers, "speed", contact->speed);
    fprintf(numbers, "case %s\n", case_name(contact->decision));
}

// The elements -----------------------------------------------------------

/// Thirds of the step; the one nearest to the contact gives way to it.
static void choose_times(const tf_shown *shown, double time[FRAMES])
{
    for (int i = 0; i < FRAMES; i++)
        time[i] = (double)i / (FRAMES - 1);
    if (tf_shown_hits(shown) && shown->toi > 0 && shown->toi < 1)
        time[shown->toi < 0.5 ? 1 : 2] = shown->toi;
}

/// The i-th box of the strip, two by two.
static tf_box frame_box(int i)
{
    double width = left_box.width / 2, height = left_box.height / 2;
    int column = i % 2, row = i / 2;
    return (tf_box){left_box.x + width * column, left_box.y + height * row,
                    width, height - caption_height};
}

/// The one box of a film.
static tf_box film_box(void)
{
    tf_box box = left_box;
    box.height -= caption_height;
    return box;
}

static void draw_frame(tf_page *page, const tf_shown *shown, tf_box box,
                       double t, bool marked)
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_margin(panel, margin);
    tf_show_slice(panel, shown, t, marked);
    char text[TIME];
    write_time(t, text);
    tf_page_text(page, box.x + box.width / 2, box.y + box.height + 6,
                 TF_ALIGN_CENTER, text, TF_LETTERS_SMALL,
                 marked   ? TF_ROLE_CONTACT
                 : t == 0 ? TF_ROLE_START
                 : t == 1 ? TF_ROLE_END
                          : TF_ROLE_INK);
}

static void draw_strip(tf_page *page, const tf_shown *shown)
{
    double time[FRAMES];
    choose_times(shown, time);
    for (int i = 0; i < FRAMES; i++)
        draw_frame(page, shown, frame_box(i), time[i],
                   tf_shown_hits(shown) && time[i] == shown->toi);
}

/// `t` < 0: a still picture.
static void draw_elements(tf_page *page, const tf_shown *shown, double t)
{
    if (shown->kind->axes == 2)
        tf_show_spacetime(tf_page_panel(page, left_box), shown, t);
    else if (t < 0)
        draw_strip(page, shown);
    else
        draw_frame(page, shown, film_box(), t,
                   tf_shown_hits(shown) && t >= shown->toi);
}

// The page ---------------------------------------------------------------

static const char *difference_title(const tf_query_kind *kind)
{
    return kind->vertices[0] == 2 ? "second edge minus first"
                                  : "seen from the point";
}

static void draw_captions(tf_page *page, const tf_shown *shown, bool alike)
{
    double middle = tf_page_width(page) / 2;
    char text[TEXT];
    write_answer(shown, text);
    tf_page_text(page, middle, caption_from, TF_ALIGN_CENTER, text, TF_LETTERS,
                 tf_shown_hits(shown) ? TF_ROLE_CONTACT : TF_ROLE_INK);
    write_scale(shown, alike, text);
    tf_page_text(page, middle, caption_from + line, TF_ALIGN_CENTER, text,
                 TF_LETTERS_SMALL, TF_ROLE_NEUTRAL);
}

static void draw_query(const void *subject, tf_page *page, FILE *numbers)
{
    const tf_answered *answered = subject;
    tf_shown shown = tf_shown_of(answered->kind, answered->question.vertex,
                                 &answered->contact);
    double t = tf_page_moves(page) ? tf_page_time(page) : -1;
    draw_elements(page, &shown, t);
    if (!tf_page_moves(page) && tf_shown_hits(&shown))
        t = shown.toi;
    tf_panel *panel = tf_page_panel(page, right_box);
    tf_panel_margin(panel, margin);
    bool alike = tf_show_difference(page, panel, &shown, t);

    char text[TEXT];
    snprintf(text, sizeof text, "%s, query %ld", shown.kind->name,
             answered->number);
    tf_page_title(page, left_box, text);
    tf_page_title(page, right_box, difference_title(shown.kind));
    draw_captions(page, &shown, alike);
    print_numbers(&shown, numbers);
}

tf_drawing tf_query_drawing(const tf_answered *answered)
{
    return (tf_drawing){TF_FIGURE_WIDTH, TF_FIGURE_HEIGHT, answered,
                        draw_query};
}
