#include "kit/cloth_parts.h"
#include "renderer/figure.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 96,
    HEIGHT = 60
};

typedef struct picture {
    uint32_t pixel[HEIGHT][WIDTH];
} picture;

// Scenes ----------------------------------------------------------------------

enum {
    ROWS = 9,
    SHEET = ROWS * ROWS,
    HALVES = 2 * (ROWS - 1) * (ROWS - 1)
};

/// A sheet, a square plate below its middle and a large one below that.
typedef struct scene {
    double at[SHEET + 8][3];
    int triangle[HALVES + 4][3];
} scene;

static void add_square(scene *s, int first, int triangle, double half, double z)
{
    for (int i = 0; i < 4; i++) {
        double *at = s->at[first + i];
        at[0] = i % 2 ? half : -half;
        at[1] = i / 2 ? half : -half;
        at[2] = z;
    }
    const int two[2][3] = {{first, first + 1, first + 3},
                           {first, first + 3, first + 2}};
    memcpy(s->triangle[triangle], two, sizeof two);
}

/// The rows of the sheet and its triangles go either way, as `random` has it.
static scene new_scene(generator *random)
{
    scene s;
    int count = 0, way = below(random, 2) ? 1 : -1;
    for (int i = 0; i < SHEET; i++) {
        s.at[i][0] = way * (i % ROWS - 4) / 4.0;
        s.at[i][1] = (i / ROWS - 4) / 4.0;
        s.at[i][2] = 1;
    }
    for (int i = 0; i < SHEET; i++) {
        if (i % ROWS == ROWS - 1 || i / ROWS == ROWS - 1)
            continue;
        const int two[2][3] = {{i, i + 1, i + ROWS + 1},
                               {i, i + ROWS + 1, i + ROWS}};
        for (int k = 0; k < 2; k++, count++) {
            int turn = below(random, 3), flip = 1 + below(random, 2);
            for (int c = 0; c < 3; c++)
                s.triangle[count][c] = two[k][(turn + flip * c) % 3];
        }
    }
    add_square(&s, SHEET, HALVES, 0.3, 0.4);
    add_square(&s, SHEET + 4, HALVES + 2, 30, 0);
    return s;
}

static tf_surface *surface_of_scene(const scene *s)
{
    return surface_of(&(tf_mesh){.axes = 3,
                                 .vertices = SHEET + 8,
                                 .triangles = HALVES + 4,
                                 .triangle = *s->triangle});
}

/// Bend the sheet, move the plate.
static void move_on(scene *s, double bend, double x)
{
    for (int i = 0; i < SHEET; i++)
        s->at[i][2] = 1 - bend * s->at[i][0] * s->at[i][0];
    for (int i = SHEET; i < SHEET + 4; i++)
        s->at[i][0] += x;
}

static void add(fig_cloth *cloth, const scene *s)
{
    ck_assert(fig_cloth_add(cloth, SHEET + 8, *s->at));
}

static fig_cloth *film_of(const tf_surface *surface, scene s, double bend)
{
    fig_cloth *cloth = fig_cloth_new(surface, 3);
    ck_assert_ptr_nonnull(cloth);
    add(cloth, &s);
    move_on(&s, bend, 0.1);
    add(cloth, &s);
    ck_assert(fig_cloth_end(cloth));
    ck_assert_int_eq(fig_cloth_frames(cloth), 2);
    return cloth;
}

static void draw_as(const fig_cloth *cloth, int frame, const fig_theme *theme,
                    const fig_cloth_look *look, picture *drawn)
{
    const fig_page_options options = {.width = WIDTH,
                                      .height = HEIGHT,
                                      .pixels_x = WIDTH,
                                      .pixels_y = HEIGHT,
                                      .theme = theme,
                                      .moves = true};
    fig_page *page;
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    fig_cloth_draw(cloth, page, (fig_box){0, 0, WIDTH, HEIGHT}, frame, look);
    fig_status status = fig_page_paint(page, *drawn->pixel);
    ck_assert_msg(status == FIG_OK, "%s", fig_status_message(status));
    fig_page_free(page);
}

static void draw(const fig_cloth *cloth, int frame, const fig_theme *theme,
                 picture *drawn)
{
    const fig_cloth_look look = {.turned = true, .elevation = 35};
    draw_as(cloth, frame, theme, &look, drawn);
}

static int channel(uint32_t pixel, int k)
{
    return (int)(pixel >> (16 - 8 * k) & 255);
}

