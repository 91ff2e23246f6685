//: Begin a search for parts
#include "topology/component.h"

#include <string.h>

bool tf_parts_begin(tf_parts *parts, const tf_adaptive_surface *surface)
{
    size_t count = (size_t)surface->triangles;
    parts->count = 0;
    if (!tf_buffer_extend(&parts->listed, count, sizeof(bool)) ||
        !tf_buffer_extend(&parts->list, count, sizeof(int)))
        return false;
    if (count > 0)
        memset(parts->listed.data, false, count * sizeof(bool));
    return true;
}

void tf_parts_free(tf_parts *parts)
{
    tf_buffer_free(&parts->listed);
    tf_buffer_free(&parts->list);
}

//: Add a part
static void list_triangle(tf_parts *parts, int triangle)
{
    bool *listed = (bool *)parts->listed.data + triangle;
    if (*listed)
        return;
    *listed = true;
    ((int *)parts->list.data)[parts->count++] = triangle;
}

static void list_star(tf_parts *parts, const tf_adaptive_surface *surface,
                      int vertex)
{
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        list_triangle(parts, c / 3);
}

int tf_parts_add(tf_parts *parts, const tf_adaptive_surface *surface,
                 int triangle)
{
    int first = parts->count;
    list_triangle(parts, triangle);
    for (int i = first; i < parts->count; i++) {
        const int *vertex = tf_triangle(surface, tf_parts_list(parts)[i]);
        for (int k = 0; k < 3; k++)
            list_star(parts, surface, vertex[k]);
    }
    return parts->count - first;
}
