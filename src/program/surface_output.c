//: Include what the output about surfaces needs
#include "program/surface_output.h"

#include "program/contact_fields.h"
#include "program/summary.h"
#include "program/visible.h"

#include <errno.h>
#include <string.h>

//: Name the kinds of rows
static const char *const contact_names[] = {
    [TF_POINT_EDGE] = "point-edge",
    [TF_POINT_TRIANGLE] = "point-triangle",
    [TF_EDGE_EDGE] = "edge-edge",
};

static const char *const crossing_names[] = {
    [TF_EDGE_THROUGH_TRIANGLE] = "edge-triangle",
    [TF_POINT_ON_TRIANGLE] = "point-triangle",
    [TF_EDGE_ON_EDGE] = "edge-edge",
};

static const char letters[] = "abcdef";

//: Write names of files
/// As a field of CSV, in quotes where it needs them.
static void write_csv_name(FILE *stream, const char *name)
{
    bool quoted = strpbrk(name, ",\"\r\n");
    fputs(quoted ? "\"" : "", stream);
    for (; *name; name++) {
        fputs(*name == '"' ? "\"" : "", stream);
        fputc(*name, stream);
    }
    fputs(quoted ? "\"" : "", stream);
}

/// As a string of JSON, which must be UTF-8.
static void write_json_name(FILE *stream, const char *name)
{
    tf_visible shown = tf_make_visible(name);
    fputc('"', stream);
    for (const char *c = shown.text; *c; c++) {
        fputs(*c == '"' || *c == '\\' ? "\\" : "", stream);
        fputc(*c, stream);
    }
    fputc('"', stream);
}

//: Write rows as CSV
static void begin_csv(const tf_surface_output *output)
{
    if (output->checks) {
        fputs("file,kind,a,b,c,d,e,f\n", output->stream);
        return;
    }
    fputs("step,kind,a,b,c,d", output->stream);
    tf_contact_head_csv(output->stream);
}

static void write_csv_vertices(FILE *stream, int columns, const int vertex[],
                               int count)
{
    for (int i = 0; i < columns; i++)
        if (i < count && vertex[i] >= 0)
            fprintf(stream, ",%d", vertex[i]);
        else
            fputc(',', stream);
}

static void contact_csv(const tf_surface_output *output, int axes,
                        const tf_surface_contact *row)
{
    fprintf(output->stream, "%ld,%s", output->tally.parts,
            contact_names[row->kind]);
    write_csv_vertices(output->stream, 4, row->vertex, 4);
    tf_contact_write_csv(output->stream, axes, &row->contact);
}

static void crossing_csv(const tf_surface_output *output, const char *file,
                         const tf_crossing *row)
{
    write_csv_name(output->stream, file);
    fprintf(output->stream, ",%s", crossing_names[row->kind]);
    write_csv_vertices(output->stream, 6, row->vertex, 5);
    fputc('\n', output->stream);
}

static void end_csv(const tf_surface_output *output)
{
    (void)output;
}

//: Write rows as JSON
static void begin_json(const tf_surface_output *output)
{
    fprintf(output->stream, "{\"%s\":[",
            output->checks ? "intersections" : "contacts");
}

static void write_json_vertices(FILE *stream, const int vertex[], int count)
{
    for (int i = 0; i < count; i++)
        if (vertex[i] >= 0)
            fprintf(stream, ",\"%c\":%d", letters[i], vertex[i]);
        else
            fprintf(stream, ",\"%c\":null", letters[i]);
}

static const char *separator(const tf_surface_output *output)
{
    return output->tally.rows > 0 ? ",\n" : "\n";
}

static void contact_json(const tf_surface_output *output, int axes,
                         const tf_surface_contact *row)
{
    fprintf(output->stream, "%s{\"step\":%ld,\"kind\":\"%s\"",
            separator(output), output->tally.parts, contact_names[row->kind]);
    write_json_vertices(output->stream, row->vertex, 4);
    tf_contact_write_json(output->stream, axes, &row->contact);
}

static void crossing_json(const tf_surface_output *output, const char *file,
                          const tf_crossing *row)
{
    fprintf(output->stream, "%s{\"file\":", separator(output));
    write_json_name(output->stream, file);
    fprintf(output->stream, ",\"kind\":\"%s\"", crossing_names[row->kind]);
    write_json_vertices(output->stream, row->vertex, 5);
    fputc('}', output->stream);
}

