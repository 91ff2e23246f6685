// What the figures of the plane print.
#define _POSIX_C_SOURCE 200809L // glob

#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "intersect/complementary.h"
#include "kit/random.h"
#include "support/linear_truth.h"
#include "support/queries.h"

#include <float.h>
#include <glob.h>

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

// Contacts --------------------------------------------------------------------

enum {
    CORNERS = 32
};

static tf_worldline corner_of_ring(int i)
{
    double from = 2 * PI * i / CORNERS, to = from + 2 * PI * 114 / 360;
    return tf_worldline_between(2,
                                (double[]){0.78 * cos(from), 0.78 * sin(from)},
                                (double[]){0.64 * cos(to), 0.64 * sin(to)});
}

static void the_point_enters_the_ring_once(void)
{
    tf_worldline point = tf_worldline_between(2, (double[]){0.62, -0.95},
                                              (double[]){-0.12, 0.3});
    int hits = 0;
    for (int i = 0; i < CORNERS; i++) {
        int next = (i + 1) % CORNERS, first = next == 0 ? 0 : i;
        tf_worldline edge[2] = {corner_of_ring(first),
                                corner_of_ring(i + next - first)};
        double time = oracle_time(2, 1, &point, 2, edge);
        if (time < 0)
            continue;
        hits++;
        expect_within(0, i, "hit_edge");
        expect_within(1e-14, time, "toi");
    }
    ck_assert_int_eq(hits, 1);
}

static void the_contact_is_where_the_oracle_has_it(void)
{
    static const double ways[][4] = {{1, 3, 2, 0}, {0, 0, 0, 1}, {4, 0, 4, 2}};
    const double weight[2] = {number("barycentric_e0"),
                              number("barycentric_e1")};
    tf_worldline v[3];
    mpq_t toi, lo, hi;
    mpq_inits(toi, lo, hi, NULL);
    mpq_set_d(lo, number("toi_lo"));
    mpq_set_d(hi, number("toi_hi"));
    make_vertices(2, 3, *ways, v);
    ck_assert(oracle_meet(2, 1, v, 2, v + 1, toi));
    ck_assert(mpq_cmp(lo, toi) <= 0 && mpq_cmp(toi, hi) <= 0);

    double at[2], on[2], one = 1;
    staircase_point(2, 1, v, &one, mpq_get_d(toi), at);
    staircase_point(2, 2, v + 1, weight, mpq_get_d(toi), on);
    for (int k = 0; k < 2; k++)
        ck_assert_double_eq_tol(at[k], on[k], 1e-14);
    ck_assert_double_eq_tol(weight[0] + weight[1], 1, 1e-15);
    mpq_clears(toi, lo, hi, NULL);
}

static void one_order_meets_the_point(void)
{
    static const double ways[][4] = {
        {4.5, 0.5, 0.5, 1.5}, {0, 0, 0, 1}, {4, 0, 4, 2}};
    tf_worldline v[3];
    make_vertices(2, 3, *ways, v);
    expect(oracle_time(2, 1, v, 2, v + 1), "toi");
    tf_worldline swapped[2] = {v[2], v[1]};
    expect(oracle_time(2, 1, v, 2, swapped), "toi_swapped");
}

/// The other order does not meet.
static void one_order_is_told(void)
{
    ck_assert_str_eq(printed, "toi 0.5\n");
}

static void the_plank_kicks_the_fly(void)
{
    static const double ways[][4] = {
        {0, 1, 0, 1}, {-2, 2, -2, -2}, {2, -2, 2, 2}};
    const double middle[2] = {0.5, 0.5};
    tf_worldline v[3];
    make_vertices(2, 3, *ways, v);
    double t = oracle_time(2, 1, v, 2, v + 1), at[2], later[2], velocity[2];
    staircase_point(2, 2, v + 1, middle, t, at);
    staircase_point(2, 2, v + 1, middle, t + 0.125, later);
    // The fly, at rest, is seen from the painted point that it meets.
    for (int k = 0; k < 2; k++) {
        ck_assert_double_eq(at[k], ways[0][k]);
        velocity[k] = (at[k] - later[k]) / 0.125;
    }
    expect(t, "toi");
    expect(velocity[0], "velocity_x");
    expect(velocity[1], "velocity_y");
    expect(sqrt(0.5) * (velocity[0] + velocity[1]), "normal_velocity");
}

