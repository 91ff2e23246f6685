// Pairs that meet, pushed apart by rows of several kinds: how often that takes
// several rounds or never ends, and how much it changes the elements.
#include "kit/figures.h"

#include "kit/pushed_pair.h"
#include "kit/random.h"
#include "renderer/plot.h"

#include <string.h>

enum {
    PAIRS = 4000, ///< of each kind that meet, for each deformation
    KINDS = 3,
    DEFORMATIONS = 3,
    ROWS = FIG_CANDIDATES + 1, ///< the last: the library's choice
    MEASURES = 4
};

static const double deformation[DEFORMATIONS] = {1, 0.1, 0.01};

/// How far the middles of the elements' squares or cubes may be apart along
/// each axis; the sides are 1.
static const double offset = 0.2;

typedef struct kind {
    const char *key, *name;
    int axes, first;
    fig_role role;
} kind;

static const kind kinds[KINDS] = {
    {"pe", "point and edge", 2, 1, FIG_ROLE_POINT},
    {"pt", "point and triangle", 3, 1, FIG_ROLE_TRIANGLE},
    {"ee", "edge and edge", 3, 2, FIG_ROLE_EDGE}};

static const char *const row_key[ROWS] = {"coordinates", "gradient", "both",
                                          "pivots", "library"};

/// What was counted for one kind of row.
typedef struct count {
    long all, stuck, gained; ///< pairs, those that stay stuck, and those that
                             ///< gained kinetic energy
    long like;   ///< pairs that every kind of row has parted: of these, summed,
    long rounds; ///< how many it took, and
    double change; ///< how much the pushes changed an element's edges
} count;

// Random pairs -----------------------------------------------------------

static double random_between(uint64_t *state, double most)
{
    return most * (2 * fig_random_number(state) - 1);
}

static tf_vector random_direction(uint64_t *state, int axes)
{
    tf_vector v = {{0, 0, 0}};
    double square;
    do {
        for (int k = 0; k < axes; k++)
            v.x[k] = random_between(state, 1);
        square = tf_vector_dot(v, v);
    } while (square > 1 || square < 1e-4);
    return fig_normalized(v);
}

/// The first element moves by 1 in some direction, and every vertex by up to
/// `deform` along each axis besides.
static fig_pair random_pair(uint64_t *state, const kind *k, double deform)
{
    fig_pair pair = {.axes = k->axes, .first = k->first, .count = k->axes + 1};
    tf_vector way = random_direction(state, k->axes), apart = {{0, 0, 0}};
    for (int i = 0; i < k->axes; i++)
        apart.x[i] = random_between(state, offset);
    for (int v = 0; v < pair.count; v++)
        for (int i = 0; i < k->axes; i++) {
            bool is_first = v < k->first;
            pair.start[v].x[i] =
                random_between(state, 0.5) + (is_first ? apart.x[i] : 0);
            pair.move[v].x[i] =
                random_between(state, deform) + (is_first ? way.x[i] : 0);
        }
    return pair;
}

// What pushing does ------------------------------------------------------

static double energy(const fig_pair *pair)
{
    double sum = 0;
    for (int i = 0; i < pair->count; i++)
        sum += tf_vector_dot(pair->move[i], pair->move[i]) / 2;
    return sum;
}

/// The most by which the pushes change the difference of two vertices of one
/// element.
static double change_of_shape(const fig_pair *before, const fig_pair *after)
{
    tf_vector push[FIG_PAIR_VERTICES];
    double most = 0;
    for (int i = 0; i < after->count; i++)
        push[i] = fig_difference(after->move[i], before->move[i]);
    for (int i = 0; i < after->count; i++)
        for (int j = 0; j < i; j++)
            if ((i < after->first) == (j < after->first))
                most = fmax(most, fig_length(fig_difference(push[i], push[j])));
    return most;
}

/// Parts a pair by every kind of row, and counts.
static void try_rows(const fig_pair *pair, count n[ROWS])
{
    int rounds[ROWS];
    fig_pair pushed[ROWS];
    bool all_parted = true;
    for (int row = 0; row < ROWS; row++) {
        pushed[row] = *pair;
        rounds[row] = row < FIG_CANDIDATES
                          ? fig_pair_part(&pushed[row], (fig_candidate)row)
                          : fig_pair_part_as_library(&pushed[row]);
        n[row].all++;
        n[row].stuck += rounds[row] < 0;
        n[row].gained += rounds[row] >= 0 &&
                         energy(&pushed[row]) > energy(pair) * (1 + 1e-12);
        all_parted &= rounds[row] >= 0;
    }
    for (int row = 0; all_parted && row < ROWS; row++) {
        n[row].like++;
        n[row].rounds += rounds[row];
        n[row].change += change_of_shape(pair, &pushed[row]);
    }
}

/// What the contacts of the proposed steps were like.
typedef struct contacts {
    long disagree, sated; ///< sides; rows that want nothing
} contacts;

static void look_at(const fig_pair *pair, const tf_contact *contact,
                    contacts *seen)
{
    fig_pair_row row = fig_pair_row_of(pair, contact, FIG_BY_COORDINATES);
    seen->sated += fig_pair_parting(pair, &row) >= 0;
    double gap = tf_vector_dot(fig_vector_of(contact->normal),
                               fig_pair_vector(pair, contact));
    seen->disagree += gap * contact->normal_velocity > 0;
}

static void try_pairs(const kind *k, double deform, count n[ROWS],
                      contacts *seen)
{
    uint64_t state = 1;
    for (int i = 0; i < PAIRS;) {
        fig_pair pair = random_pair(&state, k, deform);
        tf_contact contact;
        if (!fig_pair_meets(&pair, &contact))
            continue;
        i++;
        look_at(&pair, &contact, seen);
        try_rows(&pair, n);
    }
}