//: Count in a summary
enum {
    COUNTS = 7
};

/// The counts by name; returns how many.
static int list_counts(const tf_surface_output *output, tf_entry list[COUNTS])
{
    const tf_surface_tally *tally = &output->tally;
    const tf_detect_statistics *statistics = &tally->statistics;
    bool checks = output->checks;
    const tf_entry all[COUNTS] = {
        tf_entry_count(checks ? "files" : "steps", (size_t)tally->parts),
        tf_entry_count(checks ? "files with intersections"
                              : "steps with contacts",
                       (size_t)tally->tangled),
        tf_entry_count(checks ? "intersections" : "contacts",
                       (size_t)tally->rows),
        tf_entry_count("candidates", statistics->candidates),
        tf_entry_count("decided by axis", statistics->by_axis),
        tf_entry_count("decided by filter", statistics->by_filter),
        tf_entry_count("decided by signs", statistics->by_signs),
    };
    memcpy(list, all, sizeof all);
    return checks ? 3 : COUNTS;
}

static void end_json(const tf_surface_output *output)
{
    tf_entry list[COUNTS];
    int counts = list_counts(output, list);
    fputs("\n],\n\"summary\":", output->stream);
    tf_summary_write_json(output->stream, counts, list);
    fputs("}\n", output->stream);
}

//: Write a summary alone
static void begin_summary(const tf_surface_output *output)
{
    (void)output;
}

static void contact_summary(const tf_surface_output *output, int axes,
                            const tf_surface_contact *row)
{
    (void)output;
    (void)axes;
    (void)row;
}

static void crossing_summary(const tf_surface_output *output, const char *file,
                             const tf_crossing *row)
{
    (void)output;
    (void)file;
    (void)row;
}

static void end_summary(const tf_surface_output *output)
{
    tf_entry list[COUNTS];
    int counts = list_counts(output, list);
    tf_summary_write(output->stream, counts, list);
}

//: Find a format by its name about surfaces
struct tf_surface_format {
    const char *name;
    void (*begin)(const tf_surface_output *output);
    void (*contact)(const tf_surface_output *output, int axes,
                    const tf_surface_contact *row);
    void (*crossing)(const tf_surface_output *output, const char *file,
                     const tf_crossing *row);
    void (*end)(const tf_surface_output *output);
};

static const tf_surface_format formats[] = {
    {"csv", begin_csv, contact_csv, crossing_csv, end_csv},
    {"json", begin_json, contact_json, crossing_json, end_json},
    {"summary", begin_summary, contact_summary, crossing_summary, end_summary},
};

const tf_surface_format *tf_surface_format_named(const char *name)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (strcmp(name, formats[i].name) == 0)
            return &formats[i];
    return NULL;
}

//: Notice a write that failed about surfaces
static bool written(tf_surface_output *output)
{
    if (ferror(output->stream) && output->error == 0)
        output->error = errno;
    return output->error == 0;
}

//: Write the rows
bool tf_surface_output_begin(tf_surface_output *output, FILE *stream,
                             const tf_surface_format *format, bool checks)
{
    *output = (tf_surface_output){
        .stream = stream, .format = format, .checks = checks};
    format->begin(output);
    return written(output);
}

bool tf_surface_output_contacts(tf_surface_output *output, int axes,
                                const tf_contacts *contacts)
{
    tf_surface_tally *tally = &output->tally;
    for (size_t i = 0; i < contacts->count && written(output); i++) {
        output->format->contact(output, axes, &contacts->contact[i]);
        tally->rows++;
    }
    tally->parts++;
    tally->tangled += contacts->any;
    tally->statistics.candidates += contacts->statistics.candidates;
    tally->statistics.by_axis += contacts->statistics.by_axis;
    tally->statistics.by_filter += contacts->statistics.by_filter;
    tally->statistics.by_signs += contacts->statistics.by_signs;
    return written(output);
}

bool tf_surface_output_crossings(tf_surface_output *output, const char *file,
                                 const tf_crossings *crossings)
{
    for (size_t i = 0; i < crossings->count && written(output); i++) {
        output->format->crossing(output, file, &crossings->crossing[i]);
        output->tally.rows++;
    }
    output->tally.parts++;
    output->tally.tangled += crossings->count > 0;
    return written(output);
}

bool tf_surface_output_end(tf_surface_output *output)
{
    output->format->end(output);
    fflush(output->stream);
    return written(output);
}
