//: Find the piece of a vertex
#include "topology/reconnector.h"

enum {
    BESIDE = -2 ///< a vertex that is only a neighbor of one that is marked
};

int tf_piece_of(tf_reconnector *of, int vertex)
{
    int *piece = of->piece.data;
    while (piece[vertex] != vertex)
        vertex = piece[vertex] = piece[piece[vertex]];
    return vertex;
}

void tf_unite_pieces(tf_reconnector *of, int a, int b)
{
    ((int *)of->piece.data)[tf_piece_of(of, a)] = tf_piece_of(of, b);
}

//: Mark what is in contact
static void mark_contacts(tf_reconnector *of)
{
    int *piece = of->piece.data;
    const tf_facing *row = of->row.data;
    for (int v = 0; v < of->of->vertices; v++)
        piece[v] = TF_NONE;
    for (int i = 0; i < of->rows; i++)
        for (int k = 0; k < 2; k++) {
            piece[row[i].first[k]] = row[i].first[k];
            piece[row[i].second[k]] = row[i].second[k];
        }
}

//: Mark what is beside
static void mark_neighbors(tf_reconnector *of)
{
    int *piece = of->piece.data;
    for (int t = 0; t < of->of->triangles; t++) {
        const int *v = tf_triangle(of->of, t);
        if (!tf_is_triangle(of->of, t) ||
            (piece[v[0]] < 0 && piece[v[1]] < 0 && piece[v[2]] < 0))
            continue;
        for (int i = 0; i < 3; i++)
            if (piece[v[i]] == TF_NONE)
                piece[v[i]] = BESIDE;
    }
    for (int v = 0; v < of->of->vertices; v++)
        if (piece[v] == BESIDE)
            piece[v] = v;
}

//: Connect the pieces
static void connect_neighbors(tf_reconnector *of)
{
    const int *piece = of->piece.data;
    for (int c = 0; c < 3 * of->of->triangles; c++) {
        if (!tf_is_triangle(of->of, c / 3))
            continue;
        int a = tf_vertex_at(of->of, c);
        int b = tf_vertex_at(of->of, tf_corner_after(c));
        if (piece[a] != TF_NONE && piece[b] != TF_NONE)
            tf_unite_pieces(of, a, b);
    }
}

bool tf_find_pieces(tf_reconnector *of)
{
    if (!tf_buffer_extend(&of->piece, (size_t)of->of->vertices, sizeof(int)))
        return false;
    mark_contacts(of);
    mark_neighbors(of);
    connect_neighbors(of);
    return true;
}
