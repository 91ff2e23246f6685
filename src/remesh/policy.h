//: Declare what a policy chooses
#pragma once

#include "remesh/measure.h"
#include "remesh/remesher.h"
#include "remesh/sharp_edges.h"

/// A fraction of the target length.
typedef struct tf_fraction {
    int numerator, denominator;
} tf_fraction;

static inline double tf_fraction_of(double length, tf_fraction part)
{
    return length * part.numerator / part.denominator;
}

/// The two triangles on an edge ab, and the two on the other diagonal, cd.
typedef struct tf_diagonals {
    int corner;    ///< of the edge, at a
    int vertex[4]; ///< a, b, c and d
    tf_shape own[2], other[2];
} tf_diagonals;

//: Declare volume errors
/// The volume that an operation loses, times 6, and the vertices that can
/// restore it.
typedef struct tf_volume_error {
    double lost;
    int count; ///< of these vertices; 0: nothing is to be restored
    int vertex[4];
} tf_volume_error;

//: Declare policies
enum {
    TF_REMESH_PASSES = 4 ///< of a round: one for each operation
};

/// How to remesh: a constant that is passed by its address.  Its functions only
/// choose, in rounded arithmetic, but for `restore`, which moves vertices; what
/// is safe is decided by exact tests.
struct tf_remesh_policy {
    tf_fraction longest;  ///< edges of at least this length are split
    tf_fraction shortest; ///< edges of at most this length collapse
    struct {
        tf_operation operation;
        int most; ///< how often; a pass is repeated until it does nothing
    } pass[TF_REMESH_PASSES]; ///< of a round

    /// Where the edge of a corner is split: at first, and after so many
    /// positions were refused.  False: nowhere.
    bool (*choose_split)(tf_remesher *remesher, int corner, int refused,
                         tf_vector *position, tf_volume_error *error);

    /// How the edge of a corner collapses.  False: not at all.
    bool (*choose_collapse)(tf_remesher *remesher, int corner,
                            tf_edge_collapse *collapse);

    /// Whether an edge is flipped.
    bool (*choose_flip)(tf_remesher *remesher, const tf_diagonals *diagonals,
                        tf_volume_error *error);

    /// Where a vertex is moved.  False: nowhere.
    bool (*choose_move)(tf_remesher *remesher, int vertex, tf_vector *position);

    /// Restores what a split or a flip has lost; NULL: nothing does.
    tf_status (*restore)(tf_remesher *remesher, const tf_volume_error *error);
};
