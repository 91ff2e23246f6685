#include "support/proposals.h"

#include "support/support.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

const char *const proposal_shapes[PROPOSAL_SHAPES] = {
    "lone triangle", "sheets", "balls", "loops", "chains", "rods and specks"};
const char *const proposal_ways[PROPOSAL_WAYS] = {
    "scattered",   "spiked",   "to a point", "inside out", "flattened",
    "turned over", "shuffled", "rotated",    "carried",    "resting"};

enum {
    ALL = PROPOSAL_SHAPES * PROPOSAL_WAYS
};

int proposal_tries(void)
{
    return cases(ALL) < ALL ? PROPOSAL_WAYS : ALL;
}

int proposal_number(int i)
{
    return cases(ALL) < ALL ? i % PROPOSAL_SHAPES * PROPOSAL_WAYS + i : i;
}

static const double pi = 3.141592653589793;

// Starts ----------------------------------------------------------------------

void proposal_begin(proposal *made, int axes)
{
    made->mesh =
        (tf_mesh){.axes = axes, .triangle = made->triangle, .edge = made->edge};
    made->unit = 1;
}

int proposal_add_vertex(proposal *made, double x, double y, double z)
{
    int v = made->mesh.vertices++, axes = made->mesh.axes;
    if (v >= PROPOSAL_VERTICES)
        abort();
    made->inverse_mass[v] = 1;
    const double place[] = {x, y, z};
    for (int k = 0; k < axes; k++)
        made->start[axes * v + k] = made->end[axes * v + k] = place[k];
    return v;
}

void proposal_add_triangle(proposal *made, int a, int b, int c)
{
    if (made->mesh.triangles >= PROPOSAL_TRIANGLES)
        abort();
    int *corner = made->triangle + 3 * made->mesh.triangles++;
    corner[0] = a, corner[1] = b, corner[2] = c;
}

void proposal_add_edge(proposal *made, int a, int b)
{
    if (made->mesh.edges >= PROPOSAL_EDGES)
        abort();
    int *corner = made->edge + 2 * made->mesh.edges++;
    corner[0] = a, corner[1] = b;
}

static void make_lone_triangle(generator *random, proposal *made)
{
    int corner[3];
    for (int i = 0; i < 3; i++)
        corner[i] =
            proposal_add_vertex(made, cos(2 * pi * i / 3), sin(2 * pi * i / 3),
                                uniform(random, 0, 0.5));
    for (int i = 0; i < 3 && made->mesh.axes == 2; i++)
        proposal_add_edge(made, corner[i], corner[(i + 1) % 3]);
    if (made->mesh.axes == 3)
        proposal_add_triangle(made, corner[0], corner[1], corner[2]);
}

/// The height of a hilly sheet.
static double hill(double x, double y)
{
    return 0.6 * sin(0.9 * x) * cos(0.7 * y + 1);
}

int proposal_add_sheet(proposal *made, int n, double height)
{
    int first = made->mesh.vertices;
    for (int j = 0; j <= n; j++)
        for (int i = 0; i <= n; i++)
            proposal_add_vertex(made, i, j, height);
    for (int j = 0; j < n; j++)
        for (int i = 0; i < n; i++) {
            int v = first + j * (n + 1) + i;
            proposal_add_triangle(made, v, v + 1, v + n + 2);
            proposal_add_triangle(made, v, v + n + 2, v + n + 1);
        }
    return first;
}

/// Level if `rough` is 0.
static void add_rough_sheet(generator *random, int n, double height,
                            double rough, proposal *made)
{
    int first = proposal_add_sheet(made, n, height);
    for (int v = first; v < made->mesh.vertices; v++) {
        double *x = made->start + 3 * v;
        for (int k = 0; k < 2; k++)
            x[k] += rough * uniform(random, -0.2, 0.2);
        x[2] += rough * hill(x[0], x[1]);
    }
}

