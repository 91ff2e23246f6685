//: Include what the output of queries needs
#include "program/query_output.h"

#include "program/contact_fields.h"

#include <errno.h>
#include <string.h>

//: Begin and end CSV
static void begin_csv(const tf_query_output *output)
{
    fputs("query,hit", output->stream);
    tf_contact_head_csv(output->stream);
}

static void end_csv(const tf_query_output *output)
{
    (void)output;
}

//: Write answers as CSV
static void answer_csv(const tf_query_output *output, const tf_contact *contact)
{
    fprintf(output->stream, "%ld,%d", output->tally.queries,
            contact->verdict != TF_APART);
    tf_contact_write_csv(output->stream, output->axes, contact);
}

//: Write answers as JSON
static void begin_json(const tf_query_output *output)
{
    fputc('[', output->stream);
}

static void answer_json(const tf_query_output *output,
                        const tf_contact *contact)
{
    fprintf(output->stream, "%s\n{\"query\":%ld,\"hit\":%d",
            output->tally.queries > 0 ? "," : "", output->tally.queries,
            contact->verdict != TF_APART);
    tf_contact_write_json(output->stream, output->axes, contact);
}

static void end_json(const tf_query_output *output)
{
    fputs("\n]\n", output->stream);
}

//: Write a summary
static void begin_summary(const tf_query_output *output)
{
    (void)output;
}

static void answer_summary(const tf_query_output *output,
                           const tf_contact *contact)
{
    (void)output;
    (void)contact;
}

static void end_summary(const tf_query_output *output)
{
    const tf_tally *tally = &output->tally;
    FILE *stream = output->stream;
    fprintf(stream, "queries: %ld\nhits: %ld\n", tally->queries, tally->hits);
    for (int i = TF_GENERIC; i <= TF_DEGENERATE; i++)
        fprintf(stream, "%s: %ld\n", tf_classification_names[i],
                tally->classified[i]);
    if (tally->known > 0)
        fprintf(stream, "agree: %ld\nextra: %ld\nmissed: %ld\n", tally->agree,
                tally->extra, tally->missed);
    if (tally->compared > 0)
        fprintf(stream, "differ: %ld\nonly_method: %ld\nonly_against: %ld\n",
                tally->only_method + tally->only_against, tally->only_method,
                tally->only_against);
}

//: Find a format by its name
struct tf_query_format {
    const char *name;
    void (*begin)(const tf_query_output *output);
    void (*answer)(const tf_query_output *output, const tf_contact *contact);
    void (*end)(const tf_query_output *output);
};

static const tf_query_format formats[] = {
    {"csv", begin_csv, answer_csv, end_csv},
    {"json", begin_json, answer_json, end_json},
    {"summary", begin_summary, answer_summary, end_summary},
};

const tf_query_format *tf_query_format_named(const char *name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (strcmp(name, formats[i].name) == 0)
            return &formats[i];
    return NULL;
}

//: Notice a write that failed
// Called after every answer, before errno can change.
static bool written(tf_query_output *output)
{
    if (ferror(output->stream) && output->error == 0)
        output->error = errno;
    return output->error == 0;
}

//: Count an answer
static void count(tf_tally *tally, int truth, const tf_contact *contact)
{
    bool hit = contact->verdict != TF_APART;
    tally->queries++;
    tally->hits += hit;
    if (hit)
        tally->classified[contact->classification]++;
    tally->known += truth >= 0;
    tally->agree += truth == hit;
    tally->extra += truth == 0 && hit;
    tally->missed += truth == 1 && !hit;
}

//: Write the answers
bool tf_query_output_begin(tf_query_output *output, FILE *stream,
                           const tf_query_format *format, int axes)
{
    *output =
        (tf_query_output){.stream = stream, .format = format, .axes = axes};
    format->begin(output);
    return written(output);
}

bool tf_query_output_answer(tf_query_output *output, const tf_query_rows *query,
                            const tf_contact *contact)
{
    output->format->answer(output, contact);
    count(&output->tally, query->ground_truth, contact);
    return written(output);
}

bool tf_query_output_end(tf_query_output *output)
{
    output->format->end(output);
    fflush(output->stream);
    return written(output);
}

//: Compare two methods
void tf_query_output_compare(tf_query_output *output, const tf_contact *contact,
                             const tf_contact *against)
{
    tf_tally *tally = &output->tally;
    bool hit = contact->verdict != TF_APART;
    bool other_hit = against->verdict != TF_APART;
    tally->compared++;
    tally->only_method += hit && !other_hit;
    tally->only_against += other_hit && !hit;
}
