#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "kit/meshes.h"
#include "query/edge_edge.h"
#include "query/point_triangle.h"

enum {
    ROWS = 18,
    COLUMNS = 36
};

/// The step of the sheet, tried with all pairs of its elements.
typedef struct trial {
    fig_some_mesh mesh[2];
    tf_motion motion;
    int hits, by_then;
    double then, toi;
} trial;

/// Whether the bounds of the places of two elements are apart.
static bool are_apart(const trial *tried, int count, const int a[], int others,
                      const int b[])
{
    for (int k = 0; k < 3; k++) {
        double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i < count + others; i++)
            for (int t = 0; t < 2; t++) {
                int side = i >= count;
                int vertex = side ? b[i - count] : a[i];
                double x = tried->mesh[t].x[3 * vertex + k];
                lo[side] = fmin(lo[side], x);
                hi[side] = fmax(hi[side], x);
            }
        if (lo[0] > hi[1] || lo[1] > hi[0])
            return true;
    }
    return false;
}

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

static void try_pair(trial *tried, int count, const int a[], int others,
                     const int b[])
{
    if (share(count, a, others, b) || are_apart(tried, count, a, others, b))
        return;
    tf_contact contact;
    tf_status status =
        count == 1
            ? tf_point_triangle(&tf_exact, &tried->motion, *a, b, &contact)
            : tf_edge_edge(&tf_exact, &tried->motion, a, b, &contact);
    ck_assert_int_eq(status, TF_OK);
    if (contact.verdict != TF_HIT)
        return;
    double toi = (contact.toi_lo + contact.toi_hi) / 2;
    tried->hits++;
    tried->by_then += toi <= tried->then;
    tried->toi = fmin(tried->toi, toi);
}

/// The edges of a mesh, each once.
static int list_edges(const fig_some_mesh *mesh, int edge[][2])
{
    int count = 0;
    for (int i = 0; i < 3 * mesh->triangles; i++) {
        int a = mesh->triangle[i];
        int b = mesh->triangle[i % 3 == 2 ? i - 2 : i + 1];
        const int two[2] = {a < b ? a : b, a < b ? b : a};
        bool known = false;
        for (int j = 0; j < count && !known; j++)
            known = edge[j][0] == two[0] && edge[j][1] == two[1];
        if (!known)
            memcpy(edge[count++], two, sizeof two);
    }
    return count;
}

START_TEST(contacts_are_those_of_all_pairs)
{
    static int edge[6 * ROWS * COLUMNS][2];
    char *text = printed(&fig_folding_sheet);
    trial tried = {.mesh = {fig_folded_sheet(ROWS, COLUMNS, 112),
                            fig_folded_sheet(ROWS, COLUMNS, 200)},
                   .then = number_of(text, "time"),
                   .toi = 2};
    const fig_some_mesh *mesh = &tried.mesh[0];
    tried.motion = (tf_motion){mesh->vertices, mesh->x, tried.mesh[1].x};
    for (int v = 0; v < mesh->vertices; v++)
        for (int i = 0; i < mesh->triangles; i++)
            try_pair(&tried, 1, &v, 3, mesh->triangle + 3 * (size_t)i);
    expect_number(text, "point_triangle", tried.hits);
    int edges = list_edges(mesh, edge);
    for (int i = 0; i < edges; i++)
        for (int j = 0; j < i; j++)
            try_pair(&tried, 2, edge[j], 2, edge[i]);
    expect_number(text, "contacts", tried.hits);
    expect_number(text, "contacts_by_then", tried.by_then);
    expect_number(text, "toi", tried.toi);
    expect_number(text, "triangles", 2 * ROWS * COLUMNS);
    ck_assert_double_ge(number_of(text, "candidates"), tried.hits);
    for (int t = 0; t < 2; t++)
        fig_some_mesh_free(&tried.mesh[t]);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/folding_sheet", contacts_are_those_of_all_pairs);
}
