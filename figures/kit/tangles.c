#include "kit/tangles.h"

#include "base/require.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum {
    VERTICES_MOST = 6000,
    TRIANGLES_MOST = 12000
};

static const double tau = 6.283185307179586;

static int add_vertex(fig_some_mesh *mesh, double x, double y, double z)
{
    TF_REQUIRE(mesh->vertices < VERTICES_MOST);
    double *at = mesh->x + 3 * (ptrdiff_t)mesh->vertices;
    at[0] = x;
    at[1] = y;
    at[2] = z;
    return mesh->vertices++;
}

static void add_triangle(fig_some_mesh *mesh, int a, int b, int c)
{
    TF_REQUIRE(mesh->triangles < TRIANGLES_MOST);
    int *at = mesh->triangle + 3 * (ptrdiff_t)mesh->triangles++;
    at[0] = a;
    at[1] = b;
    at[2] = c;
}

// Sheets ---------------------------------------------------------------------

/// Two ways from the middle of a sheet to its sides, and the third axis.
typedef struct sheet {
    double middle[3], along[3], across[3], up[3];
    int columns, rows; ///< of squares
    /// How far it bulges along the third axis at a and b, -1 to 1; NULL: it is
    /// flat.
    double (*bulge)(double a, double b);
} sheet;

static void place_on_sheet(fig_some_mesh *mesh, const sheet *s, double a,
                           double b)
{
    double at[3], height = s->bulge ? s->bulge(a, b) : 0;
    for (int k = 0; k < 3; k++)
        at[k] = s->middle[k] + a * s->along[k] + b * s->across[k] +
                height * s->up[k];
    add_vertex(mesh, at[0], at[1], at[2]);
}

/// Add a sheet, its squares cut in two by turns.
static void add_sheet(fig_some_mesh *mesh, const sheet *s)
{
    int first = mesh->vertices;
    for (int i = 0; i <= s->rows; i++)
        for (int j = 0; j <= s->columns; j++)
            place_on_sheet(mesh, s, 2. * j / s->columns - 1,
                           2. * i / s->rows - 1);
    for (int i = 0; i < s->rows; i++)
        for (int j = 0; j < s->columns; j++) {
            int a = first + i * (s->columns + 1) + j, b = a + s->columns + 1;
            bool falls = (i + j) % 2;
            add_triangle(mesh, a, a + 1, falls ? b : b + 1);
            add_triangle(mesh, falls ? a + 1 : a, b + 1, b);
        }
}

/// A flat one, turned about the y axis, an angle in degrees.
static void add_turned_sheet(fig_some_mesh *mesh, double height, double angle,
                             double half, int squares)
{
    double c = cos(angle * tau / 360), s = sin(angle * tau / 360);
    add_sheet(mesh, &(sheet){.middle = {0.013, 0.007, height},
                             .along = {half * c, 0, half * s},
                             .across = {0, half, 0},
                             .columns = squares,
                             .rows = squares});
}

// Tubes ----------------------------------------------------------------------

/// Where the point of a tube is at u along its axis, 0 to 1, and at an angle
/// around it.
typedef void tube_place(const void *context, double u, double angle,
                        double at[3]);

/// Join two rings of vertices by triangles; a ring of one is a pole.
static void join_rings(fig_some_mesh *mesh, int lower, int lowers, int upper,
                       int uppers)
{
    for (int i = 0, j = 0;
         i < lowers * (lowers > 1) || j < uppers * (uppers > 1);) {
        double next_i = lowers > 1 ? (i + 1.) / lowers : 2;
        double next_j = uppers > 1 ? (j + 1.) / uppers : 2;
        int a = lower + i % lowers, b = upper + j % uppers;
        if (next_i <= next_j) {
            add_triangle(mesh, a, lower + ++i % lowers, b);
        } else {
            add_triangle(mesh, a, upper + ++j % uppers, b);
        }
    }
}

