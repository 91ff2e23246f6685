// Sheets of many faces: patches and grids.
#include "renderer/scene.h"

#include "base/require.h"
#include "renderer/scene_parts.h"

/// How faint a grid is: its plane, and its lines towards paper.
static const double grid_opacity = 0.10, grid_shade = -0.55;

/// A rectangular array of points.
typedef struct lattice {
    int rows, columns;
    const tf_vector *at;
} lattice;

static tf_vector sample(const lattice *l, int row, int column)
{
    return l->at[row * l->columns + column];
}

static int clamp(int i, int count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

/// The normal at a sample, from its neighbours; zero if they lie on a line.
static tf_vector normal_at(const lattice *l, int row, int column)
{
    tf_vector u = fig_difference(sample(l, row, clamp(column + 1, l->columns)),
                                 sample(l, row, clamp(column - 1, l->columns)));
    tf_vector v = fig_difference(sample(l, clamp(row + 1, l->rows), column),
                                 sample(l, clamp(row - 1, l->rows), column));
    return fig_normalized(fig_cross(u, v));
}

/// Half a cell: the triangle of the samples with those offsets.
static void add_half(fig_scene *scene, const lattice *l, int row, int column,
                     const int offset[3][2], fig_paint paint)
{
    fig_face face = {.paint = paint};
    for (int i = 0; i < 3; i++) {
        int r = row + offset[i][0], c = column + offset[i][1];
        face.corner[i] = sample(l, r, c);
        face.normal[i] = normal_at(l, r, c);
    }
    fig_scene_add_face(scene, &face);
}

/// The width of the line through the i-th of `count` rows or columns.
static double line_width(int i, int count, int lines)
{
    if (lines == 0)
        return 0;
    if (i == 0 || i == count - 1)
        return FIG_WIDTH_THIN;
    return i % lines == 0 ? FIG_WIDTH_HAIR : 0;
}

static void add_lines(fig_scene *scene, const lattice *l, int lines,
                      fig_paint paint)
{
    for (int r = 0; r < l->rows; r++)
        for (int c = 0; c < l->columns; c++) {
            double along_row = line_width(r, l->rows, lines);
            double along_column = line_width(c, l->columns, lines);
            if (along_row > 0 && c + 1 < l->columns)
                fig_scene_tube(scene, sample(l, r, c), sample(l, r, c + 1),
                               along_row, paint);
            if (along_column > 0 && r + 1 < l->rows)
                fig_scene_tube(scene, sample(l, r, c), sample(l, r + 1, c),
                               along_column, paint);
        }
}

void fig_scene_patch(fig_scene *scene, int rows, int columns,
                     const tf_vector at[], int lines, fig_paint paint)
{
    TF_REQUIRE(rows >= 2 && columns >= 2 && lines >= 0);
    static const int half[2][3][2] = {{{0, 0}, {0, 1}, {1, 1}},
                                      {{0, 0}, {1, 1}, {1, 0}}};
    lattice l = {rows, columns, at};
    for (int r = 0; r + 1 < rows; r++)
        for (int c = 0; c + 1 < columns; c++)
            for (int i = 0; i < 2; i++)
                add_half(scene, &l, r, c, half[i], paint);
    add_lines(scene, &l, lines, fig_crease_paint(paint));
}

/// The point origin + a u + b v.
static tf_vector plane_point(tf_vector origin, double a, tf_vector u, double b,
                             tf_vector v)
{
    return fig_combination(fig_combination(origin, a, u), b, v);
}

/// n + 1 lines along u, spread over v.
static void add_rules(fig_scene *scene, tf_vector origin, tf_vector u,
                      tf_vector v, int n, fig_paint paint)
{
    for (int i = 0; i <= n; i++) {
        fig_scene_tube(scene, plane_point(origin, 0, u, (double)i / n, v),
                       plane_point(origin, 1, u, (double)i / n, v),
                       i == 0 || i == n ? FIG_WIDTH_THIN : FIG_WIDTH_HAIR,
                       paint);
    }
}

void fig_scene_grid(fig_scene *scene, tf_vector origin, tf_vector u,
                    tf_vector v, int nu, int nv, fig_role role)
{
    TF_REQUIRE(nu >= 1 && nv >= 1);
    tf_vector corner[4];
    for (int i = 0; i < 4; i++)
        corner[i] = plane_point(origin, i & 1, u, i >> 1, v);
    fig_paint faint = {role, grid_opacity, 0};
    fig_scene_triangle(scene, corner, 0, faint);
    fig_scene_triangle(scene, corner + 1, 0, faint);
    fig_paint lines = {role, 1, grid_shade};
    add_rules(scene, origin, u, v, nv, lines);
    add_rules(scene, origin, v, u, nu, lines);
}
