//: Include what the output about responses needs
#include "program/response_output.h"

//: List the fields of a response
typedef struct response {
    const char *status;
    tf_response_report report;
    double seconds;
} response;

static const tf_field fields[] = {
    TF_FIELD("status", TF_WORD, response, status),
    TF_FIELD("first contacts", TF_COUNT, response, report.first_contacts),
    TF_FIELD("contacts", TF_COUNT, response, report.contacts),
    TF_FIELD("impulse rounds", TF_INTEGER, response,
             report.rounds[TF_IMPULSES]),
    TF_FIELD("zone rounds", TF_INTEGER, response, report.rounds[TF_ZONES]),
    TF_FIELD("rigid rounds", TF_INTEGER, response, report.rounds[TF_RIGID]),
    TF_FIELD("failsafe rounds", TF_INTEGER, response,
             report.rounds[TF_FAILSAFE]),
    TF_FIELD("rows", TF_COUNT, response, report.constraints),
    TF_FIELD("zones", TF_COUNT, response, report.zones),
    TF_FIELD("largest zone", TF_COUNT, response, report.largest_zone),
    TF_FIELD("iterations", TF_COUNT, response, report.iterations),
    TF_FIELD("violation", TF_NUMBER, response, report.violation),
    TF_FIELD("smallest gap", TF_NUMBER, response, report.smallest_gap),
    TF_FIELD("groups", TF_INTEGER, response, report.groups),
    TF_FIELD("grouped", TF_INTEGER, response, report.grouped),
    TF_FIELD("resting", TF_INTEGER, response, report.resting),
    TF_FIELD("held", TF_INTEGER, response, report.held),
    TF_FIELD("moved", TF_INTEGER, response, report.moved),
    TF_FIELD("candidates", TF_COUNT, response, report.statistics.candidates),
    TF_FIELD("decided by axis", TF_COUNT, response, report.statistics.by_axis),
    TF_FIELD("decided by filter", TF_COUNT, response,
             report.statistics.by_filter),
    TF_FIELD("decided by signs", TF_COUNT, response,
             report.statistics.by_signs),
    TF_FIELD("energy before", TF_NUMBER, response, report.energy_before),
    TF_FIELD("energy after", TF_NUMBER, response, report.energy_after),
    TF_FIELD("seconds", TF_NUMBER, response, seconds),
    {0},
};

//: Write a report of a response
bool tf_response_output_write(FILE *stream, tf_format format,
                              const tf_response_report *report, double seconds)
{
    response made = {report->first_contacts == 0 ? "clear" : "resolved",
                     *report, seconds};
    return tf_report_write(stream, format, fields, &made);
}
