// Two sheets, one cell of a grid apart, rotated and rounded to the grid.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "base/require.h"
#include "intersect/complementary.h"

#include <math.h>

enum {
    SQUARES = 6, ///< along each side of a sheet
    SIDE = SQUARES + 1,
    SHEETS = 2,
    VERTICES = SHEETS * SIDE * SIDE,
    TRIANGLES = SHEETS * SQUARES * SQUARES * 2,
    EDGES = SHEETS * (2 * SIDE + SQUARES) * SQUARES,
    CROSSINGS_MOST = EDGES
};

/// In cells: the side of a square and the way from sheet to sheet, which also
/// sets the squares of the upper sheet off against those of the lower one.
static const double square = 4, offset[3] = {2, 1, 1};

/// The rotation as a quaternion.
static const double rotation[4] = {4, -4, -5, -10};

static const fig_role role_of_sheet[SHEETS] = {FIG_ROLE_OTHER_EDGE,
                                               FIG_ROLE_TRIANGLE};

/// Events at rest, and what is between them; of edges and triangles the lower
/// sheet's come first.
typedef struct mesh {
    tf_event vertex[VERTICES];
    int edge[EDGES][2];
    int triangle[TRIANGLES][3];
} mesh;

// The mesh ---------------------------------------------------------------

static int vertex_number(int sheet, int i, int j)
{
    return (sheet * SIDE + i) * SIDE + j;
}

/// Cut each square in two along the same diagonal.
static void make_triangles(mesh *m)
{
    int count = 0;
    for (int sheet = 0; sheet < SHEETS; sheet++)
        for (int i = 0; i < SQUARES; i++)
            for (int j = 0; j < SQUARES; j++) {
                int a = vertex_number(sheet, i, j);
                int c = vertex_number(sheet, i + 1, j + 1);
                int other[2] = {vertex_number(sheet, i, j + 1),
                                vertex_number(sheet, i + 1, j)};
                for (int half = 0; half < 2; half++) {
                    m->triangle[count][0] = a;
                    m->triangle[count][1] = other[half];
                    m->triangle[count++][2] = c;
                }
            }
}

/// The sides of the squares and their diagonals.
static void make_edges(mesh *m)
{
    static const int step[3][2] = {{1, 0}, {0, 1}, {1, 1}};
    int count = 0;
    for (int sheet = 0; sheet < SHEETS; sheet++)
        for (int i = 0; i < SIDE; i++)
            for (int j = 0; j < SIDE; j++)
                for (int k = 0; k < 3; k++) {
                    int next_i = i + step[k][0], next_j = j + step[k][1];
                    if (next_i > SQUARES || next_j > SQUARES)
                        continue;
                    m->edge[count][0] = vertex_number(sheet, i, j);
                    m->edge[count++][1] = vertex_number(sheet, next_i, next_j);
                }
}

/// Rotate a place by a quaternion, w + x i + y j + z k.
static tf_vector rotate(const double q[4], tf_vector place)
{
    double w = q[0], x = q[1], y = q[2], z = q[3];
    tf_vector row[3] = {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z),
                          2 * (x * z + w * y)}},
                        {{2 * (x * y + w * z), w * w - x * x + y * y - z * z,
                          2 * (y * z - w * x)}},
                        {{2 * (x * z - w * y), 2 * (y * z + w * x),
                          w * w - x * x - y * y + z * z}}};
    double square_of_length = w * w + x * x + y * y + z * z;
    tf_vector rotated;
    for (int k = 0; k < 3; k++)
        rotated.x[k] = tf_vector_dot(row[k], place) / square_of_length;
    return rotated;
}

static void make_vertices(mesh *m, const double q[4])
{
    for (int sheet = 0; sheet < SHEETS; sheet++)
        for (int i = 0; i < SIDE; i++)
            for (int j = 0; j < SIDE; j++) {
                tf_vector place = {
                    {square * (i - SQUARES / 2.0) + sheet * offset[0],
                     square * (j - SQUARES / 2.0) + sheet * offset[1],
                     (sheet - 0.5) * offset[2]}};
                tf_event *vertex = &m->vertex[vertex_number(sheet, i, j)];
                tf_vector at = rotate(q, place);
                *vertex = (tf_event){.x = {at.x[0], at.x[1], at.x[2]}};
            }
}

static void round_vertices(mesh *m)
{
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < 3; k++)
            m->vertex[i].x[k] = round(m->vertex[i].x[k]);
}

// Crossings --------------------------------------------------------------

