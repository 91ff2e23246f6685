#include "check.h"

#include "arithmetic/exact.h"
#include "query/query.h"
#include "support/support.h"
#include "surgery/touch.h"

bool is_swept_over(const double from[3], const double to[3], const double x[3],
                   const double y[3], const double p[3], const double q[3]);

/// The corner before and after, the two others, and the ends of the edge.
typedef struct scene {
    double from[3], to[3], x[3], y[3], p[3], q[3];
} scene;

static bool is_hit(int count, const tf_worldline first[], int others,
                   const tf_worldline second[])
{
    tf_contact contact;
    tf_query(&tf_exact, 3, count, first, others, second, &contact);
    return contact.verdict == TF_HIT;
}

/// By the contacts of moving elements, and what is so at the start.
static bool meets(const scene *s)
{
    const double *start[3] = {s->from, s->x, s->y};
    if (tf_edge_touches_triangle(s->p, s->q, start))
        return true;
    tf_worldline corner[3] = {tf_worldline_between(3, s->from, s->to),
                              tf_worldline_between(3, s->x, s->x),
                              tf_worldline_between(3, s->y, s->y)};
    tf_worldline edge[2] = {tf_worldline_between(3, s->p, s->p),
                            tf_worldline_between(3, s->q, s->q)};
    for (int i = 0; i < 2; i++)
        if (is_hit(1, &edge[i], 3, corner))
            return true;
    for (int i = 0; i < 3; i++) {
        tf_worldline side[2] = {corner[i < 2 ? i : 0],
                                corner[i < 2 ? i + 1 : 2]};
        if (is_hit(2, edge, 2, side))
            return true;
    }
    return false;
}

static void expect(bool right, const scene *s)
{
    check_input("v moves from %s to %s, x = %s, y = %s, p = %s, q = %s",
                text_point(3, s->from), text_point(3, s->to),
                text_point(3, s->x), text_point(3, s->y), text_point(3, s->p),
                text_point(3, s->q));
    bool got;
    check_value(got, is_swept_over(s->from, s->to, s->x, s->y, s->p, s->q));
    check_bool(right, got);
}

TEST(a_speck)
{
    scene inside = {.from = {0, 0, 0},
                    .to = {0, 0, 4},
                    .x = {4, 0, 0},
                    .y = {0, 4, 0},
                    .p = {0.5, 0.5, 0.5},
                    .q = {0.75, 0.5, 0.5}};
    expect(true, &inside);
    inside.p[0] = inside.q[0] = -0.5;
    expect(false, &inside);
}

TEST(a_needle)
{
    const scene through = {.from = {0, 0, 0},
                           .to = {0, 0, 4},
                           .x = {4, 0, 0},
                           .y = {0, 4, 0},
                           .p = {-1, 0.5, 1},
                           .q = {5, 0.5, 1}};
    expect(true, &through);
}

TEST(a_flat_sweep)
{
    scene flat = {.from = {0, 0, 0},
                  .to = {4, 4, 0},
                  .x = {4, 0, 0},
                  .y = {3, -1, 0},
                  .p = {3.75, 1, -1},
                  .q = {3.75, 1, 1}};
    expect(meets(&flat), &flat);
    flat.p[0] = flat.q[0] = 10;
    expect(false, &flat);
}

static void expect_random(generator *random, bool on_lattice)
{
    scene s;
    double *place[] = {s.from, s.to, s.x, s.y, s.p, s.q};
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++)
            place[i][k] = on_lattice ? below(random, 4) : uniform(random, 0, 1);
    const double *start[3] = {s.from, s.x, s.y}, *end[3] = {s.to, s.x, s.y};
    if (!tf_are_collinear(start[0], start[1], start[2]) &&
        !tf_are_collinear(end[0], end[1], end[2]))
        expect(meets(&s), &s);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 1200; i++)
        expect_random(&random, i % 2 == 0);
}

void run_tests(void)
{
    check_run(1, a_speck);
    check_run(1, a_needle);
    check_run(1, a_flat_sweep);
    check_run(1, at_random);
}
