//: Include what the output of a mesh needs
#include "writers/mesh_output.h"

#include "writers/endings.h"
#include "writers/losses.h"

#include <errno.h>
#include <signal.h>

//: Begin the output of a mesh
bool tf_mesh_output_begin(tf_destination *to, const char *path,
                          const tf_mesh_file *made_of, tf_fault *fault)
{
    tf_mesh_content content = {.mesh = tf_mesh_file_elements(made_of, 3),
                               .position = made_of->position.item,
                               .from = made_of};
    return tf_mesh_check_writable(&content,
                                  tf_mesh_format_of(path, made_of->format),
                                  path, fault) &&
           tf_destination_begin(to, path, fault);
}

//: Say what is lost
static tf_visible shown_destination(const char *path)
{
    return tf_make_visible(tf_destination_is_standard(path) ? "standard output"
                                                            : path);
}

static void print_losses(const char *path, const tf_mesh_file *made_of,
                         tf_mesh_format format, bool keeps_faces)
{
    tf_losses losses = tf_find_losses(made_of, format, keeps_faces);
    if (*losses.text)
        fprintf(stderr, "tanglefree: %s: without the %s of %s\n",
                shown_destination(path).text, losses.text,
                tf_make_visible(made_of->name).text);
}

static void print_rounding(const char *path, const tf_mesh_content *content)
{
    static bool printed = false;
    size_t count = (size_t)content->mesh.vertices * (size_t)content->mesh.axes;
    size_t rounded = tf_count_rounded(content->position, count);
    if (rounded == 0 || printed)
        return;
    printed = true;
    fprintf(stderr,
            "tanglefree: %s: %zu of %zu coordinates are rounded to floats, by "
            "which elements may meet; check the file, or write a format other "
            "than STL\n",
            shown_destination(path).text, rounded, count);
}

void tf_mesh_output_remark(const char *path, const tf_mesh_content *content,
                           const tf_mesh_file *made_of)
{
    tf_mesh_format format = tf_mesh_format_of(path, made_of->format);
    if (made_of->source && !tf_mesh_is_source(content, format))
        print_losses(path, made_of, format, content->faces);
    if (tf_mesh_has_floats(content, format))
        print_rounding(path, content);
}

//: Write the mesh and the report
/// PLY holds what faces had in PLY, and OBJ what they had in OBJ.
static bool holds_faces(const tf_mesh_file *made_of, tf_mesh_format format)
{
    return made_of->format == TF_OBJ
               ? format == TF_OBJ
               : format >= TF_PLY_TEXT && format <= TF_PLY_BIG_ENDIAN;
}

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

/// Gives the file its name after the report, so that after any error it is as it
/// was; but that nobody reads the report is no reason to lose the mesh: then the
/// program ends afterwards, as by such a write.
static bool finish(tf_destination *to, const tf_mesh_report *report)
{
    void (*usual)(int) = signal(SIGPIPE, SIG_IGN);
    errno = 0;
    bool told = write_report(to, report), unread = !told && errno == EPIPE;
    signal(SIGPIPE, usual);
    bool kept = (told || unread) && tf_destination_keep(to);
    if (unread && kept)
        raise(SIGPIPE);
    return told && kept;
}

bool tf_mesh_output_write(tf_destination *to, const tf_mesh_content *content,
                          const tf_mesh_file *made_of,
                          const tf_mesh_report *report)
{
    tf_mesh_format format = tf_mesh_format_of(to->path, made_of->format);
    tf_mesh_content held = *content;
    if (!holds_faces(made_of, format))
        held.faces = NULL;
    tf_mesh_output_remark(to->path, &held, made_of);
    return tf_mesh_check_writable(&held, format, to->path, to->fault) &&
           write_mesh(to, &held, format) && finish(to, report);
}
