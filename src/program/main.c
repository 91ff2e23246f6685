//: Include what the program needs
#define _GNU_SOURCE
#include "base/version.h"
#include "files/visible.h"
#include "program/query_command.h"
#include "program/remesh_command.h"
#include "program/resolve_command.h"
#include "program/simulate_command.h"
#include "program/surface_command.h"

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

//: List the commands
typedef struct command {
    const char *name;
    char *full_name; ///< for messages
    const char *purpose;
    int (*run)(int argc, char *argv[]);
} command;

static const command commands[] = {
    {"query", "tanglefree query",
     "compute whether, when and how elements first meet", tf_query_command},
    {"detect", "tanglefree detect", "find every contact of a moving surface",
     tf_detect_command},
    {"check", "tanglefree check", "find where a surface intersects itself",
     tf_check_command},
    {"resolve", "tanglefree resolve",
     "change the end of a step such that nothing meets", tf_resolve_command},
    {"remesh", "tanglefree remesh",
     "give a surface triangles that are nearly equilateral", tf_remesh_command},
    {"simulate", "tanglefree simulate", "simulate a scene of cloth",
     tf_simulate_command},
};
enum {
    COMMANDS = sizeof commands / sizeof *commands
};

//: Describe the program
const char *argp_program_version = "tanglefree " TF_VERSION;

static char *describe(int key, const char *text, void *input)
{
    (void)input;
    if (key != ARGP_KEY_HELP_POST_DOC)
        return (char *)text;
    char *list = NULL;
    size_t length;
    FILE *stream = open_memstream(&list, &length);
    if (!stream)
        return NULL;
    fputs("Commands:\n", stream);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stream, "  %-10s %s\n", commands[i].name, commands[i].purpose);
    fputs("\n'tanglefree COMMAND --help' describes a command.", stream);
    fclose(stream);
    return list;
}

//: Find the command among the arguments
typedef struct choice {
    const command *command;
    int argc;
    char **argv; ///< of the command, its name first
} choice;

static void choose(choice *chosen, struct argp_state *state, const char *name)
{
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(name, commands[i].name) == 0)
            chosen->command = &commands[i];
    if (!chosen->command)
        argp_error(state, "unknown command '%s'; --help lists the commands",
                   tf_make_visible(name).text);
    chosen->argv = state->argv + state->next - 1;
    chosen->argc = state->argc - state->next + 1;
    state->next = state->argc;
}

//: Choose the command
static error_t parse_command(int key, char *text, struct argp_state *state)
{
    if (key == ARGP_KEY_ARG)
        choose(state->input, state, text);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "no command given; --help lists the commands");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

static choice choose_command(int argc, char *argv[])
{
    static const struct argp parser = {
        .parser = parse_command,
        .args_doc = "COMMAND [ARGUMENT...]",
        .doc = "Exact continuous collision detection.",
        .help_filter = describe,
    };
    choice chosen = {0};
    argp_parse(&parser, argc, argv, ARGP_IN_ORDER, NULL, &chosen);
    return chosen;
}

//: Make sure that the last words are written
// --help and --version end the program inside argp.
static void finish_output(void)
{
    if (fflush(stdout) == 0)
        return;
    fprintf(stderr, "tanglefree: standard output: cannot write: %s\n",
            strerror(errno));
    _exit(argp_err_exit_status);
}

//: Run the program
int main(int argc, char *argv[])
{
    static char name[] = "tanglefree";
    argp_err_exit_status = 2;
    atexit(finish_output);

    argv[0] = name;
    choice chosen = choose_command(argc, argv);
    chosen.argv[0] = chosen.command->full_name;
    return chosen.command->run(chosen.argc, chosen.argv);
}