/// Add a tube of rings of `around` vertices or, where it tapers, of fewer.
static void add_tube(fig_some_mesh *mesh, int rings, const int around[],
                     tube_place *place, const void *context)
{
    int last = 0;
    for (int i = 0; i < rings; i++) {
        int first = mesh->vertices;
        for (int j = 0; j < around[i]; j++) {
            double at[3];
            place(context, (double)i / (rings - 1), tau * j / around[i], at);
            add_vertex(mesh, at[0], at[1], at[2]);
        }
        if (i > 0)
            join_rings(mesh, last, around[i - 1], first, around[i]);
        last = first;
    }
}

/// An ellipsoid.
typedef struct ball {
    double middle[3], radius[3];
} ball;

static void place_on_ball(const void *context, double u, double angle,
                          double at[3])
{
    const ball *b = context;
    double r = sin(u * tau / 2);
    const double way[3] = {r * cos(angle), r * sin(angle), -cos(u * tau / 2)};
    for (int k = 0; k < 3; k++)
        at[k] = b->middle[k] + b->radius[k] * way[k];
}

static void add_ball(fig_some_mesh *mesh, const ball *b, int quarter)
{
    int around[64], rings = 2 * quarter + 1;
    for (int i = 0; i < rings; i++) {
        int k = i < quarter ? i : rings - 1 - i;
        around[i] = k == 0 ? 1 : 6 * k;
        if (around[i] > 4 * quarter)
            around[i] = 4 * quarter;
    }
    add_tube(mesh, rings, around, place_on_ball, b);
}

/// A limb: a tube with round ends along a straight line.
typedef struct limb {
    double from[3], to[3], radius;
    int rings;
} limb;

/// How far along the limb a ring is, and how wide: quarters of circles at both
/// ends.
static void find_profile(const limb *l, double length, double u, double *s,
                         double *r)
{
    const double cap = 4;
    double i = u * (l->rings - 1), last = l->rings - 1;
    double turn = fmin(fmin(i, last - i) / cap, 1) * tau / 4;
    *r = l->radius * sin(turn);
    *s = i <= cap          ? -l->radius * cos(turn)
         : last - i <= cap ? length + l->radius * cos(turn)
                           : length * (i - cap) / (last - 2 * cap);
}

static void place_on_limb(const void *context, double u, double angle,
                          double at[3])
{
    const limb *l = context;
    double way[3], a[3] = {0, 1, 0}, b[3], length = 0, dot = 0;
    for (int k = 0; k < 3; k++)
        length += (l->to[k] - l->from[k]) * (l->to[k] - l->from[k]);
    length = sqrt(length);
    for (int k = 0; k < 3; k++) {
        way[k] = (l->to[k] - l->from[k]) / length;
        dot += way[k] * a[k];
    }
    double rest = sqrt(1 - dot * dot);
    for (int k = 0; k < 3; k++)
        a[k] = (a[k] - dot * way[k]) / rest;
    for (int k = 0; k < 3; k++)
        b[k] = way[(k + 1) % 3] * a[(k + 2) % 3] -
               way[(k + 2) % 3] * a[(k + 1) % 3];
    double s, r;
    find_profile(l, length, u, &s, &r);
    for (int k = 0; k < 3; k++)
        at[k] = l->from[k] + s * way[k] +
                r * (cos(angle) * a[k] + sin(angle) * b[k]);
}

static void add_limb(fig_some_mesh *mesh, const limb *l, int around)
{
    int count[64];
    for (int i = 0; i < l->rings; i++)
        count[i] = i == 0 || i == l->rings - 1 ? 1 : around;
    add_tube(mesh, l->rings, count, place_on_limb, l);
}

/// A line that passes through itself once, at s from -1 to 1.
static void place_on_line(double s, double at[2])
{
    at[0] = 2.2 * s * (s * s - 0.5);
    at[1] = 1.5 * s * s;
}