/// Encounters of a point with an edge.
static const struct {
    const char *key;
    double ways[3][4];
} encounters[] = {
    {"parallel",
     {{0.75, 0.25, 1, 0.875},
      {0, 0.25, 0.25, 0.875},
      {0.5, 0.25, 0.75, 0.875}}},
    {"point_like",
     {{0, 0.375, 1, 0.625},
      {0.875, 0.875, 0.125, 0.125},
      {0.875, 0.875, 0.125, 0.125}}},
    {"within_plane",
     {{0, 0.125, 1, 0.875},
      {0.25, 0.3125, 0.25, 0.3125},
      {0.75, 0.6875, 0.75, 0.6875}}},
    {"vertex",
     {{0, 0.25, 1, 0.75}, {1, 0.25, 0.875, 0.875}, {0.5, 0, 0.5, 1}}}};

static void verdicts_and_times_are_the_oracles(void)
{
    for (int i = 0; i < 4; i++) {
        tf_worldline v[3];
        make_vertices(2, 3, *encounters[i].ways, v);
        double time = oracle_time(2, 1, v, 2, v + 1);
        expect_within(0, time >= 0, "%s_hit", encounters[i].key);
        if (time >= 0)
            expect_within(1e-15, time, "%s_time", encounters[i].key);
    }
}

/// A path and a triangle on a line of space, by how far along.
static const struct flat {
    const char *key;
    double path[2], base[2], apex; ///< the path's at t = 0, 1
    int base_time;
} flats[] = {
    {"end", {0.05, 0.8}, {0.2, 0.95}, 0.5, 1},
    {"start", {0, 0.75}, {0.15, 0.9}, 0.45, 0},
    {"within", {0.3, 0.9}, {0.1, 0.85}, 0.35, 0},
};

static tf_event event_at(double place, int t)
{
    return (tf_event){.x = {place, place / 2}, .t = t};
}

/// When the path meets what the apex and one or both ends of the base span.
static double time_of_legs(const struct flat *f, int first, int last)
{
    tf_event path[2] = {event_at(f->path[0], 0), event_at(f->path[1], 1)};
    tf_event corner[3] = {event_at(f->apex, !f->base_time)};
    oracle_simplex s = {2, {&path[0], &path[1]}}, r = {1, {&corner[0]}};
    for (int i = first; i <= last; i++, r.count++) {
        corner[r.count] = event_at(f->base[i], f->base_time);
        r.event[r.count] = &corner[r.count];
    }
    return oracle_simplices_time(2, &s, &r);
}

/// A leg that is met at the first time is not told.
static void times_of_legs_are_those_of_the_oracle(void)
{
    for (const struct flat *f = flats; f < flats + 3; f++) {
        double first = time_of_legs(f, 0, 1);
        expect(first, "%s_time", f->key);
        for (int leg = 0; leg < 2; leg++) {
            double t = time_of_legs(f, leg, leg);
            ck_assert_int_eq(has_number("%s_leg_%d", f->key, leg), t > first);
            if (t > first)
                expect(t, "%s_leg_%d", f->key, leg);
        }
    }
}

// Rounded numbers -------------------------------------------------------------

enum {
    ROW = 192,
    CELLS = 256
};

static void errors_stay_in_the_band(void)
{
    double u = DBL_EPSILON / 2, y = 0.5 + ROW * u, worst = 0, step = INFINITY;
    for (int i = 0; i < CELLS; i++) {
        double x = 0.5 + i * u;
        double number = (12 - x) * (24 - y) - (12 - y) * (24 - x);
        worst = fmax(worst, fabs(number / u - 12 * (ROW - i)));
        if (number != 0)
            step = fmin(step, fabs(number / u));
    }
    expect(worst, "error");
    expect(step, "step");
    ck_assert_double_lt(worst, number("bound"));
}

/// Count the signs of one map as the figure does: negative, zero, positive,
/// unknown, wrong, opposite.
static void count_sign(int count[6], double number, double bound, int truth)
{
    int sign = (number > 0) - (number < 0);
    bool unknown = fabs(number) <= bound && bound > 0;
    count[unknown ? 3 : 1 + sign]++;
    count[4] += !unknown && sign != truth;
    count[5] += !unknown && sign * truth < 0;
}

static void signs_of_the_maps_are_counted(void)
{
    static const char *const maps[] = {"naive", "clamped", "exact"};
    static const char *const names[] = {"negative", "zero",  "positive",
                                        "unknown",  "wrong", "opposite"};
    int count[3][6] = {{0}};
    for (int i = 0; i < CELLS * CELLS; i++) {
        double x = 0.5 + i % CELLS * 0x1p-53, y = 0.5 + i / CELLS * 0x1p-53;
        // The line is x = y: the left of it is above.
        int truth = (y > x) - (y < x);
        double down = (12 - x) * (24 - y), up = (12 - y) * (24 - x);
        double bound = (3 + 0x1p-40) * DBL_EPSILON / 2 * (down + up);
        count_sign(count[0], down - up, 0, truth);
        count_sign(count[1], down - up, bound, truth);
        count_sign(count[2], truth, 0, truth);
    }
    for (int i = 0; i < 18; i++)
        expect(count[i / 6][i % 6], "%s_%s", maps[i / 6], names[i % 6]);
}

