//: Include what gathering needs
#include "fast/gather.h"

#include "base/always_inline.h"
#include "base/prefetch.h"
#include "base/simd.h"

#include <stddef.h>
#include <string.h>

//: Prefetch the vertices of a query
enum {
    QUERIES_AHEAD = 48,   // enough for memory to answer
    NEAR_VERTICES = 20000 // a megabyte: about what the second cache holds
};

TF_ALWAYS_INLINE void prefetch_vertices(const tf_motion *motion,
                                        const int vertex[4])
{
    for (int v = 0; v < 4; v++) {
        if (vertex[v] < 0 || vertex[v] >= motion->vertices)
            return;
        ptrdiff_t place = (ptrdiff_t)3 * vertex[v];
        tf_prefetch(motion->start + place);
        tf_prefetch(motion->end + place);
    }
}

/// Requests those of a query that comes later, unless all vertices are near: the
/// lines in which they begin, as most also end there.
TF_ALWAYS_INLINE void prefetch_later(const tf_queries *queries, size_t i)
{
    if (queries->motion->vertices > NEAR_VERTICES &&
        queries->count - i > QUERIES_AHEAD)
        prefetch_vertices(queries->motion,
                          queries->vertices + 4 * (i + QUERIES_AHEAD));
}

//: Shuffle numbers
#if defined __GNUC__ && defined __has_builtin
#if __has_builtin(__builtin_shufflevector)
#define TF_SHUFFLES
#endif
#endif

enum {
    FOUR = 4
};

#ifdef TF_SHUFFLES
#define SHUFFLE(...) __builtin_shufflevector(__VA_ARGS__)
typedef double four_doubles
    __attribute__((vector_size(32), aligned(8), may_alias));
typedef int four_ints __attribute__((vector_size(16)));
typedef unsigned four_unsigned __attribute__((vector_size(16)));
#endif

//: Check the vertices of queries
/// Whether all indices are below `vertices`, and those of each query differ.
TF_ALWAYS_INLINE bool vertices_are_good(size_t count, const int vertex[],
                                        unsigned vertices)
{
#ifdef TF_SHUFFLES
    four_ints bad = {0};
    for (size_t i = 0; i < count; i++) {
        four_ints own;
        memcpy(&own, vertex + 4 * i, sizeof own);
        bad |= own == SHUFFLE(own, own, 1, 2, 3, 0);
        bad |= own == SHUFFLE(own, own, 2, 3, 0, 1);
        // As unsigned numbers, negative ones are too large.
        bad |= (four_unsigned)own >= vertices;
    }
    return !(bad[0] | bad[1] | bad[2] | bad[3]);
#else
    bool bad = false;
    for (size_t i = 0; i < 4 * count; i++) {
        const int *own = vertex + i / 4 * 4;
        bad |= (unsigned)vertex[i] >= vertices;
        bad |= vertex[i] == own[(i + 1) % 4] || vertex[i] == own[(i + 2) % 4];
    }
    return !bad;
#endif
}

//: Sort the vertices of a query
TF_ALWAYS_INLINE void sort_two(int *a, int *b)
{
    int low = *a < *b ? *a : *b, high = *a < *b ? *b : *a;
    *a = low;
    *b = high;
}

/// Puts those of each element in order.
TF_ALWAYS_INLINE void sort_vertices(tf_kind kind, int vertex[4])
{
    if (kind == TF_EDGE_EDGE) {
        sort_two(&vertex[0], &vertex[1]);
        sort_two(&vertex[2], &vertex[3]);
    } else {
        sort_two(&vertex[1], &vertex[2]);
        sort_two(&vertex[2], &vertex[3]);
        sort_two(&vertex[1], &vertex[2]);
    }
}

//: Take the vertices of queries
/// The vertices of some queries, in order, side by side as in a block.
typedef struct corners {
    int vertex[4][TF_MASK_QUERIES];
} corners;

