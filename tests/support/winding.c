#include "support/winding.h"

#include "support/dyadic.h"
#include "support/generator.h"

#include <gmp.h>
#include <limits.h>

enum {
    AXES = 3,
    RETRY = INT_MIN ///< the direction is a special one
};

typedef struct vector {
    mpz_t x[AXES];
} vector;

static void vectors_init(int count, vector v[])
{
    for (int i = 0; i < count; i++)
        mpz_inits(v[i].x[0], v[i].x[1], v[i].x[2], NULL);
}

static void vectors_clear(int count, vector v[])
{
    for (int i = 0; i < count; i++)
        mpz_clears(v[i].x[0], v[i].x[1], v[i].x[2], NULL);
}

static void subtract(vector *difference, const vector *to, const vector *from)
{
    for (int k = 0; k < AXES; k++)
        mpz_sub(difference->x[k], to->x[k], from->x[k]);
}

/// The sign of u x v along the third axis.
static int sign_of_two(const vector *u, const vector *v)
{
    mpz_t sum;
    mpz_init(sum);
    mpz_mul(sum, u->x[0], v->x[1]);
    mpz_submul(sum, u->x[1], v->x[0]);
    int sign = mpz_sgn(sum);
    mpz_clear(sum);
    return sign;
}

/// The sign of (u x v) . w.
static int sign_of_three(const vector *u, const vector *v, const vector *w)
{
    mpz_t sum, minor;
    mpz_inits(sum, minor, NULL);
    for (int k = 0; k < AXES; k++) {
        int next = (k + 1) % AXES, last = (k + 2) % AXES;
        mpz_mul(minor, u->x[next], v->x[last]);
        mpz_submul(minor, u->x[last], v->x[next]);
        mpz_addmul(sum, minor, w->x[k]);
    }
    int sign = mpz_sgn(sum);
    mpz_clears(sum, minor, NULL);
    return sign;
}

// Places ----------------------------------------------------------------------

/// The vertices of an element in multiples of 2^exponent, from a point on.
static void set_element(int axes, int exponent, const double place[],
                        const cycle *around, int i, const vector *from,
                        vector corner[])
{
    for (int j = 0; j < around->size; j++) {
        int v = around->vertices[around->size * i + j];
        for (int k = 0; k < axes; k++)
            dyadic_scale(corner[j].x[k], place[axes * v + k], exponent);
        subtract(&corner[j], &corner[j], from);
    }
}

static int least_exponent(int axes, const double place[], const cycle *around)
{
    int least = 0;
    for (int i = 0; i < around->count * around->size; i++)
        for (int k = 0; k < axes; k++)
            least = dyadic_least(least, place[axes * around->vertices[i] + k]);
    return least;
}

static void set_direction(generator *random, vector *direction)
{
    for (int k = 0; k < AXES; k++)
        mpz_set_si(direction->x[k], below(random, 1 << 30) - (1 << 29));
}

// Around a point --------------------------------------------------------------

/// How a ray from the origin passes an edge of the plane or a triangle: +1 or
/// -1 if it goes through.  An element in one line or plane with the origin is
/// missed by a ray in general direction.
static int pass(int size, const vector *ray, const vector corner[])
{
    if (size == 2) {
        int volume = sign_of_two(&corner[0], &corner[1]);
        int first = sign_of_two(&corner[0], ray);
        int second = sign_of_two(ray, &corner[1]);
        if (volume != 0 && (first == 0 || second == 0))
            return RETRY;
        return first == volume && second == volume ? volume : 0;
    }
    int volume = sign_of_three(&corner[0], &corner[1], &corner[2]);
    int passed = volume;
    for (int i = 0; i < 3 && volume != 0; i++) {
        int side = sign_of_three(ray, &corner[i], &corner[(i + 1) % 3]);
        if (side == 0)
            return RETRY;
        passed = side == volume ? passed : 0;
    }
    return passed;
}

static int count_passes(int axes, int exponent, const double place[],
                        const cycle *around, const vector *point,
                        const vector *ray)
{
    vector corner[3];
    vectors_init(3, corner);
    int sum = 0;
    for (int i = 0; i < around->count && sum != RETRY; i++) {
        set_element(axes, exponent, place, around, i, point, corner);
        int passed = pass(around->size, ray, corner);
        sum = passed == RETRY ? RETRY : sum + passed;
    }
    vectors_clear(3, corner);
    return sum;
}

int winding_number(int axes, const double place[], const cycle *around,
                   int point)
{
    const cycle alone = {1, 1, &point};
    int exponent = least_exponent(axes, place, around);
    int own = least_exponent(axes, place, &alone);
    exponent = own < exponent ? own : exponent;
    vector at[3]; // the point, the ray, the origin
    vectors_init(3, at);
    set_element(axes, exponent, place, &alone, 0, &at[2], &at[0]);
    generator random = generator_new(0);
    int sum = RETRY;
    while (sum == RETRY) {
        set_direction(&random, &at[1]);
        sum = count_passes(axes, exponent, place, around, &at[0], &at[1]);
    }
    vectors_clear(3, at);
    return sum;
}

// Around each other -----------------------------------------------------------

/// Whether two edges cross as seen along a direction, the first one nearer to
/// where it points: +1 or -1 if so.
static int cross(const vector *along, const vector a[2], const vector b[2])
{
    vector to[5]; // the edges, and from b to a and the two rests
    vectors_init(5, to);
    subtract(&to[0], &a[1], &a[0]);
    subtract(&to[1], &b[1], &b[0]);
    subtract(&to[2], &a[0], &b[0]);
    subtract(&to[3], &a[1], &b[0]);
    subtract(&to[4], &b[1], &a[0]);
    int height = sign_of_three(&to[2], &to[0], &to[1]);
    int sense = sign_of_three(along, &to[0], &to[1]);
    int a0 = sign_of_three(along, &to[1], &to[2]);
    int a1 = sign_of_three(along, &to[1], &to[3]);
    int b0 = -sign_of_three(along, &to[0], &to[2]);
    int b1 = sign_of_three(along, &to[0], &to[4]);
    vectors_clear(5, to);
    if (height == 0)
        return 0; // in one plane, apart
    if (sense == 0 || a0 == 0 || a1 == 0 || b0 == 0 || b1 == 0)
        return RETRY;
    return height == sense && a0 != a1 && b0 != b1 ? sense : 0;
}

static int count_crossings(int exponent, const double place[],
                           const cycle *first, const cycle *second,
                           const vector *along)
{
    vector at[5], *origin = &at[4];
    vectors_init(5, at);
    int sum = 0;
    for (int i = 0; i < first->count * second->count && sum != RETRY; i++) {
        set_element(AXES, exponent, place, first, i / second->count, origin,
                    &at[0]);
        set_element(AXES, exponent, place, second, i % second->count, origin,
                    &at[2]);
        int crossed = cross(along, &at[0], &at[2]);
        sum = crossed == RETRY ? RETRY : sum + crossed;
    }
    vectors_clear(5, at);
    return sum;
}

int linking_number(const double place[], const cycle *first,
                   const cycle *second)
{
    int exponent = least_exponent(AXES, place, first);
    int own = least_exponent(AXES, place, second);
    exponent = own < exponent ? own : exponent;
    vector along;
    vectors_init(1, &along);
    generator random = generator_new(0);
    int sum = RETRY;
    while (sum == RETRY) {
        set_direction(&random, &along);
        sum = count_crossings(exponent, place, first, second, &along);
    }
    vectors_clear(1, &along);
    return sum;
}
