//: Include what reading files needs
#include "formats/file_bytes.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

//: Make room for bytes
static bool make_room(tf_bytes *bytes)
{
    size_t room = 2 * bytes->room + (1 << 17);
    char *moved = realloc(bytes->item, room);
    if (moved)
        *bytes = (tf_bytes){moved, bytes->count, room};
    return moved;
}

static bool fault_in_memory(tf_fault *fault, const char *name)
{
    return tf_fault_set(
        fault, name, -1,
        "not enough memory; divide the mesh, or use a machine with more");
}

//: Describe what is wrong with a stream
/// The errors of gzip, and those of the system.
static bool check_stream(gzFile stream, const char *name, tf_fault *fault)
{
    int status, reason = errno;
    gzerror(stream, &status);
    switch (status) {
    case Z_OK:
        return true;
    case Z_ERRNO:
        return tf_fault_set_unread(fault, name, -1, reason);
    case Z_MEM_ERROR:
        return fault_in_memory(fault, name);
    case Z_BUF_ERROR:
        return tf_fault_set(fault, name, -1,
                            "the gzip file ends too early; copy it again");
    default:
        return tf_fault_set(fault, name, -1,
                            "the gzip file is damaged; copy it again");
    }
}

//: Read all bytes
static bool read_all(tf_bytes *bytes, gzFile stream, const char *name,
                     tf_hopeless *is_hopeless, tf_fault *fault)
{
    size_t got, wanted;
    do {
        if (!make_room(bytes))
            return fault_in_memory(fault, name);
        wanted = bytes->room - bytes->count - 1;
        wanted = wanted < INT_MAX ? wanted : INT_MAX;
        int read = gzread(stream, bytes->item + bytes->count, (unsigned)wanted);
        got = read > 0 ? (size_t)read : 0;
        bytes->count += got;
        bytes->item[bytes->count] = '\0';
    } while (got == wanted && !is_hopeless(bytes, got));
    return check_stream(stream, name, fault);
}

/// The end of a file is reported when it is closed, too.
static gzFile open_stream(const char *path)
{
    if (strcmp(path, "-") != 0)
        return gzopen(path, "rb");
    int copy = dup(STDIN_FILENO);
    gzFile stream = copy < 0 ? NULL : gzdopen(copy, "rb");
    if (!stream && copy >= 0)
        close(copy);
    return stream;
}

bool tf_bytes_read(tf_bytes *bytes, const char *path, const char *name,
                   tf_hopeless *is_hopeless, tf_fault *fault)
{
    errno = 0;
    gzFile stream = open_stream(path);
    if (!stream)
        return tf_fault_set_unopened(fault, name, errno ? errno : ENOMEM);
    gzbuffer(stream, 1 << 17);
    bool good = read_all(bytes, stream, name, is_hopeless, fault);
    gzclose(stream);
    return good;
}

//: Free bytes
void tf_bytes_free(tf_bytes *bytes)
{
    free(bytes->item);
    *bytes = (tf_bytes){0};
}
