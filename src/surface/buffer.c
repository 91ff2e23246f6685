//: Include what buffers need
#include "surface/buffer.h"

#include "base/memory.h"
#include "base/require.h"

#include <stdint.h>

//: Keep memory
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
    size_t bytes = count * size;
    if (bytes <= buffer->bytes)
        return true;
    char *block = tf_allocate(bytes + ALIGNMENT);
    if (!block)
        return false;
    tf_buffer_free(buffer);
    size_t shift = ALIGNMENT - (uintptr_t)block % ALIGNMENT;
    *buffer = (tf_buffer){block + shift, bytes, shift};
    return true;
}

//: Extend a list
bool tf_buffer_extend(tf_buffer *buffer, size_t count, size_t size)
{
    if (!fits(count, size))
        return false;
    if (count * size <= buffer->bytes)
        return true;
    TF_REQUIRE(buffer->shift == 0);
    size_t bytes = count * size;
    if (bytes < 2 * buffer->bytes)
        bytes = 2 * buffer->bytes;
    void *data = tf_reallocate(buffer->data, buffer->bytes, bytes);
    if (!data)
        return false;
    buffer->data = data;
    buffer->bytes = bytes;
    return true;
}

//: Free a buffer
void tf_buffer_free(tf_buffer *buffer)
{
    size_t shift = buffer->shift;
    if (shift > 0)
        tf_release((char *)buffer->data - shift, buffer->bytes + ALIGNMENT);
    else
        tf_release(buffer->data, buffer->bytes);
    *buffer = (tf_buffer){0};
}