/// How many pixels are rather blue, the color of the first part.
static int blue_pixels(const picture *drawn)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        uint32_t pixel = drawn->pixel[i / WIDTH][i % WIDTH];
        count += channel(pixel, 2) > channel(pixel, 0) + 60;
    }
    return count;
}

// Tests -----------------------------------------------------------------------

START_TEST(what_keeps_its_shape_is_stiff)
{
    generator random = generator_new(1);
    const scene s = new_scene(&random);
    tf_surface *surface = surface_of_scene(&s);
    fig_cloth *cloth = film_of(surface, s, 1e-2);
    ck_assert_int_eq(fig_cloth_shape(cloth)->parts, 3);
    for (int part = 0; part < 3; part++)
        ck_assert_int_eq(fig_cloth_is_stiff(cloth, part), part > 0);
    ck_assert_int_eq(cloth->floor, 2);
    fig_cloth_free(cloth);

    // If nothing bends, what moves is not stiff: the plate.
    cloth = film_of(surface, s, 0);
    for (int part = 0; part < 3; part++)
        ck_assert_int_eq(fig_cloth_is_stiff(cloth, part), part != 1);
    ck_assert_int_eq(cloth->floor, 2);
    fig_cloth_free(cloth);

    // If nothing moves either, nothing is stiff.
    cloth = fig_cloth_new(surface, 3);
    add(cloth, &s);
    add(cloth, &s);
    ck_assert(fig_cloth_end(cloth));
    for (int part = 0; part < 3; part++)
        ck_assert(!fig_cloth_is_stiff(cloth, part));
    ck_assert_int_eq(cloth->floor, -1);
    fig_cloth_free(cloth);
    tf_surface_free(surface);
}
END_TEST

/// What is told counts, unless nothing else is left.
START_TEST(obstacles_are_gray)
{
    generator random = generator_new(1);
    scene s = new_scene(&random);
    tf_surface *surface = surface_of_scene(&s);
    for (int kind = 0; kind < 3; kind++) {
        fig_cloth *cloth = fig_cloth_new(surface, 3);
        bool of_obstacle[SHEET + 8];
        for (int v = 0; v < SHEET + 8; v++)
            of_obstacle[v] = kind == 1 ? v < SHEET : kind == 2;
        scene moved = s;
        move_on(&moved, 0.01, 0);
        add(cloth, &s);
        if (kind > 0)
            ck_assert(fig_cloth_set_obstacles(cloth, of_obstacle));
        add(cloth, &moved);
        ck_assert(fig_cloth_end(cloth));
        for (int part = 0; part < 3; part++)
            ck_assert_int_eq(fig_cloth_is_stiff(cloth, part),
                             kind == 1 ? part == 0 : part > 0);
        fig_cloth_free(cloth);
    }
    tf_surface_free(surface);
}
END_TEST

/// Whatever way its triangles go around, a sheet that lies flat at first has its
/// front above.
START_TEST(a_sheet_has_one_front)
{
    generator random = generator_new(1);
    for (long n = cases(20); n > 0; n--) {
        const scene s = new_scene(&random);
        tf_surface *surface = surface_of_scene(&s);
        fig_cloth *cloth = film_of(surface, s, 0.3);
        for (int i = 0; i < cloth->shape.triangles; i++) {
            const int *v = cloth->shape.triangle + 3 * (size_t)i;
            tf_vector normal =
                fig_cross(fig_difference(cloth->at[v[1]], cloth->at[v[0]]),
                          fig_difference(cloth->at[v[2]], cloth->at[v[0]]));
            ck_assert_double_gt(normal.x[2] * cloth->face[i], 0);
        }
        fig_cloth_free(cloth);
        tf_surface_free(surface);
    }
}
END_TEST

