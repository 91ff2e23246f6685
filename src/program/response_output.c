//: Include what the output about responses needs
#include "program/response_output.h"

#include "program/summary.h"

#include <string.h>

//: List the entries of a report
enum {
    ENTRIES = 25
};

static const char *status_of(const tf_response_report *report)
{
    return report->first_contacts == 0 ? "clear" : "resolved";
}

static void list_entries(const tf_response_report *report, double seconds,
                         tf_entry list[ENTRIES])
{
    const tf_detect_statistics *statistics = &report->statistics;
    const int *rounds = report->rounds;
    const tf_entry all[ENTRIES] = {
        tf_entry_word("status", status_of(report)),
        tf_entry_count("first contacts", report->first_contacts),
        tf_entry_count("contacts", report->contacts),
        tf_entry_count("impulse rounds", (size_t)rounds[TF_IMPULSES]),
        tf_entry_count("zone rounds", (size_t)rounds[TF_ZONES]),
        tf_entry_count("rigid rounds", (size_t)rounds[TF_RIGID]),
        tf_entry_count("failsafe rounds", (size_t)rounds[TF_FAILSAFE]),
        tf_entry_count("rows", report->constraints),
        tf_entry_count("zones", report->zones),
        tf_entry_count("largest zone", report->largest_zone),
        tf_entry_count("iterations", report->iterations),
        tf_entry_number("violation", report->violation),
        tf_entry_number("smallest gap", report->smallest_gap),
        tf_entry_count("groups", (size_t)report->groups),
        tf_entry_count("grouped", (size_t)report->grouped),
        tf_entry_count("resting", (size_t)report->resting),
        tf_entry_count("held", (size_t)report->held),
        tf_entry_count("moved", (size_t)report->moved),
        tf_entry_count("candidates", statistics->candidates),
        tf_entry_count("decided by axis", statistics->by_axis),
        tf_entry_count("decided by filter", statistics->by_filter),
        tf_entry_count("decided by signs", statistics->by_signs),
        tf_entry_number("energy before", report->energy_before),
        tf_entry_number("energy after", report->energy_after),
        tf_entry_number("seconds", seconds),
    };
    memcpy(list, all, sizeof all);
}

//: Find a format by its name about responses
struct tf_response_format {
    const char *name;
    void (*write)(FILE *stream, int entries, const tf_entry entry[]);
    const char *end;
};

static const tf_response_format formats[] = {
    {"summary", tf_summary_write, ""},
    {"json", tf_summary_write_json, "\n"},
};

const tf_response_format *tf_response_format_named(const char *name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (strcmp(name, formats[i].name) == 0)
            return &formats[i];
    return NULL;
}

//: Write a report
bool tf_response_output_write(FILE *stream, const tf_response_format *format,
                              const tf_response_report *report, double seconds)
{
    tf_entry list[ENTRIES];
    list_entries(report, seconds, list);
    format->write(stream, ENTRIES, list);
    fputs(format->end, stream);
    return fflush(stream) == 0 && !ferror(stream);
}
