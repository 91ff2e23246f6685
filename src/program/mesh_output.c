//: Include what the output of a mesh needs
#include "program/mesh_output.h"

#include <errno.h>
#include <string.h>

//: Begin and end the output of a mesh
static bool fault_in_writing(const tf_mesh_output *output, const char *target)
{
    return tf_fault_set_unwritten(output->fault, target, errno);
}

static bool is_named(const tf_mesh_output *output)
{
    return strcmp(output->path, "-") != 0;
}

bool tf_mesh_output_begin(tf_mesh_output *output, const char *path,
                          tf_fault *fault)
{
    *output = (tf_mesh_output){.path = path, .fault = fault};
    return !is_named(output) || tf_output_file_begin(&output->file, path) ||
           fault_in_writing(output, path);
}

void tf_mesh_output_end(tf_mesh_output *output)
{
    tf_output_file_drop(&output->file);
}

//: Write the mesh alone
static bool write_mesh(const tf_mesh_output *output,
                       const tf_mesh_content *content, tf_mesh_format format)
{
    if (!is_named(output)) {
        tf_mesh_write(stdout, content, format);
        return (fflush(stdout) == 0 && !ferror(stdout)) ||
               fault_in_writing(output, "standard output");
    }
    FILE *stream = tf_output_file_open(&output->file);
    if (stream)
        tf_mesh_write(stream, content, format);
    return (stream && tf_output_file_close(&output->file, stream)) ||
           fault_in_writing(output, output->path);
}

//: Write the mesh and the report
static bool write_report(const tf_mesh_output *output,
                         const tf_mesh_report *report)
{
    bool named = is_named(output);
    return tf_report_write(named ? stdout : stderr, report->format,
                           report->field, report->record) ||
           fault_in_writing(output,
                            named ? "standard output" : "standard error");
}

// The file gets its name last, so that after any error it is as it was.
bool tf_mesh_output_write(tf_mesh_output *output,
                          const tf_mesh_content *content, tf_mesh_format usual,
                          const tf_mesh_report *report)
{
    return write_mesh(output, content,
                      tf_mesh_format_of(output->path, usual)) &&
           write_report(output, report) &&
           (!is_named(output) || tf_output_file_keep(&output->file) ||
            fault_in_writing(output, output->path));
}
