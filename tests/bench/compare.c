// The project's methods side by side: what a query costs, and how often each is
// wrong about linear motion.
//
// Costs are measured on the workloads soup and near, all methods in one run, in
// turns and by processor time.  Errors are counted on these, on the public
// queries and on the adversarial ones (below TF_SHARED_DATA, ../shared/data
// unless set), against an exact truth found by other means.  What the methods
// leave undecided counts as a hit.  The space-time methods answer another
// question, about elements that bend, so what counts as an error of theirs is
// where the two models differ.
//
// Prints a table, or with --csv all numbers as lines "name,value,unit", for
// figures/measured/methods.csv: more tolerances and thresholds, each set of
// queries by its name, and the rotating bar of tests/linear/rigid_motion.c.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "bench/measuring.h"
#include "bench/workloads.h"
#include "linear/rigid_motion.h"
#include "program/methods.h"
#include "support/linear_truth.h"

#include <glob.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROUNDS = 7,
    PATH = 1000
};

static void fail(const char *where, const char *why)
{
    fprintf(stderr, "compare: %s: %s\n", where, why);
    exit(2);
}

// Methods ---------------------------------------------------------------------

/// A method with what it takes: of a name, and of a tolerance or threshold
/// 10^-digits, or none.
typedef struct contender {
    const char *method, *name;
    const tf_arithmetic *arithmetic;
    int digits;
} contender;

enum {
    NO_DIGITS = -1, ///< a tolerance of zero
    NOT_ANY = -2    ///< no tolerance at all
};

static const contender contenders[] = {
    {"spacetime", "exact", &tf_exact, NOT_ANY},
    {"spacetime", "clamped", &tf_clamped, NOT_ANY},
    {"cubic", "cubic", NULL, NO_DIGITS},
    {"cubic", "cubic", NULL, 12},
    {"cubic", "cubic", NULL, 9},
    {"cubic", "cubic", NULL, 6},
    {"cubic", "cubic", NULL, 3},
    {"advancement", "advancement", NULL, 3},
    {"advancement", "advancement", NULL, 6},
    {"advancement", "advancement", NULL, 9},
};

enum {
    CONTENDERS = sizeof contenders / sizeof *contenders,
    MOST_DIGITS = 16 // of tolerances; of thresholds 12
};

static double number_of(const contender *c)
{
    return c->digits < 0 ? 0 : pow(10, -c->digits);
}

/// "exact", "cubic 0" or "cubic 1e-06".  Static storage.
static const char *label_of(const contender *c)
{
    static char label[40];
    if (c->digits == NOT_ANY)
        snprintf(label, sizeof label, "%s", c->name);
    else if (c->digits == NO_DIGITS)
        snprintf(label, sizeof label, "%s 0", c->name);
    else
        snprintf(label, sizeof label, "%s 1e-%02d", c->name, c->digits);
    return label;
}

/// What answers, ready.
typedef struct answerer {
    const char *name;
    const tf_method *method;
    tf_method_options options;
} answerer;

static answerer answerer_of(const contender *c)
{
    double number = number_of(c);
    return (answerer){c->method,
                      tf_choice_named(tf_methods, c->method),
                      {.arithmetic = c->arithmetic,
                       .tolerance = number,
                       .threshold = number}};
}

static bool finds_hit(const answerer *a, const tf_query_kind *kind,
                      const tf_query_rows *rows)
{
    tf_contact contact;
    tf_status status =
        tf_method_answer(a->method, &a->options, kind, rows, &contact);
    if (status != TF_OK)
        fail(a->name, tf_status_message(status));
    return contact.verdict != TF_APART;
}

// Queries ---------------------------------------------------------------------

/// A query of a set, and its truth about linear motion.
typedef struct known_query {
    const tf_query_kind *kind;
    tf_query_rows rows;
    bool hit;
} known_query;

typedef struct query_set {
    const char *name, *group;
    const char *pattern; ///< of files in the shared folder, or NULL
    long count, room, hits;
    known_query *query;
} query_set;

static query_set sets[] = {
    {.name = "public",
     .group = "public",
     .pattern = "sample-queries/*/%s/*.csv"},
    {.name = "lattice",
     .group = "adversarial",
     .pattern = "adversarial/lattice/%s/data.csv"},
    {.name = "rest",
     .group = "adversarial",
     .pattern = "adversarial/rest/%s/data.csv"},
    {.name = "tilted",
     .group = "adversarial",
     .pattern = "adversarial/tilted/%s/data.csv"},
    {.name = "scaled",
     .group = "adversarial",
     .pattern = "adversarial/scaled/%s/data.csv"},
    {.name = "soup", .group = "random"},
    {.name = "near", .group = "random"},
};

enum {
    SETS = sizeof sets / sizeof *sets
};

static const char *const groups[] = {"public", "adversarial", "random"};

enum {
    GROUPS = sizeof groups / sizeof *groups
};

