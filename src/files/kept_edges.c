//: Read kept edges
#include "files/kept_edges.h"

#include "files/masses.h"
#include "files/text_lines.h"

#include <stdlib.h>

/// Makes room for one edge more; the room is a power of two.
static bool extend(tf_kept_edges *kept)
{
    size_t count = (size_t)kept->count;
    if (count & (count - 1))
        return true;
    size_t room = count ? 2 * count : 1;
    int *more = realloc(kept->vertex, 2 * room * sizeof *more);
    if (more)
        kept->vertex = more;
    return more;
}

static bool read_line(tf_kept_edges *kept, tf_text *text, int vertices)
{
    if (!extend(kept))
        return tf_text_fault(text, "there is no memory");
    int *vertex = kept->vertex + 2 * (size_t)kept->count;
    if (!tf_vertex_read(text, vertices, &vertex[0]))
        return false;
    vertex[1] = vertex[0];
    tf_text_skip_blanks(text);
    if (!tf_ends_word(*text->at, "#") &&
        !tf_vertex_read(text, vertices, &vertex[1]))
        return false;
    tf_text_skip_blanks(text);
    kept->count++;
    return tf_ends_word(*text->at, "#") ||
           tf_text_fault(text, "more than two vertices; write an edge a line");
}

bool tf_kept_edges_read(tf_kept_edges *kept, const char *path, int vertices,
                        tf_fault *fault)
{
    tf_text_lines lines;
    tf_reading reading = tf_text_lines_open(&lines, path, fault)
                             ? tf_text_lines_next(&lines)
                             : TF_READ_FAULT;
    while (reading == TF_READ_GOOD)
        reading = read_line(kept, &lines.text, vertices)
                      ? tf_text_lines_next(&lines)
                      : TF_READ_FAULT;
    tf_text_lines_close(&lines);
    return reading == TF_READ_END;
}

bool tf_kept_edges_add(tf_kept_edges *kept, int from, int to)
{
    if (!extend(kept))
        return false;
    int *vertex = kept->vertex + 2 * (size_t)kept->count++;
    vertex[0] = from;
    vertex[1] = to;
    return true;
}

void tf_kept_edges_free(tf_kept_edges *kept)
{
    free(kept->vertex);
    *kept = (tf_kept_edges){0};
}
