#include "check.h"

#include "support/generator.h"
#include "support/oracle.h"
#include "support/support.h"

#include <string.h>

bool have_more_in_common(const double x[][3], int vertices, const int first[3],
                         const int second[3]);

static bool share(int count, const int a[], int others, const int b[])
{
    for (int i = 0; i < count; i++)
        for (int j = 0; j < others; j++)
            if (a[i] == b[j])
                return true;
    return false;
}

/// Whether two elements without a common vertex meet, by linear programs.
static bool meet(double x[][3], int count, const int a[], int others,
                 const int b[])
{
    if (share(count, a, others, b))
        return false;
    tf_event event[2][3];
    oracle_simplex simplex[2] = {{.count = count}, {.count = others}};
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < simplex[s].count; i++) {
            event[s][i] = (tf_event){.vertex = TF_NO_INDEX};
            memcpy(event[s][i].x, x[s == 0 ? a[i] : b[i]], sizeof x[0]);
            simplex[s].event[i] = &event[s][i];
        }
    return oracle_slices_meet(3, &simplex[0], &simplex[1]);
}

static bool have_more(double x[][3], const int first[3], const int second[3])
{
    for (int i = 0; i < 3; i++) {
        const int edge[2] = {first[i], first[(i + 1) % 3]};
        const int other[2] = {second[i], second[(i + 1) % 3]};
        if (meet(x, 1, &first[i], 3, second) ||
            meet(x, 1, &second[i], 3, first) || meet(x, 2, edge, 3, second) ||
            meet(x, 2, other, 3, first))
            return true;
        for (int j = 0; j < 3; j++) {
            const int third[2] = {second[j], second[(j + 1) % 3]};
            if (meet(x, 2, edge, 2, third))
                return true;
        }
    }
    return false;
}

static bool has_area(double x[][3], const int v[3])
{
    tf_vector u = {{x[v[1]][0] - x[v[0]][0], x[v[1]][1] - x[v[0]][1],
                    x[v[1]][2] - x[v[0]][2]}};
    tf_vector w = {{x[v[2]][0] - x[v[0]][0], x[v[2]][1] - x[v[0]][1],
                    x[v[2]][2] - x[v[0]][2]}};
    return u.x[0] * w.x[1] != u.x[1] * w.x[0] ||
           u.x[1] * w.x[2] != u.x[2] * w.x[1] ||
           u.x[2] * w.x[0] != u.x[0] * w.x[2];
}

/// Two triangles that share some of `vertices` vertices on a lattice.
static void try_triangles(generator *random, int shared)
{
    int vertices = 6 - shared, n = 2 + below(random, 4);
    double x[6][3];
    int first[3], second[3];
    do {
        for (int i = 0; i < 3 * vertices; i++)
            x[i / 3][i % 3] = below(random, n);
        for (int i = 0; i < 3; i++) {
            first[i] = i;
            second[i] = 3 - shared + i;
        }
    } while (!has_area(x, first) || !has_area(x, second));
    check_input("triangle %d %d %d: %s %s %s\ntriangle %d %d %d: %s %s %s",
                first[0], first[1], first[2], text_point(3, x[0]),
                text_point(3, x[1]), text_point(3, x[2]), second[0], second[1],
                second[2], text_point(3, x[second[0]]),
                text_point(3, x[second[1]]), text_point(3, x[second[2]]));
    bool got;
    check_value(got, have_more_in_common((const double(*)[3])x, vertices, first,
                                         second));
    check_bool(have_more(x, first, second), got);
}

TEST(as_linear_programs_find)
{
    generator random = generator_new((uint64_t)_i);
    for (int i = 0; i < 400; i++)
        try_triangles(&random, _i);
}

void run_tests(void)
{
    check_run(3, as_linear_programs_find);
}
