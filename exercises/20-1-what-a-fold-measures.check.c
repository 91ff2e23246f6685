#include "check.h"

#include "support/support.h"

#include <math.h>

void fold_weights(const double rest[4][3], double weight[4]);

/// Two triangles at an edge: its length, and where and how high the altitudes of
/// the other corners are.
typedef struct hinge {
    double length, foot[2], height[2];
} hinge;

/// Places the hinge, folded by an angle; a moving frame turns all of it.
static void place(const hinge *h, double fold, double turn, double x[4][3])
{
    double flat[4][3] = {
        {0, 0, 0},
        {h->length, 0, 0},
        {h->foot[0], h->height[0], 0},
        {h->foot[1], -h->height[1] * cos(fold), h->height[1] * sin(fold)}};
    double c = cos(turn), s = sin(turn);
    for (int i = 0; i < 4; i++) {
        double y = c * flat[i][0] - s * flat[i][1];
        double z = s * flat[i][0] + c * flat[i][1];
        x[i][0] = 1 + c * y - s * flat[i][2];
        x[i][1] = z - 2;
        x[i][2] = s * y + c * flat[i][2] + 0.5;
    }
}

static double length_of_sum(const double x[4][3], const double weight[4])
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int i = 0; i < 4; i++)
            sum += weight[i] * x[i][k];
        square += sum * sum;
    }
    return sqrt(square);
}

static void find_weights(const hinge *h, double weight[4])
{
    double rest[4][3];
    place(h, 0, 0.7, rest);
    for (int i = 0; i < 4; i++)
        weight[i] = NAN;
    check_input("a = %s, b = %s, c = %s, d = %s", text_point(3, rest[0]),
                text_point(3, rest[1]), text_point(3, rest[2]),
                text_point(3, rest[3]));
    check_call_n(4, weight, fold_weights((const double(*)[3])rest, weight));
}

static void expect(const hinge *h, double fold, double turn)
{
    double weight[4], x[4][3];
    find_weights(h, weight);
    place(h, fold, turn, x);
    double got = length_of_sum((const double(*)[3])x, weight);
    double expected = 2 * h->length * sin(fabs(fold) / 2);
    check_near(expected, got, 1e-11 * (1 + h->length));
}

static const hinge square = {1, {0, 1}, {1, 1}};

TEST(half_a_square_each)
{
    double weight[4];
    find_weights(&square, weight);
    static const double expected[] = {1, 1, -1, -1};
    for (int i = 0; i < 4; i++)
        check_near(expected[i], weight[i], 1e-14);
}

TEST(weights_add_up_to_zero)
{
    double weight[4];
    find_weights(&(hinge){2, {0.5, 1.5}, {1, 0.25}}, weight);
    check_near(0, weight[0] + weight[1] + weight[2] + weight[3], 1e-13);
}

TEST(flat)
{
    expect(&square, 0, 0.7);
    expect(&square, 0, -2);
    expect(&(hinge){2, {0.5, 1.5}, {1, 0.25}}, 0, 1);
    // The foot of an altitude need not be on the edge.
    expect(&(hinge){1, {-0.5, 2}, {0.5, 3}}, 0, 3);
}

TEST(folded)
{
    expect(&square, 0.5, 0.7);
    expect(&square, -3, 0.1);
    expect(&(hinge){2, {0.5, 1.5}, {1, 0.25}}, 1.25, 1);
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        hinge h = {.length = uniform(&random, 0.5, 2)};
        for (int k = 0; k < 2; k++) {
            h.foot[k] = uniform(&random, -1, 3);
            h.height[k] = uniform(&random, 0.25, 2);
        }
        expect(&h, uniform(&random, -3, 3), uniform(&random, -3, 3));
    }
}

void run_tests(void)
{
    check_run(1, half_a_square_each);
    check_run(1, weights_add_up_to_zero);
    check_run(1, flat);
    check_run(1, folded);
    check_run(1, at_random);
}
