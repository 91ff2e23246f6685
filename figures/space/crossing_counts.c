// An edge that moves in straight lines, at nine times, and three points at
// rest: one that it meets once, one that it meets twice and one that it does
// not meet.  Rays count how often the border of what it sweeps is crossed.
#include "kit/figures.h"

#include "base/require.h"
#include "linear/quadratic.h"
#include "renderer/plot.h"

enum {
    TIMES = 17,
    POINTS = 3,
    SAMPLES = 999,
    CORNERS = 4,
    VERTICES = 3 ///< of a query: a point and an edge
};

/// The ends of the edge, each at t = 0 and at t = 1.
static const double end[2][2][2] = {{{-1.5, -1}, {0, 2}}, {{0, 0}, {1.5, -1}}};

static const struct rest {
    const char *key, *name;
    double at[2];
} rests[POINTS] = {
    {"once", "$A$", {0, 0.75}},
    {"twice", "$B$", {0, -0.1875}},
    {"never", "$C$", {0, -0.5}},
};

/// The border of the sweep: the edge at the start, the path of one end, the
/// edge at the end, and the path of the other end back.
static void find_border(double corner[CORNERS][2])
{
    static const int which[CORNERS][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < CORNERS; i++)
        for (int k = 0; k < 2; k++)
            corner[i][k] = end[which[i][0]][which[i][1]][k];
}

/// A painted point of the edge at a time.
static fig_point painted(double s, double t)
{
    double x[2];
    for (int k = 0; k < 2; k++)
        x[k] = (1 - s) * ((1 - t) * end[0][0][k] + t * end[0][1][k]) +
               s * ((1 - t) * end[1][0][k] + t * end[1][1][k]);
    return (fig_point){x[0], x[1]};
}

/// Where a ray to the right of a point crosses the border; returns how often.
static int find_crossings(const double at[2], double x[CORNERS])
{
    double corner[CORNERS][2];
    find_border(corner);
    int count = 0;
    for (int i = 0; i < CORNERS; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % CORNERS];
        if ((a[1] > at[1]) == (b[1] > at[1]))
            continue;
        double part = (at[1] - a[1]) / (b[1] - a[1]);
        double crossing = a[0] + part * (b[0] - a[0]);
        if (crossing > at[0])
            x[count++] = crossing;
    }
    return count;
}

/// The first time at which the edge meets a point at rest; -1 if it does not.
static double first_meeting(const double at[2])
{
    const double start[2 * VERTICES] = {
        at[0], at[1], end[0][0][0], end[0][0][1], end[1][0][0], end[1][0][1]};
    const double stop[2 * VERTICES] = {
        at[0], at[1], end[0][1][0], end[0][1][1], end[1][1][0], end[1][1][1]};
    const tf_motion motion = {2, VERTICES, start, stop};
    tf_contact contact;
    tf_status status = tf_quadratic_point_edge(&(tf_tolerances){0}, &motion, 0,
                                               (const int[]){1, 2}, &contact);
    TF_REQUIRE(status == TF_OK);
    return contact.verdict == TF_HIT ? contact.toi_lo : -1;
}

/// How often the edge meets a point at rest: how often the point changes sides
/// of the edge's line with the foot of its perpendicular on the edge.
static int count_meetings(const double at[2])
{
    int count = 0;
    double before = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double t = (double)i / SAMPLES;
        fig_point a = painted(0, t), b = painted(1, t);
        double x = b.x - a.x, y = b.y - a.y;
        double side = x * (at[1] - a.y) - y * (at[0] - a.x);
        double foot = x * (at[0] - a.x) + y * (at[1] - a.y);
        bool beside = foot >= 0 && foot <= x * x + y * y;
        count += beside && side * before < 0;
        before = side;
    }
    return count;
}

static void draw_curve(fig_page *page, const fig_plot *plot, int count,
                       const fig_point world[], fig_stroke stroke)
{
    fig_point at[2];
    for (int i = 0; i < count; i++)
        at[i] = fig_plot_place(plot, world[i].x, world[i].y);
    fig_page_line(page, count, at, stroke);
}

