// What the figures of space print.
#include "figures/numbers.h"

#include "kit/random.h"
#include "support/queries.h"
#include "support/winding.h"

static double determinant(const double a[3], const double b[3],
                          const double c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) -
           a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Cramer's rule for the weight that corner i of a tetrahedron has in the
/// origin, but for a common factor.
static double weight_of(double corner[4][3], int i)
{
    return (i % 2 == 0 ? 1 : -1) * determinant(corner[i < 1],
                                               corner[i < 2 ? 2 : 1],
                                               corner[i < 3 ? 3 : 2]);
}

/// The tetrahedron of a pivot in the frame of the first of four vertices: the
/// other three at t = 0, up to the pivot, and then at t = 1.
static void see(const tf_worldline vertex[4], int pivot, double corner[4][3])
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            int late = i > pivot;
            corner[i][k] =
                vertex[1 + i - late].at[late].x[k] - vertex[0].at[late].x[k];
        }
}

// Conservative advancement ----------------------------------------------------

/// The number of steps by the recursion of the text with half a threshold to
/// spare, for a bar that turns by a right angle a step, a third of it too much;
/// and the angle that is left.
static int count_steps(double radius, double threshold, int most, double *left)
{
    int steps = 0;
    *left = PI / 3;
    for (; steps < most && radius * sin(*left) > threshold; steps++)
        *left -= radius * sin(*left) - threshold / 2;
    return steps;
}

static void steps_and_errors_are_those_of_the_recursion(void)
{
    static const double radius[] = {0.1, 0.5, 0.9};
    for (int r = 0; r < 3; r++)
        for (int i = 2; i <= 12; i++) {
            double left;
            expect(count_steps(radius[r], pow(10, -i), 1 << 20, &left),
                   "steps_%g_%d", radius[r], i);
            double error = left / (PI / 2);
            expect_within(1e-3 * error, error, "error_%g_%d", radius[r], i);
        }
}

static void the_bar_advances_by_the_recursion(void)
{
    double threshold = number("threshold"), left;
    int steps = count_steps(0.5, threshold, 1 << 20, &left);
    expect(steps, "steps");
    expect((PI / 3 - left) / (PI / 2), "time");
    expect(0.5 * sin(left), "distance");
    for (int i = 0; i <= steps && i <= 3; i++) {
        count_steps(0.5, threshold, i, &left);
        expect((PI / 3 - left) / (PI / 2), "time_%d", i);
        expect(0.5 * sin(left), "distance_%d", i);
    }
}

// What elements do ------------------------------------------------------------

static void the_balloon_wraps_where_the_edge_crosses(void)
{
    static const double ways[][6] = {{0.35, 0.1, 0.8, 0, -0.3, -0.7},
                                     {0.2, 0.2, 1.7, -0.2, 0, 0.5},
                                     {-1, -0.7, -0.1, -0.9, -0.9, 0.1},
                                     {1, -0.8, 0.1, 0.9, -0.7, 0},
                                     {0.1, 1, 0, -0.1, 1, 0.15}};
    tf_worldline v[5];
    make_vertices(3, 5, *ways, v);
    expect(oracle_time(3, 1, v, 3, v + 2), "toi");
    expect(meet_at(0, 3, 2, v, 3, v + 2), "degree_start");
    expect(meet_at(1, 3, 2, v, 3, v + 2), "degree_end");

    // It is the only contact.
    ck_assert_double_lt(oracle_time(3, 1, v + 1, 3, v + 2), 0);
    for (int i = 0; i < 3; i++) {
        const tf_worldline side[2] = {v[2 + (i == 0)], v[2 + (i == 2 ? 1 : 2)]};
        ck_assert_double_lt(oracle_time(3, 2, v, 2, side), 0);
    }
}

/// The border of a parallelogram winds around what is inside, once.
static void the_band_winds_where_edges_cross(void)
{
    static const double ways[][4] = {{-1.3, -0.3, -0.75, -0.35},
                                     {-0.35, 0.45, 0.85, 0.1},
                                     {0.3, -0.9, 0.1, -0.7},
                                     {0.5, 0.8, 0.15, 1}};
    tf_worldline v[4];
    make_vertices(2, 4, *ways, v);
    expect(oracle_time(2, 1, v + 1, 2, v + 2), "toi");
    expect(meet_at(0, 2, 2, v, 2, v + 2), "winding_start");
    expect(meet_at(1, 2, 2, v, 2, v + 2), "winding_end");
}

