//: Include what the program needs
#define _GNU_SOURCE
#include "base/version.h"
#include "files/fault.h"
#include "files/visible.h"
#include "program/command.h"

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

//: List the commands
static const tf_command *const commands[] = {
    &tf_query_command,    &tf_detect_command,   &tf_check_command,
    &tf_resolve_command,  &tf_weld_command,     &tf_remesh_command,
    &tf_simulate_command, &tf_untangle_command,
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
        fprintf(stream, "  %-10s %s\n", commands[i]->name,
                commands[i]->purpose);
    fputs("\n'tanglefree COMMAND --help' describes a command.", stream);
    fclose(stream);
    return list;
}

//: Run the command that is the first argument
static void run_command(const struct argp_state *state, const char *name)
{
    int argc = state->argc - state->next + 1;
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(name, commands[i]->name) == 0)
            exit(tf_command_run(commands[i], argc,
                                state->argv + state->argc - argc));
    argp_error(state, "unknown command '%s'; --help lists the commands",
               tf_make_visible(name).text);
}

static error_t parse_argument(int key, char *text, struct argp_state *state)
{
    if (key == ARGP_KEY_ARG)
        run_command(state, text);
    else if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "a command is required; --help lists the commands");
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

//: Make sure that the last words are written
// --help and --version end the program inside argp.
static void finish_output(void)
{
    if (fflush(stdout) == 0)
        return;
    tf_fault fault;
    tf_fault_set_unwritten(&fault, "standard output", errno);
    tf_fault_print(&fault, "tanglefree");
    _exit(argp_err_exit_status);
}

//: Run the program
int main(int argc, char *argv[])
{
    static const struct argp parser = {
        .parser = parse_argument,
        .args_doc = "COMMAND [ARGUMENT...]",
        .doc = "Exact continuous collision detection.",
        .help_filter = describe,
    };
    static char name[] = "tanglefree";
    argp_err_exit_status = 2;
    atexit(finish_output);
    argv[0] = name;
    argp_parse(&parser, argc, argv, ARGP_IN_ORDER, NULL, NULL);
    return argp_err_exit_status;
}
