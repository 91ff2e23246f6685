//: Find the piece of a vertex
#include "topology/pieces.h"

#include "topology/facing.h"

enum {
    BESIDE = -2 ///< a vertex that is only a neighbor of one that is marked
};

int tf_piece_of(tf_reconnector *reconnector, int vertex)
{
    int *piece = reconnector->piece.data;
    while (piece[vertex] != vertex)
        vertex = piece[vertex] = piece[piece[vertex]];
    return vertex;
}

void tf_unite_pieces(tf_reconnector *reconnector, int a, int b)
{
    ((int *)reconnector->piece.data)[tf_piece_of(reconnector, a)] =
        tf_piece_of(reconnector, b);
}

//: Mark what is in contact
static void mark_contacts(tf_reconnector *reconnector)
{
    int *piece = reconnector->piece.data;
    const tf_facing_edges *pair = reconnector->candidate.data;
    for (int v = 0; v < reconnector->surface->vertices; v++)
        piece[v] = TF_NONE;
    for (int i = 0; i < reconnector->candidates; i++)
        for (int k = 0; k < 2; k++) {
            piece[pair[i].first[k]] = pair[i].first[k];
            piece[pair[i].second[k]] = pair[i].second[k];
        }
}

//: Mark what is beside
static void mark_neighbors(tf_reconnector *reconnector)
{
    int *piece = reconnector->piece.data;
    for (int t = 0; t < reconnector->surface->triangles; t++) {
        const int *v = tf_triangle(reconnector->surface, t);
        if (!tf_is_triangle(reconnector->surface, t) ||
            (piece[v[0]] < 0 && piece[v[1]] < 0 && piece[v[2]] < 0))
            continue;
        for (int i = 0; i < 3; i++)
            if (piece[v[i]] == TF_NONE)
                piece[v[i]] = BESIDE;
    }
    for (int v = 0; v < reconnector->surface->vertices; v++)
        if (piece[v] == BESIDE)
            piece[v] = v;
}

//: Connect the pieces
static void connect_neighbors(tf_reconnector *reconnector)
{
    const int *piece = reconnector->piece.data;
    const tf_adaptive_surface *surface = reconnector->surface;
    for (int c = 0; c < 3 * surface->triangles; c++) {
        if (c % 4096 == 0 && !tf_watch_done(surface->watch, 0))
            return;
        if (!tf_is_triangle(surface, c / 3))
            continue;
        int a = tf_vertex_at(surface, c);
        int b = tf_vertex_at(surface, tf_corner_after(c));
        if (piece[a] != TF_NONE && piece[b] != TF_NONE)
            tf_unite_pieces(reconnector, a, b);
    }
}

tf_status tf_find_pieces(tf_reconnector *reconnector)
{
    if (!tf_buffer_extend(&reconnector->piece,
                          (size_t)reconnector->surface->vertices, sizeof(int)))
        return TF_OUT_OF_MEMORY;
    tf_watch *watch = reconnector->surface->watch;
    mark_contacts(reconnector);
    if (tf_watch_done(watch, 0))
        mark_neighbors(reconnector);
    if (tf_watch_done(watch, 0))
        connect_neighbors(reconnector);
    return tf_watch_done(watch, 0) ? TF_OK : TF_CANCELLED;
}
