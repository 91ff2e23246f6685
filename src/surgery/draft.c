//: Copy what a surface holds
#include "surgery/draft.h"

#include "surgery/star.h"
#include "surgery/surgery.h"

#include <string.h>

static bool copy_items(tf_buffer *to, const tf_buffer *from, int count,
                       size_t size, tf_watch *watch)
{
    if (count > 0)
        memcpy(to->data, from->data, size * (size_t)count);
    return tf_watch_done(watch, 0);
}

/// False if the caller cancels.
static bool copy_surface(tf_adaptive_surface *to,
                         const tf_adaptive_surface *from, tf_watch *watch)
{
    int vertices = from->vertices, triangles = from->triangles;
    size_t point = 3 * sizeof(double), corners = 3 * sizeof(int);
    to->vertices = vertices;
    to->triangles = triangles;
    to->free_triangle = from->free_triangle;
    to->scale = from->scale;
    to->marked = from->marked;
    tf_dynamic_tree_copy(&to->tree, &from->tree, triangles);
    return copy_items(&to->position, &from->position, vertices, point, watch) &&
           copy_items(&to->first, &from->first, vertices, sizeof(int), watch) &&
           copy_items(&to->frozen, &from->frozen, from->marked, sizeof(bool),
                      watch) &&
           copy_items(&to->vertex, &from->vertex, triangles, corners, watch) &&
           copy_items(&to->next, &from->next, triangles, corners, watch);
}

//: Begin a draft
tf_status tf_draft_begin(tf_adaptive_surface *draft,
                         const tf_adaptive_surface *surface, tf_watch *watch)
{
    draft->watch = watch;
    if (!tf_adaptive_reserve(draft, surface->vertices, surface->triangles, 0) ||
        !tf_buffer_extend(&draft->frozen, (size_t)surface->marked,
                          sizeof(bool)))
        return TF_OUT_OF_MEMORY;
    return copy_surface(draft, surface, watch) ? TF_OK : TF_CANCELLED;
}

//: Accept a draft
void tf_draft_accept(tf_adaptive_surface *draft, tf_adaptive_surface *surface)
{
    tf_adaptive_surface before = *surface;
    *surface = *draft;
    surface->lent = before.lent;
    surface->lent.has_origins = false;
    surface->watch = NULL;
    before.lent = draft->lent;
    *draft = before;
}

//: Free a draft
void tf_draft_free(tf_adaptive_surface *draft)
{
    tf_buffer_free(&draft->position);
    tf_buffer_free(&draft->vertex);
    tf_buffer_free(&draft->first);
    tf_buffer_free(&draft->next);
    tf_buffer_free(&draft->frozen);
    tf_buffer_free(&draft->found);
    tf_buffer_free(&draft->box);
    tf_dynamic_tree_free(&draft->tree);
    tf_surgery_free(&draft->surgery);
    tf_buffer_free(&draft->lent.mesh);
    tf_buffer_free(&draft->lent.remesh_report);
    tf_buffer_free(&draft->lent.reconnect_report);
    tf_buffer_free(&draft->lent.origin);
    tf_buffer_free(&draft->lent.corner_origin);
    tf_buffer_free(&draft->lent.defects);
    tf_buffer_free(&draft->lent.defect);
}
