//: Keep the memory of a reconnection
#include "topology/reconnector.h"

#include "remesh/measure.h"

void tf_reconnector_free(tf_reconnector *reconnector)
{
    tf_buffer_free(&reconnector->candidate);
    tf_buffer_free(&reconnector->normal);
    tf_buffer_free(&reconnector->piece);
    tf_components_free(&reconnector->components);
    tf_sort_memory_free(&reconnector->sorting);
}

size_t tf_reconnector_memory(const tf_reconnector *reconnector)
{
    return reconnector->candidate.bytes + reconnector->normal.bytes +
           reconnector->piece.bytes + reconnector->components.listed.bytes +
           reconnector->components.list.bytes +
           tf_sort_memory_bytes(&reconnector->sorting);
}

//: Count reconnections
void tf_reconnector_count(tf_reconnector *reconnector, tf_reconnection what,
                          tf_outcome outcome, double gained)
{
    reconnector->report.tried[what][outcome]++;
    if (outcome == TF_COMMITTED)
        reconnector->report.gained[what] += gained;
}

//: Sort candidates
tf_status tf_reconnector_sort(tf_reconnector *reconnector, size_t size,
                              tf_precedes *precedes)
{
    tf_watch *watch = reconnector->surface->watch;
    bool sorted =
        tf_list_sort(&reconnector->candidate, (size_t)reconnector->candidates,
                     size, precedes, &reconnector->sorting, watch);
    return sorted ? TF_OK : tf_watch_failure(watch);
}

//: Measure volumes
double tf_volume_below(const tf_adaptive_surface *surface, int triangle,
                       tf_vector point)
{
    tf_vector side[3];
    for (int i = 0; i < 3; i++)
        side[i] = tf_vector_difference(
            tf_position_of(surface, tf_triangle(surface, triangle)[i]), point);
    return tf_vector_dot(side[0], tf_vector_cross(side[1], side[2])) / 6;
}

/// Whether a triangle has one of some vertices.
static bool has_any(const tf_adaptive_surface *surface, int triangle, int count,
                    const int vertex[])
{
    const int *v = tf_triangle(surface, triangle);
    for (int i = 0; i < count; i++)
        if (v[0] == vertex[i] || v[1] == vertex[i] || v[2] == vertex[i])
            return true;
    return false;
}

double tf_volume_at(const tf_adaptive_surface *surface, int count,
                    const int vertex[])
{
    tf_vector point = tf_position_of(surface, vertex[0]);
    double sum = 0;
    for (int i = 0; i < count; i++) {
        int c = tf_first_corner(surface, vertex[i]);
        for (; c != TF_NONE; c = tf_next_corner(surface, c))
            if (!has_any(surface, c / 3, i, vertex)) // it is not counted yet
                sum += tf_volume_below(surface, c / 3, point);
    }
    return sum;
}
