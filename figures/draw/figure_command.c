#include "draw/commands.h"
#include "draw/drawing.h"
#include "files/visible.h"
#include "kit/figures.h"

#include <stdio.h>
#include <string.h>

// figure -----------------------------------------------------------------

typedef struct request {
    const fig_figure *figure;
    fig_settings settings;
} request;

static void choose(struct argp_state *state, const char *name)
{
    request *asked = state->input;
    if (asked->figure)
        argp_error(state, "unexpected '%s'; draw one figure at a time",
                   tf_make_visible(name).text);
    asked->figure = fig_figure_named(name);
    if (asked->figure)
        return;
    argp_error(state,
               "unknown figure '%s'; 'tanglefree-draw list' lists the figures",
               tf_make_visible(name).text);
}

/// Refuse a film in which nothing would happen.
static void check_film(struct argp_state *state)
{
    const request *asked = state->input;
    if (asked->settings.film && !asked->settings.turntable &&
        !asked->figure->moves)
        argp_error(state, "nothing in '%s' moves; add --turntable",
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
        argp_error(state, "a figure is required; 'tanglefree-draw list' "
                          "lists the figures");
        return 0;
    case ARGP_KEY_SUCCESS:
        fig_refuse_names(state, &asked->settings);
        check_film(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void draw_figure(const void *subject, fig_page *page, FILE *numbers)
{
    const fig_figure *figure = subject;
    figure->draw(page, numbers);
}

int fig_draw_figure(int argc, char *argv[])
{
    static const struct argp parser = {
        .parser = understand_figure,
        .args_doc = "NAME",
        .doc = "Draw a figure of the book and print the numbers that it "
               "shows.\vEach line of output is a key and its value.\n\n"
               "Exit status: 0 if everything was drawn, 2 if the arguments "
               "are invalid or something failed.",
        .children = fig_settings_options,
    };
    request asked = {0};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    fig_drawing drawing = {asked.figure->width, asked.figure->height,
                           asked.figure, draw_figure};
    return fig_drawing_make(&drawing, &asked.settings);
}

// list -------------------------------------------------------------------

static error_t understand_list(int key, char *text, struct argp_state *state)
{
    if (key != ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN;
    argp_error(state, "unexpected '%s'; list takes no arguments",
               tf_make_visible(text).text);
    return 0;
}

int fig_draw_list(int argc, char *argv[])
{
    static const struct argp parser = {
        .parser = understand_list,
        .doc = "List the figures of the book: their names and titles.",
    };
    argp_parse(&parser, argc, argv, 0, NULL, NULL);
    for (int i = 0; fig_figures[i]; i++)
        printf("%-21s %s\n", fig_figures[i]->name, fig_figures[i]->title);
    return 0;
}
