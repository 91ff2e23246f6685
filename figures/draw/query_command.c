#define _GNU_SOURCE
#include "draw/commands.h"
#include "draw/query_picture.h"

#include "arithmetic/exact.h"
#include "base/require.h"
#include "base/status.h"
#include "files/visible.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Arguments --------------------------------------------------------------

typedef struct request {
    const tf_query_kind *kind;
    char *path;
    long number;
    char *names; ///< those of --labels, cut at their commas
    char *name[FIG_QUERY_VERTICES];
    bool coordinates;
    double time; ///< -1: not told
    fig_settings settings;
} request;

enum {
    TIME = 'T',
    COORDINATES = 'C'
};

static const struct argp_option options[] = {
    {"kind", 'k', "KIND", 0,
     "Which elements: point-edge, point-triangle, edge-edge or vertex-face "
     "(which is point-triangle)",
     0},
    {"at", TIME, "T", 0,
     "Draw the elements at this time of the step, from 0 to 1, in place of "
     "four times",
     0},
    {"time", 0, NULL, OPTION_ALIAS, NULL, 0},
    {"coordinates", COORDINATES, NULL, 0,
     "Write the coordinates of the vertices, of the contact and of its normal "
     "below, and draw the normal as an arrow",
     0},
    {0},
};

static bool read_number(const char *text, long *number)
{
    char *end;
    errno = 0;
    *number = strtol(text, &end, 10);
    return *text >= '0' && *text <= '9' && *end == '\0' && errno == 0;
}

/// Split FILE:N at its last colon.
static void read_query_name(struct argp_state *state, char *text)
{
    request *asked = state->input;
    if (asked->path)
        argp_error(state, "unexpected '%s'; draw one query at a time",
                   tf_make_visible(text).text);
    char *colon = strrchr(text, ':');
    if (!colon || colon == text || !read_number(colon + 1, &asked->number)) {
        argp_error(state,
                   "a query must be FILE:N, where N is its number in the file, "
                   "from 0, got '%s'",
                   tf_make_visible(text).text);
        return;
    }
    *colon = '\0';
    asked->path = text;
}

/// Split text at its commas.  Returns how many names there are; -1: one of
/// them is empty or too long.
static int split_names(char *text, char *name[FIG_QUERY_VERTICES])
{
    int count = 0;
    for (char *next; (next = strsep(&text, ",")); count++) {
        if (*next == '\0' || strlen(next) > FIG_NAME_TEXT - 4)
            return -1;
        if (count < FIG_QUERY_VERTICES)
            name[count] = next;
    }
    return count;
}

/// Read the names that --labels gives, one a vertex.
static void read_names(struct argp_state *state)
{
    request *asked = state->input;
    const tf_query_kind *kind = asked->kind;
    const char *given = asked->settings.names;
    int wanted = kind->vertices[0] + kind->vertices[1];
    asked->names = strdup(given);
    if (split_names(asked->names, asked->name) != wanted)
        argp_error(state,
                   "--labels must be none or %d names, one a vertex, such as "
                   "%s, got '%s'",
                   wanted, wanted == 3 ? "q,u,v" : "q,u,v,w",
                   tf_make_visible(given).text);
    for (int i = 0; i < wanted; i++) {
        char text[FIG_NAME_TEXT];
        snprintf(text, sizeof text, "$%s'$", asked->name[i]);
        fig_check_text(state, "--labels", text);
    }
}

/// See that the options go together.
static void check(struct argp_state *state)
{
    const request *asked = state->input;
    if (asked->settings.names)
        read_names(state);
    if (asked->time >= 0 && !asked->settings.picture)
        argp_error(state, "--at is for pictures; add -o FILE.png");
}