/// A prism of three sides without ends.
START_TEST(a_tube_has_its_front_outside)
{
    double at[6][3];
    int triangle[6][3];
    for (int i = 0; i < 3; i++) {
        const double turn = 2.0943951023931953 * i;
        const double low[3] = {0, cos(turn), sin(turn)};
        memcpy(at[i], low, sizeof low);
        memcpy(at[3 + i], low, sizeof low);
        at[3 + i][0] = 5;
        const int two[2][3] = {{i, (i + 1) % 3, 3 + i},
                               {3 + i, 3 + (i + 1) % 3, (i + 1) % 3}};
        memcpy(triangle[2 * i], two, sizeof two);
    }
    tf_surface *surface = surface_of(&(tf_mesh){
        .axes = 3, .vertices = 6, .triangles = 6, .triangle = *triangle});
    fig_cloth *cloth = fig_cloth_new(surface, 3);
    ck_assert(fig_cloth_add(cloth, 6, *at));
    ck_assert(fig_cloth_end(cloth));
    for (int i = 0; i < 6; i++) {
        const int *v = cloth->shape.triangle + 3 * (size_t)i;
        const tf_vector *p = cloth->at;
        tf_vector normal = fig_cross(fig_difference(p[v[1]], p[v[0]]),
                                     fig_difference(p[v[2]], p[v[0]]));
        tf_vector middle = {{0}};
        for (int c = 0; c < 3; c++)
            for (int k = 1; k < 3; k++)
                middle.x[k] += at[v[c]][k];
        ck_assert_double_gt(tf_vector_dot(normal, middle) * cloth->face[i], 0);
    }
    fig_cloth_free(cloth);
    tf_surface_free(surface);
}
END_TEST

/// A square of `cells` by `cells` cells, whose diagonals alternate, bent a
/// little in its second frame.
static fig_cloth *film_of_square(int cells, tf_surface **surface)
{
    int row = cells + 1, count = 0;
    double *at = malloc(3 * sizeof *at * (size_t)(row * row));
    int *triangle = malloc(6 * sizeof *triangle * (size_t)(cells * cells));
    ck_assert(at && triangle);
    for (int i = 0; i < row * row; i++) {
        at[3 * i] = i % row;
        at[3 * i + 1] = i / row;
        at[3 * i + 2] = 0;
    }
    for (int i = 0; i < cells * cells; i++) {
        int x = i % cells, y = i / cells, a = y * row + x, c = a + row;
        bool odd = (x + y) % 2 == 1;
        const int two[] = {a, a + 1, odd ? c + 1 : c,
                           c, c + 1, odd ? a : a + 1};
        memcpy(triangle + count, two, sizeof two);
        count += 6;
    }
    *surface = surface_of(&(tf_mesh){.axes = 3,
                                     .vertices = row * row,
                                     .triangles = count / 3,
                                     .triangle = triangle});
    fig_cloth *cloth = fig_cloth_new(*surface, 3);
    ck_assert(fig_cloth_add(cloth, row * row, at));
    for (int i = 0; i < row * row; i++)
        at[3 * i + 2] = 0.1 * at[3 * i] * at[3 * i];
    ck_assert(fig_cloth_add(cloth, row * row, at));
    ck_assert(fig_cloth_end(cloth));
    free(at);
    free(triangle);
    return cloth;
}

/// How many cells a triangle of a square is away from the border, by its middle.
static int cells_from_border(const fig_cloth *cloth, int triangle, int cells)
{
    const int *v = cloth->shape.triangle + 3 * (size_t)triangle;
    int row = cells + 1, x = 0, y = 0;
    for (int c = 0; c < 3; c++) {
        x += v[c] % row;
        y += v[c] / row;
    }
    int from = x / 3 < y / 3 ? x / 3 : y / 3;
    int to = cells - 1 - (x / 3 > y / 3 ? x / 3 : y / 3);
    return from < to ? from : to;
}

START_TEST(stripes_run_along_the_border)
{
    static const struct {
        int cells;
        unsigned striped; ///< a bit for each ring of cells
    } square[] = {{1, 0},
                  {4, 0},
                  {6, 1U << 1},
                  {8, 1U << 1},
                  {16, 1U << 1},
                  {28, 1U << 2 | 1U << 4},
                  {40, 1U << 3 | 1U << 4 | 1U << 6}};
    for (size_t k = 0; k < sizeof square / sizeof *square; k++) {
        tf_surface *surface;
        fig_cloth *cloth = film_of_square(square[k].cells, &surface);
        for (int i = 0; i < cloth->shape.triangles; i++) {
            int ring = cells_from_border(cloth, i, square[k].cells);
            ck_assert_msg(cloth->hem[i] == (square[k].striped >> ring & 1),
                          "%d cells, ring %d", square[k].cells, ring);
        }
        fig_cloth_free(cloth);
        tf_surface_free(surface);
    }
}
END_TEST