/// The places where edges of one sheet intersect triangles of the other.
typedef struct crossings {
    int count;
    tf_vector at[CROSSINGS_MOST];
} crossings;

/// Whether an edge intersects a triangle, and where.  Five events of one time
/// are complementary in space.  A pair that lies in one plane is not counted.
static bool edge_intersects_triangle(const tf_arithmetic *arithmetic,
                                     const tf_event *const end[2],
                                     const tf_event *const corner[3],
                                     tf_vector *at)
{
    tf_pair pair = {.count = 5,
                    .start_count = 5,
                    .event = {end[0], end[1], corner[0], corner[1], corner[2]},
                    .operand = {+1, +1, -1, -1, -1},
                    .axes = 3,
                    .axis = {0, 1, 2}};
    tf_intersection found;
    if (!tf_complementary_intersect(arithmetic, &pair, TF_WITH_POINT, &found) ||
        found.verdict != TF_HIT)
        return false;
    *at = fig_combination(
        tf_vector_scaled(found.barycentric[0], fig_vector_of(end[0]->x)),
        found.barycentric[1], fig_vector_of(end[1]->x));
    return true;
}

/// Ask every edge of each sheet about every triangle of the other.
static void find_crossings(const tf_arithmetic *arithmetic, const mesh *m,
                           crossings *found)
{
    found->count = 0;
    for (int i = 0; i < EDGES; i++) {
        const tf_event *end[2] = {&m->vertex[m->edge[i][0]],
                                  &m->vertex[m->edge[i][1]]};
        int first = i < EDGES / 2 ? TRIANGLES / 2 : 0;
        for (int j = first; j < first + TRIANGLES / 2; j++) {
            const tf_event *corner[3];
            for (int k = 0; k < 3; k++)
                corner[k] = &m->vertex[m->triangle[j][k]];
            TF_REQUIRE(found->count < CROSSINGS_MOST);
            found->count += edge_intersects_triangle(arithmetic, end, corner,
                                                     &found->at[found->count]);
        }
    }
}

// Drawing ----------------------------------------------------------------

static void add_mesh(fig_scene *scene, const mesh *m)
{
    for (int i = 0; i < TRIANGLES; i++) {
        tf_vector corner[3];
        for (int j = 0; j < 3; j++)
            corner[j] = fig_vector_of(m->vertex[m->triangle[i][j]].x);
        fig_scene_triangle(
            scene, corner, FIG_WIDTH_THIN,
            (fig_paint){.role = role_of_sheet[i / (TRIANGLES / 2)],
                        .shade = -0.3});
    }
}

static void draw_mesh(fig_page *page, fig_box box, const mesh *m,
                      const crossings *found, const char *caption)
{
    fig_panel *panel = fig_page_panel(page, box);
    fig_panel_look(panel, (fig_camera){.azimuth = -62, .elevation = 8});
    fig_panel_margin(panel, 8);
    fig_scene *scene = fig_panel_scene(panel);
    add_mesh(scene, m);
    for (int i = 0; i < found->count; i++)
        fig_scene_ball(scene, found->at[i], 5,
                       (fig_paint){.role = FIG_ROLE_CONTACT});
    fig_page_caption(page, box, caption);
}

static void draw(fig_page *page, FILE *numbers)
{
    static const double upright[4] = {1, 0, 0, 0};
    double width = fig_page_width(page) / 2,
           height = fig_page_height(page) - 18;
    mesh m;
    crossings found;
    make_triangles(&m);
    make_edges(&m);

    make_vertices(&m, upright);
    round_vertices(&m);
    find_crossings(&tf_integer64, &m, &found);
    fig_number(numbers, "upright_rounded", found.count);

    make_vertices(&m, rotation);
    find_crossings(&tf_exact, &m, &found);
    fig_number(numbers, "rotated", found.count);
    draw_mesh(page, (fig_box){0, 0, width, height}, &m, &found, "*rotated*");

    round_vertices(&m);
    find_crossings(&tf_integer64, &m, &found);
    fig_number(numbers, "rotated_rounded", found.count);
    draw_mesh(page, (fig_box){width, 0, width, height}, &m, &found,
              "*rotated and rounded*");
    fig_number(numbers, "triangles", TRIANGLES);
}

const fig_figure fig_rounded_sheets = {
    .name = "rounded-sheets",
    .title = "Two sheets that cross after they were rounded to a grid",
    .width = FIG_PAGE_WIDTH,
    .height = 210,
    .draw = draw,
};
