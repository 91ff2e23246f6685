//: Include what the output of a mesh needs
#include "program/mesh_output.h"

#include "files/mesh_writer.h"
#include "files/visible.h"

#include <errno.h>
#include <string.h>

//: Note an error of writing
static bool fault_in_writing(tf_mesh_output *output, const char *target)
{
    output->error = errno;
    output->target = target;
    return false;
}

//: Begin the output of a mesh
static bool is_named(const tf_mesh_output *output)
{
    return strcmp(output->path, "-") != 0;
}

bool tf_mesh_output_begin(tf_mesh_output *output, const char *path)
{
    output->path = path;
    return !is_named(output) || tf_output_file_begin(&output->file, path) ||
           fault_in_writing(output, path);
}

//: Write the mesh alone
static void write_mesh(const tf_mesh_output *output, FILE *stream,
                       const tf_mesh_file *mesh)
{
    tf_mesh_write(stream, mesh, tf_mesh_format_of(output->path, mesh->format));
}

static bool write_scratch(tf_mesh_output *output, const tf_mesh_file *mesh)
{
    FILE *stream = tf_output_file_open(&output->file);
    if (!stream)
        return fault_in_writing(output, output->path);
    write_mesh(output, stream, mesh);
    return tf_output_file_close(&output->file, stream) ||
           fault_in_writing(output, output->path);
}

static bool write_to_standard_output(tf_mesh_output *output,
                                     const tf_mesh_file *mesh)
{
    write_mesh(output, stdout, mesh);
    return (fflush(stdout) == 0 && !ferror(stdout)) ||
           fault_in_writing(output, "standard output");
}

//: Write the mesh and the report
// The file gets its name last, so that after any error it is as it was.
bool tf_mesh_output_write(tf_mesh_output *output, const tf_mesh_file *mesh,
                          bool (*report)(FILE *stream, const void *context),
                          const void *context)
{
    if (!is_named(output))
        return write_to_standard_output(output, mesh) &&
               (report(stderr, context) ||
                fault_in_writing(output, "standard error"));
    return write_scratch(output, mesh) &&
           (report(stdout, context) ||
            fault_in_writing(output, "standard output")) &&
           (tf_output_file_keep(&output->file) ||
            fault_in_writing(output, output->path));
}

//: End the output of a mesh
void tf_mesh_output_end(tf_mesh_output *output)
{
    if (output->target)
        fprintf(stderr,
                "tanglefree: %s: cannot write: %s; mend that and run again\n",
                tf_make_visible(output->target).text, strerror(output->error));
    tf_output_file_drop(&output->file);
}
