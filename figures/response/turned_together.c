// An edge and a point that turn together meet on the way, if they are near
// enough: the edge is bent in mid-step.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/random.h"

#include "arithmetic/exact.h"
#include "kit/worlds.h"
#include "query/query.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    ANGLES = 4,
    DOTS = 13,
    PAIRS = 8000, ///< for each dot
    CURVE = 100
};

/// The turn that is shown, in degrees, about the left end of the edge.
static const double shown_angle = 40;

/// The edge, from the origin, and the point above it.
static const double length = 1, weight = 0.62, height = 0.1;

static const double angles[ANGLES] = {1e-3, 1e-2, 3e-2, 1e-1};
static const char *const names[ANGLES] = {"0.001", "0.01", "0.03", "0.1"};
static const fig_role roles[ANGLES] = {FIG_ROLE_EDGE, FIG_ROLE_POINT,
                                       FIG_ROLE_OTHER_EDGE, FIG_ROLE_TRIANGLE};

static tf_vector turned(tf_vector at, tf_vector center, double angle)
{
    double c = cos(angle), s = sin(angle);
    double x = at.x[0] - center.x[0], y = at.x[1] - center.x[1];
    return (tf_vector){
        {center.x[0] + c * x - s * y, center.x[1] + s * x + c * y, 0}};
}

/// A point and the two ends of an edge that turn together.
typedef struct turning {
    tf_worldline line[3];
} turning;

static turning turn(const tf_vector at[3], tf_vector center, double angle)
{
    turning made;
    for (int i = 0; i < 3; i++) {
        tf_vector end = turned(at[i], center, angle);
        made.line[i] = tf_worldline_between(2, at[i].x, end.x);
    }
    return made;
}

static tf_contact find_contact(const turning *t)
{
    tf_contact contact;
    TF_REQUIRE(tf_query(&tf_exact, 2, 1, t->line, 2, t->line + 1, &contact) ==
               TF_OK);
    return contact;
}

// Random pairs ----------------------------------------------------------------

static double between(uint64_t *state, double low, double high)
{
    return low + (high - low) * fig_random_number(state);
}

/// A pair at that distance, turned by that angle in one sense or the other.
static turning random_turn(uint64_t *state, double angle, double distance)
{
    double slope = between(state, 0, 2 * acos(-1)), w = between(state, 0, 1);
    tf_vector center = {{between(state, -1, 1), between(state, -1, 1), 0}};
    tf_vector along = {{cos(slope), sin(slope), 0}};
    tf_vector across = {{-along.x[1], along.x[0], 0}};
    tf_vector at[3] = {
        fig_combination(tf_vector_scaled(w, along), distance, across),
        {{0}},
        along};
    bool left = fig_random_bits(state) >> 63;
    return turn(at, center, left ? angle : -angle);
}

/// How many percent of pairs meet, at a multiple of the angle as distance.
static double percentage(uint64_t state, double angle, double ratio)
{
    int meeting = 0;
    for (int i = 0; i < PAIRS; i++) {
        turning made = random_turn(&state, angle, ratio * angle);
        meeting += find_contact(&made).verdict == TF_HIT;
    }
    return 100.0 * meeting / PAIRS;
}

static double expected(double ratio)
{
    return 50 * sqrt(fmax(0, 1 - 4 * ratio));
}

// Drawing ---------------------------------------------------------------------

static double ratio_of(int i)
{
    return (i + 0.5) * 0.3 / DOTS;
}

static void draw_share(fig_page *page, const fig_plot *plot, FILE *numbers)
{
    fig_point curve[CURVE + 1];
    for (int i = 0; i <= CURVE; i++) {
        double ratio = 0.25 * i / CURVE;
        curve[i] = (fig_point){ratio, expected(ratio)};
    }
    fig_plot_curve(page, plot, CURVE + 1, curve,
                   (fig_stroke){.paint = {.role = FIG_ROLE_NEUTRAL}});
    double most = 0;
    for (int a = 0; a < ANGLES; a++) {
        for (int i = 0; i < DOTS; i++) {
            double ratio = ratio_of(i);
            double share = percentage(
                (uint64_t)DOTS * (uint64_t)a + (uint64_t)i, angles[a], ratio);
            most = fmax(most, fabs(share - expected(ratio)));
            fig_plot_dot(page, plot, ratio, share, 4.5 - 0.6 * a, roles[a]);
        }
        fig_plot_key(page, plot->box.x + plot->box.width - 42, 20 + 14 * a,
                     names[a], roles[a]);
    }
    fig_number(numbers, "pairs", PAIRS);
    fig_number(numbers, "largest_difference", most);
}

