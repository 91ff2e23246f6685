#define _GNU_SOURCE
#include "draw/commands.h"
#include "draw/query_picture.h"

#include "contract.h"
#include "program/arithmetics.h"

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
    tf_settings settings;
} request;

static const struct argp_option options[] = {
    {"kind", 'k', "KIND", 0,
     "What meets: " TF_QUERY_KIND_NAMES " (vertex-face is point-triangle)", 0},
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
static void read_query(struct argp_state *state, char *text)
{
    request *asked = state->input;
    if (asked->path)
        argp_error(state, "'%s' is one query too many; draw one at a time",
                   text);
    char *colon = strrchr(text, ':');
    if (!colon || colon == text || !read_number(colon + 1, &asked->number)) {
        argp_error(state,
                   "'%s' names no query; write FILE:N, with N from 0, the "
                   "query's number as 'tanglefree query' counts",
                   text);
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
            argp_error(state,
                       "no kind is named '%s'; choose " TF_QUERY_KIND_NAMES,
                       text);
        return 0;
    case ARGP_KEY_ARG:
        read_query(state, text);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a query is missing; name it as FILE:N");
        return 0;
    case ARGP_KEY_END:
        if (!asked->kind)
            argp_error(state, "--kind is missing; choose " TF_QUERY_KIND_NAMES);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

// The query --------------------------------------------------------------

/// Read up to the query asked for.
static bool read_question(tf_query_file *file, const request *asked,
                          tf_question *question)
{
    for (;;) {
        tf_reading reading = tf_query_file_next(file, question);
        if (reading == TF_READ_END)
            return tf_query_file_fault(
                file, 0,
                "query %ld is beyond the end; the file has %ld, from 0 to %ld",
                asked->number, file->queries, file->queries - 1);
        if (reading == TF_READ_FAULT)
            return false;
        if (file->queries > asked->number)
            return true;
    }
}

static void complain(const tf_query_file *file)
{
    fprintf(stderr, "tanglefree-draw: %s:", file->name);
    if (file->fault_line > 0)
        fprintf(stderr, "%ld:", file->fault_line);
    fprintf(stderr, " %s\n", file->fault);
}

static bool read_file(const request *asked, tf_question *question)
{
    tf_query_file file;
    bool good = tf_query_file_open(&file, asked->path, asked->kind, 0) &&
                read_question(&file, asked, question);
    if (!good)
        complain(&file);
    tf_query_file_close(&file);
    return good;
}

static void answer(tf_answered *answered)
{
    const tf_query_kind *kind = answered->kind;
    const tf_worldline *first = answered->question.vertex;
    tf_status status = tf_query(tf_arithmetic_named("exact"), kind->axes,
                                kind->vertices[0], first, kind->vertices[1],
                                first + kind->vertices[0], &answered->contact);
    // Read from a file, all coordinates are finite.
    TF_REQUIRE(status == TF_OK);
}

int tf_draw_query(int argc, char *argv[])
{
    static const struct argp parser = {
        .options = options,
        .parser = understand,
        .args_doc = "FILE:N",
        .doc = "Draw a query of a file: the elements, their difference and "
               "where they first meet.\vFILE is as for 'tanglefree query' "
               "(standard input is /dev/stdin), and queries count from 0.  "
               "Coordinates of any size are scaled to fit.  The answer is "
               "printed, each "
               "line a key and its value.\n\n"
               "Exit status: 0 if all was drawn, 2 after bad usage, bad input "
               "or a failure.",
        .children = tf_settings_options,
    };
    request asked = {0};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    tf_answered answered = {.kind = asked.kind, .number = asked.number};
    if (!read_file(&asked, &answered.question))
        return 2;
    answer(&answered);
    tf_drawing drawing = tf_query_drawing(&answered);
    return tf_drawing_make(&drawing, &asked.settings);
}