enum {
    QUERIES = 1500,
    COORDINATE_BITS = 29
};

/// x minus the time, in units of 2^-53.
static double error_of(double x, const mpq_t toi)
{
    mpq_t difference;
    mpq_init(difference);
    mpq_set_d(difference, x);
    mpq_sub(difference, difference, toi);
    double error = ldexp(mpq_get_d(difference), 53);
    mpq_clear(difference);
    return error;
}

/// The library's interval for the path of the first vertex and the triangle in
/// which the last moves; whether they meet late enough.
static bool find_interval(const tf_worldline vertex[3],
                          tf_intersection *meeting)
{
    tf_simplex path[1], sweep[2];
    tf_sweep(1, vertex, path);
    tf_sweep(2, vertex + 1, sweep);
    tf_pair pair = tf_pair_of(&path[0], &sweep[0], 2);
    return tf_complementary_intersect(&tf_exact, &pair, TF_WITH_POINT,
                                      meeting) &&
           meeting->verdict == TF_HIT && meeting->toi_lo >= 0x1p-6;
}

static void errors_are_those_from_the_true_time(void)
{
    uint64_t state = 2009;
    double widest = 0, slack = INFINITY, farthest = 0;
    mpq_t toi;
    mpq_init(toi);
    for (int found = 0; found < QUERIES;) {
        double way[3][4];
        tf_worldline v[3];
        tf_intersection meeting;
        for (int i = 0; i < 12; i++)
            way[i / 4][i % 4] =
                (double)(fig_congruent_bits(&state) >> (64 - COORDINATE_BITS));
        make_vertices(2, 3, *way, v);
        if (!find_interval(v, &meeting))
            continue;
        oracle_simplex path = oracle_step(1, v, 0);
        oracle_simplex triangle = oracle_step(2, v + 1, 1);
        ck_assert(oracle_simplices_meet(2, &path, &triangle, toi));
        double t = mpq_get_d(toi), margin = t * (6 - 3 * t);
        double low = error_of(meeting.toi_lo, toi);
        double high = error_of(meeting.toi_hi, toi);
        ck_assert_msg(low <= 0 && high >= 0, "%.17g is outside", t);
        widest = fmax(widest, high - low);
        slack = fmin(slack, fmin(-low, high) / margin);
        farthest = fmax(farthest, fmax(-low, high) / margin);
        found++;
    }
    mpq_clear(toi);
    expect(QUERIES, "queries");
    expect(widest, "widest");
    expect(slack, "slack");
    expect(farthest, "farthest");
    ck_assert_double_le(farthest, 2);
}

// Sweeps ----------------------------------------------------------------------

/// The crease is the middle of the edge at half time, in either order.
static void the_gap_is_between_the_creases(void)
{
    static const double ways[][4] = {{0, 2, 0, 0}, {3, 0, 3, 2}};
    const double half[2] = {0.5, 0.5};
    tf_worldline v[2];
    double upper[2], lower[2];
    make_vertices(2, 2, *ways, v);
    staircase_point(2, 2, v, half, 0.5, upper);
    staircase_point(2, 2, (tf_worldline[]){v[1], v[0]}, half, 0.5, lower);
    expect(hypot(upper[0] - lower[0], upper[1] - lower[1]), "gap");
}

/// How many triangles of the edge's sweep hold a point at rest, by the oracle.
static int passes_at(double x, double y)
{
    const double ways[][4] = {{x, y, x, y}, {0, 0, 0, -1}, {6, 0, 6, 1.5}};
    tf_worldline v[3];
    make_vertices(2, 3, *ways, v);
    oracle_simplex path = oracle_step(1, v, 0), sweep[2];
    int passes = 0;
    for (int pivot = 0; pivot < 2; pivot++) {
        sweep[pivot] = oracle_step(2, v + 1, pivot);
        passes += oracle_simplices_time(2, &path, &sweep[pivot]) >= 0;
    }
    return passes;
}