START_TEST(what_has_no_border_or_is_stiff_has_no_stripes)
{
    const double at[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int triangle[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    tf_surface *surface = surface_of(&(tf_mesh){
        .axes = 3, .vertices = 4, .triangles = 4, .triangle = *triangle});
    fig_cloth *cloth = fig_cloth_new(surface, 3);
    ck_assert(fig_cloth_add(cloth, 4, *at) && fig_cloth_end(cloth));
    for (int i = 0; i < 4; i++)
        ck_assert(!cloth->hem[i]);
    fig_cloth_free(cloth);
    tf_surface_free(surface);

    // The sheet of this scene is stiff, for only the plate moves.
    generator random = generator_new(1);
    const scene s = new_scene(&random);
    surface = surface_of_scene(&s);
    cloth = film_of(surface, s, 0);
    for (int i = 0; i < HALVES; i++)
        ck_assert(!cloth->hem[i]);
    fig_cloth_free(cloth);
    tf_surface_free(surface);
}
END_TEST

/// The floor is 30 times as large as the sheet, which fills the picture.
START_TEST(cloth_fills_the_picture_and_paper_is_around_it)
{
    generator random = generator_new(1);
    const scene s = new_scene(&random);
    tf_surface *surface = surface_of_scene(&s);
    fig_cloth *cloth = film_of(surface, s, 0.3);
    const fig_theme *const themes[] = {&fig_theme_light, &fig_theme_dark};
    for (int i = 0; i < 2; i++) {
        picture drawn;
        draw(cloth, i, themes[i], &drawn);
        ck_assert_int_gt(blue_pixels(&drawn), WIDTH * HEIGHT / 8);
        fig_rgb paper = themes[i]->color[FIG_ROLE_PAPER];
        const double wanted[3] = {paper.r, paper.g, paper.b};
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(channel(drawn.pixel[0][0], k),
                                    255 * wanted[k], 1);
    }
    fig_cloth_free(cloth);
    tf_surface_free(surface);
}
END_TEST

/// Draw a film of one frame, in which an axis points up.
static void draw_upright(const tf_surface *surface, const scene *s, fig_up up,
                         picture *drawn)
{
    fig_cloth *cloth = fig_cloth_new(surface, 3);
    ck_assert_ptr_nonnull(cloth);
    fig_cloth_set_up(cloth, up);
    add(cloth, s);
    ck_assert(fig_cloth_end(cloth));
    draw(cloth, 0, &fig_theme_light, drawn);
    fig_cloth_free(cloth);
}

START_TEST(any_axis_may_point_up)
{
    generator random = generator_new(1);
    const scene s = new_scene(&random);
    tf_surface *surface = surface_of_scene(&s);
    static picture expected, drawn;
    draw_upright(surface, &s, FIG_UP_Z, &expected);
    ck_assert_int_gt(blue_pixels(&expected), WIDTH * HEIGHT / 8);
    for (int up = FIG_UP_X; up <= FIG_UP_Z; up++) {
        scene turned = s;
        for (int i = 0; i < SHEET + 8; i++)
            for (int k = 0; k < 3; k++)
                turned.at[i][(up + 1 + k) % 3] = s.at[i][k];
        draw_upright(surface, &turned, (fig_up)up, &drawn);
        ck_assert_mem_eq(&drawn, &expected, sizeof drawn);
    }
    tf_surface_free(surface);
}
END_TEST

/// Below the sheet the ground is in the dark.
START_TEST(cloth_throws_a_shadow_on_the_ground)
{
    generator random = generator_new(1);
    const scene s = new_scene(&random);
    tf_surface *surface = surface_of_scene(&s);
    fig_cloth *cloth = film_of(surface, s, 0.1);
    picture drawn;
    draw(cloth, 0, &fig_theme_light, &drawn);
    int dark = 0;
    for (int x = 0; x < WIDTH; x++)
        dark += channel(drawn.pixel[HEIGHT - 12][x], 0) < 150;
    ck_assert_int_gt(dark, WIDTH / 8);
    fig_cloth_free(cloth);
    tf_surface_free(surface);
}
END_TEST

/// A sheet that is lowest in its middle, and so flat that its border is farther
/// out in all directions but straight down.
static fig_cloth *film_of_bowl(tf_surface **surface)
{
    generator random = generator_new(1);
    scene s = new_scene(&random);
    for (int i = 0; i < SHEET; i++)
        s.at[i][2] = 0.1 * hypot(s.at[i][0], s.at[i][1]);
    *surface = surface_of(&(tf_mesh){.axes = 3,
                                     .vertices = SHEET,
                                     .triangles = HALVES,
                                     .triangle = *s.triangle});
    fig_cloth *cloth = fig_cloth_new(*surface, 3);
    ck_assert(fig_cloth_add(cloth, SHEET, *s.at) && fig_cloth_end(cloth));
    return cloth;
}

START_TEST(the_ground_hides_no_cloth)
{
    static const double elevation[] = {60, 24, 5, 1, -1, -20};
    tf_surface *surface;
    fig_cloth *cloth = film_of_bowl(&surface);
    for (int i = 0; i < SHEET; i++)
        ck_assert_double_ge(cloth->at[i].x[2], cloth->bottom);
    for (size_t i = 0; i < sizeof elevation / sizeof *elevation; i++) {
        fig_cloth_look look = {.turned = true, .elevation = elevation[i]};
        static picture grounded, groundless;
        draw_as(cloth, 0, &fig_theme_light, &look, &grounded);
        look.groundless = true;
        draw_as(cloth, 0, &fig_theme_light, &look, &groundless);
        int all = blue_pixels(&groundless);
        ck_assert_int_gt(all, WIDTH / 4);
        int seen = blue_pixels(&grounded);
        ck_assert_msg(seen >= all - 4, "%d of %d pixels from %g degrees", seen,
                      all, elevation[i]);
    }
    fig_cloth_free(cloth);
    tf_surface_free(surface);
}
END_TEST

START_TEST(any_film_is_drawn)
{
    generator random = generator_new(1);
    static surface_case made;
    for (long n = cases(60); n > 0; n--) {
        int axes = 2 + below(&random, 2);
        random_surface(&random, axes, 12, (placement)below(&random, PLACEMENTS),
                       &made);
        tf_surface *surface = surface_of(&made.mesh);
        fig_cloth *cloth = fig_cloth_new(surface, axes);
        ck_assert(fig_cloth_add(cloth, made.mesh.vertices, made.motion.start));
        ck_assert(fig_cloth_add(cloth, made.mesh.vertices, made.motion.end));
        ck_assert(fig_cloth_end(cloth));
        picture drawn;
        draw(cloth, below(&random, 2), &fig_theme_light, &drawn);
        fig_cloth_free(cloth);
        tf_surface_free(surface);
    }
}
END_TEST

/// A triangle, and a square of twice its sides, in two triangles.
START_TEST(films_one_after_the_other_share_a_box)
{
    static const double small[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const double large[][3] = {
        {0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
    static const int triangle[] = {0, 1, 2, 2, 1, 3};
    tf_surface *surface[2];
    fig_cloth *cloth[2];
    for (int i = 0; i < 2; i++) {
        surface[i] = surface_of(&(tf_mesh){.axes = 3,
                                           .vertices = 3 + i,
                                           .triangles = 1 + i,
                                           .triangle = triangle});
        cloth[i] = fig_cloth_new(surface[i], 3);
        ck_assert(fig_cloth_add(cloth[i], 3 + i, i == 0 ? *small : *large));
    }
    ck_assert(fig_cloth_end_all(2, cloth));
    double length[2];
    for (int i = 0; i < 2; i++) {
        const tf_vector *at = cloth[i]->at;
        length[i] = fig_length(fig_difference(at[1], at[0]));
        ck_assert(!fig_cloth_is_stiff(cloth[i], 0));
        ck_assert_int_eq(cloth[i]->floor, -1);
        ck_assert_mem_eq(cloth[i]->reach, cloth[0]->reach,
                         sizeof cloth[0]->reach);
    }
    ck_assert_double_eq_tol(length[1], 2 * length[0], 1e-14);
    for (int i = 0; i < 2; i++) {
        picture drawn;
        draw(cloth[i], 0, &fig_theme_light, &drawn);
        ck_assert_int_gt(blue_pixels(&drawn), 0);
        fig_cloth_free(cloth[i]);
        tf_surface_free(surface[i]);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("kit/cloth");
    TCase *cloth = tcase_create("cloth");
    tcase_add_test(cloth, what_keeps_its_shape_is_stiff);
    tcase_add_test(cloth, obstacles_are_gray);
    tcase_add_test(cloth, a_sheet_has_one_front);
    tcase_add_test(cloth, a_tube_has_its_front_outside);
    tcase_add_test(cloth, stripes_run_along_the_border);
    tcase_add_test(cloth, what_has_no_border_or_is_stiff_has_no_stripes);
    tcase_add_test(cloth, cloth_fills_the_picture_and_paper_is_around_it);
    tcase_add_test(cloth, any_axis_may_point_up);
    tcase_add_test(cloth, cloth_throws_a_shadow_on_the_ground);
    tcase_add_test(cloth, the_ground_hides_no_cloth);
    tcase_add_test(cloth, any_film_is_drawn);
    tcase_add_test(cloth, films_one_after_the_other_share_a_box);
    suite_add_tcase(s, cloth);
    return s;
}
