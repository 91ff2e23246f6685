//: Include what sources need
#include "formats/source.h"

#include <stdint.h>
#include <stdlib.h>

//: Add a point to a source
static bool make_point_room(tf_source *source)
{
    if (source->points < source->room)
        return true;
    size_t room = 2 * source->room + 64, size = sizeof *source->point;
    tf_source_point *moved =
        room > SIZE_MAX / size ? NULL : realloc(source->point, room * size);
    if (!moved)
        return false;
    source->point = moved;
    source->room = room;
    return true;
}

bool tf_source_add(tf_source *source, const tf_source_point *point)
{
    if (!make_point_room(source))
        return false;
    source->point[source->points++] = *point;
    return true;
}

//: Free a source
void tf_source_free(tf_source *source)
{
    free(source->text);
    free(source->point);
    *source = (tf_source){0};
}