static int compare_numbers(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

/// The times at which an end meets a simplex of the other edge, in order.
static int find_times(const tf_worldline v[4], double time[8])
{
    int count = 0;
    for (int i = 0; i < 8; i++) {
        oracle_simplex path = oracle_step(1, &v[i / 2], 0);
        oracle_simplex sweep = oracle_step(2, v + (i < 4 ? 2 : 0), i % 2);
        time[count] = oracle_simplices_time(2, &path, &sweep);
        count += time[count] >= 0;
    }
    qsort(time, (size_t)count, sizeof *time, compare_numbers);
    return count;
}

static void edges_cross_at_the_ends_as_the_shell_winds(void)
{
    static const double ways[][4] = {{-0.25, 0.25, 0.25, -1.5},
                                     {-1.5, 1.5, 1, 0.25},
                                     {-0.75, 0.25, 0.75, 1},
                                     {1.5, -1, 1, -1}};
    tf_worldline v[4];
    double time[8];
    make_vertices(2, 4, *ways, v);
    ck_assert_int_eq(find_times(v, time), 3);
    for (int i = 0; i < 3; i++)
        expect(time[i], "toi_%d", i);
    expect(meet_at(0, 2, 2, v, 2, v + 2), "winding_start");
    expect(meet_at(1, 2, 2, v, 2, v + 2), "winding_end");
}

/// When the triangles of a start event and two end events first meet, all in
/// the plane z = 0.
static double first_time(const double ends[4][2])
{
    double ways[4][6] = {{-1, 1.5}, {-1, 1.5}, {2, 0.5}, {2, 0.5}};
    tf_worldline v[4];
    for (int i = 0; i < 4; i++)
        memcpy(ways[i] + 3, ends[i], sizeof ends[i]);
    make_vertices(3, 4, *ways, v);
    oracle_simplex first = oracle_step(2, v, 0),
                   second = oracle_step(2, v + 2, 0);
    return oracle_simplices_time(3, &first, &second);
}

static void edges_that_cross_at_the_end_cross_before(void)
{
    static const double crossing[][2] = {{0, 0}, {2, 0}, {1, -1}, {1, 1}};
    static const double touching[][2] = {{-1, 0}, {1, 0}, {1, -1}, {1, 1}};
    expect(first_time(crossing), "crossing_first");
    expect(first_time(touching), "touching_first");
}

/// The propeller in one order of its ends, and a bar across, from y = -1 to
/// y = 1, at x and z.
static double time_of_bar(int order, double start, double end, double z)
{
    const double ways[][6] = {{-order, 0, 0, -order, 0, -order},
                              {order, 0, 0, order, 0, order},
                              {start, -1, z, end, -1, z},
                              {start, 1, z, end, 1, z}};
    tf_worldline v[4];
    make_vertices(3, 4, *ways, v);
    return oracle_time(3, 2, v, 2, v + 2);
}

static void one_order_of_the_propeller_meets_the_bar(void)
{
    double up = time_of_bar(1, 0, 0, 0.375);
    expect(up >= 0, "up_hit");
    expect(up, "up_toi");
    expect(time_of_bar(-1, 1, 0, 0.1875) >= 0, "down_hit");
}

enum {
    CURVE = 8,
    LOOP = 5
};

/// A closed polygon of vertices in the order of their indices.
static cycle polygon(int count, int first, int edge[])
{
    for (int i = 0; i < count; i++) {
        edge[2 * i] = first + i;
        edge[2 * i + 1] = first + (i + 1) % count;
    }
    return (cycle){count, 2, edge};
}

static const double curve[2][2 * (CURVE + 2)] = {
    {-0.5, -0.87, 0.34, -0.94, 0.82, -0.57, 1,   0,    0.82, 0.57,
     0.34, 0.94,  -0.5, 0.87,  -1,   0,     0.1, 0.35, 1.35, 0},
    {-0.6, -1.05, 1.2,  -1,   1.1,  -0.5, -0.5, 0.05, 1.1, 0.5,
     1.2,  1,     -0.6, 1.05, -1.3, 0,    0.7,  0.72, 0.4, 0.02}};
static const double loops[2][3 * 2 * LOOP] = {
    {-1.5, -0.7, 0.1,  0.2,  -1,   -0.2, 1,   -0.1, 0.2,  0.3,
     0.9,  0,    -1.3, 0.8,  -0.1, 0.1,  0,   0.2,  0.7,  0.1,
     -0.9, 1.9,  0,    -0.7, 2,    0.1,  0.7, 0.9,  -0.1, 1},
    {-1.2, -0.9, -0.5, 0.8,  -0.8, 0.3,  0.7, 0.3, 0.5, 0.1,
     0.9,  -0.6, -1.4, 0.4,  0.5,  -0.5, 0.1, 0.3, 0.1, 0.2,
     -1,   1.6,  -0.4, -0.4, 1.9,  0.5,  0.3, 0.5, 0,   1.1}};

static void both_ends_have_the_same_numbers(void)
{
    static const char *const when[2] = {"start", "end"};
    int edge[2 * CURVE], other[2 * LOOP];
    for (int t = 0; t < 2; t++) {
        cycle around = polygon(CURVE, 0, edge);
        for (int k = 0; k < 2; k++)
            expect(winding_number(2, curve[t], &around, CURVE + k),
                   "winding_%d_%s", k, when[t]);
        cycle first = polygon(LOOP, 0, edge),
              second = polygon(LOOP, LOOP, other);
        expect(linking_number(loops[t], &first, &second), "linking_%s",
               when[t]);
    }
}

// Steps of five vertices ------------------------------------------------------

enum {
    STEPS = 2000,
    VERTICES = 5,
    MOST = 16
};

/// From -1 up to 1.
static double next_number(uint64_t *state)
{
    return 2 * ldexp((double)(fig_congruent_bits(state) >> 11), -53) - 1;
}

static void make_step(uint64_t *state, tf_worldline vertex[VERTICES])
{
    double way[VERTICES][6];
    for (int v = 0; v < VERTICES; v++)
        for (int k = 0; k < 3; k++) {
            way[v][k] = next_number(state);
            way[v][k + 3] = way[v][k] + 2 * next_number(state);
        }
    make_vertices(3, VERTICES, *way, vertex);
}

/// The pairs of simplices that meet, as the oracle says.
static int count_pairs(int vertices, const tf_worldline first[], int others,
                       const tf_worldline second[])
{
    int count = 0;
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < others; j++) {
            oracle_simplex s = oracle_step(vertices, first, i);
            oracle_simplex r = oracle_step(others, second, j);
            count += oracle_simplices_time(3, &s, &r) >= 0;
        }
    return count;
}

