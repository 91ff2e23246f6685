//: Include what the command weld needs
#include "formats/mesh_reader.h"
#include "program/command.h"
#include "program/reports.h"
#include "scenes/coincident.h"
#include "scenes/joined.h"
#include "scenes/remarks.h"
#include "scenes/weld.h"
#include "writers/joined_writer.h"
#include "writers/mesh_output.h"

#include <stdlib.h>

//: Hold what weld does
typedef struct welding {
    const tf_request *request;
    tf_mesh_file file, welded;
    tf_columns columns, carried; ///< what the vertices of both have
    tf_source source;            ///< of the file
    int *number;                 ///< of its vertices in what is welded
    tf_fault fault;
    tf_weld_report report;
    tf_destination out;
} welding;

//: Read what is to be welded
/// Only indices must be right: elements with a corner twice collapse.
static bool check_indices(const tf_mesh_file *file)
{
    tf_joined alone;
    bool good = tf_joined_make(&alone, 1, &file);
    tf_joined_free(&alone);
    return good;
}

static bool check_within(welding *w)
{
    int vertices = tf_mesh_file_vertices(&w->file);
    double within = w->request->within;
    double least = tf_least_within(vertices, w->file.position.item);
    return within == 0 || within >= least ||
           tf_mesh_file_fault(&w->file, -1,
                              "--within %g is too small for coordinates of "
                              "that size; give at least %g, or none",
                              within, least);
}

static bool read(welding *w)
{
    w->source.keeps_parts = true;
    if (!tf_mesh_file_read_all(&w->file, w->request->operand[0], &w->columns,
                               &w->source, &w->fault))
        return false;
    tf_remarks_print(&w->file);
    return check_indices(&w->file) && check_within(w);
}

//: Weld and write
static bool weld(welding *w)
{
    size_t vertices = (size_t)tf_mesh_file_vertices(&w->file);
    w->number = malloc((vertices + 1) * sizeof *w->number);
    return w->number ? tf_weld(&w->file, w->request->within, &w->columns,
                               w->number, &w->welded, &w->carried, &w->report)
                     : tf_mesh_file_fault_in_memory(&w->file);
}

/// Where nothing was joined, nothing is lost, and elsewhere what cannot be kept.
static bool write(welding *w)
{
    bool same =
        w->report.joined + w->report.collapsed + w->report.collapsed_edges == 0;
    const tf_mesh_file *from = same ? &w->file : &w->welded;
    tf_mesh_content content = {
        .mesh = tf_mesh_file_elements(from, 3),
        .position = from->position.item,
        .columns = from->columns->count > 0 ? from->columns : NULL,
        .from = from,
        .joined = same ? NULL : &w->file,
        .number = w->number};
    if (content.joined && !tf_joined_is_writable(&content))
        content.joined = NULL;
    tf_mesh_report report = {*w->request->format, tf_weld_fields, &w->report};
    return tf_mesh_output_write(&w->out, &content, &w->file, &report);
}

static bool do_all(welding *w)
{
    return read(w) &&
           tf_mesh_output_begin(&w->out, w->request->out, &w->file,
                                &w->fault) &&
           weld(w) && write(w);
}

//: Run the command weld
static int run(const tf_request *request)
{
    welding w = {.request = request};
    bool good = do_all(&w);
    tf_fault_print(&w.fault, "tanglefree");
    tf_destination_end(&w.out);
    tf_mesh_file_free(&w.file);
    tf_mesh_file_free(&w.welded);
    tf_columns_free(&w.columns);
    tf_columns_free(&w.carried);
    tf_source_free(&w.source);
    free(w.number);
    return good ? 0 : 2;
}

const tf_command tf_weld_command = {
    .set = TF_WELD,
    .name = "weld",
    .purpose = "join vertices of a mesh that are at one position",
    .operands = "IN",
    .least = 1,
    .most = 1,
    .wanted = "one file is required: IN",
    .description = tf_weld_description,
    .run = run,
};