static void add_query(query_set *set, const tf_query_kind *kind,
                      const tf_query_rows *rows)
{
    if (set->count == set->room) {
        set->room = 2 * set->room + 1000;
        set->query =
            realloc(set->query, sizeof *set->query * (size_t)set->room);
        if (!set->query)
            fail(set->name, "not enough memory");
    }
    double toi;
    known_query *q = &set->query[set->count++];
    *q = (known_query){.kind = kind, .rows = *rows};
    q->hit = linear_truth(kind->axes, kind->vertices[0], rows->x[0], rows->x[1],
                          &toi);
    set->hits += q->hit;
    if (strcmp(set->name, "public") == 0 && rows->ground_truth != q->hit)
        fail(set->name, "the truth on file is another");
}

static void read_queries(query_set *set, const char *path,
                         const tf_query_kind *kind)
{
    tf_query_file file;
    tf_fault fault = {0};
    tf_query_rows rows;
    if (!tf_query_file_open(&file, path, kind, 0, &fault))
        fail(path, "cannot read");
    while (tf_query_file_next(&file, &rows) == TF_READ_GOOD)
        add_query(set, kind, &rows);
    if (fault.text[0] != '\0')
        fail(path, fault.text);
    tf_query_file_close(&file);
}

/// The kinds, and the folders of their files.
static const char *const kinds[][2] = {{"point-edge", "point-edge"},
                                       {"point-triangle", "vertex-face"},
                                       {"edge-edge", "edge-edge"}};

/// Fails if there are none and they are needed; else notes it.
static void find_queries(query_set *set, bool needed)
{
    const char *root = getenv("TF_SHARED_DATA");
    for (int i = 0; i < 3; i++) {
        char pattern[PATH], inside[PATH / 2];
        snprintf(inside, sizeof inside, set->pattern, kinds[i][1]);
        snprintf(pattern, sizeof pattern, "%s/%s",
                 root ? root : "../shared/data", inside);
        glob_t found;
        if (glob(pattern, 0, NULL, &found) != 0)
            continue;
        for (size_t f = 0; f < found.gl_pathc; f++)
            read_queries(set, found.gl_pathv[f],
                         tf_choice_named(tf_query_kinds, kinds[i][0]));
        globfree(&found);
    }
    if (set->count == 0 && needed)
        fail(set->name, "no queries: set TF_SHARED_DATA");
    if (set->count == 0)
        fprintf(stderr, "compare: no %s queries: set TF_SHARED_DATA\n",
                set->name);
}

static workload workload_named(const char *name, int vertices)
{
    return strcmp(name, "soup") == 0 ? workload_soup(vertices)
                                     : workload_near(vertices);
}

/// Point-triangle first, then edge-edge.
static void make_queries(query_set *set)
{
    for (int vertices = 1; vertices <= 2; vertices++) {
        workload w = workload_named(set->name, vertices);
        const tf_query_kind *kind =
            tf_choice_named(tf_query_kinds, workload_kind(&w));
        for (long i = 0; i < w.count; i++) {
            tf_query_rows rows = {.ground_truth = -1};
            for (int t = 0; t < 2; t++)
                for (int v = 0; v < QUERY_VERTICES; v++)
                    memcpy(rows.x[t] + TF_AXES * v,
                           w.queries[i].vertex[v].at[t].x,
                           TF_AXES * sizeof(double));
            add_query(set, kind, &rows);
        }
        workload_free(&w);
    }
}

// Errors ----------------------------------------------------------------------

typedef struct errors {
    long queries, extra, missed;
} errors;

static errors errors_of(const contender *c, const query_set *set)
{
    errors found = {.queries = set->count};
    answerer a = answerer_of(c);
    for (long i = 0; i < set->count; i++) {
        const known_query *q = &set->query[i];
        bool hit = finds_hit(&a, q->kind, &q->rows);
        found.extra += hit && !q->hit;
        found.missed += q->hit && !hit;
    }
    return found;
}

static errors errors_in_group(const contender *c, const char *group)
{
    errors sum = {0};
    for (int i = 0; i < SETS; i++) {
        if (strcmp(sets[i].group, group) != 0)
            continue;
        errors found = errors_of(c, &sets[i]);
        sum.queries += found.queries;
        sum.extra += found.extra;
        sum.missed += found.missed;
    }
    return sum;
}

// Costs -----------------------------------------------------------------------

/// The queries of one kind of a random set.
typedef struct race {
    const query_set *set;
    long from, to;
} race;

static double time_queries(const contender *c, const race *r)
{
    answerer a = answerer_of(c);
    double start = processor_seconds();
    for (long i = r->from; i < r->to; i++)
        finds_hit(&a, r->set->query[i].kind, &r->set->query[i].rows);
    return 1e9 * (processor_seconds() - start) / (double)(r->to - r->from);
}

enum {
    RACES = 4
};

static race races[RACES]; // soup and near, each point-triangle and edge-edge
static double best[CONTENDERS][RACES];

