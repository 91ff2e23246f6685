//: Sort the vertices of an element
#include "surface/elements.h"

#include <string.h>

void tf_element_sort(int corners, int corner[])
{
    for (int i = 1; i < corners; i++)
        for (int j = i; j > 0 && corner[j] < corner[j - 1]; j--) {
            int swap = corner[j];
            corner[j] = corner[j - 1];
            corner[j - 1] = swap;
        }
}

//: Sort elements by one of their vertices
/// Moves the elements to another list, sorted by the vertex at one place, those
/// with the same vertex in their order.
static void sort_by_vertex(int corners, int count, const int *from, int *to,
                           int at, int vertices, int *place)
{
    memset(place, 0, sizeof *place * ((size_t)vertices + 1));
    for (int i = 0; i < count; i++)
        place[from[(size_t)i * (size_t)corners + (size_t)at] + 1]++;
    for (int v = 0; v < vertices; v++)
        place[v + 1] += place[v];
    size_t size = sizeof *from * (size_t)corners;
    for (int i = 0; i < count; i++) {
        const int *element = from + (size_t)i * (size_t)corners;
        int slot = place[element[at]]++;
        memcpy(to + (size_t)slot * (size_t)corners, element, size);
    }
}

//: Drop what is listed twice
static int drop_repetitions(int corners, int count, int *corner)
{
    size_t size = sizeof *corner * (size_t)corners;
    int kept = 0;
    for (int i = 0; i < count; i++) {
        int *next = corner + (size_t)kept * (size_t)corners;
        int *own = corner + (size_t)i * (size_t)corners;
        if (kept > 0 && memcmp(next - corners, own, size) == 0)
            continue;
        memmove(next, own, size);
        kept++;
    }
    return kept;
}

//: Sort a list of elements
bool tf_elements_sort(tf_elements *list, int count, int vertices,
                      tf_sort_workspace *workspace)
{
    size_t corners = (size_t)list->corners;
    if (!tf_buffer_reserve(&workspace->other, (size_t)count * corners + 1,
                           sizeof *list->corner) ||
        !tf_buffer_reserve(&workspace->place, (size_t)vertices + 1,
                           sizeof(int)))
        return false;
    int *from = list->storage.data, *to = workspace->other.data;
    for (int at = list->corners - 1; at >= 0; at--) {
        sort_by_vertex(list->corners, count, from, to, at, vertices,
                       workspace->place.data);
        int *swap = from;
        from = to;
        to = swap;
    }
    list->count = drop_repetitions(list->corners, count, from);
    memmove(list->storage.data, from,
            (size_t)list->count * corners * sizeof *from);
    list->corner = list->storage.data;
    return true;
}

void tf_sort_workspace_free(tf_sort_workspace *workspace)
{
    tf_buffer_free(&workspace->other);
    tf_buffer_free(&workspace->place);
}
