#include "base/environment.h"
#include "base/require.h"
#include "base/version.h"
#include "draw/commands.h"
#include "files/fault.h"
#include "files/visible.h"

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *argp_program_version = "tanglefree-draw " TF_VERSION;

static const char description[] =
    "Draw the figures of the book, queries, surfaces and films of them.\v"
    "Commands:\n"
    "  figure     draw a figure of the book\n"
    "  film       draw a film of the frames of a simulation\n"
    "  list       list the figures\n"
    "  query      draw a query of a file\n"
    "  surface    draw a surface, or its step\n"
    "\n"
    "'tanglefree-draw COMMAND --help' describes a command.";

typedef struct command {
    const char *name;
    char *full_name; ///< for messages
    int (*run)(int argc, char *argv[]);
} command;

static const command commands[] = {
    {"figure", "tanglefree-draw figure", fig_draw_figure},
    {"film", "tanglefree-draw film", fig_draw_film},
    {"list", "tanglefree-draw list", fig_draw_list},
    {"query", "tanglefree-draw query", fig_draw_query},
    {"surface", "tanglefree-draw surface", fig_draw_surface},
};

/// Run the command with the arguments from its name on.
static error_t understand(int key, char *text, struct argp_state *state)
{
    int *status = state->input;
    if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "a command is required; --help lists the commands");
    if (key != ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN;
    int first = state->next - 1;
    state->next = state->argc;
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (strcmp(text, commands[i].name) == 0) {
            state->argv[first] = commands[i].full_name;
            *status = commands[i].run(state->argc - first, state->argv + first);
            return 0;
        }
    argp_error(state, "unknown command '%s'; --help lists the commands",
               tf_make_visible(text).text);
    return 0;
}

/// --help, --version and lists end the program with output still unwritten.
static void finish_output(void)
{
    if (fflush(stdout) == 0)
        return;
    tf_fault fault;
    tf_fault_set_unwritten(&fault, "standard output", errno);
    tf_fault_print(&fault, "tanglefree-draw");
    _exit(argp_err_exit_status);
}

int main(int argc, char *argv[])
{
    static char name[] = "tanglefree-draw";
    static const struct argp parser = {
        .parser = understand,
        .args_doc = "COMMAND [ARGUMENT...]",
        .doc = description,
    };
    TF_REQUIRE(argc > 0 && tf_environment_is_ieee());
    argp_err_exit_status = 2;
    atexit(finish_output);
    argv[0] = name;
    int status = 0;
    argp_parse(&parser, argc, argv, ARGP_IN_ORDER, NULL, &status);
    return status;
}