static void make_sheets(generator *random, int size, proposal *made)
{
    double gap = ldexp(1, -below(random, 6)), rough = below(random, 2);
    for (int i = 0; i < 2 + below(random, 2); i++)
        add_rough_sheet(random, 2 * size, i * gap, rough * gap, made);
}

/// Star-shaped about the origin: an octahedron's upper and lower half, each a
/// fan of rings.
static void add_ball(generator *random, int rings, double radius,
                     double roughness, proposal *made)
{
    int sectors = 2 * rings, first = made->mesh.vertices;
    for (int r = 1; r < rings; r++)
        for (int s = 0; s < sectors; s++) {
            double up = pi * r / rings, around = pi * s / rings;
            double reach = radius + uniform(random, 0, roughness);
            proposal_add_vertex(made, reach * sin(up) * cos(around),
                                reach * sin(up) * sin(around),
                                -reach * cos(up));
        }
    int bottom = proposal_add_vertex(made, 0, 0, -radius);
    int top = proposal_add_vertex(made, 0, 0, radius);
    for (int s = 0; s < sectors; s++) {
        int next = (s + 1) % sectors;
        int below_top = first + (rings - 2) * sectors;
        proposal_add_triangle(made, bottom, first + next, first + s);
        proposal_add_triangle(made, top, below_top + s, below_top + next);
        for (int v = first; v < below_top; v += sectors) {
            proposal_add_triangle(made, v + s, v + next, v + next + sectors);
            proposal_add_triangle(made, v + s, v + next + sectors,
                                  v + s + sectors);
        }
    }
}

static void make_balls(generator *random, int size, proposal *made)
{
    int rings = 2 + size;
    double radius = rings / pi, roughness = uniform(random, 0, 0.3);
    add_ball(random, rings, radius, roughness, made);
    if (below(random, 2))
        add_ball(random, rings, radius * 0.4, 0.2 * roughness, made);
}

static void add_loop(generator *random, int edges, double radius,
                     proposal *made)
{
    int first = made->mesh.vertices;
    for (int i = 0; i < edges; i++) {
        double reach = radius + uniform(random, 0, 0.1) * radius;
        double around = 2 * pi * i / edges;
        proposal_add_vertex(made, reach * cos(around), reach * sin(around), 0);
        proposal_add_edge(made, first + i, first + (i + 1) % edges);
    }
}

static void make_loops(generator *random, int size, proposal *made)
{
    int edges = 4 + 6 * size;
    for (int i = 0; i < 1 + below(random, 4); i++)
        add_loop(random, edges, edges / (2 * pi) * pow(0.6, i), made);
}

static void make_chains(generator *random, int size, proposal *made)
{
    double gap = ldexp(1, -below(random, 6));
    for (int c = 0; c < 2 + below(random, 3); c++)
        for (int i = 0; i <= 5 * size; i++) {
            int v =
                proposal_add_vertex(made, i, gap * c + 0.4 * sin(0.8 * i), 0);
            if (i > 0)
                proposal_add_edge(made, v - 1, v);
        }
}

static void make_rods_and_specks(generator *random, int size, proposal *made)
{
    add_rough_sheet(random, 2 * size, 0, 1, made);
    for (int i = 0; i < 4 * size; i++) {
        double x = 2.0 * size * i / (4 * size), lean = uniform(random, -1, 1);
        int low = proposal_add_vertex(made, x, uniform(random, 0, 2 * size), 1);
        int high = proposal_add_vertex(made, x, lean, 2);
        proposal_add_edge(made, low, high);
        proposal_add_vertex(made, uniform(random, 0, 2 * size),
                            uniform(random, 0, 2 * size),
                            uniform(random, 2.1, 3));
    }
}

// Proposals -------------------------------------------------------------------

static void find_middle(const proposal *made, double middle[3])
{
    int axes = made->mesh.axes;
    memset(middle, 0, 3 * sizeof *middle);
    for (int i = 0; i < axes * made->mesh.vertices; i++)
        middle[i % axes] += made->start[i] / made->mesh.vertices;
}