static int count_contacts(const tf_worldline vertex[VERTICES])
{
    static const int side[3][2] = {{2, 3}, {2, 4}, {3, 4}};
    int count = 0;
    for (int v = 0; v < 2; v++)
        count += count_pairs(1, &vertex[v], 3, vertex + 2);
    for (int i = 0; i < 3; i++) {
        tf_worldline edge[2] = {vertex[side[i][0]], vertex[side[i][1]]};
        count += count_pairs(2, vertex, 2, edge);
    }
    return count;
}

static void contacts_and_sums_are_the_oracles(void)
{
    double contacts[MOST + 1] = {0}, sums[MOST + 1] = {0}, odd = 0;
    uint64_t state = 1;
    for (int i = 0; i < STEPS; i++) {
        tf_worldline v[VERTICES];
        make_step(&state, v);
        int count = count_contacts(v);
        contacts[count]++;
        sums[count + meet_at(0, 3, 2, v, 3, v + 2) +
             meet_at(1, 3, 2, v, 3, v + 2)]++;
        odd += count % 2;
    }
    expect(odd, "odd_contacts");
    for (int i = 0; i <= (int)number("most"); i++) {
        expect(contacts[i], "contacts_%d", i);
        expect(sums[i], "sums_%d", i);
    }
}

// Triangles that cross at their creases ---------------------------------------

