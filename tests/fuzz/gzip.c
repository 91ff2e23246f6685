// Any bytes as a file that may be compressed.
#define _GNU_SOURCE // memfd_create
#include "formats/mesh_reader.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static int memory = -1;
    char path[50];
    if (memory < 0)
        memory = memfd_create("file", 0);
    if (memory < 0 || ftruncate(memory, 0) != 0 ||
        pwrite(memory, bytes, size, 0) != (ssize_t)size)
        abort();
    snprintf(path, sizeof path, "/proc/self/fd/%d", memory);
    tf_mesh_file file;
    tf_fault fault = {0};
    bool good = tf_mesh_file_read(&file, path, NULL, &fault);
    if (good != (fault.text[0] == '\0') || (!good && !strstr(fault.text, "; ")))
        abort();
    tf_mesh_file_free(&file);
    return 0;
}
