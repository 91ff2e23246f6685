//: Keep memory
#include "surface/buffer.h"

#include "base/memory.h"

#include <stdint.h>
#include <string.h>

static bool fits(size_t count, size_t size)
{
    return count <= (SIZE_MAX / 4) / size;
}

static bool grow(tf_buffer *buffer, size_t bytes, size_t kept)
{
    void *data = tf_allocate(bytes);
    if (!data)
        return false;
    if (kept > 0)
        memcpy(data, buffer->data, kept);
    tf_buffer_free(buffer);
    *buffer = (tf_buffer){data, bytes};
    return true;
}

bool tf_buffer_reserve(tf_buffer *buffer, size_t count, size_t size)
{
    if (!fits(count, size))
        return false;
    size_t bytes = count * size;
    return bytes <= buffer->bytes || grow(buffer, bytes, 0);
}

bool tf_buffer_extend(tf_buffer *buffer, size_t count, size_t size)
{
    if (!fits(count, size))
        return false;
    size_t bytes = count * size, twice = 2 * buffer->bytes;
    return bytes <= buffer->bytes ||
           grow(buffer, bytes > twice ? bytes : twice, buffer->bytes);
}

void tf_buffer_free(tf_buffer *buffer)
{
    tf_release(buffer->data, buffer->bytes);
    *buffer = (tf_buffer){0};
}
