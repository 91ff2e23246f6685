#include "figures/numbers.h"

#include "kit/meshes.h"
#include "surface/box.h"

enum {
    RINGS = 18,
    LEAF = 16
};

/// A triangle with its place along the curve, bit by bit.
typedef struct placed {
    unsigned cell[3];
    int triangle;
} placed;

static int compare_placed(const void *a, const void *b)
{
    const placed *p = a, *q = b;
    for (int bit = 9; bit >= 0; bit--)
        for (int k = 2; k >= 0; k--) {
            int first = p->cell[k] >> bit & 1, second = q->cell[k] >> bit & 1;
            if (first != second)
                return first - second;
        }
    return p->triangle - q->triangle;
}

/// The cell of the grid of 1024 that the middle of a box is in.
static void find_cell(const tf_box *box, const tf_box *whole, unsigned cell[3])
{
    for (int k = 0; k < 3; k++) {
        float extent = whole->high[k] - whole->low[k];
        float twice =
            (box->low[k] - whole->low[k]) + (box->high[k] - whole->low[k]);
        cell[k] = extent > 0 ? (unsigned)(twice / (2 * extent) * 1024) : 0;
    }
}

static placed *order_of(const fig_some_mesh *mesh)
{
    const tf_motion rest = {mesh->vertices, mesh->x, mesh->x};
    tf_box *box = malloc((size_t)mesh->vertices * sizeof *box);
    placed *order = malloc((size_t)mesh->triangles * sizeof *order);
    tf_box whole = tf_box_empty;
    tf_frame frame;
    int bad;
    ck_assert_int_eq(tf_frame_of(3, &rest, NULL, &frame, &bad), TF_OK);
    tf_vertex_boxes(&frame, &rest, NULL, box);
    for (int v = 0; v < mesh->vertices; v++)
        whole = tf_box_union(whole, box[v]);
    for (int i = 0; i < mesh->triangles; i++) {
        const int *v = mesh->triangle + 3 * (size_t)i;
        tf_box own =
            tf_box_union(tf_box_union(box[v[0]], box[v[1]]), box[v[2]]);
        order[i].triangle = i;
        find_cell(&own, &whole, order[i].cell);
    }
    qsort(order, (size_t)mesh->triangles, sizeof *order, compare_placed);
    free(box);
    return order;
}

/// The mean of the corners of some triangles.
static tf_vector center_of(const fig_some_mesh *mesh, int count,
                           const placed order[])
{
    tf_vector sum = {{0}};
    for (int i = 0; i < 3 * count; i++) {
        int vertex = mesh->triangle[3 * order[i / 3].triangle + i % 3];
        sum = fig_sum(sum, fig_vector_of(mesh->x + 3 * (size_t)vertex));
    }
    return tf_vector_scaled(1.0 / (3 * count), sum);
}

static void expect_curve(const char *text, const char *name, double height)
{
    fig_some_mesh mesh = fig_disc(RINGS, height);
    placed *order = order_of(&mesh);
    double length = 0, longest = 0;
    int leaves = 0;
    tf_vector last = {{0}};
    for (int i = 0; i < mesh.triangles; i += LEAF, leaves++) {
        int count = mesh.triangles - i < LEAF ? mesh.triangles - i : LEAF;
        tf_vector center = center_of(&mesh, count, order + i);
        double step = i > 0 ? fig_length(fig_difference(center, last)) : 0;
        length += step;
        longest = fmax(longest, step);
        last = center;
    }
    char key[64];
    snprintf(key, sizeof key, "%s_triangles", name);
    expect_number(text, key, mesh.triangles);
    snprintf(key, sizeof key, "%s_leaves", name);
    expect_number(text, key, leaves);
    snprintf(key, sizeof key, "%s_levels", name);
    expect_number(text, key, ceil(log(leaves) / log(LEAF)) + 1);
    snprintf(key, sizeof key, "%s_length", name);
    expect_number(text, key, length);
    snprintf(key, sizeof key, "%s_longest", name);
    expect_number(text, key, longest);
    free(order);
    fig_some_mesh_free(&mesh);
}

START_TEST(leaves_are_along_the_morton_curve)
{
    char *text = printed(&fig_morton_curve);
    expect_curve(text, "disc", 0);
    expect_curve(text, "saddle", 0.42);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/morton_curve", leaves_are_along_the_morton_curve);
}
