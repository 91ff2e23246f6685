// Scripted limbs that press cloth against a scripted body, one that comes down
// and one that turns: what is proposed, and how far they get.
#include "base/require.h"
#include "kit/figures.h"

#include "renderer/plot.h"
#include "response/resolve.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    CLOTH = 17,
    BODY = 2,
    COLUMNS = 9, ///< of the limb, each of two vertices
    LIMB = 2 * COLUMNS,
    VERTICES = BODY + CLOTH + LIMB,
    EDGES = 1 + CLOTH - 1 + 2 * (COLUMNS - 1) + 2,
    NUMBERS = 2 * VERTICES,
    FIRST = BODY + CLOTH, ///< vertex of the limb
    PANELS = 2
};

/// The body's top, the cloth above it, and the limb above that.
static const double body_half = 1.5, cloth_half = 1.3, cloth_at = 0.12;
static const double limb_at = 0.5, limb_width = 0.3, limb_from = -1,
                    limb_length = 2.4;

/// How far the limb should come down, or turn about its end on the left.
static const double down = 1, turn = 0.75;

typedef struct scene {
    tf_mesh mesh;
    int edge[2 * EDGES];
    double start[NUMBERS], proposed[NUMBERS], end[NUMBERS];
    double inverse_mass[VERTICES], followed[VERTICES];
    double least; ///< fraction followed
} scene;

// The scenes ------------------------------------------------------------------

static void add_edge(scene *s, int a, int b)
{
    int *edge = s->edge + 2 * (ptrdiff_t)s->mesh.edges++;
    edge[0] = a;
    edge[1] = b;
}

static void place(scene *s, int vertex, double x, double y)
{
    s->start[2 * (ptrdiff_t)vertex] = x;
    s->start[2 * vertex + 1] = y;
}

static void make_body_and_cloth(scene *s)
{
    for (int v = 0; v < BODY; v++)
        place(s, v, v == 0 ? -body_half : body_half, 0);
    add_edge(s, 0, 1);
    for (int i = 0; i < CLOTH; i++) {
        int v = BODY + i;
        double along = 2. * i / (CLOTH - 1) - 1;
        place(s, v, cloth_half * along, cloth_at + 0.03 * (i % 2));
        s->inverse_mass[v] = 1;
        if (i > 0)
            add_edge(s, v - 1, v);
    }
}

static void make_limb(scene *s)
{
    for (int i = 0; i < COLUMNS; i++)
        for (int j = 0; j < 2; j++) {
            int v = FIRST + 2 * i + j;
            place(s, v, limb_from + limb_length * i / (COLUMNS - 1),
                  limb_at + limb_width * j);
            if (i > 0)
                add_edge(s, v - 2, v);
        }
    add_edge(s, FIRST, FIRST + 1);
    add_edge(s, VERTICES - 2, VERTICES - 1);
}

/// Where a vertex of the limb should end.
static void propose(const double x[2], bool turns, double to[2])
{
    double c = cos(turn), z = sin(turn);
    double dx = x[0] - limb_from, dy = x[1] - limb_at;
    to[0] = turns ? limb_from + c * dx + z * dy : x[0];
    to[1] = turns ? limb_at - z * dx + c * dy : x[1] - down;
}

static void make_scene(scene *s, bool turns)
{
    memset(s, 0, sizeof *s);
    s->mesh = (tf_mesh){.axes = 2, .vertices = VERTICES, .edge = s->edge};
    make_body_and_cloth(s);
    make_limb(s);
    memcpy(s->proposed, s->start, sizeof s->start);
    for (int v = FIRST; v < VERTICES; v++)
        propose(s->start + 2 * (ptrdiff_t)v, turns,
                s->proposed + 2 * (ptrdiff_t)v);
}

static void resolve(scene *s)
{
    const tf_response_report *report;
    tf_surface *surface;
    tf_resolver *resolver;
    memcpy(s->end, s->proposed, sizeof s->end);
    TF_REQUIRE(tf_surface_create(&s->mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    TF_REQUIRE(tf_step_resolve(resolver, VERTICES, s->start, s->end,
                               s->inverse_mass, NULL, &report, NULL) == TF_OK);
    s->least = report->followed;
    memcpy(s->followed, tf_resolver_followed(resolver), sizeof s->followed);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

// Drawing ---------------------------------------------------------------------

static fig_role role_of(int vertex)
{
    return vertex < BODY    ? FIG_ROLE_INK
           : vertex < FIRST ? FIG_ROLE_POINT
                            : FIG_ROLE_EDGE;
}

static void draw_edges(fig_page *page, const fig_plot *plot, const scene *s,
                       const double x[], int from, double shade)
{
    for (int e = 0; e < s->mesh.edges; e++) {
        const int *edge = s->edge + 2 * (ptrdiff_t)e;
        const double *a = x + 2 * (ptrdiff_t)edge[0],
                     *b = x + 2 * (ptrdiff_t)edge[1];
        if (edge[0] < from)
            continue;
        fig_plot_curve(
            page, plot, 2, (fig_point[]){{a[0], a[1]}, {b[0], b[1]}},
            (fig_stroke){.paint = {.role = role_of(edge[0]), .shade = shade},
                         .width = edge[0] < BODY ? 2.5 : 1.6});
    }
}

static void draw_panel(fig_page *page, const scene *s, int i, const char *title)
{
    double width = fig_page_width(page) / PANELS;
    fig_plot plot = {.box = {width * i + 4, 18, width - 8, 136},
                     .x = {-1.75, 1.75},
                     .y = {-1.35, 1.1}};
    fig_page_fill_box(page, plot.box,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.09});
    fig_page_title(page, plot.box, title);
    draw_edges(page, &plot, s, s->start, FIRST, -0.75);
    draw_edges(page, &plot, s, s->proposed, FIRST, -0.45);
    draw_edges(page, &plot, s, s->end, 0, 0);
}

static void draw(fig_page *page, FILE *numbers)
{
    scene falls, turns;
    make_scene(&falls, false);
    make_scene(&turns, true);
    resolve(&falls);
    resolve(&turns);
    draw_panel(page, &falls, 0, "a limb that comes down");
    draw_panel(page, &turns, 1, "a limb that turns");
    fig_number(numbers, "vertices", LIMB);
    fig_number(numbers, "falling", falls.least);
    fig_number(numbers, "free", limb_at / down);
    fig_number(numbers, "turning", turns.least);
    fig_number(numbers, "tip", turns.followed[VERTICES - 1]);
}

const fig_figure fig_pressed_limb = {
    .name = "pressed-limb",
    .title = "Limbs that press cloth against a body",
    .width = FIG_PAGE_WIDTH,
    .height = 160,
    .draw = draw,
};
