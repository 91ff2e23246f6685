// How many queries the filter leaves undecided, by the family that they are of.
#include "kit/figures.h"

#include "base/require.h"
#include "fast/block_filter.h"
#include "kit/random.h"
#include "renderer/plot.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    QUERIES = 1 << 14, ///< of each family and kind
    VERTICES = 4,
    FAMILIES = 9
};

static const double row = 25, bar = 8, left = 118, top = 26;

/// The places of the vertices of a query at the start and at the end.
typedef struct places {
    double at[2][VERTICES][TF_AXES];
} places;

typedef places family(uint64_t *random, int kind);

// Families ---------------------------------------------------------------

/// Start in a cube of that size at random in the unit cube, and move by up to
/// 0.1 along each axis.
static places random_places(uint64_t *random, double size)
{
    places p;
    for (int k = 0; k < TF_AXES; k++) {
        double corner = (1 - size) * fig_random_number(random);
        for (int v = 0; v < VERTICES; v++) {
            p.at[0][v][k] = corner + size * fig_random_number(random);
            p.at[1][v][k] =
                p.at[0][v][k] + 0.2 * fig_random_number(random) - 0.1;
        }
    }
    return p;
}

static places soup(uint64_t *random, int kind)
{
    (void)kind;
    return random_places(random, 1);
}

static places near(uint64_t *random, int kind)
{
    (void)kind;
    return random_places(random, 0.1);
}

/// Coordinates 0, 1, 2 or 3.
static places lattice(uint64_t *random, int kind)
{
    places p;
    (void)kind;
    for (int i = 0; i < 2 * VERTICES * TF_AXES; i++)
        p.at[i / (VERTICES * TF_AXES)][i / TF_AXES % VERTICES][i % TF_AXES] =
            floor(4 * fig_random_number(random));
    return p;
}

/// Moves a point into a tilted plane, up to rounding.
static void tilt(double x[TF_AXES])
{
    double u = x[0], v = x[1];
    x[0] = 0.8 * u - 0.36 * v;
    x[1] = 0.6 * u + 0.48 * v;
    x[2] = 0.8 * v;
}

/// All in one tilted plane, in which they move.
static places tilted(uint64_t *random, int kind)
{
    places p = near(random, kind);
    for (int i = 0; i < 2 * VERTICES; i++)
        tilt(p.at[i / VERTICES][i % VERTICES]);
    return p;
}

static places at_rest(uint64_t *random, int kind)
{
    places p = tilted(random, kind);
    memcpy(p.at[1], p.at[0], sizeof p.at[1]);
    return p;
}

/// A point that comes to a corner of its triangle, or an end of an edge to one
/// of the other, but for a last place.
static places off_contact(uint64_t *random, int kind)
{
    places p = near(random, kind);
    memcpy(p.at[1][0], p.at[1][3], sizeof p.at[1][0]);
    double *x = &p.at[1][0][(int)(3 * fig_random_number(random))];
    *x = nextafter(*x, fig_random_number(random) < 0.5 ? -2 : 2);
    return p;
}

static places scaled(places p, const int exponent[TF_AXES])
{
    for (int i = 0; i < 2 * VERTICES; i++)
        for (int k = 0; k < TF_AXES; k++) {
            double *x = &p.at[i / VERTICES][i % VERTICES][k];
            *x = ldexp(*x, exponent[k]);
        }
    return p;
}

/// Each axis by 2^-700, 1 or 2^700.
static places scaled_axes(uint64_t *random, int kind)
{
    int exponent[TF_AXES];
    for (int k = 0; k < TF_AXES; k++)
        exponent[k] = 700 * ((int)(3 * fig_random_number(random)) - 1);
    return scaled(near(random, kind), exponent);
}

static places subnormal(uint64_t *random, int kind)
{
    return scaled(near(random, kind), (int[]){-1050, -1050, -1050});
}

static places huge(uint64_t *random, int kind)
{
    return scaled(near(random, kind), (int[]){997, 997, 997});
}

static const struct listed {
    const char *key, *name;
    family *make;
} families[FAMILIES] = {
    {"soup", "soup", soup},
    {"near", "near", near},
    {"lattice", "on a lattice", lattice},
    {"tilted", "in a tilted plane", tilted},
    {"rest", "the same, at rest", at_rest},
    {"contact", "an ulp off contact", off_contact},
    {"axes", "axes times $2^{±700}$", scaled_axes},
    {"subnormal", "subnormal", subnormal},
    {"huge", "about $10^{300}$", huge},
};

// Counts -----------------------------------------------------------------

static int size_of(uint64_t set)
{
    int size = 0;
    for (; set != 0; set &= set - 1)
        size++;
    return size;
}

/// The percentage of undecided queries.
static double undecided(family *make, int kind)
{
    static tf_query_block block[QUERIES / TF_BLOCK_QUERIES];
    static tf_query_masks masks[QUERIES / TF_MASK_QUERIES];
    uint64_t random = 15;
    for (int i = 0; i < QUERIES; i++) {
        places p = make(&random, kind);
        tf_query_block *b = &block[i / TF_BLOCK_QUERIES];
        for (int j = 0; j < 2 * VERTICES; j++)
            for (int k = 0; k < TF_AXES; k++)
                b->at[j / VERTICES][j % VERTICES][k][i % TF_BLOCK_QUERIES] =
                    p.at[j / VERTICES][j % VERTICES][k];
    }
    TF_REQUIRE((kind == 0 ? tf_filter_point_triangle : tf_filter_edge_edge)(
                   QUERIES, block, masks) == TF_OK);
    int count = 0;
    for (int i = 0; i < QUERIES / TF_MASK_QUERIES; i++)
        count += size_of(masks[i].undecided);
    return 100.0 * count / QUERIES;
}

// The picture ------------------------------------------------------------

static const char *const kind_key[] = {"pt", "ee"};
static const char *const kind_name[] = {"a point and a triangle", "two edges"};
static const fig_role kind_role[] = {FIG_ROLE_POINT, FIG_ROLE_EDGE};

static void draw_bar(fig_page *page, double y, double percent, fig_role role)
{
    double most = fig_page_width(page) - left - 48;
    char text[16];
    snprintf(text, sizeof text,
             percent > 0 && percent < 1 ? "%.2g%%" : "%.0f%%", percent);
    fig_page_fill_box(page, (fig_box){left, y, most, bar},
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.13});
    fig_page_fill_box(page, (fig_box){left, y, most * percent / 100, bar},
                      (fig_paint){.role = role});
    fig_page_text(page, left + most + 6, y + 7.5, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int kind = 0; kind < 2; kind++)
        fig_plot_key(page, left + 136 * kind, 13, kind_name[kind],
                     kind_role[kind]);
    for (int i = 0; i < FAMILIES; i++) {
        double y = top + row * i;
        fig_page_text(page, left - 8, y + 12, FIG_ALIGN_RIGHT, families[i].name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        for (int kind = 0; kind < 2; kind++) {
            double percent = undecided(families[i].make, kind);
            draw_bar(page, y + kind * (bar + 1.5), percent, kind_role[kind]);
            char key[32];
            snprintf(key, sizeof key, "%s_%s", kind_key[kind], families[i].key);
            fig_number(numbers, key, percent);
        }
    }
}

const fig_figure fig_undecided_queries = {
    .name = "undecided-queries",
    .title = "How many queries the filter leaves undecided, by family",
    .width = FIG_PAGE_WIDTH,
    .height = 254,
    .draw = draw,
};
