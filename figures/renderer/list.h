// Lists that grow.
#ifndef FIG_RENDERER_LIST_H
#define FIG_RENDERER_LIST_H

#include <stdbool.h>
#include <stddef.h>

/// `items` points to the pointer to the list's items of `size` bytes each.
/// Make room for `more` after the `count` that there are.  False if there is
/// no memory; the list is as before then.
bool fig_list_room(void *items, int count, int more, int *capacity,
                   size_t size);

/// The same for many at once: no more room than that.
bool fig_list_more(void *items, int count, int more, int *capacity,
                   size_t size);

/// A copy of `count` items of `size` bytes; NULL if there is no memory.
void *fig_list_copy(const void *items, int count, size_t size);

#endif
