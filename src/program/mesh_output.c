//: Include what the output of a mesh needs
#include "program/mesh_output.h"

#include <errno.h>

//: Write the mesh and the report
static bool write_mesh(tf_destination *to, const tf_mesh_content *content,
                       tf_mesh_format format)
{
    FILE *stream = tf_destination_open(to);
    if (stream)
        tf_mesh_write(stream, content, format);
    return stream && tf_destination_close(to);
}

static bool write_report(const tf_destination *to, const tf_mesh_report *report)
{
    bool taken = tf_destination_is_standard(to->path);
    return tf_report_write(taken ? stderr : stdout, report->format,
                           report->field, report->record) ||
           tf_fault_set_unwritten(
               to->fault, taken ? "standard error" : "standard output", errno);
}

// The file gets its name last, so that after any error it is as it was.
bool tf_mesh_output_write(tf_destination *to, const tf_mesh_content *content,
                          tf_mesh_format usual, const tf_mesh_report *report)
{
    return write_mesh(to, content, tf_mesh_format_of(to->path, usual)) &&
           write_report(to, report) && tf_destination_keep(to);
}
