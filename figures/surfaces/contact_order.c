// The contacts of a step in the order in which one worker, or two, find them,
// and the order in which a detection lists them.
#include "base/require.h"
#include "fast/detect.h"
#include "kit/figures.h"
#include "kit/meshes.h"
#include "renderer/plot.h"
#include "surface/surface_memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROWS = 60,
    COLUMNS = 120,
    WORKERS = 2,
    MOST = 128 // contacts
};

/// How far the sheet is folded at the start and at the end, in degrees.
static const double start_angle = 150, end_angle = 183.35;

static const double cell = 13, left = 70;

/// Contacts in the order in which they were found, by their ranks in the list.
typedef struct finding {
    int workers;
    int count[WORKERS]; ///< by each worker
    int rank[WORKERS][MOST];
    tf_surface_contact *list;
    int listed, points;
} finding;

// Detection --------------------------------------------------------------

/// Run tasks, the last first, on one worker after another.
static void in_turn(void *context, int count, tf_task *run, void *argument)
{
    const finding *f = context;
    for (int task = count - 1; task >= 0; task--)
        run(argument, task, task % f->workers);
}

static int rank_of(const finding *f, const tf_surface_contact *row)
{
    for (int i = 0; i < f->listed; i++)
        if (f->list[i].kind == row->kind &&
            memcmp(f->list[i].vertex, row->vertex, sizeof row->vertex) == 0)
            return i;
    TF_REQUIRE(false);
    return -1;
}

/// Keep the list, and find in it what each worker has found.
static void keep(finding *f, const tf_surface *surface,
                 const tf_contacts *found)
{
    size_t bytes = sizeof *f->list * found->count;
    f->list = malloc(bytes);
    TF_REQUIRE(f->list && found->count <= MOST);
    memcpy(f->list, found->contact, bytes);
    f->listed = (int)found->count;
    for (int i = 0; i < f->listed; i++)
        f->points += f->list[i].kind == TF_POINT_TRIANGLE;
    for (int i = 0; i < f->workers; i++) {
        const tf_worker *worker = surface->workers.worker[i];
        const tf_surface_contact *row = worker->row.data;
        f->count[i] = (int)worker->rows;
        for (int j = 0; j < f->count[i]; j++)
            f->rank[i][j] = rank_of(f, &row[j]);
    }
}

static finding find(int workers)
{
    finding f = {.workers = workers};
    fig_some_mesh at[2] = {fig_folded_sheet(ROWS, COLUMNS, start_angle),
                           fig_folded_sheet(ROWS, COLUMNS, end_angle)};
    const tf_mesh mesh = fig_mesh_in_space(&at[0]);
    const tf_motion motion = {3, at[0].vertices, at[0].x, at[1].x};
    tf_parallel parallel = {workers, in_turn, &f};
    tf_detect_options detection = {.parallel = workers > 1 ? &parallel : NULL};
    tf_surface *surface;
    tf_contacts found;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_surface_detect(surface, &motion, &detection, &found, NULL) ==
               TF_OK);
    keep(&f, surface, &found);
    tf_surface_free(surface);
    for (int t = 0; t < 2; t++)
        fig_some_mesh_free(&at[t]);
    return f;
}

static bool same_lists(const finding *a, const finding *b)
{
    return a->listed == b->listed &&
           memcmp(a->list, b->list, sizeof *a->list * (size_t)a->listed) == 0;
}

// Drawing ----------------------------------------------------------------

/// The kind gives the color, and the rank the shade.
static fig_paint paint_of(const finding *f, int rank)
{
    bool edges = rank >= f->points;
    int first = edges ? f->points : 0;
    int last = edges ? f->listed - 1 : f->points - 1;
    double along = last > first ? (double)(rank - first) / (last - first) : 0;
    return (fig_paint){.role = edges ? FIG_ROLE_EDGE : FIG_ROLE_POINT,
                       .opacity = 1,
                       .shade = 0.55 * along - 0.75 * (1 - along)};
}

/// The middle of a cell's lower or upper side.
static fig_point end_of(double width, double x, int at, double y, bool lower)
{
    return (fig_point){x + width * (at + 0.5), lower ? y + cell : y};
}

static void draw_cell(fig_page *page, fig_box box, fig_paint paint)
{
    fig_page_fill_box(page, box, paint);
}

static void draw_list(fig_page *page, const finding *f, double width, double y)
{
    for (int i = 0; i < f->listed; i++)
        draw_cell(page, (fig_box){left + width * i, y, width - 0.8, cell},
                  paint_of(f, i));
    fig_page_text(page, left - 6, y + cell - 3, FIG_ALIGN_RIGHT, "listed",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

/// What the workers have found, and where it is in the list, which is at
/// `list_y`.
static void draw_found(fig_page *page, const finding *f, double width, double y,
                       double list_y)
{
    double gap = 10, x = left - gap * (f->workers - 1) / 2.0;
    for (int i = 0; i < f->workers; i++, x += gap)
        for (int j = 0; j < f->count[i]; j++, x += width) {
            bool above = y < list_y;
            fig_paint paint = paint_of(f, f->rank[i][j]);
            const fig_point line[2] = {
                end_of(width, x, 0, y, above),
                end_of(width, left, f->rank[i][j], list_y, !above)};
            draw_cell(page, (fig_box){x, y, width - 0.8, cell}, paint);
            fig_page_line(page, 2, line,
                          (fig_stroke){.paint = paint,
                                       .width = FIG_WIDTH_HAIR,
                                       .under_labels = true});
        }
    fig_page_text(page, left - 6 - gap / 2 * (f->workers - 1), y + cell - 3,
                  FIG_ALIGN_RIGHT,
                  f->workers == 1 ? "one worker" : "two workers",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    finding one = find(1), two = find(WORKERS);
    double width = (fig_page_width(page) - left - 12) / one.listed;
    double list_y = 88;
    draw_found(page, &one, width, 20, list_y);
    draw_list(page, &one, width, list_y);
    draw_found(page, &two, width, 2 * list_y - 20, list_y);
    fig_plot_key(page, left, 10, "vertex and triangle", FIG_ROLE_POINT);
    fig_plot_key(page, left + 110, 10, "two edges", FIG_ROLE_EDGE);
    fig_number(numbers, "contacts", one.listed);
    fig_number(numbers, "point_triangle", one.points);
    fig_number(numbers, "same", same_lists(&one, &two));
    for (int i = 0; i < WORKERS; i++) {
        char key[32];
        snprintf(key, sizeof key, "worker_%d", i);
        fig_number(numbers, key, two.count[i]);
    }
    free(one.list);
    free(two.list);
}

const fig_figure fig_contact_order = {
    .name = "contact-order",
    .title = "Contacts as workers find them and as they are listed",
    .width = FIG_PAGE_WIDTH,
    .height = 180,
    .draw = draw,
};
