//: Declare what a command line requests
#pragma once

#include "files/choice.h"
#include "files/query_file.h"
#include "files/record.h"
#include "program/methods.h"
#include "query/narrow_phase.h"
#include "response/zone.h"

#include <argp.h>
#include <stdbool.h>
#include <stdint.h>

/// What the command line requests of a command: its operands, and the values of
/// its options, given or usual.
typedef struct tf_request {
    char **operand;
    int operands;
    struct argp_state *state; ///< of parsing
    uint64_t given;           ///< which rows of the table of options

    const tf_format *format;
    int threads;               ///< 0: one for each processor
    const tf_query_kind *kind; ///< of query
    const tf_method *method, *against;
    tf_method_options answering; ///< with its arithmetic also of detect
    const tf_narrow_phase *narrow_phase;
    bool first;
    bool each;       ///< of check
    const char *out; ///< a file, "-", or a folder of simulate
    const char *fixed, *masses,
        *vertex_friction; ///< of resolve, the first also of untangle: files, or
                          ///< NULL
    bool exempt_crossings; ///< of resolve
    const tf_zone_solver *solver;
    double separation, friction, restitution, restitution_threshold;
    int substeps;
    double thickness; ///< of check and resolve: 0 if not given
    double within;    ///< of weld: a length, 0 if not given
    double edge;      ///< of remesh and simulate: a length, 0 if not given
    int rounds;
    double crease;              ///< of remesh: degrees
    const char *keep, *lengths; ///< of remesh: files, or NULL
    double error;               ///< of remesh: a distance, 0 if not given
    bool strict;                ///< of remesh
    int steps, size;            ///< of simulate
    bool resume;
} tf_request;

//: Declare the table of options
/// The commands, as a set.
typedef enum tf_command_set {
    TF_QUERY = 1,
    TF_DETECT = 2,
    TF_CHECK = 4,
    TF_RESOLVE = 8,
    TF_REMESH = 16,
    TF_SIMULATE = 32,
    TF_WELD = 64,
    TF_UNTANGLE = 128
} tf_command_set;

/// What the argument of an option is.
typedef enum tf_argument_type {
    TF_SWITCH = 0, ///< there is none; sets a bool
    TF_TEXT,       ///< as it is
    TF_CHOICE,     ///< one of the names of a list; sets a pointer
    TF_WHOLE,      ///< an int
    TF_REAL        ///< a double
} tf_argument_type;

/// A row of the table, which ends with one without a name.
typedef struct tf_option {
    unsigned commands; ///< that have it
    int letter;        ///< 0: it has none
    const char *name;
    const char *argument; ///< what it is called by help; NULL: there is none
    size_t place;         ///< of the value in a request
    tf_argument_type type;
    bool required;
    const tf_choice *choices;
    const tf_choice *formats; ///< of a text: arguments that it had before 1.0
    double least, most;       ///< of a number; the least positive one: above 0
    const char *usual; ///< the argument that is meant if none is given, or NULL
    const char *help;  ///< what it is; the choices and what is usual follow
    const char *more;  ///< what help says at the end, or NULL
} tf_option;

extern const tf_option tf_options[];

//: Declare the table of old spellings
/// A spelling of before 1.0, an error until 2.0.  The table of them ends with
/// one without commands.
typedef struct tf_old_spelling {
    unsigned commands; ///< that had it
    int letter;        ///< or 0
    const char *name;  ///< or NULL
    const char *now;   ///< the name that has replaced it
} tf_old_spelling;

extern const tf_old_spelling tf_old_spellings[];

//: Declare how to read options
/// Sets what is usual for a command.
void tf_request_begin(tf_request *request, unsigned command);

/// Takes the argument of an option, or ends the program with the message that
/// it is none.
void tf_option_read(const tf_option *option, const char *text,
                    tf_request *request);

/// Ends the program with the message what to write in place of it.
_Noreturn void tf_old_spelling_refuse(const tf_old_spelling *old,
                                      const tf_request *request);

/// Whether an option was given.
bool tf_request_gave(const tf_request *request, const char *option);

/// What help says of an option, to be freed; NULL without memory.
char *tf_option_help(const tf_option *option);

/// Ends the program with a message about its arguments, as printf.
__attribute__((format(printf, 2, 3))) _Noreturn void
tf_request_refuse(const tf_request *request, const char *format, ...);
