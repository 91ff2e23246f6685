#include "kit/curve_pieces.h"

#include "response/groups.h"

#include <stdlib.h>
#include <string.h>

/// Where an edge of one triangle passes through another triangle.
typedef struct passage {
    int triangle[2]; ///< the first one is before the second
    int crossing;
    tf_vector at;
} passage;

static tf_vector find_passage(const tf_vector at[], const int v[5])
{
    tf_vector c = at[v[2]];
    tf_vector normal =
        fig_cross(fig_difference(at[v[3]], c), fig_difference(at[v[4]], c));
    double a = tf_vector_dot(normal, fig_difference(at[v[0]], c));
    double b = tf_vector_dot(normal, fig_difference(at[v[1]], c));
    return fig_lerp(at[v[0]], at[v[1]], a / (a - b));
}

static int compare_passages(const void *a, const void *b)
{
    const passage *p = a, *q = b;
    for (int i = 0; i < 2; i++)
        if (p->triangle[i] != q->triangle[i])
            return p->triangle[i] < q->triangle[i] ? -1 : 1;
    return (p->crossing > q->crossing) - (p->crossing < q->crossing);
}

// Passages -------------------------------------------------------------------

/// A list that grows.
typedef struct passages {
    size_t count, room;
    passage *item;
} passages;

static bool add_passage(passages *all, const passage *own)
{
    if (all->count == all->room) {
        size_t room = 2 * all->room + 64;
        passage *moved = realloc(all->item, room * sizeof *moved);
        if (!moved)
            return false;
        all->item = moved;
        all->room = room;
    }
    all->item[all->count++] = *own;
    return true;
}

/// Add a passage for each triangle at the edge.
static bool add_passages(passages *all, const fig_facets *facets,
                         const tf_vector at[], const tf_crossings *found, int i)
{
    const int *v = found->crossing[i].vertex;
    int none = 0, step = 0, own;
    int through = fig_facets_next(facets, 3, v + 2, &none);
    tf_vector place = find_passage(at, v);
    while ((own = fig_facets_next(facets, 2, v, &step)) >= 0) {
        passage next = {
            {own < through ? own : through, own < through ? through : own},
            i,
            place};
        if (!add_passage(all, &next))
            return false;
    }
    return true;
}

static bool list_passages(passages *all, const fig_facets *facets,
                          const tf_vector at[], const tf_crossings *found)
{
    bool good = true;
    for (int i = 0; i < (int)found->count && good; i++)
        if (found->crossing[i].kind == TF_EDGE_THROUGH_TRIANGLE)
            good = add_passages(all, facets, at, found, i);
    if (good && all->count > 0)
        qsort(all->item, all->count, sizeof *all->item, compare_passages);
    return good;
}

// Pieces ---------------------------------------------------------------------

/// The vertex that two triangles share, if they share one; -1: they do not.
static int shared_vertex(const int a[3], const int b[3])
{
    for (int i = 0; i < 3; i++)
        if (b[0] == a[i] || b[1] == a[i] || b[2] == a[i])
            return a[i];
    return -1;
}

static bool is_of_same(const passage *a, const passage *b)
{
    return memcmp(a->triangle, b->triangle, sizeof a->triangle) == 0;
}

/// Two passages of the same two triangles are the ends of a piece; a single one
/// goes on to the vertex that they share.
static void join_passages(fig_curve_pieces *pieces, const passages *all,
                          const fig_facets *facets, const tf_vector at[],
                          int crossings)
{
    for (size_t i = 0; i < all->count; i++) {
        const passage *p = &all->item[i];
        const int *a = facets->vertex + (ptrdiff_t)3 * p->triangle[0];
        const int *b = facets->vertex + (ptrdiff_t)3 * p->triangle[1];
        int shared = shared_vertex(a, b);
        fig_curve_piece own = {{p->at}, {p->crossing}, {a[0], b[0]}};
        if (i + 1 < all->count && is_of_same(p, p + 1)) {
            own.at[1] = all->item[++i].at;
            own.end[1] = all->item[i].crossing;
        } else if (shared >= 0) {
            own.at[1] = at[shared];
            own.end[1] = crossings + shared;
        } else {
            continue;
        }
        pieces->piece[pieces->count++] = own;
    }
}

/// Count the groups of ends that pieces connect.
static bool count_curves(fig_curve_pieces *pieces, int ends)
{
    tf_groups groups = {0};
    bool *seen = calloc((size_t)ends + 1, sizeof *seen);
    bool good = seen && tf_groups_begin(&groups, ends);
    for (int i = 0; i < pieces->count && good; i++)
        tf_groups_unite(&groups, pieces->piece[i].end[0],
                        pieces->piece[i].end[1]);
    for (int i = 0; i < pieces->count && good; i++) {
        int root = tf_groups_find(&groups, pieces->piece[i].end[0]);
        pieces->curves += !seen[root];
        seen[root] = true;
    }
    tf_buffer_free(&groups.storage);
    free(seen);
    return good;
}

bool fig_curve_pieces_find(fig_curve_pieces *pieces, const fig_shape *shape,
                           const tf_vector at[], const tf_crossings *found)
{
    fig_facets facets;
    passages all = {0};
    int crossings = (int)found->count;
    *pieces = (fig_curve_pieces){0};
    bool good = fig_facets_find(&facets, shape) &&
                list_passages(&all, &facets, at, found);
    if (good)
        pieces->piece = calloc(all.count + 1, sizeof *pieces->piece);
    good = good && pieces->piece;
    if (good)
        join_passages(pieces, &all, &facets, at, crossings);
    free(all.item);
    fig_facets_free(&facets);
    return good && count_curves(pieces, crossings + shape->vertices);
}

void fig_curve_pieces_free(fig_curve_pieces *pieces)
{
    free(pieces->piece);
    *pieces = (fig_curve_pieces){0};
}

void fig_curve_pieces_draw(fig_scene *scene, const fig_curve_pieces *pieces,
                           double width)
{
    for (int i = 0; i < pieces->count; i++)
        fig_scene_tube(scene, pieces->piece[i].at[0], pieces->piece[i].at[1],
                       width, (fig_paint){.role = FIG_ROLE_CONTACT});
}
