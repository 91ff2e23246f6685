// What the figures of surfaces print.
#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "bench/layers.h"
#include "fast/detect.h"
#include "intersect/signs.h"
#include "kit/meshes.h"
#include "kit/random.h"
#include "query/edge_edge.h"
#include "query/point_triangle.h"
#include "surface/join.h"
#include "threads/threads.h"

// Boxes -----------------------------------------------------------------------

enum {
    CURVE = 1600
};

/// From where to where an edge of the curve may be, by axis: it moves on by its
/// own length.
static void find_box(int edge, double box[2][2])
{
    for (int v = edge; v <= edge + 2; v++) {
        double s = 2 * PI * v / CURVE, x[2] = {sin(3 * s), sin(4 * s + 0.4)};
        for (int k = 0; k < 2; k++) {
            box[k][0] = v == edge ? x[k] : fmin(box[k][0], x[k]);
            box[k][1] = v == edge ? x[k] : fmax(box[k][1], x[k]);
        }
    }
}

/// How far two boxes overlap on an axis.
static double overlap(double a[2], double b[2])
{
    return fmin(a[1] - b[0], b[1] - a[0]);
}

static void candidates_of_the_tree_are_those_of_all_pairs(void)
{
    static double box[CURVE][2][2];
    // What overlaps by less than this may be found or not.
    const double rounding = 1e-6;
    int sure = 0, possible = 0;
    for (int i = 0; i < CURVE; i++) {
        find_box(i, box[i]);
        // Not the edge before, nor the last of all with the first.
        for (int j = i == CURVE - 1; j < i - 1; j++) {
            double least = fmin(overlap(box[i][0], box[j][0]),
                                overlap(box[i][1], box[j][1]));
            sure += least > rounding;
            possible += least > -rounding;
        }
    }
    ck_assert_double_ge(number("candidates"), sure);
    ck_assert_double_le(number("candidates"), possible);
}

enum {
    STAR = 48
};

/// Counts the pairs of a join.
typedef struct counting_sink {
    tf_pair_sink sink; ///< first, so that a sink is its counter
    int count;
} counting_sink;

static bool count_batch(tf_pair_sink *sink, int count,
                        const tf_candidate pair[])
{
    (void)pair;
    ((counting_sink *)sink)->count += count;
    return true;
}

/// The pairs that a tree of the star's edges finds.
static int join_star(const double start[], const double end[], bool swept)
{
    static tf_path path[STAR];
    static counting_sink all;
    int corner[2 * STAR], bad;
    const tf_motion motion = {2, STAR, start, end};
    tf_frame frame;
    for (int i = 0; i < 2 * STAR; i++)
        corner[i] = (i + 1) / 2 % STAR;
    ck_assert_int_eq(tf_frame_of(2, &motion, NULL, &frame, &bad), TF_OK);
    if (swept)
        tf_frame_sweep(&frame);
    tf_vertex_paths(&frame, &motion, NULL, path);
    const tf_tree_elements elements = {.count = STAR,
                                       .corners = 2,
                                       .corner = corner,
                                       .vertex = path,
                                       .whole = &frame.whole,
                                       .swept = swept};
    tf_tree tree = {0};
    tf_tree_workspace workspace = {0};
    ck_assert(tf_tree_build(&tree, &elements, &workspace, NULL));
    all.count = 0;
    all.sink.take = count_batch;
    tf_tree_join(&tree, &tree, (tf_range){0, tree.packs[0]}, &all.sink);
    tf_tree_workspace_free(&workspace);
    tf_tree_free(&tree);
    return all.count;
}

static void trees_find_the_pairs_of_the_star(void)
{
    double x[2][2 * STAR];
    for (int end = 0; end < 2; end++)
        for (int i = 0; i < STAR; i++) {
            double turn = 2 * PI * i / STAR;
            double radius = 0.3 + 0.09 * cos(5 * turn + 0.5 * end);
            x[end][2 * i] = radius * cos(turn) + 0.62 * end;
            x[end][2 * i + 1] = radius * sin(turn) + 0.55 * end;
        }
    ck_assert_double_eq(number("pairs"), STAR * (STAR - 3) / 2);
    ck_assert_double_eq(number("swept"), join_star(x[0], x[1], true));
    ck_assert_double_eq(number("both"), join_star(x[0], x[1], false));
}

enum {
    TRIANGLES = 64,
    SIZES = 13
};

/// Points of each against the other, and the edges of both.
static int count_candidates(const tf_worldline a[3], const tf_worldline b[3])
{
    int count = 0;
    for (int i = 0; i < 3; i++) {
        const tf_worldline first[2] = {a[i], a[(i + 1) % 3]};
        count += !boxes_apart(3, 1, &a[i], 3, b);
        count += !boxes_apart(3, 3, a, 1, &b[i]);
        for (int j = 0; j < 3; j++) {
            const tf_worldline second[2] = {b[j], b[(j + 1) % 3]};
            count += !boxes_apart(3, 2, first, 2, second);
        }
    }
    return count;
}

