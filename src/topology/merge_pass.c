//: Find out whether a merge is wanted
#include "topology/merge_pass.h"

#include "remesh/measure.h"
#include "surgery/star.h"
#include "topology/facing.h"
#include "topology/merge.h"
#include "topology/pieces.h"

/// Whether the triangle of the corner has two other sides that are long.
static bool has_long_sides(const tf_reconnector *reconnector, int corner)
{
    int a = tf_vertex_at(reconnector->surface, corner);
    int b = tf_vertex_at(reconnector->surface, tf_corner_after(corner));
    int c = tf_vertex_at(reconnector->surface, tf_corner_before(corner));
    return tf_length_of(reconnector->surface, b, c) >=
               reconnector->lengths.pinch &&
           tf_length_of(reconnector->surface, c, a) >=
               reconnector->lengths.pinch;
}

/// Whether the tube that would start there is not so thin that it would be
/// pinched next.
static bool starts_wide(const tf_reconnector *reconnector, const int edge[2])
{
    int forth = tf_find_edge(reconnector->surface, edge[0], edge[1]);
    int back = tf_find_edge(reconnector->surface, edge[1], edge[0]);
    return forth != TF_NONE && back != TF_NONE &&
           has_long_sides(reconnector, forth) &&
           has_long_sides(reconnector, back);
}

/// One merge is enough between two pieces: a second one would make a handle.
static bool is_merge_wanted(tf_reconnector *reconnector,
                            const tf_facing_edges *pair)
{
    return tf_piece_of(reconnector, pair->first[0]) !=
               tf_piece_of(reconnector, pair->second[0]) &&
           starts_wide(reconnector, pair->first) &&
           starts_wide(reconnector, pair->second);
}

//: Merge two pieces
static tf_status merge_pieces(tf_reconnector *reconnector,
                              const tf_facing_edges *pair)
{
    if (!is_merge_wanted(reconnector, pair))
        return TF_OK;
    const int ends[] = {pair->first[0], pair->first[1], pair->second[0],
                        pair->second[1]};
    double before = tf_volume_at(reconnector->surface, 4, ends);
    tf_outcome outcome;
    tf_status status = tf_adaptive_merge(reconnector->surface, pair->first,
                                         pair->second, &outcome);
    if (status != TF_OK)
        return status;
    tf_reconnector_count(reconnector, TF_MERGE, outcome,
                         tf_volume_at(reconnector->surface, 4, ends) - before);
    if (outcome == TF_COMMITTED)
        tf_unite_pieces(reconnector, pair->first[0], pair->second[0]);
    return TF_OK;
}

//: Merge what is in contact
tf_status tf_merge_pass(tf_reconnector *reconnector)
{
    tf_watch *watch = reconnector->surface->watch;
    tf_status status = tf_list_facing(reconnector, reconnector->lengths.patch);
    if (status == TF_OK)
        status = tf_find_pieces(reconnector);
    const tf_facing_edges *pair = reconnector->candidate.data;
    tf_watch_stage(watch, "merging", (size_t)reconnector->candidates);
    for (int i = 0; i < reconnector->candidates && status == TF_OK &&
                    pair[i].distance < reconnector->lengths.merge;
         i++)
        status = tf_watch_done(watch, 1) ? merge_pieces(reconnector, &pair[i])
                                         : TF_CANCELLED;
    return status;
}
