#include "figures/numbers.h"

enum {
    PAIRS = 4000,
    ROUNDS = 50,
    VERTICES = 3 ///< the point, then the edge's
};

static const char *const kinds[] = {"pe", "pt", "ee"};
static const char *const rows[] = {"coordinates", "gradient", "pivots", "both"};

enum {
    ROWS = 4 ///< the library's choice parts every pair that these do
};

/// A point and an edge, as the figure makes them.
typedef struct pair {
    double start[VERTICES][2], move[VERTICES][2];
} pair;

static double up_to(generator *random, double most)
{
    return uniform(random, -most, most);
}

static pair make_pair(generator *random, double deformation)
{
    pair p;
    double way[2], apart[2], square;
    do {
        way[0] = up_to(random, 1);
        way[1] = up_to(random, 1);
        square = way[0] * way[0] + way[1] * way[1];
    } while (square > 1 || square < 1e-4);
    for (int k = 0; k < 2; k++)
        apart[k] = up_to(random, 0.2);
    for (int v = 0; v < VERTICES; v++)
        for (int k = 0; k < 2; k++) {
            p.start[v][k] = up_to(random, 0.5) + (v == 0 ? apart[k] : 0);
            p.move[v][k] = up_to(random, deformation) +
                           (v == 0 ? way[k] / sqrt(square) : 0);
        }
    return p;
}

/// A contact: of the sweep's triangle with the pivot e_1 or e_0.
typedef struct meeting {
    int pivot;
    double time, coordinate, normal[2]; ///< the coordinate of e_1
} meeting;

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/// The first time that the origin is in a triangle of the sweep of the edge as
/// seen from the point.
static bool meets(const pair *p, meeting *found)
{
    double seen[2][2][2]; // by end and time
    for (int e = 0; e < 2; e++)
        for (int t = 0; t < 2; t++)
            for (int k = 0; k < 2; k++)
                seen[e][t][k] = p->start[e + 1][k] - p->start[0][k] +
                                t * (p->move[e + 1][k] - p->move[0][k]);
    found->time = 2;
    for (int pivot = 1; pivot >= 0; pivot--) {
        const double *corner[3] = {seen[0][0], seen[pivot][1 - pivot],
                                   seen[1][1]};
        double part[3], sum = 0;
        for (int i = 0; i < 3; i++)
            sum += part[i] = cross(corner[(i + 1) % 3], corner[(i + 2) % 3]);
        for (int i = 0; i < 3; i++)
            part[i] /= sum;
        double time = part[2] + (pivot == 0 ? part[1] : 0);
        if (part[0] < 0 || part[1] < 0 || part[2] < 0 || time >= found->time)
            continue;
        double length = 0;
        for (int k = 0; k < 2; k++) {
            double along[2] = {p->start[2][0] - p->start[1][0],
                               p->start[2][1] - p->start[1][1]};
            for (int j = 0; j < 2 && pivot == 0; j++)
                along[j] += p->move[2][j] - p->move[1][j];
            found->normal[k] = k == 0 ? -along[1] : along[0];
            length += found->normal[k] * found->normal[k];
        }
        for (int k = 0; k < 2; k++)
            found->normal[k] /= sqrt(length);
        found->pivot = pivot;
        found->time = time;
        found->coordinate = part[2] + (pivot == 1 ? part[1] : 0);
    }
    return found->time <= 1;
}

/// Pushes follow `share`, and make the sum of `want` times the displacements 0.
static void make_row(const pair *p, const meeting *m, int row,
                     double share[VERTICES], double want[VERTICES],
                     double normal[2])
{
    double w = m->coordinate, t = m->time;
    double late = t < w ? t : w;
    const double of[ROWS][VERTICES] = {
        {1, w - 1, -w},
        {t, late - t, -late},
        {1, m->pivot == 0 ? -1 : 0, m->pivot == 1 ? -1 : 0},
        {1, w - 1, -w}};
    double side = 0;
    for (int k = 0; k < 2; k++) {
        double dots =
            p->start[0][k] - (1 - w) * p->start[1][k] - w * p->start[2][k];
        double pivots = p->start[0][k] - p->start[1 + m->pivot][k];
        side += m->normal[k] * (row == 2 ? pivots : dots);
    }
    for (int k = 0; k < 2; k++)
        normal[k] = side < 0 ? -m->normal[k] : m->normal[k];
    memcpy(share, of[row], sizeof of[row]);
    memcpy(want, of[row == 3 ? 1 : row], sizeof of[row]);
}