/// A tube along that line.
static void place_on_loop(const void *context, double u, double angle,
                          double at[3])
{
    const double radius = *(const double *)context, tiny = 1e-4;
    double s = 2 * u - 1, before[2], after[2], middle[2];
    place_on_line(s, middle);
    place_on_line(s - tiny, before);
    place_on_line(s + tiny, after);
    double x = after[0] - before[0], y = after[1] - before[1];
    double length = sqrt(x * x + y * y);
    at[0] = middle[0] + radius * cos(angle) * y / length;
    at[1] = middle[1] - radius * cos(angle) * x / length;
    at[2] = radius * sin(angle) + 0.06 * s;
}

// The tangles ----------------------------------------------------------------

static double hill(double a, double b)
{
    return exp(-7 * (a * a + b * b));
}

static double wave(double a, double b)
{
    return 0.12 * sin(5.3 * a + 0.4) * cos(4.1 * b);
}

static void make_sheets_10(fig_some_mesh *mesh)
{
    add_turned_sheet(mesh, 0, 0, 1, 16);
    add_turned_sheet(mesh, 0.011, 10, 0.9, 15);
}

static void make_half_way(fig_some_mesh *mesh)
{
    add_turned_sheet(mesh, 0, 0, 1, 16);
    int first = mesh->vertices;
    add_turned_sheet(mesh, 0.011, 78, 0.8, 13);
    for (int i = first; i < mesh->vertices; i++) {
        mesh->x[3 * (ptrdiff_t)i + 1] -= 0.93;
        mesh->x[3 * (ptrdiff_t)i] += 0.06 * mesh->x[3 * (ptrdiff_t)i + 1];
    }
}

static void make_bump(fig_some_mesh *mesh)
{
    add_turned_sheet(mesh, 0, 0, 1, 20);
    add_sheet(mesh, &(sheet){.middle = {0.02, 0.03, -0.32},
                             .along = {1, 0, 0},
                             .across = {0, 1, 0},
                             .up = {0, 0, 0.7},
                             .columns = 21,
                             .rows = 21,
                             .bulge = hill});
}

static void make_cloth_and_ball(fig_some_mesh *mesh)
{
    add_ball(mesh, &(ball){{0, 0, 0}, {0.55, 0.55, 0.55}}, 7);
    add_sheet(mesh, &(sheet){.middle = {0.013, 0.007, 0.17},
                             .along = {1.1, 0.05, 0},
                             .across = {-0.05, 1.1, 0},
                             .up = {0, 0, 0.5},
                             .columns = 24,
                             .rows = 24,
                             .bulge = wave});
}

static void make_arm_in_torso(fig_some_mesh *mesh)
{
    add_ball(mesh, &(ball){{0, 0, 0}, {0.6, 0.45, 0.9}}, 8);
    add_limb(mesh, &(limb){{1.1, 0.03, 0.6}, {0.35, 0.05, -0.1}, 0.17, 20}, 14);
}

static void make_arm_through_torso(fig_some_mesh *mesh)
{
    add_ball(mesh, &(ball){{0, 0, 0}, {0.55, 0.45, 0.9}}, 8);
    add_limb(mesh, &(limb){{-1.05, 0.03, 0.3}, {1.05, 0.05, 0.1}, 0.17, 28},
             14);
}

static void make_loop(fig_some_mesh *mesh)
{
    int around[52];
    double radius = 0.2;
    for (int i = 0; i < 52; i++)
        around[i] = i == 0 || i == 51 ? 1 : 12;
    add_tube(mesh, 52, around, place_on_loop, &radius);
}

static void make_layers(fig_some_mesh *mesh)
{
    static const double angle[] = {0, 3, -4, 6, -2};
    for (int i = 0; i < 5; i++) {
        double c = cos(angle[i] * tau / 360), s = sin(angle[i] * tau / 360);
        add_sheet(mesh, &(sheet){.middle = {0.01 * i, -0.007 * i, 0.03 * i},
                                 .along = {c, 0, s},
                                 .across = {0, 1, i % 2 ? 0.05 : -0.04},
                                 .up = {0, 0, i % 2 ? 0.5 : -0.4},
                                 .columns = 14 + i,
                                 .rows = 15,
                                 .bulge = wave});
    }
}

