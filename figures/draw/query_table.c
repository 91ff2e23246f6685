// The coordinates of a query, as a table.
#include "draw/query_parts.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

/// Where its columns are, and the height of its rows, in points.
static const double column[] = {62, 88, 226}, row_height = 13, room_below = 8;

enum {
    TEXT = 160
};

/// A table in the making: the baseline of its next row, and whether a number
/// has been rounded.
typedef struct table {
    fig_page *page;
    double y;
    bool rounded;
} table;

static void write_cell(const table *rows, int i, const char *text,
                       fig_role role)
{
    fig_page_text(rows->page, column[i], rows->y, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, role);
}

static void write_place(table *rows, int i, int axes, tf_vector at,
                        fig_role role)
{
    char text[TEXT];
    int length = snprintf(text, sizeof text, "$(");
    for (int k = 0; k < axes; k++) {
        char number[FIG_NUMBER_TEXT];
        rows->rounded |= !fig_number_text(at.x[k], number);
        length += snprintf(text + length, sizeof text - (size_t)length, "%s%s",
                           k == 0 ? "" : ", ", number);
    }
    snprintf(text + length, sizeof text - (size_t)length, ")$");
    write_cell(rows, i, text, role);
}

static void write_vertices(table *rows, const fig_shown *shown, int element)
{
    const tf_query_kind *kind = shown->kind;
    const tf_worldline *given =
        shown->given + (element == 0 ? 0 : kind->vertices[0]);
    fig_role role = fig_shown_role(shown, element);
    for (int i = 0; i < kind->vertices[element]; i++) {
        char name[FIG_NAME_TEXT];
        fig_shown_name(shown, element, i, 0, name);
        write_cell(rows, 0, name, role);
        for (int t = 0; t < 2; t++)
            write_place(rows, 1 + t, kind->axes,
                        fig_vector_of(given[i].at[t].x), role);
        rows->y += row_height;
    }
}

/// Where the contact is; what is no more than roundoff is zero.
static tf_vector rounded_meeting(const fig_shown *shown)
{
    const tf_query_kind *kind = shown->kind;
    tf_vector meeting = fig_shown_meeting(shown);
    for (int k = 0; k < kind->axes; k++) {
        double most = 0;
        for (int i = 0; i < 2 * (kind->vertices[0] + kind->vertices[1]); i++)
            most = fmax(most, fabs(shown->given[i / 2].at[i % 2].x[k]));
        if (fabs(meeting.x[k]) < 8 * DBL_EPSILON * most)
            meeting.x[k] = 0;
    }
    return meeting;
}

static void write_contact(table *rows, const fig_shown *shown)
{
    char time[FIG_TIME_TEXT], text[TEXT];
    fig_time_text(shown->toi, time);
    snprintf(text, sizeof text, "contact at %s", time);
    write_cell(rows, 1, text, FIG_ROLE_CONTACT);
    write_place(rows, 2, shown->kind->axes, rounded_meeting(shown),
                FIG_ROLE_CONTACT);
    rows->y += row_height;
    write_cell(rows, 1, "its normal $\\b{n}$", FIG_ROLE_CONTACT);
    write_place(rows, 2, shown->kind->axes,
                fig_vector_of(shown->contact.normal), FIG_ROLE_CONTACT);
    rows->y += row_height;
}

void fig_show_coordinates(fig_page *page, const fig_shown *shown, double top)
{
    table rows = {.page = page, .y = top + row_height};
    write_cell(&rows, 1, "$t = 0$", FIG_ROLE_START);
    write_cell(&rows, 2, "$t = 1$", FIG_ROLE_END);
    rows.y += row_height;
    write_vertices(&rows, shown, 0);
    write_vertices(&rows, shown, 1);
    if (fig_shown_hits(shown))
        write_contact(&rows, shown);
    if (rows.rounded)
        write_cell(&rows, 1, "numbers are rounded to four digits",
                   FIG_ROLE_NEUTRAL);
}

double fig_coordinates_height(const fig_answered *answered)
{
    const tf_query_kind *kind = answered->kind;
    int rows = 1 + kind->vertices[0] + kind->vertices[1] + 1;
    if (answered->contact.verdict == TF_HIT)
        rows += 2;
    return rows * row_height + room_below;
}