/// A direction of length 1; along an axis half of the time.
static void random_direction(generator *random, int axes, double direction[3])
{
    double square = 0;
    int along = below(random, 2) ? below(random, axes) : axes;
    for (int k = 0; k < axes; k++) {
        direction[k] = along == axes ? uniform(random, -1, 1) : k == along;
        square += direction[k] * direction[k];
    }
    for (int k = 0; k < axes; k++)
        direction[k] /= sqrt(square);
}

/// Adds `factor` times the distance from a plane through the middle, 0 to 2.
static void press(generator *random, double factor, proposal *made)
{
    int axes = made->mesh.axes;
    double middle[3], normal[3];
    find_middle(made, middle);
    random_direction(random, axes, normal);
    for (int v = 0; v < made->mesh.vertices; v++) {
        double *x = made->end + axes * v, height = 0;
        for (int k = 0; k < axes; k++)
            height += normal[k] * (x[k] - middle[k]);
        for (int k = 0; k < axes; k++)
            x[k] -= factor * height * normal[k];
    }
}

/// From the middle outward, by a factor.
static void spread(double factor, proposal *made)
{
    double middle[3];
    find_middle(made, middle);
    for (int i = 0; i < made->mesh.axes * made->mesh.vertices; i++) {
        double center = middle[i % made->mesh.axes];
        made->end[i] =
            factor == 0 ? center : center + factor * (made->start[i] - center);
    }
}

static void scatter(generator *random, proposal *made)
{
    double reach = made->unit * ldexp(8, -below(random, 8));
    for (int i = 0; i < made->mesh.axes * made->mesh.vertices; i++)
        made->end[i] += uniform(random, -reach, reach);
}

static void spike(generator *random, proposal *made)
{
    int axes = made->mesh.axes;
    for (int i = 0; i < 1 + below(random, 3); i++) {
        double way[3];
        int v = below(random, made->mesh.vertices);
        random_direction(random, axes, way);
        for (int k = 0; k < axes; k++)
            made->end[axes * v + k] += 100 * made->unit * way[k];
    }
}

static void shuffle(generator *random, proposal *made)
{
    int axes = made->mesh.axes;
    for (int v = made->mesh.vertices - 1; v > 0; v--) {
        int other = below(random, v + 1);
        for (int k = 0; k < axes; k++) {
            double *a = made->end + axes * v + k;
            double *b = made->end + axes * other + k, swapped = *a;
            *a = *b;
            *b = swapped;
        }
    }
}

static void rotate(generator *random, proposal *made)
{
    int axes = made->mesh.axes, first = below(random, axes);
    int second = (first + 1) % axes;
    double middle[3], angle = uniform(random, -pi, pi);
    find_middle(made, middle);
    for (int v = 0; v < made->mesh.vertices; v++) {
        double *x = made->end + axes * v;
        double a = x[first] - middle[first], b = x[second] - middle[second];
        x[first] = middle[first] + cos(angle) * a - sin(angle) * b;
        x[second] = middle[second] + sin(angle) * a + cos(angle) * b;
    }
}

static void carry(generator *random, proposal *made)
{
    double way[3], far = made->unit * ldexp(1, below(random, 60));
    random_direction(random, made->mesh.axes, way);
    for (int i = 0; i < made->mesh.axes * made->mesh.vertices; i++)
        made->end[i] += far * way[i % made->mesh.axes];
}