/// Triangles at rest, as the figure makes them.
static void make_crowd(double size, tf_worldline corner[TRIANGLES][3])
{
    uint64_t random = 13;
    for (int i = 0; i < TRIANGLES; i++) {
        double x[3][3];
        for (int k = 0; k < 3; k++) {
            double low = (1 - size) * fig_random_number(&random);
            for (int c = 0; c < 3; c++)
                x[c][k] = low + size * fig_random_number(&random);
        }
        for (int c = 0; c < 3; c++)
            corner[i][c] = tf_worldline_between(3, x[c], x[c]);
    }
}

static void candidates_of_the_crowd_are_those_of_all_pairs(void)
{
    tf_worldline corner[TRIANGLES][3];
    for (int size = 0; size < SIZES; size++) {
        int count = 0;
        make_crowd(pow(10, -1.5 + 0.125 * size), corner);
        for (int i = 0; i < TRIANGLES; i++)
            for (int j = 0; j < i; j++)
                count += count_candidates(corner[i], corner[j]);
        expect(count, "%d_%d", TRIANGLES, size);
    }
}

// Queries that are decided early ----------------------------------------------

/// Whether on some axis all of the first element is before, or beyond, all of
/// the second, at both times.
static bool separated(int first, const tf_worldline vertex[4])
{
    for (int k = 0; k < 3; k++) {
        bool below = true, above = true;
        for (int t = 0; t < 2; t++)
            for (int a = 0; a < first; a++)
                for (int b = first; b < 4; b++) {
                    double x = vertex[a].at[t].x[k], y = vertex[b].at[t].x[k];
                    below &= x < y;
                    above &= x > y;
                }
        if (below || above)
            return true;
    }
    return false;
}

/// The share of queries that an axis separates, in percent, of those that the
/// figure makes.
static double percent_separated(int first, double size)
{
    enum {
        QUERIES = 32768
    };
    uint64_t random = 15;
    int count = 0;
    for (int i = 0; i < QUERIES; i++) {
        double corner[3], way[4][6];
        tf_worldline v[4];
        for (int k = 0; k < 3; k++)
            corner[k] = (1 - size) * fig_random_number(&random);
        for (int j = 0; j < 12; j++) {
            double *x = &way[j / 3][j % 3];
            x[0] = corner[j % 3] + size * fig_random_number(&random);
            x[3] = x[0] + 0.2 * fig_random_number(&random) - 0.1;
        }
        make_vertices(3, 4, *way, v);
        count += separated(first, v);
    }
    return 100.0 * count / QUERIES;
}

static void shares_are_those_of_separated_queries(void)
{
    expect(percent_separated(1, 1), "pt_soup_1");
    expect(percent_separated(2, 1), "ee_soup_1");
    expect(percent_separated(1, 0.1), "pt_near_1");
    expect(percent_separated(2, 0.1), "ee_near_1");
}

/// Whether signs other than zero decide the query: all six of some pair are the
/// same, or every pair has two that are opposite.
static bool decided(int first, const tf_worldline vertex[4])
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    int second = 4 - first;
    bool conflict = true;
    tf_sweep(first, vertex, s);
    tf_sweep(second, vertex + first, r);
    for (int i = 0; i < first * second; i++) {
        tf_pair pair = tf_pair_of(&s[i / second], &r[i % second], 3);
        int positive = 0, negative = 0;
        for (int e = 0; e < pair.count; e++) {
            tf_differences d;
            tf_pair_differences(&pair, e, &d);
            int sign = tf_exact.sign(&d) * tf_pair_orientation(&pair, e);
            positive += sign > 0;
            negative += sign < 0;
        }
        if (positive == pair.count || negative == pair.count)
            return true;
        conflict &= positive > 0 && negative > 0;
    }
    return conflict;
}

/// Determinants of such small integers have no errors.
static double percent_on_lattice(int first)
{
    enum {
        QUERIES = 1 << 14
    };
    uint64_t random = 15;
    int count = 0;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline v[4];
        double x[2][4][3];
        for (int j = 0; j < 24; j++)
            x[j / 12][j / 3 % 4][j % 3] = floor(4 * fig_random_number(&random));
        for (int j = 0; j < 4; j++)
            v[j] = tf_worldline_between(3, x[0][j], x[1][j]);
        count += !separated(first, v) && !decided(first, v);
    }
    return 100.0 * count / QUERIES;
}

static void zeros_are_undecided(void)
{
    expect(percent_on_lattice(1), "pt_lattice");
    expect(percent_on_lattice(2), "ee_lattice");
}

// Contacts --------------------------------------------------------------------

