#define _GNU_SOURCE
#include "draw/commands.h"
#include "draw/query_picture.h"

#include "base/require.h"
#include "base/status.h"
#include "program/arithmetics.h"
#include "program/visible.h"

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
    fig_settings settings;
} request;

static const struct argp_option options[] = {
    {"kind", 'k', "KIND", 0,
     "Which elements: " TF_QUERY_KIND_NAMES " (vertex-face is point-triangle)",
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
                   "'%s' is not a query; write FILE:N, where N is the number "
                   "of the query in the file, from 0",
                   tf_make_visible(text).text);
        return;
    }
    *colon = '\0';
    asked->path = text;
}

static error_t understand(int key, char *text, struct argp_state *state)
{
    request *asked = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &asked->settings;
        return 0;
    case 'k':
        asked->kind = tf_query_kind_named(text);
        if (!asked->kind)
            argp_error(state, "unknown kind '%s'; choose " TF_QUERY_KIND_NAMES,
                       tf_make_visible(text).text);
        return 0;
    case ARGP_KEY_ARG:
        read_query_name(state, text);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "no query given; write FILE:N");
        return 0;
    case ARGP_KEY_END:
        if (!asked->kind)
            argp_error(state,
                       "--kind is required; choose " TF_QUERY_KIND_NAMES);
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
            return tf_text_lines_fault(&file->lines, 0,
                                       "there is no query %ld; the file has "
                                       "%ld, numbered from 0 to %ld",
                                       asked->number, file->queries,
                                       file->queries - 1);
        if (reading == TF_READ_FAULT)
            return false;
        if (file->queries > asked->number)
            return true;
    }
}

static bool read_file(const request *asked, tf_query_rows *query)
{
    tf_query_file file;
    bool good = tf_query_file_open(&file, asked->path, asked->kind, 0) &&
                read_query(&file, asked, query);
    if (!good)
        tf_text_lines_print_fault(&file.lines, "tanglefree-draw");
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
    tf_status status = tf_query(tf_arithmetic_named("exact"), kind->axes,
                                kind->vertices[0], first, kind->vertices[1],
                                first + kind->vertices[0], &answered->contact);
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
    request asked = {0};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    fig_answered answered = {.kind = asked.kind, .number = asked.number};
    tf_query_rows query;
    if (!read_file(&asked, &query))
        return 2;
    take_vertices(&query, &answered);
    answer(&answered);
    fig_drawing drawing = fig_query_drawing(&answered);
    return fig_drawing_make(&drawing, &asked.settings);
}
