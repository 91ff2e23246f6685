// Any bytes as a scene file.
#define _GNU_SOURCE // memfd_create
#include "scenes/scene_file.h"

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
        memory = memfd_create("scene", 0);
    if (memory < 0 || ftruncate(memory, 0) != 0 ||
        pwrite(memory, bytes, size, 0) != (ssize_t)size)
        abort();
    snprintf(path, sizeof path, "/proc/self/fd/%d", memory);
    tf_scene_meshes meshes;
    tf_fault fault = {0};
    bool good = tf_scene_file_read(&meshes, path, &fault);
    if (good != (fault.text[0] == '\0') ||
        (good && (meshes.count == 0 || meshes.frames == 0)))
        abort();
    for (int m = 0; m < meshes.count && good; m++)
        if (!tf_scene_mesh_path(&meshes.mesh[m], meshes.frames - 1))
            abort();
    tf_scene_meshes_free(&meshes);
    return 0;
}