static void draw_line(fig_page *page, const fig_plot *plot, int count,
                      const tf_vector at[], fig_stroke stroke)
{
    fig_point point[3];
    for (int i = 0; i < count; i++)
        point[i] = (fig_point){at[i].x[0], at[i].x[1]};
    fig_plot_curve(page, plot, count, point, stroke);
}

/// The edge and the point at one time, paler at the ends of the step.
static void draw_state(fig_page *page, const fig_plot *plot,
                       const turning *state, double t)
{
    bool at_end = t == 0 || t == 1;
    tf_vector bent[3], point = fig_worldline_place(&state->line[0], 2, t);
    tf_worldline crease = {{state->line[1].at[0], state->line[2].at[1]}};
    bent[0] = fig_worldline_place(&state->line[1], 2, t);
    bent[1] = fig_worldline_place(&crease, 2, t);
    bent[2] = fig_worldline_place(&state->line[2], 2, t);
    draw_line(page, plot, 3, bent,
              (fig_stroke){
                  .paint = {.role = FIG_ROLE_EDGE, .shade = at_end ? -0.45 : 0},
                  .width = FIG_WIDTH_TUBE});
    fig_plot_dot(page, plot, point.x[0], point.x[1],
                 at_end ? 5 : FIG_WIDTH_BALL, FIG_ROLE_POINT);
    if (at_end)
        return;
    tf_vector end = turned((tf_vector){{length, 0, 0}}, (tf_vector){{0}},
                           t * shown_angle * acos(-1) / 180);
    draw_line(page, plot, 2, (tf_vector[]){{{0}}, end},
              (fig_stroke){.paint = {.role = FIG_ROLE_EDGE},
                           .width = FIG_WIDTH_THIN,
                           .dash = 3});
}

static void write_at(fig_page *page, const fig_plot *plot, double x, double y,
                     const char *text)
{
    fig_point place = fig_plot_place(plot, x, y);
    fig_page_text(page, place.x, place.y, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_turn(fig_page *page, const fig_plot *plot, FILE *numbers)
{
    const tf_vector at[3] = {
        {{weight * length, height, 0}}, {{0}}, {{length, 0, 0}}};
    turning made = turn(at, (tf_vector){{0}}, shown_angle * acos(-1) / 180);
    tf_contact contact = find_contact(&made);
    TF_REQUIRE(contact.verdict == TF_HIT);
    double toi = fig_toi(&contact);
    tf_vector path[2] = {fig_worldline_place(&made.line[0], 2, 0),
                         fig_worldline_place(&made.line[0], 2, 1)};
    draw_line(page, plot, 2, path,
              (fig_stroke){.paint = {.role = FIG_ROLE_POINT},
                           .width = FIG_WIDTH_THIN});
    draw_state(page, plot, &made, 0);
    draw_state(page, plot, &made, 1);
    draw_state(page, plot, &made, toi);
    tf_vector place = fig_worldline_place(&made.line[0], 2, toi);
    fig_plot_dot(page, plot, place.x[0], place.x[1], FIG_WIDTH_BALL,
                 FIG_ROLE_CONTACT);
    char text[32];
    snprintf(text, sizeof text, "$t ≈ %.2f$", toi);
    write_at(page, plot, 1.03, -0.02, "$t = 0$");
    write_at(page, plot, 0.93, 0.29, text);
    write_at(page, plot, 0.79, 0.66, "$t = 1$");
    fig_number(numbers, "angle", shown_angle);
    fig_number(numbers, "toi", toi);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot picture = {
        .box = {4, 14, 166, 126}, .x = {-0.05, 1.29}, .y = {-0.1, 0.917}};
    fig_plot plot = {.box = {216, 8, 160, 132},
                     .x = {0, 0.3},
                     .y = {-2, 56},
                     .ticks_x = 3,
                     .name_x = "distance / (angle × length)",
                     .name_y = "% that meet"};
    draw_turn(page, &picture, numbers);
    fig_plot_frame(page, &plot);
    draw_share(page, &plot, numbers);
}

const fig_figure fig_turned_together = {
    .name = "turned-together",
    .title = "A point and an edge that turn together meet on the way",
    .width = FIG_PAGE_WIDTH,
    .height = 174,
    .draw = draw,
};
