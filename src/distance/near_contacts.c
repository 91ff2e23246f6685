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
            between.x[k] += (x[i][k] - x[0][k]) *
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

//: Merge near pairs and contacts
/// The sign of the order of a contact and a near pair in lists.
static int order_of(const tf_surface_contact *contact, const tf_near_pair *pair)
{
    if (contact->kind != pair->kind)
        return contact->kind < pair->kind ? -1 : 1;
    for (int i = 0; i < 4; i++)
        if (contact->vertex[i] != pair->vertex[i])
            return contact->vertex[i] < pair->vertex[i] ? -1 : 1;
    return 0;
}

/// A pair that is in contact has a row already.  Returns how many rows there are.
static size_t merge_rows(const tf_thickness *thickness, const tf_motion *motion,
                         size_t contacts, const tf_near_pairs *near,
                         tf_watch *watch)
{
    const tf_surface_contact *contact = thickness->contact.data;
    tf_surface_contact *row = thickness->row.data;
    size_t rows = 0, i = 0, j = 0;
    while (i < contacts || j < near->count) {
        int order = i == contacts      ? 1
                    : j == near->count ? -1
                                       : order_of(&contact[i], &near->pair[j]);
        if (!tf_watch_work(watch, order > 0 ? ROW_WORK : 1))
            return 0;
        if (order > 0)
            set_row(motion, &near->pair[j], &row[rows++]);
        else
            row[rows++] = contact[i];
        i += order <= 0;
        j += order >= 0;
    }
    return rows;
}

//: Add near pairs to contacts
static tf_status add_rows(tf_thickness *thickness, const tf_motion *motion,
                          const tf_near_pairs *near, tf_contacts *contacts,
                          tf_watch *watch)
{
    if (!tf_buffer_reserve(&thickness->row, contacts->count + near->count + 1,
                           sizeof(tf_surface_contact)))
        return TF_OUT_OF_MEMORY;
    size_t rows =
        merge_rows(thickness, motion, contacts->count, near, watch);
    if (tf_watch_cancelled(watch))
        return TF_CANCELLED;
    thickness->near = rows - contacts->count;
    contacts->contact = thickness->row.data;
    contacts->count = rows;
    contacts->any = rows > 0;
    return TF_OK;
}

tf_status tf_near_contacts_add(tf_thickness *thickness, tf_surface *surface,
                               const tf_motion *motion,
                               const tf_parallel *parallel,
                               tf_contacts *contacts, tf_error *error)
{
    tf_near_search search = {.surface = surface,
                             .vertices = motion->vertices,
                             .position = motion->end,
                             .before = motion->start,
                             .length = thickness->length,
                             .parallel = parallel};
    tf_near_pairs near;
    // The search overwrites what the surface has lent.
    if (!tf_buffer_reserve(&thickness->contact, contacts->count + 1,
                           sizeof(tf_surface_contact)))
        return tf_fail(error, TF_OUT_OF_MEMORY);
    memcpy(thickness->contact.data, contacts->contact,
           contacts->count * sizeof(tf_surface_contact));
    tf_status status = tf_near_search_run(&search, &near, error);
    if (status != TF_OK)
        return status;
    return tf_fail(error, add_rows(thickness, motion, &near, contacts,
                                   surface->workers.watch));
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

//: Account for the memory of thickness
size_t tf_thickness_memory(const tf_thickness *thickness)
{
    return thickness->row.bytes + thickness->contact.bytes;
}

void tf_thickness_free(tf_thickness *thickness)
{
    tf_buffer_free(&thickness->row);
    tf_buffer_free(&thickness->contact);
}
