//: Include what the output about surfaces needs
#include "program/surface_output.h"

#include "program/contact_fields.h"

#include <string.h>

//: List the fields of a contact of a surface
typedef struct contact_row {
    size_t step;
    const char *kind;
    int vertex[4];
    tf_contact_values contact;
} contact_row;

static const tf_field contact_fields[] = {
    TF_FIELD("step", contact_row, step),
    TF_FIELD("kind", contact_row, kind),
    TF_FIELD("a", contact_row, vertex[0]),
    TF_FIELD("b", contact_row, vertex[1]),
    TF_FIELD("c", contact_row, vertex[2]),
    TF_FIELD("d", contact_row, vertex[3]),
    TF_CONTACT_FIELDS(contact_row, contact),
    {0},
};

static const char *const contact_kinds[] = {
    [TF_POINT_EDGE] = "point-edge",
    [TF_POINT_TRIANGLE] = "point-triangle",
    [TF_EDGE_EDGE] = "edge-edge",
};

//: List the fields of an intersection
typedef struct crossing_row {
    const char *file, *kind;
    int vertex[5];
} crossing_row;

static const tf_field crossing_fields[] = {
    TF_FIELD("file", crossing_row, file),
    TF_FIELD("kind", crossing_row, kind),
    TF_FIELD("a", crossing_row, vertex[0]),
    TF_FIELD("b", crossing_row, vertex[1]),
    TF_FIELD("c", crossing_row, vertex[2]),
    TF_FIELD("d", crossing_row, vertex[3]),
    TF_FIELD("e", crossing_row, vertex[4]),
    {"f", TF_EMPTY, 0, NULL},
    {0},
};

static const char *const crossing_kinds[] = {
    [TF_EDGE_THROUGH_TRIANGLE] = "edge-triangle",
    [TF_POINT_ON_TRIANGLE] = "point-triangle",
    [TF_EDGE_ON_EDGE] = "edge-edge",
};

static const char *const near_kinds[] = {
    [TF_POINT_EDGE] = "near-point-edge",
    [TF_POINT_TRIANGLE] = "near-point-triangle",
    [TF_EDGE_EDGE] = "near-edge-edge",
};

//: List the counts of steps and of files
static const tf_field counts_of_steps[] = {
    TF_FIELD("steps", tf_surface_tally, parts),
    TF_FIELD("steps with contacts", tf_surface_tally, tangled),
    TF_FIELD("contacts", tf_surface_tally, rows),
    TF_FIELD("candidates", tf_surface_tally, statistics.candidates),
    TF_FIELD("decided by axis", tf_surface_tally, statistics.by_axis),
    TF_FIELD("decided by filter", tf_surface_tally, statistics.by_filter),
    TF_FIELD("decided by signs", tf_surface_tally, statistics.by_signs),
    {0},
};

static const tf_field counts_of_files[] = {
    TF_FIELD("files", tf_surface_tally, parts),
    TF_FIELD("files with intersections", tf_surface_tally, tangled),
    TF_FIELD("intersections", tf_surface_tally, rows),
    {0},
};

static const tf_field counts_with_near[] = {
    TF_FIELD("files", tf_surface_tally, parts),
    TF_FIELD("files with rows", tf_surface_tally, tangled),
    TF_FIELD("intersections", tf_surface_tally, rows),
    TF_FIELD("near pairs", tf_surface_tally, near),
    {0},
};

//: Begin and end the output about surfaces
bool tf_surface_output_begin(tf_surface_output *output, FILE *stream,
                             tf_format format, bool checks, bool measures)
{
    *output = (tf_surface_output){.checks = checks, .measures = measures};
    return tf_records_begin(&output->records, stream, format,
                            checks ? "intersections" : "contacts",
                            checks ? crossing_fields : contact_fields);
}

bool tf_surface_output_end(tf_surface_output *output)
{
    return tf_records_end(&output->records,
                          output->measures ? counts_with_near
                          : output->checks ? counts_of_files
                                           : counts_of_steps,
                          &output->tally);
}

//: Write the rows
static bool add_row(tf_surface_output *output, const void *row)
{
    output->tally.rows++;
    return tf_records_add(&output->records, row);
}

static void add_statistics(tf_detect_statistics *total,
                           const tf_detect_statistics *statistics)
{
    total->candidates += statistics->candidates;
    total->by_axis += statistics->by_axis;
    total->by_filter += statistics->by_filter;
    total->by_signs += statistics->by_signs;
}

bool tf_surface_output_contacts(tf_surface_output *output, int axes,
                                const tf_contacts *contacts)
{
    tf_surface_tally *tally = &output->tally;
    bool good = true;
    for (size_t i = 0; i < contacts->count && good; i++) {
        const tf_surface_contact *found = &contacts->contact[i];
        contact_row row = {.step = tally->parts,
                           .kind = contact_kinds[found->kind],
                           .contact =
                               tf_contact_values_of(&found->contact, axes)};
        memcpy(row.vertex, found->vertex, sizeof row.vertex);
        good = add_row(output, &row);
    }
    tally->parts++;
    tally->tangled += contacts->any;
    add_statistics(&tally->statistics, &contacts->statistics);
    return good;
}

bool tf_surface_output_crossings(tf_surface_output *output, const char *file,
                                 const tf_crossings *crossings)
{
    bool good = true;
    for (size_t i = 0; i < crossings->count && good; i++) {
        const tf_crossing *found = &crossings->crossing[i];
        crossing_row row = {.file = file, .kind = crossing_kinds[found->kind]};
        memcpy(row.vertex, found->vertex, sizeof row.vertex);
        good = add_row(output, &row);
    }
    output->tally.parts++;
    output->tally.tangled += crossings->count > 0;
    return good;
}

bool tf_surface_output_near(tf_surface_output *output, const char *file,
                            bool tangled, const tf_near_pairs *pairs)
{
    bool good = true;
    for (size_t i = 0; i < pairs->count && good; i++) {
        const tf_near_pair *found = &pairs->pair[i];
        crossing_row row = {.file = file, .kind = near_kinds[found->kind]};
        memcpy(row.vertex, found->vertex, sizeof found->vertex);
        row.vertex[4] = -1;
        good = tf_records_add(&output->records, &row);
    }
    output->tally.near += pairs->count;
    output->tally.tangled += pairs->count > 0 && !tangled;
    return good;
}
