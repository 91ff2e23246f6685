// Needles through a box of twelve triangles: through the insides of two of
// them, through diagonals and through corners; and how many triangles each
// meets, by exact and by perturbed signs.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/perturbed.h"
#include "base/require.h"
#include "intersect/complementary.h"

enum {
    CORNERS = 8, ///< of the box, corner i at the bits of i
    FACETS = 12,
    NEEDLES = 3,
    EVENTS = 5 ///< of a needle and a triangle
};

/// A needle and where it passes the surface.
typedef struct needle {
    const char *key, *title;
    double end[2][TF_AXES], pass[2][TF_AXES];
} needle;

static const needle needles[NEEDLES] = {
    {"inside",
     "*through two insides*",
     {{0.3, 0.875, -0.5}, {0.7, 0.125, 1.5}},
     {{0.4, 0.6875, 0}, {0.6, 0.3125, 1}}},
    {"diagonal",
     "*through two diagonals*",
     {{0.5, 0.5, -0.5}, {0.5, 0.5, 1.5}},
     {{0.5, 0.5, 0}, {0.5, 0.5, 1}}},
    {"corner",
     "*through two corners*",
     {{-0.25, -0.25, -0.25}, {1.25, 1.25, 1.25}},
     {{0, 0, 0}, {1, 1, 1}}},
};

/// Looks at the middle of the box.
static const fig_camera camera = {.azimuth = -24,
                                  .elevation = 20,
                                  .height = 2.2,
                                  .center = {{0.5, 0.5, 0.5}}};

/// The corners of the box, numbers 0 to 7, then the ends of a needle.
typedef struct scenery {
    tf_event corner[CORNERS], end[2];
    int facet[FACETS][3];
} scenery;

static scenery make_scenery(const needle *n)
{
    scenery s;
    for (int i = 0; i < CORNERS; i++)
        s.corner[i] =
            (tf_event){.x = {i & 1, i >> 1 & 1, i >> 2 & 1}, .vertex = i};
    for (int i = 0; i < 2; i++)
        s.end[i] = (tf_event){.x = {n->end[i][0], n->end[i][1], n->end[i][2]},
                              .vertex = CORNERS + i};

    // The diagonal of a face starts at its corner 0 or 7 and ends opposite.
    int count = 0;
    for (int axis = 0; axis < TF_AXES; axis++)
        for (int side = 0; side < 2; side++)
            for (int way = 1; way <= 2; way++) {
                int first = side == 0 ? 0 : CORNERS - 1;
                int along = 1 << (axis + way) % TF_AXES;
                int *facet = s.facet[count++];
                facet[0] = first;
                facet[1] = first ^ along;
                facet[2] = first ^ (CORNERS - 1) ^ 1 << axis;
            }
    return s;
}

/// Whether the needle meets a triangle of the box.
static bool meets(const tf_arithmetic *arithmetic, const scenery *s, int facet)
{
    tf_pair pair = {
        .count = EVENTS, .start_count = EVENTS, .axes = 3, .axis = {0, 1, 2}};
    for (int i = 0; i < EVENTS; i++) {
        pair.event[i] = i < 2 ? &s->end[i] : &s->corner[s->facet[facet][i - 2]];
        pair.operand[i] = i < 2 ? +1 : -1;
    }
    tf_intersection meeting;
    bool decided =
        tf_complementary_intersect(arithmetic, &pair, TF_WITH_POINT, &meeting);
    TF_REQUIRE(decided && meeting.verdict != TF_UNDECIDED);
    return meeting.verdict == TF_HIT;
}

static int count_met(const tf_arithmetic *arithmetic, const scenery *s)
{
    int count = 0;
    for (int i = 0; i < FACETS; i++)
        count += meets(arithmetic, s, i);
    return count;
}

/// The triangles that the moved needle meets stand out, then those that only
/// the needle itself meets.
static void draw_box(fig_scene *scene, const scenery *s)
{
    for (int i = 0; i < FACETS; i++) {
        tf_vector corner[3];
        for (int j = 0; j < 3; j++)
            corner[j] = fig_vector_of(s->corner[s->facet[i][j]].x);
        fig_paint paint = {.role = FIG_ROLE_TRIANGLE, .opacity = 0.1};
        if (meets(&tf_exact, s, i))
            paint.opacity = 0.28;
        if (meets(&tf_perturbed, s, i))
            paint = (fig_paint){.role = FIG_ROLE_OTHER_EDGE, .opacity = 0.5};
        fig_scene_triangle(scene, corner, FIG_WIDTH_THIN, paint);
    }
}

static void draw_needle(fig_page *page, const needle *n, const scenery *s,
                        fig_box box)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, camera);
    fig_scene *scene = fig_panel_scene(panel);
    draw_box(scene, s);
    fig_scene_arrow(scene, fig_vector_of(n->end[0]), fig_vector_of(n->end[1]),
                    FIG_WIDTH_TUBE, (fig_paint){.role = FIG_ROLE_EDGE});
    for (int i = 0; i < 2; i++)
        fig_scene_ball(scene, fig_vector_of(n->pass[i]), 6,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
}

static void draw(fig_page *page, FILE *numbers)
{
    static const double text_room = 34;
    double width = fig_page_width(page) / NEEDLES;
    double height = fig_page_height(page) - text_room;
    for (int i = 0; i < NEEDLES; i++) {
        const needle *n = &needles[i];
        scenery s = make_scenery(n);
        fig_box box = {width * i, 0, width, height};
        draw_needle(page, n, &s, box);
        fig_page_caption(page, box, n->title);

        int exact = count_met(&tf_exact, &s);
        int perturbed = count_met(&tf_perturbed, &s);
        char text[64];
        snprintf(text, sizeof text, "exact %d, perturbed %d", exact, perturbed);
        fig_page_text(page, box.x + width / 2, fig_page_height(page) - 6,
                      FIG_ALIGN_CENTER, text, FIG_LETTERS, FIG_ROLE_INK);
        snprintf(text, sizeof text, "exact_%s", n->key);
        fig_number(numbers, text, exact);
        snprintf(text, sizeof text, "perturbed_%s", n->key);
        fig_number(numbers, text, perturbed);
    }
}

const fig_figure fig_needle_through_box = {
    .name = "needle-through-box",
    .title = "How many triangles of a box a needle intersects",
    .width = FIG_PAGE_WIDTH,
    .height = 190,
    .draw = draw,
};
