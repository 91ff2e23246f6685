//: Include what options need
#define _GNU_SOURCE // asprintf
#include "program/options.h"

#include "fast/vectorized.h"
#include "files/number.h"
#include "files/visible.h"
#include "program/arithmetics.h"
#include "response/conjugate_residuals.h"
#include "response/gauss_seidel.h"
#include "response/minres.h"
#include "response/normal_residuals.h"
#include "threads/threads.h"

#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Name narrow phases, solvers and formats
static const tf_choice narrow_phases[] = {
    {"reference", &tf_reference},
    {"vector", &tf_vectorized},
    {NULL, NULL},
};

static const tf_choice solvers[] = {
    {"gauss-seidel", &tf_gauss_seidel},
    {"conjugate-residuals", &tf_conjugate_residuals},
    {"minres", &tf_minres},
    {"normal-residuals", &tf_normal_residuals},
    {NULL, NULL},
};

static const tf_format csv = TF_CSV, json = TF_JSON, summary = TF_SUMMARY;

static const tf_choice formats[] = {
    {"csv", &csv},
    {"json", &json},
    {"summary", &summary},
    {NULL, NULL},
};

//: List the options
// Numbers without a range of their own.
#define NOT_NEGATIVE .least = 0, .most = DBL_MAX
#define POSITIVE .least = DBL_TRUE_MIN, .most = DBL_MAX

// Commands that write rows, and those that report what they did.
#define ROWS (TF_QUERY | TF_DETECT | TF_CHECK)
#define REPORT (TF_RESOLVE | TF_REMESH | TF_SIMULATE | TF_WELD | TF_UNTANGLE)

#define OPTION(name_, letter_, argument_, member, type_)                       \
    .name = (name_), .letter = (letter_), .argument = (argument_),             \
    .place = offsetof(tf_request, member), .type = (type_)