static void areas_are_those_of_a_grid(void)
{
    enum {
        COLUMNS = 60,
        LINES = 50
    };
    const double cell = 2.5 / LINES * 2 / COLUMNS;
    int all = 0, twice = 0;
    for (int i = 0; i < COLUMNS * LINES; i++) {
        int passes = passes_at((i % COLUMNS + 0.5) * 6 / COLUMNS,
                               (i / COLUMNS + 0.5) * 2.5 / LINES - 1);
        all += passes > 0;
        twice += passes > 1;
    }
    expect_within(0.02, all * cell, "all");
    expect_within(0.02, twice * cell, "twice");
    expect(passes_at(2.5, 0.5), "passes_between");
    expect(passes_at(5, 0.25), "passes_beyond");
}

enum {
    SAMPLES = 2000
};

/// The largest distance from a point of `from` to the closest of `to`.
static double farthest(double from[][2], double to[][2])
{
    double most = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double least = INFINITY;
        for (int j = 0; j <= SAMPLES; j++)
            least = fmin(least,
                         hypot(from[i][0] - to[j][0], from[i][1] - to[j][1]));
        most = fmax(most, least);
    }
    return most;
}

static void bent_and_straight_edges_are_so_far_apart(void)
{
    static const double ways[][4] = {{0.1, 0.75, 0.3, 0.05},
                                     {1.25, 0.15, 1.05, 0.95}};
    static double bent[SAMPLES + 1][2], straight[SAMPLES + 1][2];
    tf_worldline edge[2];
    double shift = 0;
    make_vertices(2, 2, *ways, edge);
    for (int i = 0; i <= SAMPLES; i++) {
        double s = (double)i / SAMPLES;
        staircase_point(2, 2, edge, (double[]){1 - s, s}, 0.5, bent[i]);
        for (int k = 0; k < 2; k++)
            straight[i][k] = ((1 - s) * (ways[0][k] + ways[0][2 + k]) +
                              s * (ways[1][k] + ways[1][2 + k])) /
                             2;
        shift = fmax(shift, hypot(bent[i][0] - straight[i][0],
                                  bent[i][1] - straight[i][1]));
    }
    expect_within(1e-12, shift, "shift");
    expect_within(
        1e-5, fmax(farthest(bent, straight), farthest(straight, bent)), "gap");
}

// Bent or straight edges ------------------------------------------------------

enum {
    RANDOM = 200000,
    JUDGED = 500 ///< of those, by the oracle too
};

/// The edge's ends at the time t, less the point.
static void see(const tf_worldline vertex[3], double t, double seen[2][2])
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            double at[2];
            for (int late = 0; late < 2; late++)
                at[late] =
                    vertex[i + 1].at[late].x[k] - vertex[0].at[late].x[k];
            seen[i][k] = (1 - t) * at[0] + t * at[1];
        }
}

