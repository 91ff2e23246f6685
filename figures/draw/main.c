#include "contract.h"
#include "draw/commands.h"

#include <argp.h>
#include <string.h>

const char *argp_program_version = "tanglefree-draw 0.1.0";

static const char description[] =
    "Draw the figures of the book, and queries.\v"
    "Commands:\n"
    "  figure     draw a figure of the book\n"
    "  list       list the figures\n"
    "  query      draw a query of a file\n"
    "\n"
    "'tanglefree-draw COMMAND --help' tells more.";

typedef struct command {
    const char *name;
    char *full_name; ///< for messages
    int (*run)(int argc, char *argv[]);
} command;

static const command commands[] = {
    {"figure", "tanglefree-draw figure", tf_draw_figure},
    {"list", "tanglefree-draw list", tf_draw_list},
    {"query", "tanglefree-draw query", tf_draw_query},
};

/// Run the command with the arguments from its name on.
static error_t understand(int key, char *text, struct argp_state *state)
{
    int *status = state->input;
    if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "a command is missing; choose figure, list or query");
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
    argp_error(state, "no command is named '%s'; choose figure, list or query",
               text);
    return 0;
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
    argv[0] = name;
    int status = 0;
    argp_parse(&parser, argc, argv, ARGP_IN_ORDER, NULL, &status);
    return status;
}