// A letter means the same in all commands, those of tanglefree-draw included.
const tf_option tf_options[] = {
    {TF_QUERY, OPTION("kind", 'k', "KIND", kind, TF_CHOICE),
     .choices = tf_query_kinds, .required = true, .help = "Which elements",
     .more = " (which is point-triangle)"},
    {TF_QUERY | TF_DETECT,
     OPTION("arithmetic", 'a', "NAME", answering.arithmetic, TF_CHOICE),
     .choices = tf_arithmetics, .usual = "exact",
     .help = "How signs are found"},
    {TF_QUERY, OPTION("method", 'm', "METHOD", method, TF_CHOICE),
     .choices = tf_methods, .usual = "spacetime",
     .help = "How queries are answered"},
    {TF_QUERY, OPTION("tolerance", 0, "X", answering.tolerance, TF_REAL),
     NOT_NEGATIVE, .usual = "1e-6",
     .help = "The distance at which elements touch, for cubic"},
    {TF_QUERY, OPTION("threshold", 0, "X", answering.threshold, TF_REAL),
     NOT_NEGATIVE, .usual = "1e-6",
     .help = "The distance at which advancement ends"},
    {TF_QUERY, OPTION("against", 0, "METHOD", against, TF_CHOICE),
     .choices = tf_methods,
     .help = "Compare with this method, for the format summary"},
    {TF_DETECT, OPTION("first", 0, NULL, first, TF_SWITCH),
     .help = "Only the first contact of each step"},
    {TF_DETECT, OPTION("narrow-phase", 'n', "NAME", narrow_phase, TF_CHOICE),
     .choices = narrow_phases, .usual = "vector",
     .help = "What decides the candidates",
     .more = ", which is faster; both give the same answers"},
    {ROWS, OPTION("format", 0, "FORMAT", format, TF_CHOICE), .choices = formats,
     .usual = "csv", .help = "The format of the output"},
    {REPORT, OPTION("format", 0, "FORMAT", format, TF_CHOICE),
     .choices = formats, .usual = "summary",
     .help = "The format of the report"},
    {ROWS, OPTION("output", 'o', "FILE", out, TF_TEXT), .formats = formats,
     .usual = "-", .help = "Where to write",
     .more = ", which is standard output"},
    {TF_RESOLVE, OPTION("output", 'o', "OUT", out, TF_TEXT), .formats = formats,
     .required = true,
     .help = "Where to write the end of the step, or the folder for the frames "
             "of a scene"},
    {TF_REMESH, OPTION("output", 'o', "OUT", out, TF_TEXT), .formats = formats,
     .required = true, .help = "Where to write the new mesh"},
    {TF_WELD, OPTION("output", 'o', "OUT", out, TF_TEXT), .required = true,
     .help = "Where to write the welded mesh"},
    {TF_UNTANGLE, OPTION("output", 'o', "OUT", out, TF_TEXT), .required = true,
     .help =
         "Where to write the mesh, or the folder for the frames of a scene"},
    {TF_SIMULATE, OPTION("output", 'o', "DIR", out, TF_TEXT),
     .help = "The folder for the frames; required"},
    {TF_RESOLVE, OPTION("fixed", 'f', "FILE", fixed, TF_TEXT),
     .help = "The scripted vertices, which end where END has them unless they "
             "have to be held back: their numbers, from 0"},
    {TF_UNTANGLE, OPTION("fixed", 'f', "FILE", fixed, TF_TEXT),
     .help = "The vertices that stay: their numbers, from 0"},
    {TF_RESOLVE, OPTION("masses", 0, "FILE", masses, TF_TEXT),
     .help = "The masses of all vertices; the default is 1 for each"},
    {TF_RESOLVE, OPTION("solver", 0, "NAME", solver, TF_CHOICE),
     .choices = solvers, .usual = "gauss-seidel",
     .help = "What solves impact zones"},
    {TF_RESOLVE, OPTION("separation", 0, "X", separation, TF_REAL),
     NOT_NEGATIVE,
     .help = "Push apart what would meet and is nearer than this at the "
             "start; the default is 0.05 of the mean edge length"},
    {TF_RESOLVE, OPTION("friction", 0, "X", friction, TF_REAL), NOT_NEGATIVE,
     .usual = "0", .help = "Coulomb's coefficient"},
    {TF_RESOLVE, OPTION("vertex-friction", 0, "FILE", vertex_friction, TF_TEXT),
     .help = "Coulomb's coefficients of all vertices, in place of --friction"},
    {TF_RESOLVE, OPTION("restitution", 0, "X", restitution, TF_REAL),
     .least = 0, .most = 1, .usual = "0",
     .help = "The part of the normal velocity that is left after a collision, "
             "from 0 to 1"},
    {TF_RESOLVE,
     OPTION("restitution-threshold", 0, "X", restitution_threshold, TF_REAL),
     NOT_NEGATIVE, .usual = "0",
     .help = "What would approach by less than this length in the step has no "
             "restitution"},
    {TF_RESOLVE, OPTION("substeps", 0, "N", substeps, TF_WHOLE), .least = 1,
     .most = 1000, .usual = "1",
     .help = "In how many parts to take the step, each of them clear"},
    {TF_RESOLVE,
     OPTION("exempt-crossings", 0, NULL, exempt_crossings, TF_SWITCH),
     .help =
         "Leave out what crosses in START, list it, and keep all else clear"},
    {TF_CHECK, OPTION("each", 0, NULL, each, TF_SWITCH),
     .help = "Check each file, or each mesh of a scene, by itself"},
    {TF_CHECK, OPTION("thickness", 0, "D", thickness, TF_REAL), POSITIVE,
     .help = "Find pairs of elements that are nearer than this, too"},
    {TF_RESOLVE, OPTION("thickness", 0, "D", thickness, TF_REAL), POSITIVE,
     .help = "Pairs that start at this distance or more end at this distance "
             "or more; the default is that they don't meet"},
    {TF_WELD, OPTION("within", 0, "D", within, TF_REAL), POSITIVE,
     .help = "Join vertices that are no farther from each other than this; the "
             "default is those at exactly the same position"},
    {TF_REMESH, OPTION("edge", 'e', "L", edge, TF_REAL), POSITIVE,
     .help =
         "The length that edges should have; with --lengths or --error, the "
         "greatest"},
    {TF_REMESH, OPTION("lengths", 0, "FILE", lengths, TF_TEXT),
     .help = "The lengths that edges should have near each vertex, in their "
             "order"},
    {TF_REMESH, OPTION("error", 0, "D", error, TF_REAL), POSITIVE,
     .help = "The greatest distance between the new surface and the old one, "
             "either way; triangles are as large as that allows"},
    {TF_REMESH, OPTION("crease", 0, "ANGLE", crease, TF_REAL),
     .least = DBL_TRUE_MIN, .most = 180, .usual = "25",
     .help = "Edges at which the surface turns by more than this, in degrees, "
             "are sharp and stay"},
    {TF_REMESH, OPTION("keep", 0, "FILE", keep, TF_TEXT),
     .help = "More sharp edges, one a line: the numbers of their two vertices, "
             "from 0; a vertex alone is a corner"},
    {TF_REMESH, OPTION("strict", 0, NULL, strict, TF_SWITCH),
     .help = "Refuse a mesh with defects; the default is to leave them alone"},
    {TF_REMESH, OPTION("rounds", 0, "N", rounds, TF_WHOLE), .least = 1,
     .most = 1000,
     .help = "How often to go through all changes; the default is 5, and 10 "
             "with --error"},
    {TF_SIMULATE, OPTION("steps", 0, "N", steps, TF_WHOLE), .least = 0,
     .most = 99999, .help = "How many steps; 'list' shows the default"},
    {TF_SIMULATE, OPTION("size", 0, "N", size, TF_WHOLE), .least = 1,
     .most = 2000,
     .help = "The resolution of cloth; 'list' shows what it counts, and the "
             "default"},
    {TF_SIMULATE, OPTION("edge", 'e', "LENGTH", edge, TF_REAL), POSITIVE,
     .help = "The usual length of edges of a surface that flows; 'list' shows "
             "the default"},
    {TF_SIMULATE, OPTION("resume", 0, NULL, resume, TF_SWITCH),
     .help = "Go on from the last frame in DIR"},
    {TF_DETECT | TF_CHECK | TF_RESOLVE | TF_SIMULATE | TF_UNTANGLE,
     OPTION("threads", 't', "NUMBER", threads, TF_WHOLE), .least = 1,
     .most = TF_MOST_THREADS,
     .help = "How many threads to use; the default is one per processor"},
    {0},
};