enum {
    FACES = 4 ///< of a bent triangle
};

static void make_triangles(tf_worldline corner[6])
{
    static const double ways[][6] = {
        {-3, -6, 6, 4, -5, 6}, {6, -3, -1, 6, 3, -1}, {6, 6, -4, 0, 6, -5},
        {5, 5, -6, -1, 3, -4}, {-3, -6, 3, 2, -6, 6}, {-6, -2, -3, -5, 4, 1}};
    make_vertices(3, 6, *ways, corner);
}

/// The flat pieces of a bent triangle, the middle one in two.
static void make_faces(const tf_worldline corner[3], double t,
                       tf_vector faces[FACES][3])
{
    // From which vertex to which the way goes that a corner is on.
    static const int way[FACES][3][2] = {{{0, 0}, {0, 1}, {0, 2}},
                                         {{0, 1}, {1, 1}, {1, 2}},
                                         {{0, 1}, {1, 2}, {0, 2}},
                                         {{0, 2}, {1, 2}, {2, 2}}};
    for (int f = 0; f < FACES; f++)
        for (int i = 0; i < 3; i++) {
            double weight[3] = {0};
            weight[way[f][i][0]] += 1 - t;
            weight[way[f][i][1]] += t;
            staircase_point(3, 3, corner, weight, t, faces[f][i].x);
        }
}

/// Six times the volume of a tetrahedron.
static double volume(tf_vector a, tf_vector b, tf_vector c, tf_vector d)
{
    return tf_vector_dot(fig_cross(fig_difference(b, a), fig_difference(c, a)),
                         fig_difference(d, a));
}

/// Where a segment pierces a face.
static bool pierce(tf_vector from, tf_vector to, const tf_vector c[3],
                   tf_vector *place)
{
    double below = volume(c[0], c[1], c[2], from);
    double above = volume(c[0], c[1], c[2], to), side[3];
    for (int i = 0; i < 3; i++)
        side[i] = volume(from, to, c[i], c[(i + 1) % 3]);
    *place = fig_lerp(from, to, below / (below - above));
    return below * above < 0 && side[0] * side[1] >= 0 &&
           side[1] * side[2] >= 0 && side[0] * side[2] >= 0;
}

/// The length of the segment that two faces share, between the places where a
/// side of one pierces the other.
static double shared_length(const tf_vector a[3], const tf_vector b[3])
{
    tf_vector place[7];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        int next = (i + 1) % 3;
        count += pierce(a[i], a[next], b, &place[count]);
        count += pierce(b[i], b[next], a, &place[count]);
    }
    return count < 2 ? 0 : fig_length(fig_difference(place[1], place[0]));
}

static double crossing_length(double t)
{
    tf_worldline corner[6];
    tf_vector first[FACES][3], second[FACES][3];
    double length = 0;
    make_triangles(corner);
    make_faces(corner, t, first);
    make_faces(corner + 3, t, second);
    for (int i = 0; i < FACES * FACES; i++)
        length += shared_length(first[i / FACES], second[i % FACES]);
    return length;
}

static void triangles_cross_in_mid_step_only(void)
{
    expect(crossing_length(0), "length_start");
    expect(crossing_length(1), "length_end");
    expect_within(1e-9, crossing_length(number("time")), "length");
    double after = crossing_length(number("time_after"));
    expect_within(1e-9, after, "length_after");
    ck_assert_double_gt(after, 1);
    ck_assert_double_eq(crossing_length(number("time_before")), 0);
}

static void none_of_the_fifteen_queries_hits(void)
{
    tf_worldline v[6];
    make_triangles(v);
    for (int i = 0; i < 6; i++)
        ck_assert(oracle_time(3, 1, v + i, 3, v + (i < 3 ? 3 : 0)) < 0);
    for (int i = 0; i < 9; i++) {
        // The side opposite a corner.
        int a = i / 3, b = i % 3;
        tf_worldline first[2] = {v[a == 0], v[a == 2 ? 1 : 2]};
        tf_worldline second[2] = {v[3 + (b == 0)], v[3 + (b == 2 ? 1 : 2)]};
        ck_assert(oracle_time(3, 2, first, 2, second) < 0);
    }
}

