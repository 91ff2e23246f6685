// The numbers that figures print are those of numbers.txt, which tells how its
// lines are read, and of the tests in parts/.
#define _POSIX_C_SOURCE 200809L // open_memstream

#include "figures/numbers.h"
#include "figures/pages.h"

#include <stdarg.h>

enum {
    LINE = 1024
};

static const figure_test *const parts[] = {
    plane_tests,    space_tests,    arithmetic_tests, surfaces_tests,
    response_tests, untangle_tests, adaptive_tests};

const char *printed;
static const char *name; ///< of the figure under test

// What a figure prints --------------------------------------------------------

/// The caller frees it.
static char *print(const fig_figure *figure, const fig_theme *theme)
{
    fig_page_options options = {.pixels_x = FIG_PAGE_PIXELS_X,
                                .pixels_y = FIG_PAGE_PIXELS_Y,
                                .theme = theme};
    char *text = NULL;
    size_t size;
    FILE *numbers = open_memstream(&text, &size);
    fig_page_free(draw_figure(figure, options, numbers));
    fclose(numbers);
    return text;
}

/// The value in the line of a key, "key value"; NULL if there is none.
static const char *find(const char *text, const char *key)
{
    size_t length = strlen(key);
    while (text && (strncmp(text, key, length) != 0 || text[length] != ' ')) {
        const char *end = strchr(text, '\n');
        text = end ? end + 1 : NULL;
    }
    return text ? text + length : NULL;
}

static double number_in(const char *text, const char *key)
{
    const char *value = find(text, key);
    ck_assert_msg(value != NULL, "%s: no number %s in:\n%s", name, key, text);
    return strtod(value, NULL);
}

/// The key that was given as printf's arguments.
#define MAKE_KEY(made, key)                                                    \
    char made[LINE];                                                           \
    do {                                                                       \
        va_list words;                                                         \
        va_start(words, key);                                                  \
        vsnprintf(made, sizeof made, key, words);                              \
        va_end(words);                                                         \
    } while (0)

double number(const char *key, ...)
{
    MAKE_KEY(made, key);
    return number_in(printed, made);
}

bool has_number(const char *key, ...)
{
    MAKE_KEY(made, key);
    return find(printed, made) != NULL;
}

/// How far a number may be off that is expected up to rounding.
static double rounding(double expected)
{
    return 1e-12 * fmax(1, fabs(expected));
}

static void compare(double tolerance, double expected, const char *key)
{
    double found = number_in(printed, key);
    ck_assert_msg(fabs(found - expected) <= tolerance,
                  "%s: %s is %.17g, not %.17g", name, key, found, expected);
}

void expect(double expected, const char *key, ...)
{
    MAKE_KEY(made, key);
    compare(rounding(expected), expected, made);
}

void expect_within(double tolerance, double expected, const char *key, ...)
{
    MAKE_KEY(made, key);
    compare(tolerance, expected, made);
}

double measured(const char *name_of_file, const char *row, ...)
{
    MAKE_KEY(made, row);
    char path[LINE], line[LINE];
    snprintf(path, sizeof path, "figures/measured/%s.csv", name_of_file);
    FILE *file = fopen(path, "r");
    ck_assert_msg(file != NULL, "%s: no %s", name, path);
    size_t length = strlen(made);
    bool found = false;
    while (!found && fgets(line, sizeof line, file))
        found = strncmp(line, made, length) == 0 && line[length] == ',';
    fclose(file);
    ck_assert_msg(found, "%s: no row '%s' in %s", name, made, path);
    return strtod(line + length + 1, NULL);
}

// Expressions -----------------------------------------------------------------

static double degrees(double x)
{
    return x * 180 / PI;
}

static double radians(double x)
{
    return x * PI / 180;
}

static const struct {
    const char *name;
    double (*apply)(double x);
} functions[] = {
    {"abs", fabs},  {"sqrt", sqrt},       {"exp", exp},
    {"log", log},   {"sin", sin},         {"cos", cos},
    {"tan", tan},   {"acos", acos},       {"atan", atan},
    {"ceil", ceil}, {"round", round},     {"radians", radians},
    {"log2", log2}, {"degrees", degrees},
};

static bool accept(const char **at, const char *word)
{
    *at += strspn(*at, " ");
    bool found = strncmp(*at, word, strlen(word)) == 0;
    *at += found ? strlen(word) : 0;
    return found;
}

