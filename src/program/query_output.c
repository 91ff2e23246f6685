//: Include what the output of queries needs
#include "program/query_output.h"

#include "program/contact_fields.h"

//: List the fields of an answer
typedef struct answer {
    size_t query;
    int hit;
    tf_contact_values contact;
} answer;

static const tf_field answer_fields[] = {
    TF_FIELD("query", answer, query),
    TF_FIELD("hit", answer, hit),
    TF_CONTACT_FIELDS(answer, contact),
    {0},
};

//: List the counts of queries
static const tf_field counts[] = {
    TF_FIELD("queries", tf_tally, queries),
    TF_FIELD("hits", tf_tally, hits),
    TF_FIELD("generic", tf_tally, classified[TF_GENERIC]),
    TF_FIELD("touching", tf_tally, classified[TF_TOUCHING]),
    TF_FIELD("degenerate", tf_tally, classified[TF_DEGENERATE]),
    {0},
};

static const tf_field counts_of_truth[] = {
    TF_FIELD("agree", tf_tally, agree),
    TF_FIELD("extra", tf_tally, extra),
    TF_FIELD("missed", tf_tally, missed),
    {0},
};

static const tf_field counts_of_methods[] = {
    TF_FIELD("differ", tf_tally, differ),
    TF_FIELD("only_method", tf_tally, only_method),
    TF_FIELD("only_against", tf_tally, only_against),
    {0},
};

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
void tf_query_output_begin(tf_query_output *output, FILE *stream,
                           tf_format format, int axes)
{
    *output = (tf_query_output){.axes = axes};
    tf_records_begin(&output->records, stream, format, NULL, answer_fields);
}

bool tf_query_output_answer(tf_query_output *output, const tf_query_rows *query,
                            const tf_contact *contact)
{
    answer made = {output->tally.queries, contact->verdict != TF_APART,
                   tf_contact_values_of(contact, output->axes)};
    count(&output->tally, query->ground_truth, contact);
    return tf_records_add(&output->records, &made);
}

bool tf_query_output_end(tf_query_output *output)
{
    const tf_tally *tally = &output->tally;
    tf_records *records = &output->records;
    if (records->format == TF_SUMMARY) {
        tf_record_write_lines(records->stream, counts, tally);
        if (tally->known > 0)
            tf_record_write_lines(records->stream, counts_of_truth, tally);
        if (tally->compared > 0)
            tf_record_write_lines(records->stream, counts_of_methods, tally);
    }
    return tf_records_end(records, NULL, NULL);
}

//: Compare two methods
void tf_query_output_compare(tf_query_output *output, const tf_contact *contact,
                             const tf_contact *against)
{
    tf_tally *tally = &output->tally;
    bool hit = contact->verdict != TF_APART;
    bool other_hit = against->verdict != TF_APART;
    tally->compared++;
    tally->differ += hit != other_hit;
    tally->only_method += hit && !other_hit;
    tally->only_against += other_hit && !hit;
}