// Two edges -------------------------------------------------------------------

enum {
    SAMPLES = 80
};

static const double edges[4][6] = {{-2.625, -1, -1, -2.875, -0.5, 0.5},
                                   {1.375, 0.5, -2, 1.375, -0.5, 2.75},
                                   {0.5, -1.375, 2.75, -0.25, -1.375, -2},
                                   {-0.5, 2.625, 1.5, 0.75, 2.625, -1}};

/// A place of the slice at the time t of a triangle of an edge's sweep: the
/// share s of its way from the crease to the end.
static void find_place(int edge, int i, double t, double s, double place[3])
{
    const double *first = edges[2 * edge], *second = edges[2 * edge + 1];
    const double *end = i == 0 ? second : first;
    for (int k = 0; k < 3; k++)
        place[k] = (1 - s) * ((1 - t) * first[k] + t * second[k + 3]) +
                   s * ((1 - t) * end[k] + t * end[k + 3]);
}

/// How near two pieces come, by trying many places at many times: at most a bit
/// too much.
static double sampled(int i, int j)
{
    double least = INFINITY;
    for (int step = 0; step <= SAMPLES; step++)
        for (int n = 0; n < (SAMPLES + 1) * (SAMPLES + 1); n++) {
            double a[3], b[3], t = step / (double)SAMPLES;
            find_place(0, i, t, n / (SAMPLES + 1) / (double)SAMPLES, a);
            find_place(1, j, t, n % (SAMPLES + 1) / (double)SAMPLES, b);
            least = fmin(least,
                         hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
        }
    return least;
}

static void four_pairs_do_what_the_oracle_says(void)
{
    tf_worldline v[4];
    make_vertices(3, 4, *edges, v);
    expect(oracle_time(3, 2, v, 2, v + 2), "toi");
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            oracle_simplex s = oracle_step(2, v, 1 - i);
            oracle_simplex r = oracle_step(2, v + 2, 1 - j);
            expect(oracle_simplices_time(3, &s, &r) >= 0, "hit_%d%d", i, j);
            // In space, whatever the time, three pairs overlap: the chapter
            // says which.
            ck_assert_int_eq(oracle_slices_meet(3, &s, &r), i + j > 0);
            double found = number("nearest_%d%d", i, j), tried = sampled(i, j);
            ck_assert_double_le(found, tried + 1e-3);
            ck_assert_double_ge(found, tried - 0.06);
        }
}

// Other methods ---------------------------------------------------------------

/// The scenes of inclusion cells, multiplied by 12.
static const struct {
    const char *key;
    int corner[4][2];
} scenes[] = {
    {"pass", {{-18, -21}, {0, -9}, {0, 15}, {18, -21}}},
    {"turn", {{-18, -9}, {0, 3}, {0, 27}, {18, -9}}},
    {"slide", {{-18, -9}, {12, 6}, {-12, -6}, {18, 9}}},
};

/// By the extremes of the differences at the corners of the cell (s, t) of
/// one x one, in integers.
static bool may_hold_zero(const int corner[4][2], long s, long t, long one)
{
    for (int k = 0; k < 2; k++) {
        int above = 0, below = 0;
        for (int i = 0; i < 4; i++) {
            long u = s + i % 2, v = t + i / 2;
            long x = (one - v) * ((one - u) * corner[0][k] + u * corner[1][k]) +
                     v * ((one - u) * corner[2][k] + u * corner[3][k]);
            above += x > 0;
            below += x < 0;
        }
        if (above == 4 || below == 4)
            return false;
    }
    return true;
}

/// How many boxes another division looks at: recursively.
static int count_boxes(const int corner[4][2], int depth, int most, long s,
                       long t)
{
    if (depth > 0 && !may_hold_zero(corner, s, t, 1L << depth))
        return 1;
    int count = 1;
    for (int i = 0; depth < most && i < 4; i++)
        count +=
            count_boxes(corner, depth + 1, most, 2 * s + i % 2, 2 * t + i / 2);
    return count;
}