static double read_sum(const char **at);

/// What stands before a closing mark, which is read too.
static void read_until(const char **at, const char *marks, char word[LINE])
{
    size_t length = strcspn(*at, marks);
    snprintf(word, LINE, "%.*s", (int)length, *at);
    *at += length;
}

/// A key of the figure under test, or of another one, "figure:key".
static double number_of(const char *key)
{
    const char *colon = strchr(key, ':');
    if (!colon)
        return number_in(printed, key);
    char other[LINE];
    snprintf(other, sizeof other, "%.*s", (int)(colon - key), key);
    const fig_figure *figure = fig_figure_named(other);
    ck_assert_msg(figure != NULL, "%s: no figure %s", name, other);
    char *text = print(figure, &fig_theme_light);
    double value = number_in(text, colon + 1);
    free(text);
    return value;
}

static double read_term(const char **at)
{
    char word[LINE], *end;
    if (accept(at, "(")) {
        double value = read_sum(at);
        ck_assert_msg(accept(at, ")"), "%s: no ')' before %s", name, *at);
        return value;
    }
    if (accept(at, "'")) {
        read_until(at, "'", word);
        accept(at, "'");
        return measured("library", "%s", word);
    }
    read_until(at, " ()", word);
    for (size_t i = 0; **at == '(' && i < sizeof functions / sizeof *functions;
         i++)
        if (strcmp(word, functions[i].name) == 0)
            return functions[i].apply(read_term(at));
    double value = strtod(word, &end);
    return end > word && *end == '\0' ? value : number_of(word);
}

static double read_product(const char **at)
{
    double value = read_term(at);
    for (;;)
        if (accept(at, "* "))
            value *= read_term(at);
        else if (accept(at, "/ "))
            value /= read_term(at);
        else
            return value;
}

static double read_sum(const char **at)
{
    double value = read_product(at);
    for (;;)
        if (accept(at, "+ "))
            value += read_product(at);
        else if (accept(at, "- "))
            value -= read_product(at);
        else
            return value;
}

// Lines -----------------------------------------------------------------------

static bool compares(double a, const char *relation, double b, double tolerance)
{
    switch (relation[0]) {
    case '<':
        return relation[1] == '=' ? a <= b : a < b;
    case '>':
        return relation[1] == '=' ? a >= b : a > b;
    case '!':
        return a != b;
    default:
        return fabs(a - b) <= tolerance;
    }
}

static void expect_statement(const char *statement)
{
    static const char *const relations[] = {"<=", ">=", "!=", "<", ">", "="};
    const char *at = statement;
    double left = read_sum(&at);
    do {
        int i = 0;
        while (i < 6 && !accept(&at, relations[i]))
            i++;
        ck_assert_msg(i < 6, "%s: no relation before '%s'", name, at);
        double right = read_sum(&at);
        double tolerance = accept(&at, "+-") ? read_sum(&at) : rounding(right);
        ck_assert_msg(compares(left, relations[i], right, tolerance),
                      "%s: %s: found %.17g, expected %s %.17g", name, statement,
                      left, relations[i], right);
        left = right;
    } while (*at != '\0');
}

/// How many items, "{a,b,c}", there are between braces.
static int count_items(const char *brace)
{
    int count = 1;
    for (; *brace != '}'; brace++)
        count += *brace == ',';
    return count;
}

/// A line with an item in place of all braces that have so many of them.
static void choose(const char *line, int items, int item, char chosen[LINE])
{
    while (*line) {
        if (*line != '{' || count_items(line) != items) {
            *chosen++ = *line++;
            continue;
        }
        const char *from = line + 1;
        for (int i = 0; i < item; i++)
            from = strchr(from, ',') + 1;
        while (*from != ',' && *from != '}')
            *chosen++ = *from++;
        line = strchr(line, '}') + 1;
    }
    *chosen = '\0';
}

static void expect_expanded(const char *line)
{
    const char *brace = strchr(line, '{');
    if (!brace) {
        expect_statement(line);
        return;
    }
    int items = count_items(brace);
    for (int i = 0; i < items; i++) {
        char chosen[LINE];
        choose(line, items, i, chosen);
        expect_expanded(chosen);
    }
}

