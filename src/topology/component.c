//: Begin a search for components
#include "topology/component.h"

#include <string.h>

bool tf_components_begin(tf_components *components,
                         const tf_adaptive_surface *surface)
{
    size_t count = (size_t)surface->triangles;
    components->count = 0;
    if (!tf_buffer_extend(&components->listed, count, sizeof(bool)) ||
        !tf_buffer_extend(&components->list, count, sizeof(int)))
        return false;
    if (count > 0)
        memset(components->listed.data, false, count * sizeof(bool));
    return true;
}

void tf_components_free(tf_components *components)
{
    tf_buffer_free(&components->listed);
    tf_buffer_free(&components->list);
}

//: Add a component
static void list_triangle(tf_components *components, int triangle)
{
    bool *listed = (bool *)components->listed.data + triangle;
    if (*listed)
        return;
    *listed = true;
    ((int *)components->list.data)[components->count++] = triangle;
}

static void list_star(tf_components *components,
                      const tf_adaptive_surface *surface, int vertex)
{
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        list_triangle(components, c / 3);
}

int tf_components_add(tf_components *components,
                      const tf_adaptive_surface *surface, int triangle)
{
    int first = components->count;
    list_triangle(components, triangle);
    for (int i = first; i < components->count; i++) {
        if (i % 1024 == 1023 && !tf_watch_done(surface->watch, 0))
            break;
        const int *vertex =
            tf_triangle(surface, tf_components_list(components)[i]);
        for (int k = 0; k < 3; k++)
            list_star(components, surface, vertex[k]);
    }
    return components->count - first;
}