static void boxes_are_as_many(void)
{
    for (int i = 0; i < 3; i++)
        for (int depth = 1; depth <= 14; depth++)
            expect(count_boxes(scenes[i].corner, 0, depth, 0, 0), "%s_%d",
                   scenes[i].key, depth);
}

/// The points start at (1 + shift, 3) and the edge's line is y = t + t x / 4:
/// the root of 12 - (17 + shift) t - t^2, and from the edge's end the distance.
static void roots_and_distances_are_those_of_the_formulas(void)
{
    double shift = number("shift"), b = 17 + shift;
    double t = (sqrt(b * b + 48) - b) / 2;
    expect((sqrt(17 * 17 + 48) - 17) / 2, "hit_root");
    expect(t, "miss_root");
    expect(hypot(shift + t - 3, 3 - 5 * t), "miss_distance");

    // At the ends of the window the distance is the tolerance.
    double from = number("miss_from"), to = number("miss_to");
    expect_within(1e-12, hypot(shift + to - 3, 3 - 5 * to), "tolerance");
    expect_within(1e-12, hypot(shift + from - 3, 3 - 5 * from), "tolerance");
}

/// The least of a count over all tolerances, or of the sum of two.
static double least_of(const char *set, const char *first, const char *second)
{
    double least = INFINITY;
    for (int digits = 0; digits <= 16; digits++) {
        char row[32] = "cubic 0";
        if (digits > 0)
            snprintf(row, sizeof row, "cubic 1e-%02d", digits);
        double count = measured("methods", "%s %s %s", row, set, first);
        count += second ? measured("methods", "%s %s %s", row, set, second) : 0;
        least = fmin(least, count);
    }
    return least;
}

static void errors_are_those_counted(void)
{
    static const char *const sets[] = {"adversarial", "public", "random"};
    for (int s = 0; s < 3; s++) {
        expect(least_of(sets[s], "missed", "extra"), "%s_least", sets[s]);
        expect(least_of(sets[s], "missed", NULL), "%s_missed_least", sets[s]);
        expect(least_of(sets[s], "extra", NULL), "%s_extra_least", sets[s]);
    }
}

// Signs and volumes -----------------------------------------------------------

/// The areas of slices follow a quadratic law, for which Simpson's rule is
/// exact: from those of the triangles and of the hexagon half way.  Its walls
/// are bent at the middle of one vertex's event at t = 0 and another one's at
/// t = 1.
static void the_volume_of_the_prism_is_simpsons(void)
{
    static const double at[2][3][2] = {
        {{0, 0.35}, {0.4, 0}, {0.7, 0.5}},
        {{0.05, 0.25}, {0.5, 0.05}, {0.65, 0.6}}};
    static const int way[3][6][2] = {
        {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {2, 2}, {2, 2}},
        {{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 2}, {0, 2}},
        {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {2, 2}, {2, 2}}};
    double volume = 0;
    for (int slice = 0; slice < 3; slice++) {
        double x[6][2], t = slice / 2.;
        for (int i = 0; i < 12; i++) {
            const int *w = way[slice][i / 2];
            x[i / 2][i % 2] =
                (1 - t) * at[0][w[0]][i % 2] + t * at[1][w[1]][i % 2];
        }
        // Twice the area by Gauss's formula.
        for (int i = 0; i < 6; i++) {
            const double *p = x[i], *q = x[(i + 1) % 6];
            volume += (slice == 1 ? 4 : 1) / 12. * (p[0] * q[1] - p[1] * q[0]);
        }
    }
    expect(volume, "volume");
}

/// The coordinates are short: determinants are exact.
static void signs_are_those_of_determinants(void)
{
    // The point rests at the origin.
    static const double ways[][6] = {{0},
                                     {-2.75, -0.5, -1.75, -2.5, -1, 1.25},
                                     {1.75, -0.5, -2.25, 1.5, -1.5, 1.75},
                                     {-0.75, 3.5, -2, -0.5, 2.5, 2.25}};
    tf_worldline v[4];
    make_vertices(3, 4, *ways, v);
    for (int pivot = 0; pivot < 3; pivot++) {
        double corner[4][3];
        see(v, pivot, corner);
        for (int i = 0; i < 4; i++) {
            double weight = weight_of(corner, i);
            expect((weight > 0) - (weight < 0), "sign_%d_%d", pivot, i);
            if (pivot == 1)
                ck_assert_double_eq(weight, weight_of(corner, 0));
        }
    }
}