// Numbers ----------------------------------------------------------------

static void print_number(FILE *numbers, const char *what, const char *row,
                         const char *elements, double deform, double value)
{
    char key[64];
    snprintf(key, sizeof key, "%s%s%s_%s_%g", what, *row ? "_" : "", row,
             elements, deform);
    fig_number(numbers, key, value);
}

/// A measure of a kind of row: rounds and change of shape, on average, and, of a
/// thousand pairs, those that stay stuck and those that gain energy.
static double measure(const count *n, int which)
{
    double all = (double)n->all, like = (double)n->like;
    switch (which) {
    case 0:
        return (double)n->rounds / like;
    case 1:
        return n->change / like;
    case 2:
        return 1000 * (double)n->stuck / all;
    default:
        return 1000 * (double)n->gained / all;
    }
}

static void print_counts(FILE *numbers, const char *elements, double deform,
                         const count n[ROWS])
{
    static const char *const key[MEASURES] = {"rounds", "change", "stuck",
                                              "gained"};
    for (int row = 0; row < ROWS; row++)
        for (int i = 0; i < MEASURES; i++)
            print_number(numbers, key[i], row_key[row], elements, deform,
                         measure(&n[row], i));
}

// Drawing ----------------------------------------------------------------

static const double left = 92, row_height = 21, top = 26;

typedef struct scale {
    double x, width, from, to;
    const char *name;
} scale;

/// The place of a number on a scale; numbers beyond stand at its end.
static double place_on(const scale *s, double number)
{
    double part = (fmin(number, s->to) - s->from) / (s->to - s->from);
    return s->x + part * s->width;
}

static void draw_scale(fig_page *page, const scale *s)
{
    double bottom = top + ROWS * row_height - row_height / 2;
    const fig_stroke thin = {.paint = {.role = FIG_ROLE_NEUTRAL, .shade = -0.5},
                             .width = FIG_WIDTH_HAIR,
                             .under_labels = true};
    fig_page_text(page, s->x + s->width / 2, 10, FIG_ALIGN_CENTER, s->name,
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
    for (int row = 0; row < ROWS; row++) {
        double y = top + row * row_height;
        fig_page_line(page, 2, (fig_point[]){{s->x, y}, {s->x + s->width, y}},
                      thin);
    }
    for (int i = 0; i <= 2; i++) {
        char text[16];
        double number = s->from + i * (s->to - s->from) / 2;
        double x = place_on(s, number);
        snprintf(text, sizeof text, "%g", number);
        fig_page_line(page, 2,
                      (fig_point[]){{x, top - row_height / 2}, {x, bottom}},
                      thin);
        fig_page_text(page, x, bottom + 11, FIG_ALIGN_CENTER, text,
                      FIG_LETTERS_SMALL, FIG_ROLE_NEUTRAL);
    }
}

static void draw_counts(fig_page *page, const scale s[], const kind *k, int at,
                        const count n[ROWS])
{
    for (int row = 0; row < ROWS; row++)
        for (int i = 0; i < 3; i++)
            fig_page_dot(page, place_on(&s[i], measure(&n[row], i)),
                         top + row * row_height + 4 * (at - 1), 5,
                         (fig_paint){.role = k->role});
}

static void name_rows(fig_page *page)
{
    static const char *const name[ROWS] = {"coordinates, $c$", "gradient, $B$",
                                           "push $c$, want $B$",
                                           "the two pivots", "as the library"};
    for (int row = 0; row < ROWS; row++)
        fig_page_text(page, left - 12, top + row * row_height + 3,
                      FIG_ALIGN_RIGHT, name[row], FIG_LETTERS_SMALL,
                      FIG_ROLE_INK);
}

static void draw(fig_page *page, FILE *numbers)
{
    double width = (fig_page_width(page) - left - 8) / 3 - 18;
    const scale s[3] = {
        {left, width, 1, 2, "rounds"},
        {left + width + 24, width, 0, 0.5, "change of shape"},
        {left + 2 * width + 48, width, 0, 80, "stuck, of 1,000"}};
    for (int i = 0; i < 3; i++)
        draw_scale(page, &s[i]);
    name_rows(page);
    fig_number(numbers, "pairs", PAIRS);
    fig_number(numbers, "most_rounds", FIG_PAIR_ROUNDS);
    for (int d = 0; d < DEFORMATIONS; d++)
        for (int k = 0; k < KINDS; k++) {
            count n[ROWS] = {{0}};
            contacts seen = {0, 0};
            try_pairs(&kinds[k], deformation[d], n, &seen);
            print_counts(numbers, kinds[k].key, deformation[d], n);
            print_number(numbers, "disagree", "", kinds[k].key, deformation[d],
                         1000 * (double)seen.disagree / PAIRS);
            print_number(numbers, "sated", "", kinds[k].key, deformation[d],
                         1000 * (double)seen.sated / PAIRS);
            if (deformation[d] == 0.1)
                draw_counts(page, s, &kinds[k], k, n);
        }
    for (int k = 0; k < KINDS; k++)
        fig_plot_key(page, left + 96 * k, fig_page_height(page) - 8,
                     kinds[k].name, kinds[k].role);
}

const fig_figure fig_kinds_of_rows = {
    .name = "kinds-of-rows",
    .title = "Pairs that are pushed apart by several kinds of rows",
    .width = FIG_PAGE_WIDTH,
    .height = 166,
    .draw = draw,
};
