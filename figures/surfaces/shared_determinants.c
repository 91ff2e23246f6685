// Which of the signs of a query are those of the same determinant, and which
// coordinates are sums of others: found out by computing them.
#include "kit/figures.h"

#include "arithmetic/filter.h"
#include "base/require.h"
#include "intersect/signs.h"
#include "kit/random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    VERTICES = 4,
    TRIALS = 8,
    MOST_ROWS = 4,
    CELLS = TF_PAIR_EVENTS,
    LARGEST = 50 ///< coordinates are integers up to it
};

static const double cell_width = 50, cell_height = 22, row_step = 27, left = 50;

/// The vertices by name, at the start and at the end.
static const struct kind {
    const char *key, *title, *name[2];
    int vertices; ///< of the first element
} kinds[] = {
    {"ee", "*two edges*, $AB$ *and* $CD$", {"ABCD", "abcd"}, 2},
    {"pt", "*a point* $P$ *and a triangle* $ABC$", {"PABC", "pabc"}, 1},
};

/// One coordinate of a pair of simplices.
typedef struct cell {
    char event;           ///< the name of the one that it belongs to
    double value[TRIALS]; ///< of the coordinate in random queries
    unsigned terms;       ///< of which others in the row it is the sum
    int number;           ///< of its determinant; 0: none, a sum
    bool seen;            ///< the determinant has been met before
} cell;

typedef struct chart {
    const struct kind *kind;
    int rows;
    char title[MOST_ROWS][24];
    cell at[MOST_ROWS][CELLS];
} chart;

// The coordinates --------------------------------------------------------

static void make_query(uint64_t *random, tf_worldline vertex[VERTICES])
{
    for (int i = 0; i < VERTICES; i++) {
        double at[2][TF_AXES];
        for (int j = 0; j < 2 * TF_AXES; j++)
            at[j / TF_AXES][j % TF_AXES] =
                floor(2 * LARGEST * fig_random_number(random)) - LARGEST;
        vertex[i] = tf_worldline_between(TF_AXES, at[0], at[1]);
        tf_worldline_set_vertex(&vertex[i], i);
    }
}

/// The coordinate without an event; integers like these are not rounded.
static double coordinate(const tf_pair *pair, int without)
{
    tf_differences differences;
    tf_pair_differences(pair, without, &differences);
    return tf_pair_orientation(pair, without) *
           tf_differences_estimate(&differences).number;
}

static void fill_row(chart *c, int row, int trial, const tf_pair *pair)
{
    TF_REQUIRE(pair->count == CELLS);
    for (int i = 0; i < CELLS; i++) {
        const tf_event *event = pair->event[i];
        c->at[row][i].event = c->kind->name[event->t][event->vertex];
        c->at[row][i].value[trial] = coordinate(pair, i);
    }
}

static void fill_chart(chart *c, int trial, uint64_t *random)
{
    tf_worldline vertex[VERTICES];
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    int first = c->kind->vertices, second = VERTICES - first;
    make_query(random, vertex);
    tf_sweep(first, vertex, s);
    tf_sweep(second, vertex + first, r);
    c->rows = 0;
    for (int i = 0; i < first; i++)
        for (int j = 0; j < second; j++) {
            tf_pair pair = tf_pair_of(&s[i], &r[j], TF_AXES);
            if (first == 1)
                snprintf(c->title[c->rows], sizeof *c->title, "$S_%d$",
                         r[j].pivot);
            else
                snprintf(c->title[c->rows], sizeof *c->title, "$S_%d, R_%d$",
                         s[i].pivot, r[j].pivot);
            fill_row(c, c->rows++, trial, &pair);
        }
}

// What they have in common -----------------------------------------------

static int size_of(unsigned set)
{
    int size = 0;
    for (; set != 0; set &= set - 1)
        size++;
    return size;
}

/// Whether a cell is the sum of some cells of its row in all queries.
static bool is_sum(const cell row[CELLS], int lane, unsigned terms)
{
    bool equal = true;
    for (int trial = 0; trial < TRIALS; trial++) {
        double sum = 0;
        for (int i = 0; i < CELLS; i++)
            sum += terms >> i & 1 ? row[i].value[trial] : 0;
        equal &= sum == row[lane].value[trial];
    }
    return equal;
}

/// The smallest set of two cells or more that a cell is the sum of; 0: none.
static unsigned terms_of(const cell row[CELLS], int lane)
{
    unsigned best = 0;
    for (unsigned set = 1; set < 1U << CELLS; set++)
        if (size_of(set) > 1 && !(set >> lane & 1) && is_sum(row, lane, set) &&
            (best == 0 || size_of(set) < size_of(best)))
            best = set;
    return best;
}

/// Whether two cells are the same but for the sign.
static bool same(const cell *a, const cell *b)
{
    bool equal = true;
    for (int trial = 0; trial < TRIALS; trial++)
        equal &= fabs(a->value[trial]) == fabs(b->value[trial]);
    return equal;
}

