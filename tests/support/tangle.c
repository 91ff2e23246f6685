#include "support/tangle.h"

#include "support/memory.h"
#include "support/oracle.h"

#include <gmp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Signs -----------------------------------------------------------------------

/// The rows point[i] - point[n], i < n, on n axes.
typedef double differences[3][3];

/// Whether no product of three of them leaves the normal doubles: each is zero,
/// or a multiple of 2^-352.
static bool are_moderate(int n, differences d)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            if (d[i][k] != 0 &&
                !(fabs(d[i][k]) > 0x1p-300 && fabs(d[i][k]) < 0x1p300))
                return false;
    return true;
}

/// The determinant of the differences, rounded, and the same with all terms
/// positive.  Each term is rounded at most 8 times: three differences, two
/// products, three sums.
static double rounded_determinant(int n, differences d, double *permanent)
{
    if (n == 2) {
        double one = d[0][0] * d[1][1], other = d[0][1] * d[1][0];
        *permanent = fabs(one) + fabs(other);
        return one - other;
    }
    double sum = 0;
    *permanent = 0;
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;
        double one = d[1][l] * d[2][m], other = d[1][m] * d[2][l];
        sum += d[0][k] * (one - other);
        *permanent += fabs(d[0][k]) * (fabs(one) + fabs(other));
    }
    return sum;
}

static void exact_difference(mpq_t d, double a, double b)
{
    mpq_t subtrahend;
    mpq_init(subtrahend);
    mpq_set_d(d, a);
    mpq_set_d(subtrahend, b);
    mpq_sub(d, d, subtrahend);
    mpq_clear(subtrahend);
}

/// sum += sign * a b c.
static void exact_add(mpq_t sum, int sign, const mpq_t a, const mpq_t b,
                      const mpq_t c)
{
    mpq_t product;
    mpq_init(product);
    mpq_mul(product, a, b);
    mpq_mul(product, product, c);
    if (sign > 0)
        mpq_add(sum, sum, product);
    else
        mpq_sub(sum, sum, product);
    mpq_clear(product);
}

/// The determinant in rational numbers; for n = 2 with a third row 0, 0, 1.
static int exact_sign(int n, const double *const point[], const int axis[])
{
    mpq_t d[3][3], sum;
    mpq_init(sum);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            mpq_init(d[i][k]);
            if (i < n && k < n)
                exact_difference(d[i][k], point[i][axis[k]], point[n][axis[k]]);
            else if (i == k)
                mpq_set_ui(d[i][k], 1, 1);
        }
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;
        exact_add(sum, 1, d[0][k], d[1][l], d[2][m]);
        exact_add(sum, -1, d[0][k], d[1][m], d[2][l]);
    }
    int sign = mpq_sgn(sum);
    mpq_clear(sum);
    for (int i = 0; i < 9; i++)
        mpq_clear(d[i / 3][i % 3]);
    return sign;
}

static int sign_of(double x)
{
    return (x > 0) - (x < 0);
}

/// The sign of the determinant of point[i] - point[n] on n axes: of the rounded
/// one if that is sure, else of the exact one.  The rounded one is off by less
/// than 9 * 2^-53 of its permanent, and so is the permanent, which is zero only
/// if each term has a factor that is zero.
static int orientation(int n, const double *const point[], const int axis[])
{
    differences d;
    double permanent;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n; k++)
            d[i][k] = point[i][axis[k]] - point[n][axis[k]];
    double determinant = rounded_determinant(n, d, &permanent);
    if (are_moderate(n, d) && fabs(determinant) >= 0x1p-49 * permanent)
        return sign_of(determinant);
    return exact_sign(n, point, axis);
}

static const int space[] = {0, 1, 2};
static const int planes[3][2] = {{0, 1}, {1, 2}, {2, 0}};

static int orientation_3(const double *a, const double *b, const double *c,
                         const double *d)
{
    return orientation(3, (const double *const[]){a, b, c, d}, space);
}

static int orientation_2(const int plane[2], const double *a, const double *b,
                         const double *c)
{
    return orientation(2, (const double *const[]){a, b, c}, plane);
}

// Elements in a coordinate plane ----------------------------------------------

/// Whether two sets of points overlap on an axis.
static bool overlap(int axis, int count, const double *const a[], int others,
                    const double *const b[])
{
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < count; i++) {
        least[0] = fmin(least[0], a[i][axis]);
        most[0] = fmax(most[0], a[i][axis]);
    }
    for (int i = 0; i < others; i++) {
        least[1] = fmin(least[1], b[i][axis]);
        most[1] = fmax(most[1], b[i][axis]);
    }
    return least[0] <= most[1] && least[1] <= most[0];
}