/// Push until the pair is apart: how often, or -1.
static int part(pair *p, int row)
{
    for (int round = 0; round <= ROUNDS; round++) {
        meeting m;
        if (!meets(p, &m))
            return round;
        double share[VERTICES], want[VERTICES], normal[2];
        double parting = 0, compliance = 0;
        make_row(p, &m, row, share, want, normal);
        for (int v = 0; v < VERTICES; v++) {
            parting += want[v] *
                       (normal[0] * p->move[v][0] + normal[1] * p->move[v][1]);
            compliance += share[v] * want[v];
        }
        if (parting >= -1e-12)
            return -1;
        for (int v = 0; v < VERTICES; v++)
            for (int k = 0; k < 2; k++)
                p->move[v][k] -= parting / compliance * share[v] * normal[k];
    }
    return -1;
}

/// What was counted for one kind of row: pairs that stay stuck, and the rounds
/// and the change of shape of those pairs that every kind has parted.
typedef struct count {
    int stuck;
    long rounds;
    double change;
} count;

static double change_of_shape(const pair *before, const pair *after)
{
    double d[2];
    for (int k = 0; k < 2; k++)
        d[k] = after->move[2][k] - before->move[2][k] - after->move[1][k] +
               before->move[1][k];
    return hypot(d[0], d[1]);
}

static void expect_rows(const char *text, double deformation)
{
    generator random = {.state = 1};
    count n[ROWS] = {{0}};
    int like = 0;
    for (int i = 0; i < PAIRS;) {
        pair p = make_pair(&random, deformation), pushed[ROWS];
        meeting m;
        if (!meets(&p, &m))
            continue;
        i++;
        int took[ROWS];
        bool all_parted = true;
        for (int row = 0; row < ROWS; row++) {
            pushed[row] = p;
            took[row] = part(&pushed[row], row);
            n[row].stuck += took[row] < 0;
            all_parted &= took[row] >= 0;
        }
        like += all_parted;
        for (int row = 0; all_parted && row < ROWS; row++) {
            n[row].rounds += took[row];
            n[row].change += change_of_shape(&p, &pushed[row]);
        }
    }
    for (int row = 0; row < ROWS; row++) {
        const struct {
            const char *what;
            double expected, tolerance;
        } line[] = {{"rounds", (double)n[row].rounds / like, 2e-3},
                    {"change", n[row].change / like, 2e-3},
                    {"stuck", 1000. * n[row].stuck / PAIRS, 0.6}};
        for (int i = 0; i < 3; i++) {
            // What is at a limit may be stuck or not, as rounding has it.
            char key[64];
            snprintf(key, sizeof key, "%s_%s_pe_%g", line[i].what, rows[row],
                     deformation);
            ck_assert_double_eq_tol(number_of(text, key), line[i].expected,
                                    line[i].tolerance);
        }
    }
}

START_TEST(rows_do_what_is_told)
{
    char *text = printed(&fig_kinds_of_rows);
    expect_number(text, "pairs", PAIRS);
    expect_number(text, "most_rounds", ROUNDS);
    expect_rows(text, 0.1);
    expect_rows(text, 1);

    // What the text says of all pairs.
    expect_number(text, "disagree_ee_0.1", 0);
    for (int k = 0; k < 3; k++)
        for (int d = 0; d < 3; d++) {
            const double deformation[] = {0.01, 0.1, 1};
            char key[64];
            snprintf(key, sizeof key, "stuck_library_%s_%g", kinds[k],
                     deformation[d]);
            expect_number(text, key, 0);
            for (int row = 0; row < 3; row++) {
                snprintf(key, sizeof key, "gained_%s_%s_%g", rows[row],
                         kinds[k], deformation[d]);
                expect_number(text, key, 0);
            }
        }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/kinds_of_rows", rows_do_what_is_told);
}