enum {
    ROWS = 18,
    COLUMNS = 36,
    PLACES = (ROWS + 1) * (COLUMNS + 1)
};

/// The step of a sheet, tried with all pairs of its elements.
typedef struct trial {
    tf_motion motion;
    tf_worldline way[PLACES];
    int hits, by_then;
    double then, toi;
} trial;

/// A point and a triangle, or two edges.
static void try_pair(trial *tried, int first, const int a[], const int b[])
{
    tf_worldline v[4];
    tf_contact contact;
    for (int i = 0; i < 4; i++)
        v[i] = tried->way[i < first ? a[i] : b[i - first]];
    for (int i = 0; i < first; i++)
        for (int j = 0; j < 4 - first; j++)
            if (a[i] == b[j])
                return;
    if (boxes_apart(3, first, v, 4 - first, v + first))
        return;
    tf_status status =
        first == 1
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
    static bool known[PLACES][PLACES];
    int count = 0;
    for (int i = 0; i < 3 * mesh->triangles; i++) {
        int a = mesh->triangle[i];
        int b = mesh->triangle[i % 3 == 2 ? i - 2 : i + 1];
        int low = a < b ? a : b, high = a < b ? b : a;
        if (!known[low][high]) {
            edge[count][0] = low;
            edge[count++][1] = high;
        }
        known[low][high] = true;
    }
    return count;
}

static void contacts_of_the_sheet_are_those_of_all_pairs(void)
{
    static int edge[6 * ROWS * COLUMNS][2];
    static trial tried;
    fig_some_mesh mesh[2] = {fig_folded_sheet(ROWS, COLUMNS, 112),
                             fig_folded_sheet(ROWS, COLUMNS, 200)};
    int triangles = mesh->triangles;
    ck_assert_int_eq(mesh->vertices, PLACES);
    tried.motion = (tf_motion){3, PLACES, mesh[0].x, mesh[1].x};
    tried.then = number("time");
    tried.toi = 2;
    for (int v = 0; v < PLACES; v++)
        tried.way[v] = tf_worldline_between(3, mesh[0].x + 3 * (ptrdiff_t)v,
                                            mesh[1].x + 3 * (ptrdiff_t)v);
    for (int v = 0; v < PLACES; v++)
        for (int i = 0; i < triangles; i++)
            try_pair(&tried, 1, &v, mesh->triangle + 3 * (ptrdiff_t)i);
    expect(tried.hits, "point_triangle");
    int edges = list_edges(mesh, edge);
    for (int i = 0; i < edges; i++)
        for (int j = 0; j < i; j++)
            try_pair(&tried, 2, edge[j], edge[i]);
    expect(tried.hits, "contacts");
    expect(tried.by_then, "contacts_by_then");
    expect(tried.toi, "toi");
    ck_assert_double_ge(number("candidates"), tried.hits);
    for (int t = 0; t < 2; t++)
        fig_some_mesh_free(&mesh[t]);
}

/// The contacts of a step, lent until the surface is freed.
static tf_contacts detect(const tf_mesh *mesh, const tf_motion *motion,
                          const tf_detect_options *detection,
                          tf_surface **surface)
{
    tf_contacts found;
    ck_assert_int_eq(tf_surface_create(mesh, surface, NULL), TF_OK);
    ck_assert_int_eq(
        tf_surface_detect(*surface, motion, detection, &found, NULL), TF_OK);
    return found;
}

static void workers_find_the_contacts_of_three_threads(void)
{
    fig_some_mesh at[2] = {fig_folded_sheet(60, 120, 150),
                           fig_folded_sheet(60, 120, 183.35)};
    const tf_mesh mesh = fig_mesh_in_space(&at[0]);
    const tf_motion motion = {3, at[0].vertices, at[0].x, at[1].x};
    int points = 0;
    tf_threads *threads;
    ck_assert_int_eq(tf_threads_create(3, &threads), TF_OK);
    tf_detect_options on_three = {.parallel = tf_threads_parallel(threads)};
    tf_surface *surface;
    tf_contacts found = detect(&mesh, &motion, &on_three, &surface);
    for (size_t i = 0; i < found.count; i++)
        points += found.contact[i].kind == TF_POINT_TRIANGLE;
    expect_within(0, (double)found.count, "contacts");
    expect_within(0, points, "point_triangle");
    tf_surface_free(surface);
    tf_threads_free(threads);
    for (int t = 0; t < 2; t++)
        fig_some_mesh_free(&at[t]);
}

/// How many pairs of elements share no vertex, counted around each vertex.
static double count_pairs(const tf_mesh *mesh, const tf_surface *surface)
{
    int edges;
    const int *edge = tf_surface_edges(surface, &edges);
    int *degree = calloc((size_t)mesh->vertices, sizeof *degree);
    ck_assert_ptr_nonnull(degree);
    double pairs = (double)mesh->vertices * mesh->triangles -
                   3.0 * mesh->triangles + 0.5 * edges * (edges - 1.0);
    // An edge shares its vertex with the edges there that come before it.
    for (int i = 0; i < 2 * edges; i++)
        pairs -= degree[edge[i]]++;
    free(degree);
    return pairs;
}

