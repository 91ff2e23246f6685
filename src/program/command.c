//: Include what commands need
#include "program/command.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>

//: Number the options for argp
/// The key of an option is its letter, or this and its row.
enum {
    NO_LETTER = 256,
    OLD = 512,        // the same of an old spelling
    OPTIONS_ROOM = 32 // more than a command has
};

static int key_of(const tf_option *option)
{
    return option->letter ? option->letter
                          : NO_LETTER + (int)(option - tf_options);
}

/// NULL: a command has no such option.
static const tf_option *option_of(const tf_command *command, int key)
{
    for (const tf_option *option = tf_options; option->name; option++)
        if (option->commands & command->set && key_of(option) == key)
            return option;
    return NULL;
}

static int key_of_old(const tf_old_spelling *old)
{
    return old->letter ? old->letter : OLD + (int)(old - tf_old_spellings);
}

/// NULL: it is none of a command.
static const tf_old_spelling *old_spelling_of(const tf_command *command,
                                              int key)
{
    for (const tf_old_spelling *old = tf_old_spellings; old->commands; old++)
        if (old->commands & command->set && key_of_old(old) == key)
            return old;
    return NULL;
}

//: List the options for argp
/// An old spelling may have an argument, and is not told of.
static struct argp_option *list_old(const tf_command *command,
                                    struct argp_option *list)
{
    for (const tf_old_spelling *old = tf_old_spellings; old->commands; old++)
        if (old->commands & command->set)
            *list++ = (struct argp_option){
                old->name,
                key_of_old(old),
                "",
                OPTION_ARG_OPTIONAL | OPTION_HIDDEN | OPTION_NO_USAGE,
                NULL,
                0};
    return list;
}

static void list_options(const tf_command *command,
                         struct argp_option list[OPTIONS_ROOM])
{
    int count = 0;
    for (const tf_option *option = tf_options; option->name; option++)
        if (option->commands & command->set)
            list[count++] =
                (struct argp_option){option->name,     key_of(option),
                                     option->argument, 0,
                                     option->help,     0};
    *list_old(command, list + count) = (struct argp_option){0};
}

//: Check the arguments
/// Ends the program if an option lacks, and says what it may be or is for.
static void require_option(const tf_option *option, const tf_request *request)
{
    char purpose[200];
    if (!option->required || tf_request_gave(request, option->name))
        return;
    snprintf(purpose, sizeof purpose, "%s",
             option->choices ? tf_list_choices(option->choices).text
                             : option->help);
    purpose[0] = (char)tolower(purpose[0]);
    tf_request_refuse(request, "--%s %s is required: %s", option->name,
                      option->argument, purpose);
}

static void check_arguments(const tf_command *command, tf_request *request)
{
    if (request->operands < command->least || request->operands > command->most)
        tf_request_refuse(request, "%s", command->wanted);
    for (const tf_option *option = tf_options; option->name; option++)
        if (option->commands & command->set)
            require_option(option, request);
    if (command->check)
        command->check(request);
}

//: Parse an argument
/// What argp passes on.
typedef struct parsing {
    const tf_command *command;
    tf_request request;
} parsing;

static error_t parse_argument(int key, char *text, struct argp_state *state)
{
    parsing *own = state->input;
    tf_request *request = &own->request;
    const tf_option *option = option_of(own->command, key);
    const tf_old_spelling *old = old_spelling_of(own->command, key);
    request->state = state;
    if (old)
        tf_old_spelling_refuse(old, request);
    if (option) {
        tf_option_read(option, text, request);
        request->given |= UINT64_C(1) << (option - tf_options);
    } else if (key == ARGP_KEY_ARGS) {
        request->operand = state->argv + state->next;
        request->operands = state->argc - state->next;
    } else if (key == ARGP_KEY_END)
        check_arguments(own->command, request);
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

//: Run a command
/// Says all of an option.
static char *complete_help(int key, const char *text, void *input)
{
    const parsing *own = input;
    const tf_option *option = option_of(own->command, key);
    return option ? tf_option_help(option) : (char *)text;
}

int tf_command_run(const tf_command *command, int argc, char *argv[])
{
    char name[64], *before = argv[0];
    snprintf(name, sizeof name, "tanglefree %s", command->name);
    struct argp_option list[OPTIONS_ROOM];
    list_options(command, list);
    const struct argp parser = {.options = list,
                                .parser = parse_argument,
                                .args_doc = command->operands,
                                .doc = command->description,
                                .help_filter = complete_help};
    parsing own = {.command = command};
    tf_request_begin(&own.request, command->set);
    argv[0] = name; // which messages begin with
    argp_parse(&parser, argc, argv, 0, NULL, &own);
    argv[0] = before;
    return command->run(&own.request);
}
