//: Include what destinations need
#include "files/destination.h"

#include "files/gzip_stream.h"

#include <errno.h>
#include <string.h>

//: Begin and end a destination
bool tf_destination_is_standard(const char *path)
{
    return strcmp(path, "-") == 0;
}

static bool fault_in_writing(const tf_destination *to, int reason)
{
    bool standard = tf_destination_is_standard(to->path);
    return tf_fault_set_unwritten(
        to->fault, standard ? "standard output" : to->path, reason);
}

bool tf_destination_begin(tf_destination *to, const char *path, tf_fault *fault)
{
    *to = (tf_destination){.path = path, .fault = fault};
    return tf_destination_is_standard(path) ||
           tf_output_file_begin(&to->file, path) || fault_in_writing(to, errno);
}

void tf_destination_end(tf_destination *to)
{
    if (to->stream && to->stream != stdout)
        fclose(to->stream);
    if (to->plain)
        fclose(to->plain);
    to->stream = to->plain = NULL;
    tf_output_file_drop(&to->file);
}

//: Open a destination
static FILE *open_file(tf_destination *to)
{
    FILE *stream = tf_output_file_open(&to->file);
    if (!stream || !tf_is_gzip_name(to->path))
        return stream;
    to->plain = stream;
    return tf_gzip_open(stream);
}

FILE *tf_destination_open(tf_destination *to)
{
    to->stream = tf_destination_is_standard(to->path) ? stdout : open_file(to);
    if (!to->stream)
        fault_in_writing(to, errno);
    return to->stream;
}

//: Close a destination
/// Writes the rest of what is compressed.
static bool close_compressed(tf_destination *to, FILE *stream)
{
    FILE *plain = to->plain;
    bool failed = ferror(stream);
    bool good = fclose(stream) == 0 && !failed;
    int cause = errno;
    to->plain = NULL;
    bool written = tf_output_file_close(&to->file, plain);
    errno = good ? errno : cause;
    return good && written;
}

bool tf_destination_close(tf_destination *to)
{
    FILE *stream = to->stream;
    to->stream = NULL;
    bool written = stream == stdout ? fflush(stdout) == 0 && !ferror(stdout)
                   : to->plain      ? close_compressed(to, stream)
                                    : tf_output_file_close(&to->file, stream);
    return written || fault_in_writing(to, errno);
}

//: Finish a destination

bool tf_destination_keep(tf_destination *to)
{
    return tf_destination_is_standard(to->path) ||
           tf_output_file_keep(&to->file) || fault_in_writing(to, errno);
}

bool tf_destination_finish(tf_destination *to, bool good, int reason)
{
    if (reason)
        return fault_in_writing(to, reason);
    return good && tf_destination_close(to) && tf_destination_keep(to);
}
