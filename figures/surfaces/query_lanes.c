// The numbers of eight queries in memory, line by line: one query after
// another, and in a block, one lane a query.
#include "kit/figures.h"

#include "fast/block_filter.h"

#include <stddef.h>
#include <stdio.h>

enum {
    QUERIES = TF_BLOCK_QUERIES,
    NUMBERS = 24, ///< of a query
    LINE = 8,     ///< numbers that a cache line holds
    LINES = QUERIES * NUMBERS / LINE,
    GROUP = 3 ///< lines that have a name in common
};

static const double cell_width = 15, cell_height = 7.4, top = 24;

/// How queries lie in memory: where number i of a query is.
typedef int arrangement(int query, int number);

static int one_after_another(int query, int number)
{
    return query * NUMBERS + number;
}

static int in_lanes(int query, int number)
{
    static const tf_query_block block;
    const double *first = &block.at[0][0][0][0];
    int t = number / (NUMBERS / 2), v = number / 3 % 4, k = number % 3;
    return (int)(&block.at[t][v][k][query] - first);
}

static const struct layout {
    const char *key, *title;
    arrangement *place;
    const char *group[LINES / GROUP];
    double left;
} layouts[] = {
    {"rows",
     "*one query after another*",
     one_after_another,
     {"query 0", "query 1", "query 2", "query 3", "query 4", "query 5",
      "query 6", "query 7"},
     58},
    {"lanes",
     "*a lane a query*",
     in_lanes,
     {"$P$", "$A$", "$B$", "$C$", "$p$", "$a$", "$b$", "$c$"},
     234},
};

static fig_box cell_of(const struct layout *layout, int place)
{
    int column = place % LINE, row = place / LINE;
    return (fig_box){layout->left + column * cell_width,
                     top + row * cell_height, cell_width, cell_height};
}

/// A query has one shade wherever its numbers are.
static void draw_number(fig_page *page, const struct layout *layout, int query,
                        int number)
{
    fig_box cell = cell_of(layout, layout->place(query, number));
    fig_page_fill_box(
        page, (fig_box){cell.x, cell.y, cell.width - 0.8, cell.height - 0.8},
        (fig_paint){.role = FIG_ROLE_EDGE,
                    .opacity = 0.14 + 0.74 * query / (QUERIES - 1)});
}

/// The number that the processor wants of all queries at once.
static void mark_wanted(fig_page *page, const struct layout *layout)
{
    for (int query = 0; query < QUERIES; query++) {
        fig_box cell = cell_of(layout, layout->place(query, 0));
        double right = cell.x + cell.width - 0.8;
        double foot = cell.y + cell.height - 0.8;
        fig_point corner[4] = {
            {cell.x, cell.y}, {right, cell.y}, {right, foot}, {cell.x, foot}};
        fig_page_line(page, 4, corner,
                      (fig_stroke){.paint.role = FIG_ROLE_CONTACT,
                                   .width = 1.6,
                                   .closed = true});
    }
}

static int lines_wanted(const struct layout *layout)
{
    bool wanted[LINES] = {false};
    int count = 0;
    for (int query = 0; query < QUERIES; query++)
        wanted[layout->place(query, 0) / LINE] = true;
    for (int line = 0; line < LINES; line++)
        count += wanted[line];
    return count;
}

static void name_lines(fig_page *page, const struct layout *layout)
{
    for (int i = 0; i < LINES / GROUP; i++)
        fig_page_text(page, layout->left - 8,
                      top + (GROUP * i + GROUP / 2.0) * cell_height + 3,
                      FIG_ALIGN_RIGHT, layout->group[i], FIG_LETTERS_SMALL,
                      FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    for (int i = 0; i < 2; i++) {
        const struct layout *layout = &layouts[i];
        fig_page_text(page, layout->left + LINE * cell_width / 2, top - 9,
                      FIG_ALIGN_CENTER, layout->title, FIG_LETTERS,
                      FIG_ROLE_INK);
        for (int query = 0; query < QUERIES; query++)
            for (int number = 0; number < NUMBERS; number++)
                draw_number(page, layout, query, number);
        mark_wanted(page, layout);
        name_lines(page, layout);
        char key[32];
        snprintf(key, sizeof key, "%s_wanted", layout->key);
        fig_number(numbers, key, lines_wanted(layout));
    }
    fig_number(numbers, "bytes", NUMBERS * sizeof(double));
    fig_number(numbers, "lines", LINES);
}

const fig_figure fig_query_lanes = {
    .name = "query-lanes",
    .title = "Eight queries in memory, one after another and in lanes",
    .width = FIG_PAGE_WIDTH,
    .height = 210,
    .draw = draw,
};
