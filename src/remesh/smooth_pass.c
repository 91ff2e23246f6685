//: Find the middle of a star
#include "remesh/remesher.h"

#include "remesh/crease.h"
#include "remesh/measure.h"
#include "surgery/move.h"
#include "surgery/star.h"

tf_vector tf_star_middle(const tf_adaptive_surface *surface, int vertex)
{
    tf_vector sum = {{0}};
    double total = 0;
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        double area = tf_vector_length(tf_shape_normal(&shape));
        for (int i = 0; i < 3; i++)
            sum = tf_vector_sum(sum, area / 3, shape.corner[i]);
        total += area;
    }
    return tf_vector_scaled(1 / total, sum);
}

//: Smooth a vertex
bool tf_is_worth_a_move(const tf_remesher *remesher, int vertex,
                        tf_vector place)
{
    tf_vector way =
        tf_vector_difference(place, tf_position_of(remesher->surface, vertex));
    return tf_vector_length(way) > remesher->edge / 20;
}

static tf_status smooth_vertex(tf_remesher *remesher, int vertex)
{
    tf_vector place = tf_star_middle(remesher->surface, vertex);
    place = tf_remesher_project(remesher, place);
    if (!tf_is_worth_a_move(remesher, vertex, place) ||
        !tf_star_stays_good(remesher, vertex, TF_NONE, place))
        return TF_OK;
    tf_outcome outcome;
    tf_status status =
        tf_adaptive_move(remesher->surface, vertex, place.x, &outcome);
    if (status == TF_OK)
        tf_remesher_count(remesher, TF_SMOOTH, outcome);
    return status;
}

//: Smooth all vertices
tf_status tf_smooth_pass(tf_remesher *remesher)
{
    tf_status status = TF_OK;
    for (int v = 0; v < remesher->surface->vertices && status == TF_OK; v++)
        if (tf_first_corner(remesher->surface, v) != TF_NONE &&
            tf_freedom_of(remesher->surface, v) == TF_FREE)
            status = smooth_vertex(remesher, v);
    return status;
}
