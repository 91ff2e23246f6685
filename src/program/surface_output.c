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
    const char *mesh[2];
} contact_row;

#define CONTACT_FIELDS                                                         \
    TF_FIELD("step", contact_row, step), TF_FIELD("kind", contact_row, kind),  \
        TF_FIELD("a", contact_row, vertex[0]),                                 \
        TF_FIELD("b", contact_row, vertex[1]),                                 \
        TF_FIELD("c", contact_row, vertex[2]),                                 \
        TF_FIELD("d", contact_row, vertex[3]),                                 \
        TF_CONTACT_FIELDS(contact_row, contact)

static const tf_field contact_fields[] = {CONTACT_FIELDS, {0}};

static const tf_field contact_fields_of_meshes[] = {
    CONTACT_FIELDS,
    TF_FIELD("mesh", contact_row, mesh[0]),
    TF_FIELD("other_mesh", contact_row, mesh[1]),
    {0},
};

static const char *const contact_kinds[] = {
    [TF_POINT_EDGE] = "point-edge",
    [TF_POINT_TRIANGLE] = "point-triangle",
    [TF_EDGE_EDGE] = "edge-edge",
};

//: List the fields of an intersection
typedef struct crossing_row {
    size_t frame;
    const char *kind;
    int vertex[5];
    const char *mesh[2]; // or files
} crossing_row;

#define CROSSING_FIELDS                                                        \
    TF_FIELD("kind", crossing_row, kind),                                      \
        TF_FIELD("a", crossing_row, vertex[0]),                                \
        TF_FIELD("b", crossing_row, vertex[1]),                                \
        TF_FIELD("c", crossing_row, vertex[2]),                                \
        TF_FIELD("d", crossing_row, vertex[3]),                                \
        TF_FIELD("e", crossing_row, vertex[4]),                                \
    {                                                                          \
        "f", TF_EMPTY, 0, NULL                                                 \
    }

static const tf_field crossing_fields[] = {
    TF_FIELD("file", crossing_row, mesh[0]),
    CROSSING_FIELDS,
    {0},
};

static const tf_field crossing_fields_of_files[] = {
    TF_FIELD("file", crossing_row, mesh[0]),
    CROSSING_FIELDS,
    TF_FIELD("other_file", crossing_row, mesh[1]),
    {0},
};

