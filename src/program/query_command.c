//: Include what the command query needs
#include "program/query_command.h"

#include "files/query_file.h"
#include "program/arguments.h"
#include "program/arithmetics.h"
#include "program/methods.h"
#include "program/progress.h"
#include "program/query_output.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

//: Hold what the command line requests
typedef struct query_request {
    const tf_query_kind *kind;
    const tf_method *method, *against; ///< to compare with, or NULL
    tf_method_options options;
    unsigned given; ///< which of these, by tf_method_option
    tf_format format;
    char **paths;
    int path_count;
} query_request;

//: Describe the usage
static const char description[] =
    "Compute whether, when and how moving elements first meet.\v"
    "A FILE is CSV without a header, one vertex per row: the vertices of the "
    "first element and then of the second at t = 0, then the same at t = 1.  "
    "A row is x,y[,z], decimal numbers or hexadecimal floats, or "
    "xnum,xden,ynum,yden[,znum,zden], integers of any length, perhaps followed "
    "by the ground truth, 0 or 1.  The first row determines the format of its "
    "file.  Blank lines and lines that begin with # are skipped.  Without a "
    "FILE, or if it is \"-\", standard input is read.  For perturbed signs, "
    "the "
    "vertices are numbered in the order of the rows.\n\n"
    "csv and json print one answer per query: the number of the query, from 0; "
    "hit, which is 1 for a hit (and for what clamped signs leave undecided), "
    "else 0; toi_lo and toi_hi, which enclose the time of impact (with "
    "perturbed signs, that of the moved vertices; with other methods than "
    "spacetime both are the time found); the unit normal of the "
    "contact; the normal velocity; and the case, generic, touching or "
    "degenerate.  Without a hit these are empty, or null.  summary counts the "
    "hits and, where the ground truth is given, the hits that are not in it "
    "(extra) and those in it alone (missed); and with --against how many "
    "answers differ and how many hits only --method or only --against "
    "finds.\n\n"
    "Exit status: 0 if all queries were answered, 2 if the arguments or the "
    "input are invalid or the output cannot be written.";

// Options without a letter.
enum {
    TOLERANCE = 256,
    THRESHOLD,
    AGAINST
};

static const struct argp_option options[] = {
    {"kind", 'k', "KIND", 0,
     "Which elements: " TF_QUERY_KIND_NAMES " (vertex-face is point-triangle)",
     0},
    {"arithmetic", 'a', "NAME", 0,
     "How signs are found: " TF_ARITHMETIC_NAMES "; the default is exact", 0},
    {"method", 'm', "METHOD", 0,
     "How queries are answered: " TF_METHOD_NAMES "; the default is spacetime",
     0},
    {"tolerance", TOLERANCE, "X", 0,
     "The distance at which elements touch, for cubic; the default is 1e-6", 0},
    {"threshold", THRESHOLD, "X", 0,
     "The distance at which advancement ends; the default is 1e-6", 0},
    {"against", AGAINST, "METHOD", 0,
     "Compare with this method, for the output summary", 0},
    {"output", 'o', "FORMAT", 0,
     "Output format: " TF_ROWS_FORMAT_NAMES "; the default is csv", 0},
    {0},
};

//: Parse a distance
static double parse_distance(struct argp_state *state, const char *option,
                             const char *text)
{
    return tf_parse_number(state, option, text, DBL_MAX,
                           "0 or more, such as 1e-6");
}

//: Find a method for an option
static const tf_method *parse_method(struct argp_state *state, const char *text)
{
    const tf_method *method = tf_method_named(text);
    if (!method)
        tf_refuse_name(state, "method", text, TF_METHOD_NAMES);
    return method;
}

//: Check that the options go together
/// Fails if an option was given that neither method takes.
static void expect_taken(struct argp_state *state, tf_method_option option,
                         const char *name, const char *method)
{
    const query_request *request = state->input;
    unsigned taken = tf_method_takes(request->method);
    if (request->against)
        taken |= tf_method_takes(request->against);
    if (request->given & ~taken & option)
        argp_error(state, "--%s is for --method %s alone", name, method);
}

static void check_request(struct argp_state *state)
{
    const query_request *request = state->input;
    if (!request->kind)
        argp_error(state, "--kind is required; choose " TF_QUERY_KIND_NAMES);
    if (request->against && request->format != TF_SUMMARY)
        argp_error(state, "--against needs --output summary, which has what "
                          "it counts");
    expect_taken(state, TF_TAKES_ARITHMETIC, "arithmetic", "spacetime");
    expect_taken(state, TF_TAKES_TOLERANCE, "tolerance", "cubic");
    expect_taken(state, TF_TAKES_THRESHOLD, "threshold", "advancement");
}

//: Parse an option of a method
static bool parse_method_option(int key, const char *text,
                                struct argp_state *state)
{
    query_request *request = state->input;
    switch (key) {
    case 'a':
        request->given |= TF_TAKES_ARITHMETIC;
        if (!(request->options.arithmetic = tf_arithmetic_named(text)))
            tf_refuse_name(state, "arithmetic", text, TF_ARITHMETIC_NAMES);
        return true;
    case TOLERANCE:
        request->given |= TF_TAKES_TOLERANCE;
        request->options.tolerance = parse_distance(state, "tolerance", text);
        return true;
    case THRESHOLD:
        request->given |= TF_TAKES_THRESHOLD;
        request->options.threshold = parse_distance(state, "threshold", text);
        return true;
    default:
        return false;
    }
}

