#include "kit/soft_light.h"

#include "support/support.h"

#include <stdlib.h>

static const double tau = 6.283185307179586;

static const tf_vector oblique = {{-0.6, 0, 0.8}};

/// A lit point on level ground.
static fig_lit on_ground(double x, double y)
{
    return (fig_lit){.at = {(float)x, (float)y, 0}, .normal = {0, 0, 1}};
}

static void light(int count, fig_lit lit[], int casters,
                  const fig_caster caster[], tf_vector lamp)
{
    ck_assert(fig_light_softly(count, lit, casters, caster, lamp));
}

// A ball ----------------------------------------------------------------------

enum {
    AROUND = 48,
    UP = 24,
    BALL = 2 * AROUND * UP
};

static void set_place(float at[3], double up, double turn, double height,
                      double radius)
{
    double angle = tau / 2 * up / UP, around = tau * turn / AROUND;
    at[0] = (float)(radius * sin(angle) * cos(around));
    at[1] = (float)(radius * sin(angle) * sin(around));
    at[2] = (float)(height - radius * cos(angle));
}

/// A ball above the origin.
static fig_caster *new_ball(double height, double radius)
{
    fig_caster *ball = calloc(BALL, sizeof *ball), *next = ball;
    ck_assert_ptr_nonnull(ball);
    for (int i = 0; i < UP; i++)
        for (int j = 0; j < AROUND; j++)
            for (int half = 0; half < 2; half++, next++) {
                set_place(next->at[0], i, j, height, radius);
                set_place(next->at[1], i + 1, j + 1, height, radius);
                set_place(next->at[2], i + half, j + 1 - half, height, radius);
            }
    return ball;
}

/// Level ground takes light by the cosine to the zenith: a ball there that fills
/// the angle a to the zenith keeps sin(a)^2 off.
START_TEST(a_ball_overhead_keeps_the_sky_off)
{
    for (double height = 1.2; height < 8; height *= 1.5) {
        fig_caster *ball = new_ball(height, 1);
        fig_lit lit = on_ground(0, 0);
        light(1, &lit, BALL, ball, oblique);
        ck_assert_double_eq_tol((double)lit.sky, 1 - 1 / (height * height),
                                0.05);
        free(ball);
    }
}
END_TEST

/// The lamp shines along (0.6, 0, -0.8), so that the shadow of a ball at the
/// height h is around (0.75 h, 0).
START_TEST(a_ball_throws_a_shadow_with_a_soft_border)
{
    fig_caster *ball = new_ball(4, 1);
    fig_lit lit[81];
    for (int i = 0; i <= 80; i++)
        lit[i] = on_ground(3, 0.05 * i);
    light(81, lit, BALL, ball, oblique);
    ck_assert_double_eq((double)lit[0].lamp, 0);
    ck_assert_double_eq_tol((double)lit[80].lamp, 0.8, 0.01);
    int between = 0;
    for (int i = 1; i <= 80; i++) {
        ck_assert_float_ge(lit[i].lamp, lit[i - 1].lamp - 1e-6F);
        between += lit[i].lamp > 0.04F && lit[i].lamp < 0.76F;
    }
    ck_assert_int_ge(between, 10);
    free(ball);
}
END_TEST

START_TEST(a_ball_does_not_darken_the_side_toward_the_lamp)
{
    fig_caster *ball = new_ball(4, 1);
    fig_lit *lit = calloc(3 * BALL, sizeof *lit);
    ck_assert_ptr_nonnull(lit);
    for (int i = 0; i < 3 * BALL; i++)
        for (int k = 0; k < 3; k++) {
            lit[i].at[k] = ball[i / 3].at[i % 3][k];
            lit[i].normal[k] = lit[i].at[k] - (k == 2 ? 4 : 0);
        }
    light(3 * BALL, lit, BALL, ball, oblique);
    for (int i = 0; i < 3 * BALL; i++) {
        const float *n = lit[i].normal;
        double facing = -0.6 * (double)n[0] + 0.8 * (double)n[2];
        ck_assert_double_eq_tol((double)lit[i].lamp, fmax(0, facing), 0.07);
        ck_assert_double_eq_tol((double)lit[i].sky, 0.5 + 0.5 * (double)n[2],
                                0.07);
    }
    free(lit);
    free(ball);
}
END_TEST

// Flat things -----------------------------------------------------------------

START_TEST(a_thin_plate_is_light_above_and_dark_below)
{
    const fig_caster plate[2] = {{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}}},
                                 {{{-1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}}};
    fig_lit lit[2] = {{.at = {0.2F, 0.1F, 1}, .normal = {0, 0, 1}},
                      {.at = {0.2F, 0.1F, 1}, .normal = {0, 0, -1}}};
    light(2, lit, 2, plate, (tf_vector){{0, 0, 3}});
    ck_assert_double_eq_tol((double)lit[0].lamp, 1, 0.02);
    ck_assert_double_eq_tol((double)lit[0].sky, 1, 1e-4);
    ck_assert_double_eq((double)lit[1].lamp, 0);
    ck_assert_double_eq((double)lit[1].sky, 0);
}
END_TEST

START_TEST(anything_may_cast_shadows)
{
    fig_lit lit[2] = {on_ground(0, 0), {.at = {1, 2, 3}}};
    light(2, lit, 0, NULL, oblique);
    ck_assert_double_eq_tol((double)lit[0].lamp, 0.8, 0.01);
    ck_assert_double_eq_tol((double)lit[0].sky, 1, 1e-4);
    ck_assert_double_eq((double)lit[1].lamp, 0);

    // Triangles without area, far off or not, large and small ones.
    generator random = generator_new(1);
    for (long n = cases(40); n > 0; n--) {
        fig_caster caster[20];
        double size = ldexp(1, (int)below(&random, 60) - 40);
        double off = below(&random, 2) ? ldexp(1, (int)below(&random, 20)) : 0;
        for (int i = 0; i < 20; i++)
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < 3; k++)
                    caster[i].at[c][k] =
                        (float)(off + size * ((double)below(&random, 5) - 2));
        light(2, lit, 20, caster, oblique);
        for (int i = 0; i < 2; i++)
            ck_assert(lit[i].lamp >= 0 && lit[i].lamp <= 1 && lit[i].sky >= 0 &&
                      lit[i].sky <= 1.001F);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("kit/soft_light");
    TCase *soft = tcase_create("soft_light");
    tcase_add_test(soft, a_ball_overhead_keeps_the_sky_off);
    tcase_add_test(soft, a_ball_throws_a_shadow_with_a_soft_border);
    tcase_add_test(soft, a_ball_does_not_darken_the_side_toward_the_lamp);
    tcase_add_test(soft, a_thin_plate_is_light_above_and_dark_below);
    tcase_add_test(soft, anything_may_cast_shadows);
    suite_add_tcase(s, soft);
    return s;
}