static void run_races(void)
{
    for (int i = 0; i < RACES; i++) {
        const query_set *set = &sets[SETS - 2 + i / 2];
        long half = set->count / 2;
        races[i] = (race){set, i % 2 * half, (i % 2 + 1) * half};
    }
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < RACES; i++)
            for (int c = 0; c < CONTENDERS; c++) {
                double time = time_queries(&contenders[c], &races[i]);
                best[c][i] = round == 0 ? time : fmin(best[c][i], time);
            }
}

// The rotating bar ------------------------------------------------------------

/// A bar of length 1 turns by 90 degrees about its end, into a point at 60
/// degrees and at 0.5 from the center, at t = 2/3.
static tf_advancement turn_bar(double threshold)
{
    static const double bar[] = {0, 0, 1, 0};
    static const double point[] = {0.25, 0.43301270189221932};
    const double quarter = 1.5707963267948966;
    tf_rigid_body turning = {.vertices = bar, .rotation = {0, 0, quarter}};
    tf_rigid_body rest = {.vertices = point, .center = {point[0], point[1]}};
    tf_advance_limits limits = {.threshold = threshold};
    tf_advancement at;
    if (tf_advance_point_edge(&limits, &rest, &turning, &at) != TF_OK)
        fail("bar", "not advanced");
    return at;
}

// Output ----------------------------------------------------------------------

static void print_heading(void)
{
    printf("%-18s %13s %13s", "ns a query, errors", sets[SETS - 2].name,
           sets[SETS - 1].name);
    for (int g = 0; g < GROUPS; g++)
        printf(" %15s", groups[g]);
    printf("\n%-18s %6s %6s %6s %6s", "", "pt", "ee", "pt", "ee");
    for (int g = 0; g < GROUPS; g++)
        printf(" %7s %7s", "extra", "missed");
    printf("\n");
}

static void print_table(void)
{
    print_heading();
    for (int c = 0; c < CONTENDERS; c++) {
        printf("%-18s", label_of(&contenders[c]));
        for (int i = 0; i < RACES; i++)
            printf(" %6.0f", best[c][i]);
        for (int g = 0; g < GROUPS; g++) {
            errors found = errors_in_group(&contenders[c], groups[g]);
            if (found.queries > 0)
                printf(" %7ld %7ld", found.extra, found.missed);
            else
                printf(" %7s %7s", "-", "-");
        }
        printf("\n");
    }
    for (int i = 0; i < SETS; i++)
        printf("%s: %ld queries, %ld hits\n", sets[i].name, sets[i].count,
               sets[i].hits);
}

static void print_errors(const contender *c)
{
    const char *label = label_of(c);
    for (int g = 0; g < GROUPS; g++) {
        errors found = errors_in_group(c, groups[g]);
        printf("%s %s extra,%ld,queries\n%s %s missed,%ld,queries\n", label,
               groups[g], found.extra, label, groups[g], found.missed);
    }
    for (int i = 1; i < SETS; i++) {
        errors found = errors_of(c, &sets[i]);
        printf("%s %s extra,%ld,queries\n%s %s missed,%ld,queries\n", label,
               sets[i].name, found.extra, label, sets[i].name, found.missed);
    }
}

static void print_bar(int digits)
{
    tf_advancement at = turn_bar(pow(10, -digits));
    printf("bar 1e-%02d steps,%d,\nbar 1e-%02d error,%.3g,steps of time\n",
           digits, at.steps, digits, 2.0 / 3 - at.time);
}

static void print_csv(void)
{
    for (int i = 0; i < SETS; i++)
        printf("%s queries,%ld,\n%s hits,%ld,\n", sets[i].name, sets[i].count,
               sets[i].name, sets[i].hits);
    for (int c = 0; c < CONTENDERS; c++)
        for (int i = 0; i < RACES; i++)
            printf("%s %s %s,%.1f,ns a query\n", label_of(&contenders[c]),
                   races[i].set->name, kinds[1 + i % 2][0], best[c][i]);
    print_errors(&contenders[0]);
    print_errors(&contenders[1]);
    for (int digits = NO_DIGITS; digits <= MOST_DIGITS; digits++)
        if (digits != 0)
            print_errors(&(contender){"cubic", "cubic", NULL, digits});
    for (int digits = 1; digits <= 12; digits++)
        print_errors(&(contender){"advancement", "advancement", NULL, digits});
    for (int digits = 1; digits <= 12; digits++)
        print_bar(digits);
}

int main(int count, char **argument)
{
    bool csv = count == 2 && strcmp(argument[1], "--csv") == 0;
    if (count > 1 && !csv) {
        fprintf(stderr, "usage: compare [--csv]\n");
        return 2;
    }
    for (int i = 0; i < SETS; i++)
        if (sets[i].pattern)
            find_queries(&sets[i], csv);
        else
            make_queries(&sets[i]);
    run_races();
    if (csv)
        print_csv();
    else
        print_table();
    for (int i = 0; i < SETS; i++)
        free(sets[i].query);
    return 0;
}
