#include "figures/numbers.h"

/// A path and a triangle on a line of space, by how far along.
typedef struct flat {
    const char *key;
    double path[2], base[2], apex; ///< the path's at t = 0, 1
    int base_time;
} flat;

static const flat flats[] = {
    {"end", {0.05, 0.8}, {0.2, 0.95}, 0.5, 1},
    {"start", {0, 0.75}, {0.15, 0.9}, 0.45, 0},
    {"within", {0.3, 0.9}, {0.1, 0.85}, 0.35, 0},
};

static tf_event event_at(double place, int t)
{
    return (tf_event){.x = {place, place / 2}, .t = t};
}

/// When the path meets what the apex and one or both ends of the base span, by
/// the oracle; -1 if it does not.
static double time_of(const flat *f, int first, int last)
{
    tf_event path[2], corner[3];
    for (int t = 0; t < 2; t++)
        path[t] = event_at(f->path[t], t);
    corner[0] = event_at(f->apex, !f->base_time);
    oracle_simplex s = {2, {&path[0], &path[1]}}, r = {1, {&corner[0]}};
    for (int i = first; i <= last; i++) {
        corner[r.count] = event_at(f->base[i], f->base_time);
        r.event[r.count] = &corner[r.count];
        r.count++;
    }
    mpq_t toi;
    mpq_init(toi);
    double time = oracle_simplices_meet(2, &s, &r, toi) ? mpq_get_d(toi) : -1;
    mpq_clear(toi);
    return time;
}

START_TEST(times_are_those_of_the_oracle)
{
    char *text = printed(&fig_coplanar_path), key[32];
    for (size_t i = 0; i < sizeof flats / sizeof *flats; i++) {
        const flat *f = &flats[i];
        double first = time_of(f, 0, 1);
        snprintf(key, sizeof key, "%s_time", f->key);
        expect_number(text, key, first);
        for (int leg = 0; leg < 2; leg++) {
            // A leg that is met at the first time is not told.
            double t = time_of(f, leg, leg);
            snprintf(key, sizeof key, "%s_leg_%d ", f->key, leg);
            bool told = strstr(text, key);
            ck_assert_msg(told == (t > first), "%stold: %d", key, told);
            key[strlen(key) - 1] = '\0';
            if (told)
                expect_number(text, key, t);
        }
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/coplanar_path", times_are_those_of_the_oracle);
}