/// The next line of numbers.txt, without comments, in two: the figure's name
/// and what is expected of its numbers.
static bool read_line(FILE *file, char figure[LINE], char line[LINE])
{
    char text[LINE];
    int next = ' ';
    for (size_t length = 0; next == ' ' && length < sizeof text - 1;) {
        if (!fgets(text + length, (int)(sizeof text - length), file))
            return false;
        if (*text == '#' || *text == '\n')
            continue;
        length += strcspn(text + length, "\n");
        ungetc(next = getc(file), file);
    }
    ck_assert_int_eq(sscanf(text, "%1023s %1023[^\n]", figure, line), 2);
    return true;
}

static FILE *open_lines(void)
{
    FILE *file = fopen("tests/figures/numbers.txt", "r");
    ck_assert_ptr_nonnull(file);
    return file;
}

// Tests -----------------------------------------------------------------------

static void expect_lines(void)
{
    FILE *file = open_lines();
    char figure[LINE], line[LINE];
    while (read_line(file, figure, line))
        if (strcmp(figure, name) == 0)
            for (char *next = strtok(line, ";"); next; next = strtok(NULL, ";"))
                expect_expanded(next);
    fclose(file);
}

START_TEST(figures_print_what_is_expected)
{
    const fig_figure *figure = fig_figures[_i];
    char *dark = print(figure, &fig_theme_dark);
    char *light = print(figure, &fig_theme_light);
    name = figure->name;
    printed = light;
    ck_assert_str_eq(light, dark);
    expect_lines();
    if (figure->moves)
        expect_statement("0 <= film_still <= 1");
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        for (const figure_test *test = parts[i]; test->figure; test++)
            if (test->figure == figure)
                test->expect();
    free(light);
    free(dark);
}
END_TEST

START_TEST(every_line_is_about_a_figure)
{
    FILE *file = open_lines();
    char figure[LINE], line[LINE];
    while (read_line(file, figure, line))
        ck_assert_msg(fig_figure_named(figure) != NULL, "no figure %s: %s",
                      figure, line);
    fclose(file);
}
END_TEST

// Scenes of moving elements ---------------------------------------------------

void make_vertices(int axes, int count, const double coordinate[],
                   tf_worldline vertex[])
{
    for (int i = 0; i < count; i++, coordinate += 2 * axes)
        vertex[i] = tf_worldline_between(axes, coordinate, coordinate + axes);
}

double oracle_time(int axes, int vertices, const tf_worldline first[],
                   int others, const tf_worldline second[])
{
    mpq_t toi;
    mpq_init(toi);
    bool meet = oracle_meet(axes, vertices, first, others, second, toi);
    double time = meet ? mpq_get_d(toi) : -1;
    mpq_clear(toi);
    return time;
}

double oracle_simplices_time(int axes, const oracle_simplex *s,
                             const oracle_simplex *r)
{
    mpq_t toi;
    mpq_init(toi);
    double time = oracle_simplices_meet(axes, s, r, toi) ? mpq_get_d(toi) : -1;
    mpq_clear(toi);
    return time;
}

bool meet_at(int t, int axes, int vertices, const tf_worldline first[],
             int others, const tf_worldline second[])
{
    oracle_simplex s = {.count = vertices}, r = {.count = others};
    for (int i = 0; i < vertices; i++)
        s.event[i] = &first[i].at[t];
    for (int i = 0; i < others; i++)
        r.event[i] = &second[i].at[t];
    return oracle_slices_meet(axes, &s, &r);
}

bool boxes_apart(int axes, int vertices, const tf_worldline first[], int others,
                 const tf_worldline second[])
{
    for (int k = 0; k < axes; k++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int i = 0; i < vertices + others; i++)
            for (int t = 0; t < 2; t++) {
                bool side = i >= vertices;
                const tf_worldline *v =
                    side ? &second[i - vertices] : &first[i];
                low[side] = fmin(low[side], v->at[t].x[k]);
                high[side] = fmax(high[side], v->at[t].x[k]);
            }
        if (low[0] > high[1] || low[1] > high[0])
            return true;
    }
    return false;
}

Suite *suite(void)
{
    Suite *s = suite_create("figures/numbers");
    TCase *numbers = tcase_create("numbers");
    tcase_add_loop_test(numbers, figures_print_what_is_expected, 0,
                        count_figures());
    tcase_add_test(numbers, every_line_is_about_a_figure);
    suite_add_tcase(s, numbers);
    return s;
}