//: Parse an argument
static error_t parse_argument(int key, char *text, struct argp_state *state)
{
    query_request *request = state->input;
    if (parse_method_option(key, text, state))
        return 0;
    switch (key) {
    case 'k':
        if (!(request->kind = tf_query_kind_named(text)))
            tf_refuse_name(state, "kind", text, TF_QUERY_KIND_NAMES);
        return 0;
    case 'm':
        request->method = parse_method(state, text);
        return 0;
    case AGAINST:
        request->against = parse_method(state, text);
        return 0;
    case 'o':
        request->format = tf_parse_format(state, text, true);
        return 0;
    case ARGP_KEY_ARGS:
        request->paths = state->argv + state->next;
        request->path_count = state->argc - state->next;
        return 0;
    case ARGP_KEY_END:
        check_request(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

//: Hold what the command has done
typedef struct answering {
    query_request request;
    tf_query_file file;
    tf_query_output output;
    tf_progress progress;
    long rounded; ///< coordinates
} answering;

static int vertex_count(const tf_query_kind *kind)
{
    return kind->vertices[0] + kind->vertices[1];
}

//: Report a coordinate that is out of range
static bool fault_in_range(answering *work, const tf_query_rows *query)
{
    const tf_arithmetic *arithmetic = work->request.options.arithmetic;
    int axes = work->request.kind->axes;
    int end = axes * vertex_count(work->request.kind), i = 0;
    while (i < 2 * end &&
           tf_arithmetic_fits(arithmetic, axes, query->x[i / end][i % end]))
        i++;
    return tf_text_lines_fault(
        &work->file.lines, query->line[i / axes], TF_OUT_OF_RANGE_FAULT,
        query->x[i / end][i % end], tf_arithmetic_name(arithmetic),
        tf_arithmetic_bits(arithmetic, axes));
}

//: Answer a query
static bool answer_by(answering *work, const tf_method *method,
                      const tf_query_rows *query, tf_contact *contact)
{
    const query_request *request = &work->request;
    tf_status status = tf_method_answer(method, &request->options,
                                        request->kind, query, contact);
    if (status == TF_OUT_OF_RANGE)
        return fault_in_range(work, query);
    if (status != TF_OK)
        return tf_text_lines_fault(&work->file.lines, query->line[0], "%s",
                                   tf_status_message(status));
    return true;
}

static bool answer_query(answering *work, const tf_query_rows *query)
{
    const tf_method *against = work->request.against;
    tf_contact contact, other;
    if (!answer_by(work, work->request.method, query, &contact) ||
        (against && !answer_by(work, against, query, &other)))
        return false;
    if (against)
        tf_query_output_compare(&work->output, &contact, &other);
    work->rounded += query->rounded;
    tf_progress_show(&work->progress, (long)work->output.tally.queries,
                     "queries");
    return tf_query_output_answer(&work->output, query, &contact);
}

//: Answer the queries of a file
static bool answer_open_file(answering *work)
{
    tf_query_rows query;
    tf_reading reading;
    while ((reading = tf_query_file_next(&work->file, &query)) == TF_READ_GOOD)
        if (!answer_query(work, &query))
            return false;
    return reading == TF_READ_END;
}

// A file with a fault stays open, for it holds the description of the fault.
static bool answer_file(answering *work, const char *path)
{
    if (!tf_query_file_open(&work->file, path, work->request.kind,
                            (long)work->output.tally.queries) ||
        !answer_open_file(work))
        return false;
    tf_query_file_close(&work->file);
    return true;
}

//: Answer all queries
static bool answer_files(answering *work)
{
    if (work->request.path_count == 0)
        return answer_file(work, "-");
    for (int i = 0; i < work->request.path_count; i++)
        if (!answer_file(work, work->request.paths[i]))
            return false;
    return true;
}

//: Print what went wrong
// After the answers, so that those of good queries are out by then.
static void print_errors(answering *work)
{
    if (work->rounded > 0)
        fprintf(stderr,
                "tanglefree: rounded %ld rational coordinate%s to the nearest "
                "double\n",
                work->rounded, work->rounded == 1 ? "" : "s");
    if (work->output.records.error != 0)
        fprintf(stderr,
                "tanglefree: standard output: cannot write: %s; the output "
                "is incomplete\n",
                strerror(work->output.records.error));
    if (work->file.lines.fault[0] != '\0')
        tf_text_lines_print_fault(&work->file.lines, "tanglefree");
    tf_query_file_close(&work->file);
}

//: Run the command query
int tf_query_command(int argc, char *argv[])
{
    static const struct argp parser = {
        options, parse_argument, "[FILE...]", description, NULL, NULL, NULL};
    answering work = {
        .request = {.method = tf_method_named("spacetime"),
                    .options = {.arithmetic = tf_arithmetic_named("exact"),
                                .tolerance = 1e-6,
                                .threshold = 1e-6}}};
    argp_parse(&parser, argc, argv, 0, NULL, &work.request);

    work.progress = tf_progress_begin();
    bool good = tf_query_output_begin(&work.output, stdout, work.request.format,
                                      work.request.kind->axes) &&
                answer_files(&work);
    tf_progress_end(&work.progress);
    good = tf_query_output_end(&work.output) && good;
    print_errors(&work);
    return good ? 0 : 2;
}