/// Whether two closed edges, however short, meet: neither is on one side of the
/// other's line, and if all is on a line, they overlap there.
static bool edges_meet_2(const int plane[2], const double *const a[2],
                         const double *const b[2])
{
    return overlap(plane[0], 2, a, 2, b) && overlap(plane[1], 2, a, 2, b) &&
           orientation_2(plane, a[0], a[1], b[0]) *
                   orientation_2(plane, a[0], a[1], b[1]) <=
               0 &&
           orientation_2(plane, b[0], b[1], a[0]) *
                   orientation_2(plane, b[0], b[1], a[1]) <=
               0;
}

/// Whether a point is in a closed triangle.  Seen from a point outside, some
/// side turns left and some right, or, if the triangle is on a line with it, no
/// side turns and the point is not between.
static bool point_in_triangle_2(const int plane[2], const double *p,
                                const double *const t[3])
{
    bool left = false, right = false;
    if (!overlap(plane[0], 1, &p, 3, t) || !overlap(plane[1], 1, &p, 3, t))
        return false;
    for (int i = 0; i < 3; i++) {
        int turn = orientation_2(plane, p, t[i], t[(i + 1) % 3]);
        left |= turn > 0;
        right |= turn < 0;
    }
    return !(left && right);
}

// Elements in space -----------------------------------------------------------

// Elements of one plane meet if their projections to all three coordinate planes
// do: in one of them, or more, the projection of that plane is one to one.

static bool edges_meet_3(const double *const a[2], const double *const b[2])
{
    if (orientation_3(a[0], a[1], b[0], b[1]) != 0)
        return false;
    for (int i = 0; i < 3; i++)
        if (!edges_meet_2(planes[i], a, b))
            return false;
    return true;
}

static bool point_in_triangle_3(const double *p, const double *const t[3])
{
    if (orientation_3(p, t[0], t[1], t[2]) != 0)
        return false;
    for (int i = 0; i < 3; i++)
        if (!point_in_triangle_2(planes[i], p, t))
            return false;
    return true;
}

/// Whether the ends of the edge are on different sides of the triangle, and its
/// line turns the same way around all three sides.
static bool edge_pierces(const double *const edge[2], const double *const t[3])
{
    if (orientation_3(edge[0], t[0], t[1], t[2]) *
            orientation_3(edge[1], t[0], t[1], t[2]) !=
        -1)
        return false;
    int turn = orientation_3(edge[0], edge[1], t[0], t[1]);
    return turn != 0 && turn == orientation_3(edge[0], edge[1], t[1], t[2]) &&
           turn == orientation_3(edge[0], edge[1], t[2], t[0]);
}

// The elements of a mesh ------------------------------------------------------

typedef struct element {
    int corners, vertex[3]; ///< in increasing order, then -1
    double least[3], most[3];
} element;

struct tangle_judge {
    int axes, elements;
    element *element; ///< edges, triangles and vertices, none twice
    int found, room;
    tangle *tangle;
    const double *position;
    const double *inverse_mass; ///< NULL: all pairs count
};

