//: Choose how a short edge collapses
#include "remesh/remesher.h"

#include "remesh/crease.h"
#include "remesh/measure.h"
#include "surgery/collapse.h"
#include "surgery/star.h"

/// A collapse: which vertex goes, which stays, and where.
typedef struct collapsing {
    int from, to;
    tf_vector place;
} collapsing;

/// Whether a vertex may go along the edge of a corner there.
static bool may_go(const tf_adaptive_surface *surface, int corner,
                   tf_freedom freedom)
{
    return freedom == TF_FREE ||
           (freedom == TF_ALONG_CREASE && tf_is_crease(surface, corner));
}

/// Two free vertices meet in the middle, and else the freer one goes to the
/// other.  False if neither may go.
static bool choose_collapse(tf_remesher *remesher, int corner,
                            collapsing *chosen)
{
    int a = tf_vertex_at(remesher->surface, corner);
    int b = tf_vertex_at(remesher->surface, tf_corner_after(corner));
    tf_freedom of_a = tf_freedom_of(remesher->surface, a);
    tf_freedom of_b = tf_freedom_of(remesher->surface, b);
    bool swap = of_b > of_a;
    chosen->from = swap ? b : a;
    chosen->to = swap ? a : b;
    chosen->place = tf_position_of(remesher->surface, chosen->to);
    if (of_a == TF_FREE && of_b == TF_FREE)
        chosen->place = tf_remesher_project(
            remesher, tf_middle_of(remesher->surface, a, b));
    return may_go(remesher->surface, corner, swap ? of_b : of_a);
}

//: Find out whether a collapse is wanted
bool tf_edges_stay_short(const tf_adaptive_surface *surface, int vertex,
                         int other, tf_vector place, double most)
{
    int c = tf_first_corner(surface, vertex);
    for (; c != TF_NONE; c = tf_next_corner(surface, c))
        for (int i = 1; i < 3; i++) {
            int end = tf_vertex_at(surface, c / 3 * 3 + (c + i) % 3);
            tf_vector way =
                tf_vector_difference(tf_position_of(surface, end), place);
            if (end != other && tf_vector_length(way) > most)
                return false;
        }
    return true;
}

static bool is_wanted(const tf_remesher *remesher, const collapsing *chosen)
{
    int from = chosen->from, to = chosen->to;
    double most = remesher->edge * 4 / 3;
    return tf_edges_stay_short(remesher->surface, from, to, chosen->place,
                               most) &&
           tf_edges_stay_short(remesher->surface, to, from, chosen->place,
                               most) &&
           tf_star_stays_good(remesher, from, to, chosen->place) &&
           tf_star_stays_good(remesher, to, from, chosen->place);
}

//: Collapse a short edge
static tf_status collapse_edge(tf_remesher *remesher, const tf_edge_row *edge)
{
    int corner = tf_find_edge(remesher->surface, edge->a, edge->b);
    collapsing chosen;
    if (corner == TF_NONE ||
        tf_length_of(remesher->surface, edge->a, edge->b) > edge->length ||
        !choose_collapse(remesher, corner, &chosen) ||
        !is_wanted(remesher, &chosen))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = tf_adaptive_collapse_to(
        remesher->surface, chosen.from, chosen.to, chosen.place.x, &outcome);
    if (status == TF_OK)
        tf_remesher_count(remesher, TF_COLLAPSE, outcome);
    return status;
}

//: Collapse all short edges
tf_status tf_collapse_pass(tf_remesher *remesher)
{
    if (!tf_remesher_list(remesher, 0, remesher->edge * 4 / 5))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = remesher->row.data;
    tf_status status = TF_OK;
    for (int i = 0; i < remesher->rows && status == TF_OK; i++)
        status = collapse_edge(remesher, &row[i]);
    return status;
}