/// The edge at equal intervals of time, and its border.
static void draw_sweep(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < TIMES; i++) {
        double t = (double)i / (TIMES - 1);
        const fig_point edge[2] = {painted(0, t), painted(1, t)};
        bool ends = i == 0 || i == TIMES - 1;
        fig_stroke stroke = {
            .paint = {.role = FIG_ROLE_EDGE, .opacity = ends ? 0 : 0.55},
            .width = ends ? FIG_WIDTH_TUBE : FIG_WIDTH_THIN,
            .under_labels = !ends};
        draw_curve(page, plot, 2, edge, stroke);
    }
    for (int i = 0; i < 2; i++) {
        const fig_point path[2] = {painted(i, 0), painted(i, 1)};
        draw_curve(page, plot, 2, path,
                   (fig_stroke){.paint.role = FIG_ROLE_EDGE,
                                .width = FIG_WIDTH_LINE,
                                .dash = 3});
    }
}

/// The ends of the edge, named at the start and at the end.
static void name_ends(fig_page *page, const fig_plot *plot)
{
    static const char *const name[2][2] = {{"$e_0$", "$e_0'$"},
                                           {"$e_1$", "$e_1'$"}};
    static const fig_side side[2][2] = {{FIG_SIDE_W, FIG_SIDE_W},
                                        {FIG_SIDE_S, FIG_SIDE_S}};
    for (int i = 0; i < 2; i++)
        for (int t = 0; t < 2; t++) {
            fig_point at = fig_plot_dot(page, plot, end[i][t][0], end[i][t][1],
                                        FIG_WIDTH_BALL, FIG_ROLE_EDGE);
            fig_page_label(page, at.x, at.y,
                           (fig_label){.text = name[i][t],
                                       .role = FIG_ROLE_EDGE,
                                       .side = side[i][t]});
        }
}

/// A point at rest and its ray, with a dot at each crossing of the border.
static void draw_rest(fig_page *page, const fig_plot *plot,
                      const struct rest *rest, double toi)
{
    static const double reach = 1.75;
    double x[CORNERS];
    int crossings = find_crossings(rest->at, x);
    const fig_point ray[2] = {{rest->at[0], rest->at[1]}, {reach, rest->at[1]}};
    draw_curve(page, plot, 2, ray,
               (fig_stroke){.paint.role = FIG_ROLE_POINT, .arrow = true});
    for (int i = 0; i < crossings; i++) {
        fig_point at = fig_plot_place(plot, x[i], rest->at[1]);
        fig_page_dot(page, at.x, at.y, 5, (fig_paint){.role = FIG_ROLE_INK});
    }
    fig_point at =
        fig_plot_dot(page, plot, rest->at[0], rest->at[1], FIG_WIDTH_BALL,
                     toi < 0 ? FIG_ROLE_POINT : FIG_ROLE_CONTACT);
    fig_page_label(page, at.x, at.y,
                   (fig_label){.text = rest->name,
                               .role = FIG_ROLE_POINT,
                               .side = FIG_SIDE_W,
                               .gap = 6});
}

static void write_counts(fig_page *page, const fig_plot *plot,
                         const struct rest *rest, int crossings, int meetings)
{
    fig_point at = fig_plot_place(plot, 1.82, rest->at[1]);
    char text[64];
    snprintf(text, sizeof text, "%s: %d crossing%s, %d contact%s", rest->name,
             crossings, crossings == 1 ? "" : "s", meetings,
             meetings == 1 ? "" : "s");
    fig_page_text(page, at.x, at.y + 3, FIG_ALIGN_LEFT, text, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    static const double low = -1.2, high = 2.15, left = -1.9;
    fig_box box = {4, 4, fig_page_width(page) - 8, fig_page_height(page) - 8};
    double scale = box.height / (high - low);
    fig_plot plot = {
        .box = box, .x = {left, left + box.width / scale}, .y = {low, high}};
    draw_sweep(page, &plot);
    for (int i = 0; i < POINTS; i++) {
        double x[CORNERS], toi = first_meeting(rests[i].at);
        int crossings = find_crossings(rests[i].at, x);
        draw_rest(page, &plot, &rests[i], toi);
        int meetings = count_meetings(rests[i].at);
        write_counts(page, &plot, &rests[i], crossings, meetings);
        char key[32];
        snprintf(key, sizeof key, "crossings_%s", rests[i].key);
        fig_number(numbers, key, crossings);
        snprintf(key, sizeof key, "contacts_%s", rests[i].key);
        fig_number(numbers, key, meetings);
        snprintf(key, sizeof key, "toi_%s", rests[i].key);
        fig_number(numbers, key, toi);
    }
    name_ends(page, &plot);
}

const fig_figure fig_crossing_counts = {
    .name = "crossing-counts",
    .title = "An edge that meets a point once, twice, or not at all",
    .width = FIG_PAGE_WIDTH,
    .height = 250,
    .draw = draw,
};