//: List the old spellings
const tf_old_spelling tf_old_spellings[] = {
    {TF_RESOLVE | TF_REMESH | TF_SIMULATE, 0, "write", "output"},
    {TF_DETECT, 'f', NULL, "first"},
    {TF_RESOLVE, 'm', NULL, "masses"},
    {TF_RESOLVE, 's', NULL, "solver"},
    {0},
};

//: Refuse what is requested
void tf_request_refuse(const tf_request *request, const char *format, ...)
{
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    argp_error(request->state, "%s", text);
    exit(argp_err_exit_status);
}

/// In the same words for all options.
static void refuse_argument(const tf_option *option, const char *text,
                            const char *wanted, const tf_request *request)
{
    tf_request_refuse(request, "--%s must be %s, got '%s'", option->name,
                      wanted, tf_make_visible(text).text);
}

//: Refuse old spellings
void tf_old_spelling_refuse(const tf_old_spelling *old,
                            const tf_request *request)
{
    if (old->name)
        tf_request_refuse(request, "--%s is an old spelling; write --%s",
                          old->name, old->now);
    tf_request_refuse(request, "-%c is an old spelling; write --%s",
                      old->letter, old->now);
}

/// Takes a text that is no format.
static const char *read_text(const tf_option *option, const char *text,
                             const tf_request *request)
{
    if (option->formats && tf_choice_named(option->formats, text))
        tf_request_refuse(request,
                          "--%s %s is an old spelling; write --format %s, or "
                          "./%s for a file of that name",
                          option->name, text, text, text);
    return text;
}

//: Read a number of an option
/// Describes the numbers that an option takes.
static void describe_range(const tf_option *option, char words[100])
{
    const char *what = option->type == TF_WHOLE ? "a whole number" : "a number";
    if (option->most < DBL_MAX)
        snprintf(words, 100, "%s from %g to %g", what, option->least,
                 option->most);
    else
        snprintf(words, 100, "%s %s", what,
                 option->least > 0 ? "above 0" : "from 0 on");
}

static double read_number(const tf_option *option, const char *text,
                          const tf_request *request)
{
    const char *rest = text;
    double number = NAN;
    bool good = tf_number_read(&rest, &number) && *rest == '\0' &&
                number >= option->least && number <= option->most &&
                (option->type != TF_WHOLE || number == floor(number));
    char words[100];
    describe_range(option, words);
    if (!good)
        refuse_argument(option, text, words, request);
    return number;
}

//: Read an option
/// Sets a pointer, whatever it points to.
static void read_choice(const tf_option *option, const char *text,
                        const tf_request *request, void *place)
{
    const void *value = tf_choice_named(option->choices, text);
    if (!value)
        refuse_argument(option, text, tf_list_choices(option->choices).text,
                        request);
    memcpy(place, &value, sizeof value);
}

void tf_option_read(const tf_option *option, const char *text,
                    tf_request *request)
{
    void *place = (char *)request + option->place;
    switch (option->type) {
    case TF_SWITCH:
        *(bool *)place = true;
        break;
    case TF_TEXT:
        *(const char **)place = read_text(option, text, request);
        break;
    case TF_CHOICE:
        read_choice(option, text, request, place);
        break;
    case TF_WHOLE:
        *(int *)place = (int)read_number(option, text, request);
        break;
    case TF_REAL:
        *(double *)place = read_number(option, text, request);
        break;
    }
}

//: Set what is usual
void tf_request_begin(tf_request *request, unsigned command)
{
    *request = (tf_request){0};
    for (const tf_option *option = tf_options; option->name; option++)
        if (option->commands & command && option->usual)
            tf_option_read(option, option->usual, request);
}

//: Find out what was given
bool tf_request_gave(const tf_request *request, const char *option)
{
    for (int i = 0; tf_options[i].name; i++)
        if (request->given >> i & 1 && strcmp(tf_options[i].name, option) == 0)
            return true;
    return false;
}

//: Say what an option is
char *tf_option_help(const tf_option *option)
{
    char *text;
    tf_choices names = {""};
    if (option->choices)
        names = tf_list_choices(option->choices);
    return asprintf(&text, "%s%s%s%s%s%s%s", option->help,
                    option->choices ? ": " : "", names.text,
                    option->usual ? "; the default is " : "",
                    option->usual ? option->usual : "",
                    option->more ? option->more : "",
                    option->required ? "; required" : "") < 0
               ? NULL
               : text;
}