static bool origin_within(const double a[2], const double b[2],
                          const double c[2])
{
    double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

/// Whether the bent edge meets the point: in the point's frame the origin is in
/// a triangle of the sweep.
static bool meets_bent(const tf_worldline vertex[3])
{
    double start[2][2], end[2][2];
    see(vertex, 0, start);
    see(vertex, 1, end);
    return origin_within(start[0], start[1], end[1]) ||
           origin_within(start[0], end[0], end[1]);
}

/// Whether the straight edge meets the point.
static bool meets_straight(const tf_worldline vertex[3])
{
    double x[2][3][2], toi;
    for (int i = 0; i < 12; i++)
        x[i / 6][i / 2 % 3][i % 2] = vertex[i / 2 % 3].at[i / 6].x[i % 2];
    return !boxes_apart(2, 1, vertex, 2, vertex + 1) &&
           linear_truth(2, 1, *x[0], *x[1], &toi);
}

/// Count among the figure's random points and edges.
static void expect_counts(double displacement)
{
    uint64_t state = 1;
    int hits = 0, extra = 0, fewer = 0;
    for (int i = 0; i < RANDOM; i++) {
        tf_worldline v[3];
        fig_random_vertices(&state, 2, displacement, 3, v);
        bool bent = meets_bent(v), straight = meets_straight(v);
        if (i < JUDGED)
            ck_assert(bent == (oracle_time(2, 1, v, 2, v + 1) >= 0));
        hits += bent;
        extra += bent && !straight;
        fewer += straight && !bent;
    }
    int differ = extra + fewer;
    expect((double)hits / RANDOM, "hits_%g", displacement);
    expect(extra, "extra_%g", displacement);
    expect(fewer, "fewer_%g", displacement);
    expect((double)differ / RANDOM, "differ_%g", displacement);
    expect((double)RANDOM / differ, "one_in_%g", displacement);
    expect((double)differ / hits, "share_%g", displacement);
    expect(sqrt(differ) / hits, "error_%g", displacement);
}

/// Those that the text tells.
static void counts_of_hits_are_right(void)
{
    expect_counts(0.01);
    expect_counts(0.1);
    expect_counts(1);
}

// Layers ----------------------------------------------------------------------

enum {
    MODULES = 512,
    NAME = 64
};

/// The modules of src/, found in its files themselves.
static struct module {
    char path[NAME], layer[NAME];
    bool is_public, includes[MODULES];
} modules[MODULES];

/// The layer in which the figure has a folder of src/: those of which the
/// program alone is made are one with it.
static const char *layer_of_folder(const char *folder)
{
    static const char *const of_program[] = {"files", "formats", "writers",
                                             "scenes", "simulate"};
    for (int i = 0; i < 5; i++)
        if (strcmp(folder, of_program[i]) == 0)
            return "program";
    return folder;
}

/// The module of a file.
static int module_at(const char *file)
{
    char path[NAME], folder[NAME];
    int i = 0;
    snprintf(path, sizeof path, "%.*s", (int)strcspn(file, "."), file);
    while (*modules[i].path && strcmp(modules[i].path, path) != 0)
        i++;
    ck_assert_int_lt(i + 1, MODULES);
    strcpy(modules[i].path, path);
    snprintf(folder, NAME, "%.*s", (int)strcspn(file, "/"), file);
    strcpy(modules[i].layer, layer_of_folder(folder));
    return i;
}

static void read_source(const char *path)
{
    char line[256], included[NAME];
    struct module *from = &modules[module_at(path + strlen("src/"))];
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    while (fgets(line, sizeof line, file))
        if (sscanf(line, "#include \"%63[^\"]\"", included) == 1) {
            int to = module_at(included);
            from->includes[to] = from != &modules[to];
            from->is_public |= strcmp(included, "base/api.h") == 0;
        }
    fclose(file);
}

/// The first module of the same layer.
static int first_of_layer(int module)
{
    int first = 0;
    while (strcmp(modules[first].layer, modules[module].layer) != 0)
        first++;
    return first;
}

static void read_sources(void)
{
    glob_t files;
    ck_assert_int_eq(glob("src/*/*.[ch]", 0, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++)
        read_source(files.gl_pathv[i]);
    globfree(&files);
    modules[module_at("base/api.h")].is_public = true;
}

/// A layer is known by its first module.
static void includes_are_those_of_the_sources(void)
{
    static int arrows[MODULES][MODULES], size[MODULES];
    int count = 0, api = 0, includes = 0, within = 0;
    read_sources();
    for (; *modules[count].path; count++) {
        int from = first_of_layer(count);
        size[from]++;
        api += modules[count].is_public;
        for (int i = 0; i < MODULES; i++)
            if (modules[count].includes[i]) {
                arrows[from][first_of_layer(i)]++;
                includes++;
            }
    }
    for (int i = 0; i < count; i++) {
        if (size[i] > 0)
            expect(size[i], "%s_modules", modules[i].layer);
        within += arrows[i][i];
        for (int j = 0; j < count; j++) {
            const char *from = modules[i].layer, *to = modules[j].layer;
            if (i == j || arrows[i][j] == 0)
                continue;
            expect(arrows[i][j], "%s_%s", from, to);
            ck_assert_msg(!has_number("%s_%s", to, from), "%s is below %s", to,
                          from);
        }
    }
    expect(count, "modules");
    expect(api, "public");
    expect(includes, "includes");
    expect(within, "within");
    expect(includes - within, "down");
}

const figure_test plane_tests[] = {
    {&fig_cover, the_point_enters_the_ring_once},
    {&fig_edge_sweep, the_contact_is_where_the_oracle_has_it},
    {&fig_error_band, errors_stay_in_the_band},
    {&fig_layers, includes_are_those_of_the_sources},
    {&fig_coplanar_path, times_of_legs_are_those_of_the_oracle},
    {&fig_model_disagreement, counts_of_hits_are_right},
    {&fig_degenerate_point_edge, verdicts_and_times_are_the_oracles},
    {&fig_turning_plank, the_plank_kicks_the_fly},
    {&fig_sign_maps, signs_of_the_maps_are_counted},
    {&fig_staircase_patch, bent_and_straight_edges_are_so_far_apart},
    {&fig_edge_orders_moving, one_order_meets_the_point},
    {&fig_swept_edge, the_gap_is_between_the_creases},
    {&fig_swept_twice, areas_are_those_of_a_grid},
    {&fig_time_margins, errors_are_those_from_the_true_time},
    {&fig_edge_orders, one_order_is_told},
    {NULL, NULL}};