enum {
    QUERIES = 200000,
    JUDGED = 500 ///< of those, by the oracle too
};

/// Whether all corners are strictly on one side of the origin on some axis.
static bool beside_an_axis(double corner[4][3])
{
    for (int k = 0; k < 3; k++) {
        int above = 0, below = 0;
        for (int i = 0; i < 4; i++) {
            above += corner[i][k] > 0;
            below += corner[i][k] < 0;
        }
        if (above == 4 || below == 4)
            return true;
    }
    return false;
}

/// How many signs are asked for until two conflict; none must be zero.  Tells
/// whether none did.  They are those of the barycentric coordinates at each
/// time: first the point's, which is the sum, and then the triangle's.
static bool ask(double corner[4][3], int pivot, int *signs)
{
    double coordinate[6] = {0};
    for (int i = 0; i < 4; i++) {
        double weight = weight_of(corner, i);
        coordinate[i + 1 + (i > pivot)] = weight;
        coordinate[i > pivot ? pivot + 2 : 0] += weight;
    }
    for (int i = 0; i < 6; i++) {
        ++*signs;
        if ((coordinate[i] > 0) != (coordinate[0] > 0))
            return false;
    }
    return true;
}

static bool ask_all(const tf_worldline vertex[4], int *signs)
{
    bool hit = false;
    for (int pivot = 2; pivot >= 0; pivot--) {
        double corner[4][3];
        see(vertex, pivot, corner);
        hit |= !beside_an_axis(corner) && ask(corner, pivot, signs);
    }
    return hit;
}

static void signs_that_are_spent_are_counted(void)
{
    uint64_t state = 1;
    double queries[2] = {0, 0}, signs[2] = {0, 0}, none = 0;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline v[4];
        fig_random_vertices(&state, 3, 0.1, 4, v);
        int asked = 0;
        bool hit = ask_all(v, &asked);
        if (i < JUDGED)
            ck_assert(hit == (oracle_time(3, 1, v, 3, v + 1) >= 0));
        none += asked == 0;
        queries[hit] += asked > 0;
        signs[hit] += asked;
    }
    expect(queries[true], "hits");
    expect(100 * none / QUERIES, "none_percent");
    expect(signs[false] / queries[false], "miss_mean");
    expect(signs[true] / queries[true], "hit_mean");
}

const figure_test space_tests[] = {
    {&fig_advancement_steps, steps_and_errors_are_those_of_the_recursion},
    {&fig_advancing_bar, the_bar_advances_by_the_recursion},
    {&fig_triangle_differences, the_balloon_wraps_where_the_edge_crosses},
    {&fig_crease_crossing, none_of_the_fifteen_queries_hits},
    {&fig_crease_crossing, triangles_cross_in_mid_step_only},
    {&fig_edge_edge_distances, four_pairs_do_what_the_oracle_says},
    {&fig_contact_parity, contacts_and_sums_are_the_oracles},
    {&fig_inclusion_boxes, boxes_are_as_many},
    {&fig_contact_at_end, edges_that_cross_at_the_end_cross_before},
    {&fig_no_tunneling, both_ends_have_the_same_numbers},
    {&fig_prism, the_volume_of_the_prism_is_simpsons},
    {&fig_propeller_and_bar, one_order_of_the_propeller_meets_the_bar},
    {&fig_root_and_window, roots_and_distances_are_those_of_the_formulas},
    {&fig_sheared_frame, signs_are_those_of_determinants},
    {&fig_winding_of_contacts, edges_cross_at_the_ends_as_the_shell_winds},
    {&fig_signs_evaluated, signs_that_are_spent_are_counted},
    {&fig_tolerance_errors, errors_are_those_counted},
    {&fig_edge_differences, the_band_winds_where_edges_cross},
    {NULL, NULL}};
