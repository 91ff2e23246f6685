//: Include what near pairs as contacts need
#include "distance/near_contacts.h"

#include "base/fail.h"
#include "distance/near_search.h"
#include "distance/nearest.h"
#include "geometry/vector.h"
#include "query/shape.h"

#include <string.h>

enum {
    ROW_WORK = 64 ///< units of work that a row takes
};

//: Make a contact of a near pair
/// The vector between the nearest points, from the second element's to the
/// first's, scaled to length 1.
static void set_normal(const tf_query_shape *shape, const double *const x[],
                       tf_contact *contact)
{
    tf_vector between = {{0}};
    int both = shape->vertices + shape->others;
    for (int i = 1; i < both; i++)
        for (int k = 0; k < shape->axes; k++)
            between.x[k] +=
                (x[i][k] - x[0][k]) *
                (i < shape->vertices
                     ? contact->barycentric[0][i]
                     : -contact->barycentric[1][i - shape->vertices]);
    double length = tf_vector_length(between);
    if (!(length > 0) || !isfinite(length))
        return;
    for (int k = 0; k < TF_AXES; k++)
        contact->normal[k] = between.x[k] / length;
}

static void set_row(const tf_motion *motion, const tf_near_pair *pair,
                    tf_surface_contact *row)
{
    const tf_query_shape *shape = tf_query_shape_of(pair->kind);
    const double *x[4] = {NULL};
    for (int i = 0; i < shape->vertices + shape->others; i++)
        x[i] = motion->end + (ptrdiff_t)shape->axes * pair->vertex[i];
    tf_nearest nearest = tf_nearest_of(pair->kind, x);
    memset(row, 0, sizeof *row);
    row->kind = pair->kind;
    memcpy(row->vertex, pair->vertex, sizeof row->vertex);
    row->contact.verdict = TF_APART;
    row->contact.toi_lo = row->contact.toi_hi = 1;
    memcpy(row->contact.barycentric, nearest.barycentric,
           sizeof nearest.barycentric);
    set_normal(shape, x, &row->contact);
}

//: List near pairs as contacts
static tf_status list_rows(tf_thickness *thickness, const tf_motion *motion,
                           const tf_near_pairs *near, tf_watch *watch)
{
    if (!tf_buffer_reserve(&thickness->row, near->count + 1,
                           sizeof(tf_surface_contact)))
        return TF_OUT_OF_MEMORY;
    tf_surface_contact *row = thickness->row.data;
    for (size_t i = 0; i < near->count; i++) {
        if (!tf_watch_work(watch, ROW_WORK))
            return TF_CANCELLED;
        set_row(motion, &near->pair[i], &row[i]);
    }
    return TF_OK;
}

tf_status tf_near_contacts_find(tf_thickness *thickness, tf_surface *surface,
                                const tf_motion *motion,
                                const tf_parallel *parallel, tf_contacts *found,
                                tf_error *error)
{
    tf_near_search search = {.surface = surface,
                             .vertices = motion->vertices,
                             .position = motion->end,
                             .before = motion->start,
                             .length = thickness->length,
                             .parallel = parallel};
    tf_near_pairs near;
    tf_status status = tf_near_search_run(&search, &near, error);
    if (status == TF_OK)
        status = tf_fail(
            error, list_rows(thickness, motion, &near, surface->workers.watch));
    if (status != TF_OK)
        return status;
    found->any = near.count > 0;
    found->count = near.count;
    found->contact = thickness->row.data;
    return TF_OK;
}

//: Count the pairs that start near
tf_status tf_near_contacts_count_start(const tf_thickness *thickness,
                                       tf_surface *surface,
                                       const tf_motion *motion,
                                       const tf_parallel *parallel,
                                       size_t *count, tf_error *error)
{
    tf_near_search search = {.surface = surface,
                             .vertices = motion->vertices,
                             .position = motion->start,
                             .length = thickness->length,
                             .parallel = parallel};
    tf_near_pairs near;
    tf_status status = tf_near_search_run(&search, &near, error);
    if (status == TF_OK)
        *count = near.count;
    return status;
}
