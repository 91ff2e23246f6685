// Sheets of many faces: patches and grids.
#include "stage/scene.h"

#include "contract.h"
#include "stage/scene_parts.h"
#include "stage/vector.h"

/// How faint a grid is: its plane, and its lines towards paper.
static const double grid_opacity = 0.10, grid_shade = -0.55;

/// A rectangular array of points.
typedef struct lattice {
    int rows, columns;
    const double (*at)[3];
} lattice;

static const double *sample(const lattice *l, int row, int column)
{
    return l->at[row * l->columns + column];
}

static int clamp(int i, int count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

/// The normal at a sample, from its neighbours; zero if they lie on a line.
static void find_normal(const lattice *l, int row, int column, double normal[3])
{
    double u[3], v[3];
    tf_add(sample(l, row, clamp(column + 1, l->columns)), -1,
           sample(l, row, clamp(column - 1, l->columns)), u);
    tf_add(sample(l, clamp(row + 1, l->rows), column), -1,
           sample(l, clamp(row - 1, l->rows), column), v);
    tf_cross(u, v, normal);
    tf_normalize(normal);
}

/// Half a cell: the triangle of the samples with those offsets.
static void add_half(tf_scene *scene, const lattice *l, int row, int column,
                     const int offset[3][2], tf_paint paint)
{
    tf_face face = {.paint = paint};
    for (int i = 0; i < 3; i++) {
        int r = row + offset[i][0], c = column + offset[i][1];
        tf_add(sample(l, r, c), 0, sample(l, r, c), face.corner[i]);
        find_normal(l, r, c, face.normal[i]);
    }
    tf_scene_add_face(scene, &face);
}

/// The width of the line through the i-th of `count` rows or columns.
static double line_width(int i, int count, int lines)
{
    if (lines == 0)
        return 0;
    if (i == 0 || i == count - 1)
        return TF_WIDTH_THIN;
    return i % lines == 0 ? TF_WIDTH_HAIR : 0;
}

static void add_lines(tf_scene *scene, const lattice *l, int lines,
                      tf_paint paint)
{
    for (int r = 0; r < l->rows; r++)
        for (int c = 0; c < l->columns; c++) {
            double along_row = line_width(r, l->rows, lines);
            double along_column = line_width(c, l->columns, lines);
            if (along_row > 0 && c + 1 < l->columns)
                tf_scene_tube(scene, sample(l, r, c), sample(l, r, c + 1),
                              along_row, paint);
            if (along_column > 0 && r + 1 < l->rows)
                tf_scene_tube(scene, sample(l, r, c), sample(l, r + 1, c),
                              along_column, paint);
        }
}

void tf_scene_patch(tf_scene *scene, int rows, int columns,
                    const double at[][3], int lines, tf_paint paint)
{
    TF_REQUIRE(rows >= 2 && columns >= 2 && lines >= 0);
    static const int half[2][3][2] = {{{0, 0}, {0, 1}, {1, 1}},
                                      {{0, 0}, {1, 1}, {1, 0}}};
    lattice l = {rows, columns, at};
    for (int r = 0; r + 1 < rows; r++)
        for (int c = 0; c + 1 < columns; c++)
            for (int i = 0; i < 2; i++)
                add_half(scene, &l, r, c, half[i], paint);
    add_lines(scene, &l, lines, tf_crease_paint(paint));
}

/// The point origin + a u + b v.
static void plane_point(const double origin[3], double a, const double u[3],
                        double b, const double v[3], double at[3])
{
    tf_add(origin, a, u, at);
    tf_add(at, b, v, at);
}

/// n + 1 lines along u, spread over v.
static void add_rules(tf_scene *scene, const double origin[3],
                      const double u[3], const double v[3], int n,
                      tf_paint paint)
{
    for (int i = 0; i <= n; i++) {
        double from[3], to[3];
        plane_point(origin, 0, u, (double)i / n, v, from);
        plane_point(origin, 1, u, (double)i / n, v, to);
        tf_scene_tube(scene, from, to,
                      i == 0 || i == n ? TF_WIDTH_THIN : TF_WIDTH_HAIR, paint);
    }
}

void tf_scene_grid(tf_scene *scene, const double origin[3], const double u[3],
                   const double v[3], int nu, int nv, tf_role role)
{
    TF_REQUIRE(nu >= 1 && nv >= 1);
    double corner[4][3];
    for (int i = 0; i < 4; i++)
        plane_point(origin, i & 1, u, i >> 1, v, corner[i]);
    tf_paint faint = {role, grid_opacity, 0};
    tf_scene_triangle(scene, (const double(*)[3])corner, 0, faint);
    tf_scene_triangle(scene, (const double(*)[3])(corner + 1), 0, faint);
    tf_paint lines = {role, 1, grid_shade};
    add_rules(scene, origin, u, v, nv, lines);
    add_rules(scene, origin, v, u, nu, lines);
}