static const tf_field crossing_fields_of_meshes[] = {
    TF_FIELD("frame", crossing_row, frame),
    CROSSING_FIELDS,
    TF_FIELD("mesh", crossing_row, mesh[0]),
    TF_FIELD("other_mesh", crossing_row, mesh[1]),
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

//: List the counts of steps, files and frames
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

#define COUNTS(parts_, tangled_)                                               \
    TF_FIELD(parts_, tf_surface_tally, parts),                                 \
        TF_FIELD(tangled_, tf_surface_tally, tangled),                         \
        TF_FIELD("intersections", tf_surface_tally, rows)

#define NEAR_COUNT TF_FIELD("near pairs", tf_surface_tally, near)

// By whether there are near pairs, and whether it is about frames.
static const tf_field counts_of_checks[2][2][5] = {
    {{COUNTS("files", "files with intersections"), {0}},
     {COUNTS("frames", "frames with intersections"), {0}}},
    {{COUNTS("files", "files with rows"), NEAR_COUNT, {0}},
     {COUNTS("frames", "frames with rows"), NEAR_COUNT, {0}}}};

//: Begin and end the output about surfaces
void tf_surface_output_begin(tf_surface_output *output, FILE *stream,
                             const tf_surface_output_options *options)
{
    static const tf_field *const contacts[] = {
        [TF_NAMES_OF_FILE] = contact_fields,
        [TF_NAMES_OF_MESHES] = contact_fields_of_meshes};
    static const tf_field *const crossings[] = {
        [TF_NAMES_OF_FILE] = crossing_fields,
        [TF_NAMES_OF_FILES] = crossing_fields_of_files,
        [TF_NAMES_OF_MESHES] = crossing_fields_of_meshes};
    bool checks = options->checks;
    *output = (tf_surface_output){.options = *options};
    tf_records_begin(&output->records, stream, options->format,
                     checks ? "intersections" : "contacts",
                     (checks ? crossings : contacts)[options->names]);
}

bool tf_surface_output_end(tf_surface_output *output, bool done)
{
    const tf_surface_output_options *options = &output->options;
    if (!done && output->records.count == 0)
        return output->records.error == 0;
    bool frames = options->names == TF_NAMES_OF_MESHES;
    const tf_field *counts = options->checks
                                 ? counts_of_checks[options->measures][frames]
                                 : counts_of_steps;
    bool told = done || options->format == TF_JSON;
    return tf_records_end(&output->records, told ? counts : NULL,
                          &output->tally);
}

//: Name the elements of a row
/// Gives vertices, of two elements of which the first has `first`, the numbers of
/// their meshes, which it names and counts among those in rows.
static void name_elements(const tf_surface_part *part, int count, int vertex[],
                          int first, const char *name[2])
{
    int mesh[2];
    tf_joined_localize(part->joined, count, vertex, first, mesh);
    for (int i = 0; i < 2; i++) {
        name[i] = part->name[mesh[i]];
        part->listed[mesh[i]] = true;
    }
}

//: Write the contacts of a step
static void add_statistics(tf_detect_statistics *total,
                           const tf_detect_statistics *statistics)
{
    total->candidates += statistics->candidates;
    total->by_axis += statistics->by_axis;
    total->by_filter += statistics->by_filter;
    total->by_signs += statistics->by_signs;
}

static bool add_contact(tf_surface_output *output, const tf_surface_part *part,
                        int axes, const tf_surface_contact *found)
{
    contact_row row = {.step = output->tally.parts,
                       .kind = contact_kinds[found->kind],
                       .contact = tf_contact_values_of(&found->contact, axes)};
    memcpy(row.vertex, found->vertex, sizeof row.vertex);
    name_elements(part, 4, row.vertex, found->kind == TF_EDGE_EDGE ? 2 : 1,
                  row.mesh);
    output->tally.rows++;
    return tf_records_add(&output->records, &row);
}

bool tf_surface_output_contacts(tf_surface_output *output,
                                const tf_surface_part *part, int axes,
                                const tf_contacts *contacts)
{
    tf_surface_tally *tally = &output->tally;
    bool good = true;
    for (size_t i = 0; i < contacts->count && good; i++)
        good = add_contact(output, part, axes, &contacts->contact[i]);
    tally->parts++;
    tally->tangled += contacts->any;
    add_statistics(&tally->statistics, &contacts->statistics);
    return good;
}

//: Write what is wrong with a frame
static bool add_crossing(tf_surface_output *output, const tf_surface_part *part,
                         const char *kind, const int vertex[5], int first)
{
    crossing_row row = {.frame = output->tally.parts, .kind = kind};
    memcpy(row.vertex, vertex, sizeof row.vertex);
    name_elements(part, 5, row.vertex, first, row.mesh);
    output->part_rows++;
    return tf_records_add(&output->records, &row);
}

bool tf_surface_output_crossings(tf_surface_output *output,
                                 const tf_surface_part *part,
                                 const tf_crossings *crossings)
{
    bool good = true;
    for (size_t i = 0; i < crossings->count && good; i++) {
        const tf_crossing *found = &crossings->crossing[i];
        good = add_crossing(output, part, crossing_kinds[found->kind],
                            found->vertex,
                            found->kind == TF_POINT_ON_TRIANGLE ? 1 : 2);
        output->tally.rows++;
    }
    return good;
}

bool tf_surface_output_near(tf_surface_output *output,
                            const tf_surface_part *part,
                            const tf_near_pairs *pairs)
{
    bool good = true;
    for (size_t i = 0; i < pairs->count && good; i++) {
        const tf_near_pair *found = &pairs->pair[i];
        const int *v = found->vertex;
        good = add_crossing(output, part, near_kinds[found->kind],
                            (int[]){v[0], v[1], v[2], v[3], -1},
                            found->kind == TF_EDGE_EDGE ? 2 : 1);
    }
    output->tally.near += pairs->count;
    return good;
}

//: Count what was checked
void tf_surface_output_count(tf_surface_output *output,
                             const tf_surface_part *part)
{
    tf_surface_tally *tally = &output->tally;
    bool joined = output->options.names == TF_NAMES_OF_FILES;
    tally->parts += joined ? (size_t)part->joined->meshes : 1;
    if (joined)
        for (int m = 0; m < part->joined->meshes; m++)
            tally->tangled += part->listed[m];
    else
        tally->tangled += output->part_rows > 0;
    output->part_rows = 0;
}

//: List intersections after a report
bool tf_surface_output_append(FILE *stream, tf_format report,
                              const tf_mesh_file *file, const char *name,
                              const tf_crossings *crossings)
{
    bool listed = false;
    tf_joined joined;
    tf_surface_output output;
    tf_surface_part part = {
        .joined = &joined, .name = &name, .listed = &listed};
    tf_surface_output_options how = {
        .format = report == TF_JSON ? TF_JSON : TF_CSV, .checks = true};
    bool good = tf_joined_make(&joined, 1, &file);
    if (good) {
        if (report != TF_JSON)
            fputc('\n', stream);
        tf_surface_output_begin(&output, stream, &how);
        good = tf_surface_output_crossings(&output, &part, crossings);
        tf_surface_output_count(&output, &part);
        good = tf_surface_output_end(&output, good) && good;
    }
    tf_joined_free(&joined);
    return good;
}
