//: Include what sources need
#include "formats/source.h"

#include <stdint.h>
#include <stdlib.h>

//: Add to a source
/// Makes room for one more in a list; NULL: there is no memory.
static void *grown(void *list, size_t count, size_t *room, size_t size)
{
    if (count < *room)
        return list;
    size_t more = 2 * *room + 64;
    void *moved = more > SIZE_MAX / size ? NULL : realloc(list, more * size);
    if (moved)
        *room = more;
    return moved;
}

bool tf_source_add(tf_source *source, const tf_source_point *point)
{
    tf_source_point *list =
        grown(source->point, source->points, &source->room, sizeof *list);
    if (!list)
        return false;
    source->point = list;
    list[source->points++] = *point;
    return true;
}

bool tf_source_add_part(tf_source *source, const tf_source_part *part)
{
    tf_source_part *list =
        grown(source->part, source->parts, &source->part_room, sizeof *list);
    if (!list)
        return false;
    source->part = list;
    list[source->parts++] = *part;
    return true;
}

//: Free a source
void tf_source_free(tf_source *source)
{
    free(source->text);
    free(source->point);
    free(source->part);
    *source = (tf_source){0};
}
