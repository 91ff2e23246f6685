//: Include what streams that compress need
#define _GNU_SOURCE // fopencookie, strcasecmp
#include "files/gzip_stream.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

//: Know the name of a compressed file
bool tf_is_gzip_name(const char *path)
{
    size_t length = strlen(path);
    return length >= 3 && strcasecmp(path + length - 3, ".gz") == 0;
}

//: Write to a stream that compresses
static ssize_t compress_bytes(void *file, const char *bytes, size_t count)
{
    return gzwrite(file, bytes, (unsigned)count);
}

/// zlib leaves the cause in errno, but not for want of memory.
static int close_file(void *file)
{
    int status = gzclose(file);
    if (status == Z_MEM_ERROR)
        errno = ENOMEM;
    return status == Z_OK ? 0 : -1;
}

//: Open a stream that compresses
static gzFile open_file(FILE *to)
{
    int descriptor = dup(fileno(to));
    gzFile file = descriptor < 0 ? NULL : gzdopen(descriptor, "wb");
    if (!file && descriptor >= 0) {
        close(descriptor);
        errno = ENOMEM;
    }
    return file;
}

FILE *tf_gzip_open(FILE *to)
{
    const cookie_io_functions_t functions = {.write = compress_bytes,
                                             .close = close_file};
    gzFile file = open_file(to);
    FILE *stream = file ? fopencookie(file, "wb", functions) : NULL;
    if (file && !stream)
        gzclose(file);
    return stream;
}