static int compare_ints(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static void add_element(tangle_judge *judge, int corners, const int vertex[])
{
    element *added = &judge->element[judge->elements++];
    *added = (element){.corners = corners, .vertex = {-1, -1, -1}};
    memcpy(added->vertex, vertex, sizeof *vertex * (size_t)corners);
    qsort(added->vertex, (size_t)corners, sizeof *vertex, compare_ints);
}

/// By the number of corners, then by vertices.
static int compare_elements(const void *a, const void *b)
{
    const element *one = a, *other = b;
    int order = one->corners - other->corners;
    for (int i = 0; i < 3 && order == 0; i++)
        order = one->vertex[i] - other->vertex[i];
    return order;
}

static void drop_repeated(tangle_judge *judge)
{
    int kept = 0;
    qsort(judge->element, (size_t)judge->elements, sizeof *judge->element,
          compare_elements);
    for (int i = 0; i < judge->elements; i++)
        if (kept == 0 || compare_elements(&judge->element[kept - 1],
                                          &judge->element[i]) != 0)
            judge->element[kept++] = judge->element[i];
    judge->elements = kept;
}

tangle_judge *tangle_judge_new(const tf_mesh *mesh)
{
    tangle_judge *judge = allocate(1, sizeof *judge);
    int most = mesh->vertices + mesh->edges + 4 * mesh->triangles;
    judge->axes = mesh->axes;
    judge->element = allocate((size_t)most, sizeof *judge->element);
    for (int v = 0; v < mesh->vertices; v++)
        add_element(judge, 1, &v);
    for (int i = 0; i < mesh->edges; i++)
        add_element(judge, 2, mesh->edge + 2 * i);
    for (int i = 0; i < mesh->triangles; i++) {
        const int *t = mesh->triangle + 3 * i;
        add_element(judge, 3, t);
        for (int k = 0; k < 3; k++)
            add_element(judge, 2, (const int[]){t[k], t[(k + 1) % 3]});
    }
    drop_repeated(judge);
    return judge;
}

void tangle_judge_free(tangle_judge *judge)
{
    free(judge->element);
    free(judge->tangle);
    free(judge);
}

void tangle_judge_script(tangle_judge *judge, const double inverse_mass[])
{
    judge->inverse_mass = inverse_mass;
}

// Pairs -----------------------------------------------------------------------

static int count_free(const tangle_judge *judge, const element *e)
{
    int count = 0;
    for (int i = 0; i < e->corners; i++)
        count += judge->inverse_mass[e->vertex[i]] > 0;
    return count;
}

static bool counts(const tangle_judge *judge, const element *a,
                   const element *b)
{
    int more = a->corners + b->corners - judge->axes - 1;
    return !judge->inverse_mass ||
           count_free(judge, a) + count_free(judge, b) > more;
}

static bool share_vertex(const element *a, const element *b)
{
    for (int i = 0; i < a->corners; i++)
        for (int j = 0; j < b->corners; j++)
            if (a->vertex[i] == b->vertex[j])
                return true;
    return false;
}

/// What two elements may be, the one with fewer corners first; false if nothing.
static bool kind_of(int axes, const element *a, const element *b,
                    tangle_kind *kind)
{
    if (a->corners == 2 && b->corners == 2)
        *kind = EDGES_MEET;
    else if (a->corners == 1 && b->corners == 2 && axes == 2)
        *kind = POINT_IN_EDGE;
    else if (a->corners == 1 && b->corners == 3)
        *kind = POINT_IN_TRIANGLE;
    else if (a->corners == 2 && b->corners == 3)
        *kind = EDGE_PIERCES_TRIANGLE;
    else
        return false;
    return true;
}

static void find_corners(const tangle_judge *judge, const element *e,
                         const double *corner[])
{
    for (int i = 0; i < e->corners; i++)
        corner[i] = judge->position + judge->axes * e->vertex[i];
}

static bool meet(const tangle_judge *judge, tangle_kind kind, const element *a,
                 const element *b)
{
    const double *first[3], *second[3];
    find_corners(judge, a, first);
    find_corners(judge, b, second);
    switch (kind) {
    case EDGE_PIERCES_TRIANGLE:
        return edge_pierces(first, second);
    case POINT_IN_TRIANGLE:
        return point_in_triangle_3(first[0], second);
    case POINT_IN_EDGE:
        first[1] = first[0];
        return edges_meet_2(planes[0], first, second);
    default:
        return judge->axes == 2 ? edges_meet_2(planes[0], first, second)
                                : edges_meet_3(first, second);
    }
}

static void add_tangle(tangle_judge *judge, tangle_kind kind, const element *a,
                       const element *b)
{
    if (judge->found == judge->room) {
        judge->room = 2 * judge->room + 16;
        judge->tangle =
            realloc(judge->tangle, sizeof *judge->tangle * (size_t)judge->room);
        if (!judge->tangle)
            abort();
    }
    tangle *added = &judge->tangle[judge->found++];
    *added = (tangle){kind, {-1, -1, -1, -1, -1}};
    memcpy(added->vertex, a->vertex, sizeof(int) * (size_t)a->corners);
    memcpy(added->vertex + a->corners, b->vertex,
           sizeof(int) * (size_t)b->corners);
}

static void judge_pair(tangle_judge *judge, const element *a, const element *b)
{
    tangle_kind kind;
    if (compare_elements(a, b) > 0) {
        const element *swapped = a;
        a = b;
        b = swapped;
    }
    if (kind_of(judge->axes, a, b, &kind) && !share_vertex(a, b) &&
        counts(judge, a, b) && meet(judge, kind, a, b))
        add_tangle(judge, kind, a, b);
}

static int compare_tangles(const void *a, const void *b)
{
    const tangle *one = a, *other = b;
    int order = (int)one->kind - (int)other->kind;
    for (int i = 0; i < 5 && order == 0; i++)
        order = one->vertex[i] - other->vertex[i];
    return order;
}

static int sort_tangles(tangle_judge *judge)
{
    if (judge->found > 0)
        qsort(judge->tangle, (size_t)judge->found, sizeof *judge->tangle,
              compare_tangles);
    return judge->found;
}

int tangle_count_all(tangle_judge *judge, const double position[])
{
    judge->position = position;
    judge->found = 0;
    for (int i = 0; i < judge->elements; i++)
        for (int j = i + 1; j < judge->elements; j++)
            judge_pair(judge, &judge->element[i], &judge->element[j]);
    return sort_tangles(judge);
}

// The sweep -------------------------------------------------------------------

static void find_box(const tangle_judge *judge, element *e)
{
    for (int k = 0; k < judge->axes; k++) {
        e->least[k] = INFINITY;
        e->most[k] = -INFINITY;
        for (int i = 0; i < e->corners; i++) {
            double x = judge->position[judge->axes * e->vertex[i] + k];
            e->least[k] = fmin(e->least[k], x);
            e->most[k] = fmax(e->most[k], x);
        }
    }
}

/// Along the first axis.
static int compare_boxes(const void *a, const void *b)
{
    const element *one = *(element *const *)a, *other = *(element *const *)b;
    return sign_of(one->least[0] - other->least[0]);
}

static bool boxes_overlap(int axes, const element *a, const element *b)
{
    for (int k = 0; k < axes; k++)
        if (!(a->least[k] <= b->most[k] && b->least[k] <= a->most[k]))
            return false;
    return true;
}

int tangle_count(tangle_judge *judge, const double position[])
{
    int count = judge->elements;
    element **sorted = allocate((size_t)count, sizeof *sorted);
    judge->position = position;
    judge->found = 0;
    for (int i = 0; i < count; i++) {
        sorted[i] = &judge->element[i];
        find_box(judge, sorted[i]);
    }
    qsort(sorted, (size_t)count, sizeof *sorted, compare_boxes);
    for (int i = 0; i < count; i++)
        for (int j = i + 1;
             j < count && sorted[j]->least[0] <= sorted[i]->most[0]; j++)
            if (boxes_overlap(judge->axes, sorted[i], sorted[j]))
                judge_pair(judge, sorted[i], sorted[j]);
    free(sorted);
    return sort_tangles(judge);
}

// Steps -----------------------------------------------------------------------

/// Around the paths of its vertices.
static void find_swept_box(tangle_judge *judge, element *e,
                           const double start[], const double end[])
{
    element at_start = *e;
    judge->position = start;
    find_box(judge, &at_start);
    judge->position = end;
    find_box(judge, e);
    for (int k = 0; k < judge->axes; k++) {
        e->least[k] = fmin(e->least[k], at_start.least[k]);
        e->most[k] = fmax(e->most[k], at_start.most[k]);
    }
}

static void find_worldlines(int axes, const element *e, const double start[],
                            const double end[], tf_worldline line[])
{
    for (int i = 0; i < e->corners; i++) {
        size_t first = (size_t)(axes * e->vertex[i]);
        for (int t = 0; t < 2; t++) {
            line[i].at[t] = (tf_event){.t = t, .vertex = e->vertex[i]};
            memcpy(line[i].at[t].x, (t ? end : start) + first,
                   sizeof(double) * (size_t)axes);
        }
    }
}

static void judge_moving_pair(tangle_judge *judge, const element *a,
                              const element *b, const double start[],
                              const double end[])
{
    tangle_kind kind;
    tf_worldline first[3], second[3];
    mpq_t toi;
    if (!kind_of(judge->axes, a, b, &kind) || share_vertex(a, b) ||
        !counts(judge, a, b) || kind == EDGE_PIERCES_TRIANGLE ||
        (kind == EDGES_MEET && judge->axes == 2))
        return;
    find_worldlines(judge->axes, a, start, end, first);
    find_worldlines(judge->axes, b, start, end, second);
    mpq_init(toi);
    if (oracle_meet(judge->axes, a->corners, first, b->corners, second, toi))
        add_tangle(judge, kind, a, b);
    mpq_clear(toi);
}

int tangle_count_in_step(tangle_judge *judge, const double start[],
                         const double end[])
{
    judge->found = 0;
    for (int i = 0; i < judge->elements; i++)
        find_swept_box(judge, &judge->element[i], start, end);
    for (int i = 0; i < judge->elements; i++)
        for (int j = i + 1; j < judge->elements; j++)
            if (boxes_overlap(judge->axes, &judge->element[i],
                              &judge->element[j]))
                judge_moving_pair(judge, &judge->element[i], &judge->element[j],
                                  start, end);
    return sort_tangles(judge);
}

const tangle *tangles(const tangle_judge *judge)
{
    return judge->tangle;
}

const char *tangle_text(const tangle *found)
{
    static const char *const names[] = {"edge pierces triangle",
                                        "point in triangle", "edges meet",
                                        "point in edge"};
    static char text[120];
    const int *v = found->vertex;
    snprintf(text, sizeof text, "%s: %d %d %d %d %d", names[found->kind], v[0],
             v[1], v[2], v[3], v[4]);
    return text;
}