static void crowded_layers_are_detected_again(void)
{
    layers cloth = layers_new(71, 1, 1);
    tf_surface *surface;
    tf_contacts found = detect(&cloth.mesh, &cloth.motion, NULL, &surface);
    expect(cloth.mesh.triangles, "crowded_triangles");
    expect(count_pairs(&cloth.mesh, surface), "crowded_pairs");
    expect((double)found.statistics.candidates, "crowded_candidates");
    expect((double)found.count, "crowded_contacts");
    tf_surface_free(surface);
    layers_free(&cloth);
}

static const double strip[5][6] = {{0, 0, 0, 0, -1, 0},
                                   {4, 0, 0, 4, 1, 0},
                                   {2, 4, 0, 2, 4, 0},
                                   {2, -4, 0, 2, -4, 0},
                                   {2, 0.25, 1.5, 2, 0.25, -1.5}};

/// When the particle meets a triangle that is swept in this order.
static double time_of_particle(int a, int b, int c)
{
    tf_worldline v[5];
    make_vertices(3, 5, *strip, v);
    return oracle_time(3, 1, &v[4], 3, (tf_worldline[]){v[a], v[b], v[c]});
}

static void a_private_order_opens_a_crack(void)
{
    double first = time_of_particle(0, 1, 2),
           second = time_of_particle(0, 1, 3);
    expect((first >= 0) + (time_of_particle(1, 0, 3) >= 0), "private_hits");
    expect((first >= 0) + (second >= 0), "shared_hits");
    expect(fmax(first, second), "toi");
}

// The order of the leaves -----------------------------------------------------

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

/// The cell of the grid of 1024 that the middle of three corners is in.
static void find_cell(const tf_path *corner[3], const tf_box *whole,
                      unsigned cell[3])
{
    for (int k = 0; k < 3; k++) {
        float extent = 3 * (whole->high[k] - whole->low[k]);
        float sum = corner[0]->at[k] + corner[1]->at[k] + corner[2]->at[k];
        float along = (sum - 3 * whole->low[k]) * (1024 / extent);
        cell[k] = extent > 0 ? (unsigned)along : 0;
    }
}

static placed *order_of(const fig_some_mesh *mesh)
{
    const tf_motion rest = {3, mesh->vertices, mesh->x, mesh->x};
    tf_path *path = malloc((size_t)mesh->vertices * sizeof *path);
    placed *order = malloc((size_t)mesh->triangles * sizeof *order);
    tf_frame frame;
    int bad;
    ck_assert_int_eq(tf_frame_of(3, &rest, NULL, &frame, &bad), TF_OK);
    tf_vertex_paths(&frame, &rest, NULL, path);
    for (int i = 0; i < mesh->triangles; i++) {
        const int *v = mesh->triangle + 3 * (size_t)i;
        const tf_path *corner[] = {&path[v[0]], &path[v[1]], &path[v[2]]};
        order[i].triangle = i;
        find_cell(corner, &frame.whole, order[i].cell);
    }
    qsort(order, (size_t)mesh->triangles, sizeof *order, compare_placed);
    free(path);
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

static void expect_curve(const char *name, double height)
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
    expect(mesh.triangles, "%s_triangles", name);
    expect(leaves, "%s_leaves", name);
    expect(ceil(log(leaves) / log(LEAF)) + 1, "%s_levels", name);
    expect(length, "%s_length", name);
    expect(longest, "%s_longest", name);
    free(order);
    fig_some_mesh_free(&mesh);
}

static void leaves_are_along_the_morton_curve(void)
{
    expect_curve("disc", 0);
    expect_curve("saddle", 0.42);
}

const figure_test surfaces_tests[] = {
    {&fig_box_tree, candidates_of_the_tree_are_those_of_all_pairs},
    {&fig_bulk_motion, trees_find_the_pairs_of_the_star},
    {&fig_candidate_counts, candidates_of_the_crowd_are_those_of_all_pairs},
    {&fig_early_outs, shares_are_those_of_separated_queries},
    {&fig_folding_sheet, contacts_of_the_sheet_are_those_of_all_pairs},
    {&fig_contact_order, workers_find_the_contacts_of_three_threads},
    {&fig_pairs_to_contacts, crowded_layers_are_detected_again},
    {&fig_morton_curve, leaves_are_along_the_morton_curve},
    {&fig_crack_at_neighbors, a_private_order_opens_a_crack},
    {&fig_undecided_queries, zeros_are_undecided},
    {NULL, NULL}};
