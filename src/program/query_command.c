//: Include what the command query needs
#include "program/query_command.h"

#include "contract.h"
#include "program/arithmetics.h"
#include "program/progress.h"
#include "program/query_file.h"
#include "program/query_output.h"

#include <argp.h>
#include <stdio.h>
#include <string.h>

//: Hold what the command was asked
typedef struct request {
    const tf_query_kind *kind;
    const tf_arithmetic *arithmetic;
    const tf_query_format *format;
    char **paths;
    int path_count;
} request;

//: Tell how to ask
static const char description[] =
    "Tell whether, when and how moving elements first meet.\v"
    "A FILE is CSV without a header, a row a point: all vertices of the first "
    "element and then of the second at t = 0, then the same at t = 1.  A row "
    "is x,y[,z] in decimals or hexadecimal floats, or xnum,xden,ynum,yden"
    "[,znum,zden] in integers of any length, and then perhaps the truth, 0 or "
    "1.  The first row decides for its file.  No FILE, or \"-\", is standard "
    "input.  Perturbed signs number the vertices in the order of the rows.\n\n"
    "csv and json give an answer a line: the query's number, from 0; hit, 1 "
    "(with clamped signs also where undecided) or 0; toi_lo and toi_hi, which "
    "enclose the time of impact; the contact's "
    "unit normal; the normal speed; and the case, generic, touching or "
    "degenerate.  Without a hit they are empty, or null.  summary counts the "
    "hits, and those not in truth (extra), or in truth alone (missed).\n\n"
    "Exit status: 0 if all was answered, 2 after bad usage or input.";

static const struct argp_option options[] = {
    {"kind", 'k', "KIND", 0,
     "What meets: " TF_QUERY_KIND_NAMES " (vertex-face is point-triangle)", 0},
    {"arithmetic", 'a', "NAME", 0,
     "How signs are found: " TF_ARITHMETIC_NAMES "; exact unless given", 0},
    {"output", 'o', "FORMAT", 0, TF_QUERY_FORMAT_NAMES "; csv unless given", 0},
    {0},
};

//: Refuse a name
static void refuse(struct argp_state *state, const char *what, const char *name,
                   const char *names)
{
    argp_error(state, "no %s is named '%s'; choose %s", what, name, names);
}

//: Understand an argument
static error_t understand(int key, char *text, struct argp_state *state)
{
    request *asked = state->input;
    switch (key) {
    case 'k':
        if (!(asked->kind = tf_query_kind_named(text)))
            refuse(state, "kind", text, TF_QUERY_KIND_NAMES);
        return 0;
    case 'a':
        if (!(asked->arithmetic = tf_arithmetic_named(text)))
            refuse(state, "arithmetic", text, TF_ARITHMETIC_NAMES);
        return 0;
    case 'o':
        if (!(asked->format = tf_query_format_named(text)))
            refuse(state, "output", text, TF_QUERY_FORMAT_NAMES);
        return 0;
    case ARGP_KEY_ARGS:
        asked->paths = state->argv + state->next;
        asked->path_count = state->argc - state->next;
        return 0;
    case ARGP_KEY_END:
        if (!asked->kind)
            argp_error(state, "--kind is missing; choose " TF_QUERY_KIND_NAMES);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

//: Hold what the command has done
typedef struct answering {
    request asked;
    tf_query_file file;
    tf_query_output output;
    tf_progress progress;
    long rounded; ///< coordinates
} answering;

//: Name the coordinate that is out of range
static const double *out_of_range(const answering *work,
                                  const tf_question *question, int row)
{
    const tf_query_kind *kind = work->asked.kind;
    int vertices = kind->vertices[0] + kind->vertices[1];
    const tf_event *event =
        &question->vertex[row % vertices].at[row / vertices];
    for (int k = 0; k < kind->axes; k++)
        if (!tf_arithmetic_holds(work->asked.arithmetic, kind->axes,
                                 event->x[k]))
            return &event->x[k];
    return NULL;
}

//: Refuse a query that is out of range
static bool fault_in_range(answering *work, const tf_question *question)
{
    const tf_arithmetic *arithmetic = work->asked.arithmetic;
    int rows =
        2 * (work->asked.kind->vertices[0] + work->asked.kind->vertices[1]);
    const double *x = NULL;
    int row = 0;
    while (row < rows && !(x = out_of_range(work, question, row)))
        row++;
    TF_REQUIRE(x);
    return tf_query_file_fault(
        &work->file, question->line + row,
        "the coordinate %.17g is out of range: %s holds integers below 2^%d "
        "in absolute value; use --arithmetic exact",
        *x, arithmetic->name, arithmetic->bits[work->asked.kind->axes]);
}

//: Answer a query
static bool answer_query(answering *work, const tf_question *question)
{
    const tf_query_kind *kind = work->asked.kind;
    const tf_worldline *first = question->vertex;
    tf_contact contact;
    if (tf_query(work->asked.arithmetic, kind->axes, kind->vertices[0], first,
                 kind->vertices[1], first + kind->vertices[0],
                 &contact) != TF_OK)
        return fault_in_range(work, question);
    work->rounded += question->rounded;
    tf_progress_tell(&work->progress, work->output.tally.queries, "queries");
    return tf_query_output_answer(&work->output, question, &contact);
}

//: Answer the queries of a file
static bool answer_open_file(answering *work)
{
    tf_question question;
    tf_reading reading;
    while ((reading = tf_query_file_next(&work->file, &question)) ==
           TF_READ_GOOD)
        if (!answer_query(work, &question))
            return false;
    return reading == TF_READ_END;
}

// The file in which a fault was found stays open, for it tells the fault.
static bool answer_file(answering *work, const char *path)
{
    if (!tf_query_file_open(&work->file, path, work->asked.kind,
                            work->output.tally.queries) ||
        !answer_open_file(work))
        return false;
    tf_query_file_close(&work->file);
    return true;
}

//: Answer all queries
static bool answer_files(answering *work)
{
    if (work->asked.path_count == 0)
        return answer_file(work, "-");
    for (int i = 0; i < work->asked.path_count; i++)
        if (!answer_file(work, work->asked.paths[i]))
            return false;
    return true;
}

//: Tell what went wrong
// After the answers, so that those of good queries are out by then.
static void complain(answering *work)
{
    if (work->rounded > 0)
        fprintf(stderr,
                "tanglefree: %ld rational coordinate%s; rounded to nearest\n",
                work->rounded,
                work->rounded == 1 ? " is no double" : "s are no doubles");
    if (work->output.error != 0)
        fprintf(stderr,
                "tanglefree: standard output: cannot write: %s; mend that and "
                "run again\n",
                strerror(work->output.error));
    if (work->file.fault[0] != '\0')
        tf_query_file_complain(&work->file);
    tf_query_file_close(&work->file);
}

//: Run the command query
int tf_query_command(int argc, char *argv[])
{
    static const struct argp parser = {
        options, understand, "[FILE...]", description, NULL, NULL, NULL};
    answering work = {.asked = {.arithmetic = tf_arithmetic_named("exact"),
                                .format = tf_query_format_named("csv")}};
    argp_parse(&parser, argc, argv, 0, NULL, &work.asked);

    work.progress = tf_progress_begin();
    bool good = tf_query_output_begin(&work.output, stdout, work.asked.format,
                                      work.asked.kind->axes) &&
                answer_files(&work);
    tf_progress_end(&work.progress);
    good = tf_query_output_end(&work.output) && good;
    complain(&work);
    return good ? 0 : 2;
}