static void propose(generator *random, proposal_way way, proposal *made)
{
    memcpy(made->end, made->start, sizeof made->end);
    switch (way) {
    case SCATTERED:
        scatter(random, made);
        break;
    case SPIKED:
        spike(random, made);
        break;
    case TO_A_POINT:
        spread(0, made);
        break;
    case INSIDE_OUT:
        spread(uniform(random, -2, -0.5), made);
        break;
    case FLATTENED:
        press(random, 1, made);
        break;
    case TURNED_OVER:
        press(random, 2, made);
        break;
    case SHUFFLED:
        shuffle(random, made);
        break;
    case ROTATED:
        rotate(random, made);
        break;
    case CARRIED:
        carry(random, made);
        break;
    case RESTING:
        break;
    }
}

// Both ------------------------------------------------------------------------

static void renumber_vertices(const int place[], int count, int vertex[])
{
    for (int i = 0; i < count; i++)
        vertex[i] = place[vertex[i]];
}

/// Gives the vertices another order: answers depend on it.
static void renumber(generator *random, proposal *made)
{
    int place[PROPOSAL_VERTICES] = {0}, count = made->mesh.vertices;
    int axes = made->mesh.axes;
    static double start[3 * PROPOSAL_VERTICES];
    for (int v = 0; v < count; v++) {
        int other = below(random, v + 1);
        place[v] = place[other];
        place[other] = v;
    }
    memcpy(start, made->start, sizeof start);
    for (int v = 0; v < count; v++)
        memcpy(made->start + axes * place[v], start + axes * v,
               sizeof(double) * (size_t)axes);
    renumber_vertices(place, 3 * made->mesh.triangles, made->triangle);
    renumber_vertices(place, 2 * made->mesh.edges, made->edge);
}

static void start(generator *random, proposal_shape shape, int size,
                  proposal *made)
{
    bool plane = shape == LOOPS || shape == CHAINS ||
                 (shape == LONE_TRIANGLE && below(random, 2));
    made->mesh = (tf_mesh){
        .axes = plane ? 2 : 3, .triangle = made->triangle, .edge = made->edge};
    switch (shape) {
    case LONE_TRIANGLE:
        make_lone_triangle(random, made);
        break;
    case SHEETS:
        make_sheets(random, size, made);
        break;
    case BALLS:
        make_balls(random, size, made);
        break;
    case LOOPS:
        make_loops(random, size, made);
        break;
    case CHAINS:
        make_chains(random, size, made);
        break;
    case RODS_AND_SPECKS:
        make_rods_and_specks(random, size, made);
        break;
    }
}

/// Slants and scales the start, but not always, and moves it away from the
/// origin.
static void place(generator *random, proposal *made)
{
    int axes = made->mesh.axes;
    double unit = below(random, 2) ? 1 : uniform(random, 0.01, 100);
    double slant = below(random, 2) * uniform(random, -0.5, 0.5);
    double away = below(random, 2) * ldexp(1, below(random, 20));
    for (int v = 0; v < made->mesh.vertices; v++) {
        double *x = made->start + axes * v;
        for (int k = 1; k < axes; k++)
            x[k] += slant * x[k - 1];
        for (int k = 0; k < axes; k++)
            x[k] = unit * (x[k] + away);
    }
    made->unit = unit;
}

void proposal_make(generator *random, proposal_shape shape, int size,
                   proposal_way way, proposal *made)
{
    start(random, shape, size, made);
    place(random, made);
    renumber(random, made);
    propose(random, way, made);
}

/// Scripts all vertices on one side of another one.
static void script_side(generator *random, proposal *made)
{
    int axes = made->mesh.axes, k = below(random, axes);
    double to = made->start[axes * below(random, made->mesh.vertices) + k];
    for (int v = 0; v < made->mesh.vertices; v++)
        if (made->start[axes * v + k] < to)
            made->inverse_mass[v] = 0;
}

void proposal_weigh(generator *random, proposal *made)
{
    double scripted = uniform(random, 0, 0.5);
    for (int v = 0; v < made->mesh.vertices; v++)
        made->inverse_mass[v] =
            uniform(random, 0, 1) < scripted ? 0 : uniform(random, 0.1, 10);
    if (below(random, 3) == 0)
        script_side(random, made);
}
