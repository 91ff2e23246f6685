//: Include what the command query needs

#include "files/destination.h"
#include "files/query_file.h"
#include "program/arithmetics.h"
#include "program/command.h"
#include "program/methods.h"
#include "program/progress.h"
#include "program/query_output.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>

//: Check that the options go together
static void check_options(tf_request *request)
{
    if (request->against && *request->format != TF_SUMMARY)
        tf_request_refuse(request, "--against is for --format summary, which "
                                   "has what it counts; add that");
    for (const tf_choice *own = tf_methods; own->name; own++) {
        const char *option = tf_method_option(own->value);
        if (tf_request_gave(request, option) && own->value != request->method &&
            own->value != request->against)
            tf_request_refuse(request,
                              "--%s is for --method %s; add that, or drop it",
                              option, own->name);
    }
}

//: Hold what the command has done
typedef struct answering {
    const tf_request *request;
    tf_query_file file;
    tf_destination to;
    tf_query_output output;
    tf_fault fault;
    tf_progress_line progress;
    long rounded; ///< coordinates
} answering;

static int vertex_count(const tf_query_kind *kind)
{
    return kind->vertices[0] + kind->vertices[1];
}

//: Report a coordinate that is out of range
static bool fault_in_range(answering *work, const tf_query_rows *query)
{
    const tf_arithmetic *arithmetic = work->request->answering.arithmetic;
    int axes = work->request->kind->axes;
    int end = axes * vertex_count(work->request->kind), i = 0;
    while (i < 2 * end &&
           tf_arithmetic_fits(arithmetic, axes, query->x[i / end][i % end]))
        i++;
    return tf_fault_set(
        &work->fault, work->file.lines.text.name, query->line[i / axes],
        TF_OUT_OF_RANGE_FAULT, query->x[i / end][i % end],
        tf_arithmetic_name(arithmetic), tf_arithmetic_bits(arithmetic, axes));
}

//: Answer a query
static bool answer_by(answering *work, const tf_method *method,
                      const tf_query_rows *query, tf_contact *contact)
{
    const tf_request *request = work->request;
    tf_status status = tf_method_answer(method, &request->answering,
                                        request->kind, query, contact);
    if (status == TF_OUT_OF_RANGE)
        return fault_in_range(work, query);
    if (status != TF_OK)
        return tf_fault_set(&work->fault, work->file.lines.text.name,
                            query->line[0], "%s", tf_status_message(status));
    return true;
}

static bool answer_query(answering *work, const tf_query_rows *query)
{
    const tf_method *against = work->request->against;
    tf_contact contact, other;
    if (!answer_by(work, work->request->method, query, &contact) ||
        (against && !answer_by(work, against, query, &other)))
        return false;
    if (against)
        tf_query_output_compare(&work->output, &contact, &other);
    work->rounded += query->rounded;
    tf_progress_line_show(&work->progress, (long)work->output.tally.queries,
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

static bool answer_file(answering *work, const char *path)
{
    bool good = tf_query_file_open(&work->file, path, work->request->kind,
                                   work->output.tally.queries, &work->fault) &&
                answer_open_file(work);
    tf_query_file_close(&work->file);
    return good;
}

//: Answer all queries
static bool answer_files(answering *work)
{
    if (work->request->operands == 0)
        return answer_file(work, "-");
    for (int i = 0; i < work->request->operands; i++)
        if (!answer_file(work, work->request->operand[i]))
            return false;
    return true;
}

//: Print what went wrong
// After the answers, so that those of good queries are out by then.
static void print_rounded(long rounded)
{
    if (rounded > 0)
        fprintf(stderr,
                "tanglefree: rounded %ld rational coordinate%s to the nearest "
                "double\n",
                rounded, rounded == 1 ? "" : "s");
}

//: Write all answers
static bool write_answers(answering *work)
{
    const tf_request *request = work->request;
    FILE *stream = tf_destination_begin(&work->to, request->out, &work->fault)
                       ? tf_destination_open(&work->to)
                       : NULL;
    if (!stream)
        return false;
    tf_query_output_begin(&work->output, stream, *request->format,
                          request->kind->axes);
    bool good = answer_files(work);
    tf_progress_line_end(&work->progress);
    good = tf_query_output_end(&work->output) && good;
    return tf_destination_finish(&work->to, good, work->output.records.error);
}

//: Run the command query
static int run(const tf_request *request)
{
    bool silent = !tf_destination_is_standard(request->out);
    answering work = {.request = request,
                      .progress = tf_progress_line_begin(silent)};
    bool good = write_answers(&work);
    tf_destination_end(&work.to);
    print_rounded(work.rounded);
    tf_fault_print(&work.fault, "tanglefree");
    return good ? 0 : 2;
}

const tf_command tf_query_command = {
    .set = TF_QUERY,
    .name = "query",
    .purpose = "compute whether, when and how elements first meet",
    .operands = "[FILE...]",
    .most = INT_MAX,
    .description = tf_query_description,
    .check = check_options,
    .run = run,
};
