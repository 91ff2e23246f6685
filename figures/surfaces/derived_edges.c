// A surface, and how its edges are derived: copied out of its triangles, and
// sorted by one vertex after the other.
#include "kit/figures.h"

#include "base/require.h"
#include "surface/derive.h"

#include <stddef.h>
#include <string.h>

enum {
    VERTICES = 9,
    TRIANGLES = 5,
    LOOSE = 1,
    RECORDS = 3 * TRIANGLES + LOOSE,
    COLUMNS = 3
};

static const double place[VERTICES][3] = {
    {0, 0, 0},   {2, 0, 0.3},   {4, 0, 0},   {0, 2, 0},         {2, 2, 0.4},
    {4, 2, 0.1}, {1.9, 1, 1.7}, {5.4, 2, 1}, {0.55, 0.75, 1.35}};
static const int triangle[TRIANGLES][3] = {
    {0, 1, 4}, {4, 3, 0}, {1, 2, 5}, {5, 4, 1}, {1, 6, 4}};
static const int rod[LOOSE][2] = {{7, 5}};

static const tf_mesh mesh = {.axes = 3,
                             .vertices = VERTICES,
                             .triangles = TRIANGLES,
                             .triangle = triangle[0],
                             .edges = LOOSE,
                             .edge = rod[0]};

static const fig_box surface_box = {0, 8, 226, 190};
static const double column_left = 236, column_width = 50, row_height = 11.2,
                    row_top = 34;
static const char *const column_title[COLUMNS] = {"copied", "by the\nsecond",
                                                  "by the first,\neach once"};

/// The edges as they are copied from the triangles, before any is dropped.
static void copy_records(const tf_elements *triangles, int record[RECORDS][2])
{
    static const int side[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (int i = 0; i < RECORDS - LOOSE; i++)
        for (int end = 0; end < 2; end++)
            record[i][end] = triangles->corner[3 * (i / 3) + side[i % 3][end]];
    record[RECORDS - 1][0] = rod[0][1];
    record[RECORDS - 1][1] = rod[0][0];
}

/// Sort the edges by one vertex, those with the same one in their order.
static void sort_records(int at, int record[RECORDS][2])
{
    for (int i = 1; i < RECORDS; i++)
        for (int j = i; j > 0 && record[j][at] < record[j - 1][at]; j--) {
            int swap[2];
            memcpy(swap, record[j], sizeof swap);
            memcpy(record[j], record[j - 1], sizeof swap);
            memcpy(record[j - 1], swap, sizeof swap);
        }
}

// Drawing ----------------------------------------------------------------

static tf_vector vertex(int v)
{
    return fig_vector_of(place[v]);
}

static void name_vertices(fig_panel *panel)
{
    static const fig_side side[VERTICES] = {FIG_SIDE_W, FIG_SIDE_S, FIG_SIDE_S,
                                            FIG_SIDE_N, FIG_SIDE_N, FIG_SIDE_E,
                                            FIG_SIDE_N, FIG_SIDE_N, FIG_SIDE_N};
    for (int v = 0; v < VERTICES; v++) {
        char text[8];
        snprintf(text, sizeof text, "%d", v);
        fig_panel_label(panel, vertex(v),
                        (fig_label){.text = text,
                                    .size = FIG_LETTERS_SMALL,
                                    .side = side[v],
                                    .gap = 5});
    }
}

static void draw_surface(fig_page *page, const tf_elements *edges)
{
    fig_panel *panel = fig_page_panel(page, surface_box);
    fig_panel_look(panel, (fig_camera){.azimuth = 42, .elevation = 30});
    fig_panel_margin(panel, 14);
    fig_scene *scene = fig_panel_scene(panel);
    for (int i = 0; i < TRIANGLES; i++) {
        tf_vector corner[3];
        for (int c = 0; c < 3; c++)
            corner[c] = vertex(triangle[i][c]);
        fig_scene_triangle(
            scene, corner, 0,
            (fig_paint){.role = FIG_ROLE_TRIANGLE, .opacity = 0.55});
    }
    for (int i = 0; i < edges->count; i++)
        fig_scene_tube(scene, vertex(edges->corner[(ptrdiff_t)2 * i]),
                       vertex(edges->corner[2 * i + 1]), FIG_WIDTH_TUBE,
                       (fig_paint){.role = FIG_ROLE_EDGE});
    for (int v = 0; v < VERTICES; v++)
        fig_scene_ball(scene, vertex(v), v == VERTICES - 1 ? 6.5 : 4.5,
                       (fig_paint){.role = FIG_ROLE_POINT});
    name_vertices(panel);
}

/// The records in the order after a pass; what repeats the one before it is
/// pale in the last column.
static void write_column(fig_page *page, int column, int record[RECORDS][2])
{
    double middle = column_left + (column + 0.5) * column_width;
    char title[32];
    strcpy(title, column_title[column]);
    char *second = strchr(title, '\n');
    if (second)
        *second++ = 0;
    fig_page_text(page, middle, second ? 10 : 15, FIG_ALIGN_CENTER, title,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    if (second)
        fig_page_text(page, middle, 20, FIG_ALIGN_CENTER, second,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int i = 0; i < RECORDS; i++) {
        bool again = column == COLUMNS - 1 && i > 0 &&
                     memcmp(record[i], record[i - 1], sizeof *record) == 0;
        char text[16];
        snprintf(text, sizeof text, "%d  %d", record[i][0], record[i][1]);
        double y = row_top + i * row_height;
        fig_page_text(page, middle, y, FIG_ALIGN_CENTER, text,
                      FIG_LETTERS_SMALL,
                      again ? FIG_ROLE_NEUTRAL : FIG_ROLE_INK);
        if (again)
            fig_page_line(
                page, 2,
                (fig_point[]){{middle - 11, y - 3}, {middle + 11, y - 3}},
                (fig_stroke){.width = FIG_WIDTH_THIN,
                             .paint = {.role = FIG_ROLE_NEUTRAL}});
    }
}

static void print_numbers(const tf_elements *edges, FILE *numbers)
{
    fig_number(numbers, "triangles", TRIANGLES);
    fig_number(numbers, "records", RECORDS);
    fig_number(numbers, "edges", edges->count);
    for (int i = 0; i < edges->count; i++) {
        char key[16];
        snprintf(key, sizeof key, "edge_%d", i);
        fig_number(numbers, key,
                   10 * edges->corner[(ptrdiff_t)2 * i] +
                       edges->corner[2 * i + 1]);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_elements triangles = {0}, edges = {0};
    tf_sort_workspace workspace = {0};
    bool good = tf_mesh_triangles(&mesh, &triangles, &workspace) &&
                tf_mesh_edges(&mesh, &triangles, &edges, &workspace);
    TF_REQUIRE(good);
    int record[RECORDS][2];
    copy_records(&triangles, record);
    draw_surface(page, &edges);
    write_column(page, 0, record);
    sort_records(1, record);
    write_column(page, 1, record);
    sort_records(0, record);
    write_column(page, 2, record);
    print_numbers(&edges, numbers);
    tf_buffer_free(&triangles.storage);
    tf_buffer_free(&edges.storage);
    tf_sort_workspace_free(&workspace);
}

const fig_figure fig_derived_edges = {
    .name = "derived-edges",
    .title = "A surface, and its edges as they are sorted",
    .width = FIG_PAGE_WIDTH,
    .height = 212,
    .draw = draw,
};