/// Fills the last block with copies of the last query.
TF_ALWAYS_INLINE void take_vertices(const tf_queries *queries, size_t begin,
                                    size_t end, corners *taken)
{
    for (size_t lane = 0; lane % TF_BLOCK_QUERIES != 0 || begin + lane < end;
         lane++) {
        size_t i = begin + lane < end ? begin + lane : end - 1;
        int own[4];
        prefetch_later(queries, i);
        memcpy(own, queries->vertices + 4 * i, sizeof own);
        sort_vertices(queries->kind, own);
        for (int v = 0; v < 4; v++)
            taken->vertex[v][lane] = own[v];
    }
}

//: Turn the coordinates of four vertices
/// Writes x, y and z of four vertices side by side.  May read the number behind
/// each.
TF_ALWAYS_INLINE void turn(const double *const x[FOUR],
                           double row[3][TF_BLOCK_QUERIES])
{
#ifdef TF_SHUFFLES
    four_doubles a = *(const four_doubles *)x[0];
    four_doubles b = *(const four_doubles *)x[1];
    four_doubles c = *(const four_doubles *)x[2];
    four_doubles d = *(const four_doubles *)x[3];
    four_doubles xz_ab = SHUFFLE(a, b, 0, 4, 2, 6);
    four_doubles xz_cd = SHUFFLE(c, d, 0, 4, 2, 6);
    four_doubles y_ab = SHUFFLE(a, b, 1, 5, 3, 7);
    four_doubles y_cd = SHUFFLE(c, d, 1, 5, 3, 7);
    *(four_doubles *)row[0] = SHUFFLE(xz_ab, xz_cd, 0, 1, 4, 5);
    *(four_doubles *)row[1] = SHUFFLE(y_ab, y_cd, 0, 1, 4, 5);
    *(four_doubles *)row[2] = SHUFFLE(xz_ab, xz_cd, 2, 3, 6, 7);
#else
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < FOUR; i++)
            row[k][i] = x[i][k];
#endif
}

//: Gather the coordinates of four vertices
/// The positions of all vertices at one time; those of the last one are there
/// again with a number behind them.
typedef struct positions {
    const double *x;
    int last;
    double of_last[FOUR];
} positions;

TF_ALWAYS_INLINE positions positions_of(const double x[], int vertices)
{
    positions all = {.x = x, .last = vertices - 1};
    memcpy(all.of_last, x + (ptrdiff_t)3 * all.last, 3 * sizeof *x);
    return all;
}

TF_ALWAYS_INLINE void gather_four(const positions *all, const int vertex[FOUR],
                                  double row[3][TF_BLOCK_QUERIES])
{
    const double *x[FOUR];
    for (int i = 0; i < FOUR; i++)
        x[i] = vertex[i] == all->last ? all->of_last
                                      : all->x + (ptrdiff_t)3 * vertex[i];
    turn(x, row);
}

//: Gather queries
/// The rows of a vertex in a block, from one of its lanes on.
TF_ALWAYS_INLINE double (*from_lane(double row[3][TF_BLOCK_QUERIES],
                                    int lane))[TF_BLOCK_QUERIES]
{
    return (double(*)[TF_BLOCK_QUERIES])(row[0] + lane);
}

TF_SIMD_256 static bool gather(const tf_queries *queries, size_t begin,
                               size_t end, tf_query_block block[])
{
    const tf_motion *motion = queries->motion;
    if (motion->vertices < 0 ||
        !vertices_are_good(end - begin, queries->vertices + 4 * begin,
                           (unsigned)motion->vertices))
        return false;
    corners taken;
    take_vertices(queries, begin, end, &taken);
    positions start = positions_of(motion->start, motion->vertices);
    positions last = positions_of(motion->end, motion->vertices);
    for (size_t i = 0; i < end - begin; i += TF_BLOCK_QUERIES, block++)
        for (int v = 0; v < 4; v++)
            for (int lane = 0; lane < TF_BLOCK_QUERIES; lane += FOUR) {
                const int *vertex = taken.vertex[v] + i + lane;
                gather_four(&start, vertex, from_lane(block->at[0][v], lane));
                gather_four(&last, vertex, from_lane(block->at[1][v], lane));
            }
    return true;
}

bool tf_gather(const tf_queries *queries, size_t begin, size_t end,
               tf_query_block block[])
{
    return gather(queries, begin, end, block);
}