static void make_balls(fig_some_mesh *mesh)
{
    for (int i = 0; i < 6; i++) {
        double turn = tau * i / 6;
        add_ball(mesh,
                 &(ball){{0.55 * cos(turn), 0.55 * sin(turn), 0.09 * (i % 3)},
                         {0.36, 0.36, 0.36}},
                 5);
    }
}

/// A sheet each vertex of which was moved by chance.
static void make_crumple(fig_some_mesh *mesh)
{
    add_turned_sheet(mesh, 0, 0, 1, 20);
    unsigned state = 20;
    for (int i = 0; i < 3 * mesh->vertices; i++) {
        state = state * 1664525u + 1013904223u;
        mesh->x[i] += 0.16 * ((state >> 8) / 16777216. - 0.5);
    }
}

/// A sheet whose sides have been folded through its middle.
static void make_fold(fig_some_mesh *mesh)
{
    add_turned_sheet(mesh, 0, 0, 1, 24);
    for (int i = 0; i < mesh->vertices; i++) {
        double *at = mesh->x + 3 * (ptrdiff_t)i, line[2];
        place_on_line(0.9 * at[0] + 0.01, line);
        at[1] += 0.07 * at[0];
        at[0] = line[0] + 0.03 * at[1];
        at[2] = line[1];
    }
}

static void make_bottle(fig_some_mesh *mesh)
{
    enum {
        N = 36,
        M = 18
    };
    int first = mesh->vertices;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            double u = tau * i / N, v = tau * (j + 0.5) / M;
            double r =
                0.55 + 0.22 * (cos(u / 2) * sin(v) - sin(u / 2) * sin(2 * v));
            add_vertex(mesh, r * cos(u), r * sin(u),
                       0.4 * (sin(u / 2) * sin(v) + cos(u / 2) * sin(2 * v)));
        }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < M; j++) {
            int k = (j + 1) % M, next = i + 1;
            // Around once, v has become -v.
            int a = first + i * M + j, b = first + i * M + k;
            int c = next < N ? a + M : first + (2 * M - 1 - j) % M;
            int d = next < N ? b + M : first + (2 * M - 1 - k) % M;
            add_triangle(mesh, a, c, b);
            add_triangle(mesh, b, c, d);
        }
}

static const struct {
    const char *name;
    void (*make)(fig_some_mesh *mesh);
    double azimuth, elevation;
} makers[] = {
    {"bump", make_bump, 25, 24},
    {"cloth and ball", make_cloth_and_ball, 25, 24},
    {"arm in torso", make_arm_in_torso, 25, 24},
    {"arm through torso", make_arm_through_torso, 25, 24},
    {"loop", make_loop, 10, 50},
    {"fold", make_fold, 30, 32},
    {"sheets at 10", make_sheets_10, 25, 24},
    {"half way in", make_half_way, 35, 24},
    {"five layers", make_layers, 25, 24},
    {"six balls", make_balls, 25, 24},
    {"crumple", make_crumple, 25, 24},
    {"Klein bottle", make_bottle, 25, 24},
};

const char *fig_tangle_name(int i)
{
    return i < (int)(sizeof makers / sizeof *makers) ? makers[i].name : NULL;
}

fig_tangle fig_tangle_make(const char *name)
{
    size_t i = 0;
    while (strcmp(makers[i].name, name) != 0)
        TF_REQUIRE(++i < sizeof makers / sizeof *makers);
    fig_tangle tangle = {0};
    tangle.mesh.x = malloc((size_t)3 * VERTICES_MOST * sizeof *tangle.mesh.x);
    tangle.mesh.triangle =
        malloc((size_t)3 * TRIANGLES_MOST * sizeof *tangle.mesh.triangle);
    TF_REQUIRE(tangle.mesh.x && tangle.mesh.triangle);
    makers[i].make(&tangle.mesh);
    tangle.camera = (fig_camera){.azimuth = makers[i].azimuth,
                                 .elevation = makers[i].elevation};
    return tangle;
}

void fig_tangle_free(fig_tangle *tangle)
{
    fig_some_mesh_free(&tangle->mesh);
    free(tangle->fixed);
    *tangle = (fig_tangle){0};
}