/// Find sums, then number the determinants of all other cells.  Returns how
/// many there are.
static int number_cells(chart *c)
{
    int count = 0;
    for (int i = 0; i < c->rows * CELLS; i++) {
        cell *this = &c->at[i / CELLS][i % CELLS];
        this->terms = terms_of(c->at[i / CELLS], i % CELLS);
        for (int j = 0; j < i && this->terms == 0 && !this->seen; j++) {
            const cell *other = &c->at[j / CELLS][j % CELLS];
            if (other->terms == 0 && same(this, other)) {
                this->number = other->number;
                this->seen = true;
            }
        }
        if (this->terms == 0 && !this->seen)
            this->number = ++count;
    }
    return count;
}

// The picture ------------------------------------------------------------

/// "7", or the numbers of which it is the sum, "3 + 4".
static void write_content(const cell row[CELLS], int i, char text[32])
{
    if (row[i].terms == 0) {
        snprintf(text, 32, "%d", row[i].number);
        return;
    }
    int length = 0;
    for (int j = 0; j < CELLS; j++)
        if (row[i].terms >> j & 1)
            length += snprintf(text + length, 32 - (size_t)length, "%s%d",
                               length > 0 ? "+" : "", row[j].number);
}

static fig_paint paint_of(const cell *this)
{
    if (this->terms != 0)
        return (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.22};
    return (fig_paint){.role = this->seen ? FIG_ROLE_TRIANGLE : FIG_ROLE_EDGE,
                       .opacity = this->seen ? 0.3 : 0.42};
}

static void draw_row(fig_page *page, const chart *c, int row, double top)
{
    fig_page_text(page, left - 8, top + 15, FIG_ALIGN_RIGHT, c->title[row],
                  FIG_LETTERS, FIG_ROLE_INK);
    for (int i = 0; i < CELLS; i++) {
        double x = left + i * (cell_width + 4);
        char name[8], content[32];
        snprintf(name, sizeof name, "$%c$", c->at[row][i].event);
        write_content(c->at[row], i, content);
        bool sum = c->at[row][i].terms != 0;
        fig_page_fill_box(page, (fig_box){x, top, cell_width, cell_height},
                          paint_of(&c->at[row][i]));
        fig_page_text(page, x + 4, top + 10, FIG_ALIGN_LEFT, name,
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
        fig_page_text(page, x + cell_width - 5, top + 16, FIG_ALIGN_RIGHT,
                      content, sum ? FIG_LETTERS_SMALL : FIG_LETTERS,
                      FIG_ROLE_INK);
    }
}

static void print_numbers(FILE *numbers, const chart *c, int different)
{
    int sums = 0, repeated = 0;
    for (int i = 0; i < c->rows * CELLS; i++) {
        sums += c->at[i / CELLS][i % CELLS].terms != 0;
        repeated += c->at[i / CELLS][i % CELLS].seen;
    }
    const struct {
        const char *name;
        int value;
    } number[] = {{"coordinates", c->rows * CELLS},
                  {"sums", sums},
                  {"repeated", repeated},
                  {"determinants", different}};
    for (int i = 0; i < 4; i++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%s", c->kind->key, number[i].name);
        fig_number(numbers, key, number[i].value);
    }
}

static void draw_key(fig_page *page, double y)
{
    static const cell shown[] = {{.number = 1}, {.seen = true}, {.terms = 1}};
    static const char *const name[] = {"a determinant", "the same again",
                                       "a sum"};
    static const double place[] = {0, 108, 216};
    for (int i = 0; i < 3; i++) {
        double x = left + place[i];
        fig_page_fill_box(page, (fig_box){x, y - 9, 14, 11},
                          paint_of(&shown[i]));
        fig_page_text(page, x + 19, y, FIG_ALIGN_LEFT, name[i],
                      FIG_LETTERS_SMALL, FIG_ROLE_INK);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    uint64_t random = 14;
    double top = 6;
    for (int k = 0; k < 2; k++) {
        chart c = {.kind = &kinds[k]};
        for (int trial = 0; trial < TRIALS; trial++)
            fill_chart(&c, trial, &random);
        print_numbers(numbers, &c, number_cells(&c));
        fig_page_text(page, left, top + 10, FIG_ALIGN_LEFT, c.kind->title,
                      FIG_LETTERS, FIG_ROLE_INK);
        for (int row = 0; row < c.rows; row++)
            draw_row(page, &c, row, top + 18 + row_step * row);
        top += 28 + row_step * c.rows;
    }
    draw_key(page, top + 8);
}

const fig_figure fig_shared_determinants = {
    .name = "shared-determinants",
    .title = "The determinants of a query, and which are sums of others",
    .width = FIG_PAGE_WIDTH,
    .height = 268,
    .draw = draw,
};
