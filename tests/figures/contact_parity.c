#include "figures/numbers.h"

#include "kit/random.h"

enum {
    STEPS = 2000,
    VERTICES = 5,
    MOST = 16
};

/// From -1 up to 1.
static double next_number(uint64_t *state)
{
    return 2 * ldexp((double)(fig_congruent_bits(state) >> 11), -53) - 1;
}

static void make_step(uint64_t *state, tf_worldline vertex[VERTICES])
{
    for (int v = 0; v < VERTICES; v++) {
        double start[TF_AXES], end[TF_AXES];
        for (int k = 0; k < TF_AXES; k++) {
            start[k] = next_number(state);
            end[k] = start[k] + 2 * next_number(state);
        }
        vertex[v] = tf_worldline_between(TF_AXES, start, end);
    }
}

/// The pairs of simplices that meet, as the oracle says.
static int count_pairs(int vertices, const tf_worldline first[], int others,
                       const tf_worldline second[], mpq_t unused)
{
    int count = 0;
    for (int i = 0; i < vertices; i++)
        for (int j = 0; j < others; j++) {
            oracle_simplex s = oracle_step(vertices, first, i);
            oracle_simplex r = oracle_step(others, second, j);
            count += oracle_simplices_meet(TF_AXES, &s, &r, unused);
        }
    return count;
}

static int count_contacts(const tf_worldline vertex[VERTICES], mpq_t unused)
{
    int count = 0;
    for (int v = 0; v < 2; v++)
        count += count_pairs(1, &vertex[v], 3, vertex + 2, unused);
    static const int side[3][2] = {{2, 3}, {2, 4}, {3, 4}};
    for (int i = 0; i < 3; i++) {
        tf_worldline edge[2] = {vertex[side[i][0]], vertex[side[i][1]]};
        count += count_pairs(2, vertex, 2, edge, unused);
    }
    return count;
}

static bool cross_at(const tf_worldline v[VERTICES], int t)
{
    oracle_simplex s = {2, {&v[0].at[t], &v[1].at[t]}};
    oracle_simplex r = {3, {&v[2].at[t], &v[3].at[t], &v[4].at[t]}};
    return oracle_slices_meet(TF_AXES, &s, &r);
}

START_TEST(counts_are_the_oracles)
{
    char *text = printed(&fig_contact_parity);
    long contacts[MOST + 1] = {0}, sums[MOST + 1] = {0};
    uint64_t state = 1;
    mpq_t unused;
    mpq_init(unused);
    for (int i = 0; i < STEPS; i++) {
        tf_worldline vertex[VERTICES];
        make_step(&state, vertex);
        int count = count_contacts(vertex, unused);
        contacts[count]++;
        sums[count + cross_at(vertex, 0) + cross_at(vertex, 1)]++;
    }
    mpq_clear(unused);
    expect_number(text, "steps", STEPS);
    expect_number(text, "odd_sums", 0);
    long odd = 0;
    for (int i = 1; i <= MOST; i += 2)
        odd += contacts[i];
    expect_number(text, "odd_contacts", (double)odd);
    for (int i = 0; i <= (int)number_of(text, "most"); i++) {
        char key[32];
        snprintf(key, sizeof key, "contacts_%d", i);
        expect_number(text, key, (double)contacts[i]);
        snprintf(key, sizeof key, "sums_%d", i);
        expect_number(text, key, (double)sums[i]);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/contact_parity", counts_are_the_oracles);
}
