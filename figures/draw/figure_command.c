#include "draw/commands.h"
#include "draw/drawing.h"
#include "figures.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

// figure -----------------------------------------------------------------

typedef struct request {
    const tf_figure *figure;
    tf_settings settings;
} request;

static void choose(struct argp_state *state, const char *name)
{
    request *asked = state->input;
    if (asked->figure)
        argp_error(state, "'%s' is one figure too many; draw one at a time",
                   name);
    asked->figure = tf_figure_named(name);
    if (asked->figure)
        return;
    char names[1024] = "";
    for (int i = 0; tf_figures[i]; i++)
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s",
                 i == 0 ? "" : ", ", tf_figures[i]->name);
    argp_error(state, "no figure is named '%s'; choose one of %s", name, names);
}

/// Refuse a film in which nothing would happen.
static void check_film(struct argp_state *state)
{
    const request *asked = state->input;
    if (asked->settings.film && !asked->settings.turntable &&
        !asked->figure->moves)
        argp_error(state, "nothing moves in '%s'; add --turntable",
                   asked->figure->name);
}

static error_t understand_figure(int key, char *text, struct argp_state *state)
{
    request *asked = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &asked->settings;
        return 0;
    case ARGP_KEY_ARG:
        choose(state, text);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a figure is missing; 'tanglefree-draw list' names "
                          "them");
        return 0;
    case ARGP_KEY_SUCCESS:
        check_film(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void draw_figure(const void *subject, tf_page *page, FILE *numbers)
{
    const tf_figure *figure = subject;
    figure->draw(page, numbers);
}

int tf_draw_figure(int argc, char *argv[])
{
    static const struct argp parser = {
        .parser = understand_figure,
        .args_doc = "NAME",
        .doc = "Draw a figure of the book and print the numbers that it "
               "shows.\vEach line of output is a key and its value.\n\n"
               "Exit status: 0 if all was drawn, 2 after bad usage or a "
               "failure.",
        .children = tf_settings_options,
    };
    request asked = {0};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    tf_drawing drawing = {asked.figure->width, asked.figure->height,
                          asked.figure, draw_figure};
    return tf_drawing_make(&drawing, &asked.settings);
}

// list -------------------------------------------------------------------

static error_t understand_list(int key, char *text, struct argp_state *state)
{
    if (key != ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN;
    argp_error(state, "'%s' is too much; list takes no argument", text);
    return 0;
}

int tf_draw_list(int argc, char *argv[])
{
    static const struct argp parser = {
        .parser = understand_list,
        .doc = "List the figures of the book: their names and titles.",
    };
    argp_parse(&parser, argc, argv, 0, NULL, NULL);
    for (int i = 0; tf_figures[i]; i++)
        printf("%-18s %s\n", tf_figures[i]->name, tf_figures[i]->title);
    if (fflush(stdout) == 0)
        return 0;
    fprintf(stderr, "tanglefree-draw: standard output: cannot write: %s\n",
            strerror(errno));
    return 2;
}
