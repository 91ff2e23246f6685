//: Keep memory
#include "surface/buffer.h"

#include <stdint.h>
#include <stdlib.h>

enum {
    ALIGNMENT = 64
};

static bool fits(size_t count, size_t size)
{
    return count <= (SIZE_MAX / 4) / size;
}

bool tf_buffer_reserve(tf_buffer *buffer, size_t count, size_t size)
{
    if (!fits(count, size))
        return false;
    if (count * size <= buffer->bytes)
        return true;
    size_t bytes = (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    void *data = aligned_alloc(ALIGNMENT, bytes);
    if (!data)
        return false;
    free(buffer->data);
    buffer->data = data;
    buffer->bytes = bytes;
    return true;
}

bool tf_buffer_extend(tf_buffer *buffer, size_t count, size_t size)
{
    if (!fits(count, size))
        return false;
    if (count * size <= buffer->bytes)
        return true;
    size_t bytes = count * size;
    if (bytes < 2 * buffer->bytes)
        bytes = 2 * buffer->bytes;
    void *data = realloc(buffer->data, bytes);
    if (!data)
        return false;
    buffer->data = data;
    buffer->bytes = bytes;
    return true;
}

void tf_buffer_free(tf_buffer *buffer)
{
    free(buffer->data);
    *buffer = (tf_buffer){0};
}
