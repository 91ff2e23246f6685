//: Choose how a short edge collapses
#include "remesh/remesher.h"

#include "remesh/crease.h"
#include "remesh/measure.h"
#include "surgery/operations.h"
#include "surgery/star.h"

/// A collapse: which vertex goes, which stays, and where.
typedef struct collapsing {
    int from, to;
    tf_vector place;
} collapsing;

/// Whether a vertex may go along the edge of a corner there.
static bool may_go(const tf_adaptive *of, int corner, tf_freedom freedom)
{
    return freedom == TF_FREE ||
           (freedom == TF_ALONG_CREASE && tf_is_crease(of, corner));
}

/// Two free vertices meet in the middle, and else the freer one goes to the
/// other.  False if neither may go.
static bool choose_collapse(tf_remesher *of, int corner, collapsing *chosen)
{
    int a = tf_vertex_at(of->of, corner);
    int b = tf_vertex_at(of->of, tf_corner_after(corner));
    tf_freedom of_a = tf_freedom_of(of->of, a);
    tf_freedom of_b = tf_freedom_of(of->of, b);
    bool swap = of_b > of_a;
    chosen->from = swap ? b : a;
    chosen->to = swap ? a : b;
    chosen->place = tf_position_of(of->of, chosen->to);
    if (of_a == TF_FREE && of_b == TF_FREE)
        chosen->place = tf_remesher_project(of, tf_middle_of(of->of, a, b));
    return may_go(of->of, corner, swap ? of_b : of_a);
}

//: Find out whether a collapse is wanted
bool tf_edges_stay_short(const tf_adaptive *of, int vertex, int other,
                         tf_vector place, double most)
{
    int c = tf_first_corner(of, vertex);
    for (; c != TF_NONE; c = tf_next_corner(of, c))
        for (int i = 1; i < 3; i++) {
            int end = tf_vertex_at(of, c / 3 * 3 + (c + i) % 3);
            tf_vector way =
                tf_vector_difference(tf_position_of(of, end), place);
            if (end != other && tf_vector_length(way) > most)
                return false;
        }
    return true;
}

static bool is_wanted(const tf_remesher *of, const collapsing *chosen)
{
    int from = chosen->from, to = chosen->to;
    double most = of->edge * 4 / 3;
    return tf_edges_stay_short(of->of, from, to, chosen->place, most) &&
           tf_edges_stay_short(of->of, to, from, chosen->place, most) &&
           tf_star_stays_good(of, from, to, chosen->place) &&
           tf_star_stays_good(of, to, from, chosen->place);
}

//: Collapse a short edge
static tf_status collapse_edge(tf_remesher *of, const tf_edge_row *edge)
{
    int corner = tf_find_edge(of->of, edge->a, edge->b);
    collapsing chosen;
    if (corner == TF_NONE ||
        tf_length_of(of->of, edge->a, edge->b) > edge->length ||
        !choose_collapse(of, corner, &chosen) || !is_wanted(of, &chosen))
        return TF_OK;
    tf_outcome outcome;
    tf_status status = tf_adaptive_collapse_to(of->of, chosen.from, chosen.to,
                                               chosen.place.x, &outcome);
    if (status == TF_OK)
        tf_remesher_count(of, TF_COLLAPSE, outcome);
    return status;
}

//: Collapse all short edges
tf_status tf_collapse_pass(tf_remesher *of)
{
    if (!tf_remesher_list(of, 0, of->edge * 4 / 5))
        return TF_OUT_OF_MEMORY;
    const tf_edge_row *row = of->row.data;
    tf_status status = TF_OK;
    for (int i = 0; i < of->rows && status == TF_OK; i++)
        status = collapse_edge(of, &row[i]);
    return status;
}
