// Two sheets, one cell of a grid apart, rotated and rounded to the grid.
#include "figures.h"

#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "contract.h"
#include "spacetime/complementary.h"

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

static const tf_role role_of_sheet[SHEETS] = {TF_ROLE_OTHER_EDGE,
                                              TF_ROLE_TRIANGLE};

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
static void rotate(const double q[4], const double place[3], double rotated[3])
{
    double w = q[0], x = q[1], y = q[2], z = q[3];
    double matrix[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z),
                            2 * (x * z + w * y)},
                           {2 * (x * y + w * z), w * w - x * x + y * y - z * z,
                            2 * (y * z - w * x)},
                           {2 * (x * z - w * y), 2 * (y * z + w * x),
                            w * w - x * x - y * y + z * z}};
    double square_of_length = w * w + x * x + y * y + z * z;
    for (int k = 0; k < 3; k++)
        rotated[k] = (matrix[k][0] * place[0] + matrix[k][1] * place[1] +
                      matrix[k][2] * place[2]) /
                     square_of_length;
}

static void make_vertices(mesh *m, const double q[4])
{
    for (int sheet = 0; sheet < SHEETS; sheet++)
        for (int i = 0; i < SIDE; i++)
            for (int j = 0; j < SIDE; j++) {
                double place[3] = {
                    square * (i - SQUARES / 2.0) + sheet * offset[0],
                    square * (j - SQUARES / 2.0) + sheet * offset[1],
                    (sheet - 0.5) * offset[2]};
                tf_event *vertex = &m->vertex[vertex_number(sheet, i, j)];
                *vertex = (tf_event){.t = 0};
                rotate(q, place, vertex->x);
            }
}

static void round_vertices(mesh *m)
{
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < 3; k++)
            m->vertex[i].x[k] = round(m->vertex[i].x[k]);
}

// Crossings --------------------------------------------------------------

/// The places where edges of one sheet meet triangles of the other.
typedef struct crossings {
    int count;
    double at[CROSSINGS_MOST][3];
} crossings;

/// Whether an edge meets a triangle, and where.  Five events of one time are
/// complementary in space.  A pair that lies in one plane is not counted.
static bool edge_meets_triangle(const tf_arithmetic *arithmetic,
                                const tf_event *const end[2],
                                const tf_event *const corner[3], double at[3])
{
    tf_pair pair = {.count = 5,
                    .early = 5,
                    .event = {end[0], end[1], corner[0], corner[1], corner[2]},
                    .side = {+1, +1, -1, -1, -1},
                    .axes = 3,
                    .axis = {0, 1, 2}};
    tf_meeting meeting;
    if (!tf_complementary_meet(arithmetic, &pair, &meeting) ||
        meeting.verdict != TF_HIT)
        return false;
    for (int k = 0; k < 3; k++)
        at[k] =
            meeting.weight[0] * end[0]->x[k] + meeting.weight[1] * end[1]->x[k];
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
            found->count += edge_meets_triangle(arithmetic, end, corner,
                                                found->at[found->count]);
        }
    }
}

// Drawing ----------------------------------------------------------------

static void add_mesh(tf_scene *scene, const mesh *m)
{
    for (int i = 0; i < TRIANGLES; i++) {
        double corner[3][3];
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++)
                corner[j][k] = m->vertex[m->triangle[i][j]].x[k];
        tf_scene_triangle(scene, (const double(*)[3])corner, TF_WIDTH_THIN,
                          (tf_paint){.role = role_of_sheet[i / (TRIANGLES / 2)],
                                     .shade = -0.3});
    }
}

static void draw_mesh(tf_page *page, tf_box box, const mesh *m,
                      const crossings *found, const char *caption)
{
    tf_panel *panel = tf_page_panel(page, box);
    tf_panel_look(panel, (tf_camera){.azimuth = -62, .elevation = 8});
    tf_panel_margin(panel, 8);
    tf_scene *scene = tf_panel_scene(panel);
    add_mesh(scene, m);
    for (int i = 0; i < found->count; i++)
        tf_scene_ball(scene, found->at[i], 5,
                      (tf_paint){.role = TF_ROLE_CONTACT});
    tf_page_caption(page, box, caption);
}

static void draw(tf_page *page, FILE *numbers)
{
    static const double upright[4] = {1, 0, 0, 0};
    double width = tf_page_width(page) / 2, height = tf_page_height(page) - 18;
    mesh m;
    crossings found;
    make_triangles(&m);
    make_edges(&m);

    make_vertices(&m, upright);
    round_vertices(&m);
    find_crossings(&tf_integer64, &m, &found);
    tf_figure_number(numbers, "upright_rounded", found.count);

    make_vertices(&m, rotation);
    find_crossings(&tf_exact, &m, &found);
    tf_figure_number(numbers, "rotated", found.count);
    draw_mesh(page, (tf_box){0, 0, width, height}, &m, &found, "*rotated*");

    round_vertices(&m);
    find_crossings(&tf_integer64, &m, &found);
    tf_figure_number(numbers, "rotated_rounded", found.count);
    draw_mesh(page, (tf_box){width, 0, width, height}, &m, &found,
              "*rotated and rounded*");
    tf_figure_number(numbers, "triangles", TRIANGLES);
}

const tf_figure tf_figure_rounded_sheets = {
    .name = "rounded-sheets",
    .title = "Two sheets that cross after they were rounded to a grid",
    .width = TF_FIGURE_WIDTH,
    .height = 210,
    .draw = draw,
};