static error_t understand(int key, char *text, struct argp_state *state)
{
    request *asked = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &asked->settings;
        return 0;
    case 'k':
        asked->kind = tf_choice_named(tf_query_kinds, text);
        if (!asked->kind)
            argp_error(state, "--kind must be %s, got '%s'",
                       tf_list_choices(tf_query_kinds).text,
                       tf_make_visible(text).text);
        return 0;
    case TIME:
        asked->time = fig_read_time(state, "--at", text);
        return 0;
    case COORDINATES:
        asked->coordinates = true;
        return 0;
    case ARGP_KEY_SUCCESS:
        check(state);
        return 0;
    case ARGP_KEY_ARG:
        read_query_name(state, text);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a query is required: FILE:N");
        return 0;
    case ARGP_KEY_END:
        if (!asked->kind)
            argp_error(state, "--kind KIND is required: %s",
                       tf_list_choices(tf_query_kinds).text);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

// The query --------------------------------------------------------------

/// Read up to the requested query.
static bool read_query(tf_query_file *file, const request *asked,
                       tf_query_rows *query)
{
    for (;;) {
        tf_reading reading = tf_query_file_next(file, query);
        if (reading == TF_READ_END)
            return tf_fault_set(
                file->lines.text.fault, file->lines.text.name, -1,
                "there is no query %ld; they are numbered from 0 to %zu",
                asked->number, file->queries - 1);
        if (reading == TF_READ_FAULT)
            return false;
        if (file->queries > (size_t)asked->number)
            return true;
    }
}

static bool read_file(const request *asked, tf_query_rows *query)
{
    tf_query_file file;
    tf_fault fault = {0};
    bool good =
        tf_query_file_open(&file, asked->path, asked->kind, 0, &fault) &&
        read_query(&file, asked, query);
    tf_fault_print(&fault, "tanglefree-draw");
    tf_query_file_close(&file);
    return good;
}

/// The vertices of a query in the order of its rows.
static void take_vertices(const tf_query_rows *query, fig_answered *answered)
{
    const tf_query_kind *kind = answered->kind;
    const double *start = query->x[0], *end = query->x[1];
    for (int i = 0; i < kind->vertices[0] + kind->vertices[1]; i++) {
        answered->vertex[i] = tf_worldline_between(kind->axes, start, end);
        start += kind->axes;
        end += kind->axes;
    }
}

static void answer(fig_answered *answered)
{
    const tf_query_kind *kind = answered->kind;
    const tf_worldline *first = answered->vertex;
    tf_status status = tf_query(&tf_exact, kind->axes, kind->vertices[0], first,
                                kind->vertices[1], first + kind->vertices[0],
                                &answered->contact);
    // Read from a file, all coordinates are finite.
    TF_REQUIRE(status == TF_OK);
}

int fig_draw_query(int argc, char *argv[])
{
    static const struct argp parser = {
        .options = options,
        .parser = understand,
        .args_doc = "FILE:N",
        .doc = "Draw query N of a file: the elements, their difference, and "
               "where they first meet.\vThe format of FILE is that of "
               "'tanglefree query'; for standard input, write /dev/stdin.  "
               "Queries are numbered from 0.  Coordinates of any size are "
               "scaled to fit.  The answer is printed; each line is a key and "
               "its value.\n\n"
               "Exit status: 0 if everything was drawn, 2 if the arguments or "
               "the input are invalid or something failed.",
        .children = fig_settings_options,
    };
    request asked = {.time = -1};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    fig_answered answered = {.kind = asked.kind,
                             .number = asked.number,
                             .names = asked.names ? asked.name : NULL,
                             .titled = asked.settings.title != NULL,
                             .still = asked.time >= 0,
                             .time = asked.time,
                             .coordinates = asked.coordinates};
    tf_query_rows query;
    int status = 2;
    if (read_file(&asked, &query)) {
        take_vertices(&query, &answered);
        answer(&answered);
        fig_drawing drawing = fig_query_drawing(&answered);
        status = fig_drawing_make(&drawing, &asked.settings);
    }
    free(asked.names);
    return status;
}
