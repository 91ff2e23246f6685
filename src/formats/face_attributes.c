//: Keep what faces have
#include "formats/face_attributes.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

bool tf_face_attributes_agree(const tf_face_attributes *faces, int face,
                              int other)
{
    const tf_columns *row = &faces->row;
    return row->count == 0 ||
           memcmp(tf_columns_row(row, face), tf_columns_row(row, other),
                  (size_t)row->count * sizeof(double)) == 0;
}

bool tf_excerpts_add(tf_excerpts *list, const tf_excerpt *excerpt)
{
    if (list->count == list->room) {
        size_t room = 2 * list->room + 16;
        tf_excerpt *moved = room > SIZE_MAX / sizeof *moved
                                ? NULL
                                : realloc(list->item, room * sizeof *moved);
        if (!moved)
            return false;
        list->item = moved;
        list->room = room;
    }
    list->item[list->count++] = *excerpt;
    return true;
}

void tf_face_attributes_free(tf_face_attributes *faces)
{
    free(faces->library.item);
    free(faces->heading.item);
    tf_columns_free(&faces->row);
    tf_columns_free(&faces->texture);
    free(faces->corner.item);
    *faces = (tf_face_attributes){0};
}
