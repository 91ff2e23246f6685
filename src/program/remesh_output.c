//: Include what the report of remeshing needs
#include "program/remesh_output.h"

#include "program/summary.h"

//: Name the operations and their outcomes
static const char *const names[TF_OPERATIONS][TF_OUTCOMES] = {
    [TF_SPLIT] = {NULL, "splits", "impossible splits", "collinear splits",
                  "overlapping splits", "splits past vertices",
                  "splits past edges", "splits past triangles"},
    [TF_COLLAPSE] = {NULL, "collapses", "impossible collapses",
                     "collinear collapses", "overlapping collapses",
                     "collapses past vertices", "collapses past edges",
                     "collapses past triangles"},
    [TF_FLIP] = {NULL, "flips", "impossible flips", "collinear flips",
                 "overlapping flips", "flips past vertices", "flips past edges",
                 "flips past triangles"},
    [TF_SMOOTH] = {NULL, "moves", "impossible moves", "collinear moves",
                   "overlapping moves", "moves past vertices",
                   "moves past edges", "moves past triangles"},
};

//: List the entries about remeshing
enum {
    OWN_ENTRIES = 10,
    REMESH_ENTRIES = OWN_ENTRIES + TF_OPERATIONS * (TF_OUTCOMES - 1)
};

static void list_operations(const tf_remesh_report *report, tf_entry list[])
{
    int count = 0;
    for (int i = 0; i < TF_OPERATIONS; i++)
        for (int j = TF_COMMITTED; j < TF_OUTCOMES; j++)
            list[count++] = tf_entry_count(names[i][j], report->tried[i][j]);
}

static void list_entries(const tf_remeshed *of, tf_entry list[REMESH_ENTRIES])
{
    const tf_remesh_report *report = &of->report;
    const tf_entry own[OWN_ENTRIES] = {
        tf_entry_count("triangles before", (size_t)of->triangles_before),
        tf_entry_count("triangles", (size_t)of->triangles_after),
        tf_entry_number("edge", of->edge),
        tf_entry_number("least quality before", report->least_before),
        tf_entry_number("least quality", report->least_after),
        tf_entry_number("mean quality before", report->mean_before),
        tf_entry_number("mean quality", report->mean_after),
        tf_entry_number("distance", report->distance),
        tf_entry_count("rounds", (size_t)report->rounds),
        tf_entry_number("seconds", of->seconds),
    };
    for (int i = 0; i < OWN_ENTRIES; i++)
        list[i] = own[i];
    list_operations(report, list + OWN_ENTRIES);
}

//: Write the report of remeshing
bool tf_remesh_output_write(FILE *stream, const tf_remeshed *remeshed)
{
    tf_entry list[REMESH_ENTRIES];
    list_entries(remeshed, list);
    if (remeshed->json) {
        tf_summary_write_json(stream, REMESH_ENTRIES, list);
        fputc('\n', stream);
    } else
        tf_summary_write(stream, REMESH_ENTRIES, list);
    return fflush(stream) == 0 && !ferror(stream);
}
