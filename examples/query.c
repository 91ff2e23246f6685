// Which of five points hit a triangle during a step, and when.
//
//     cc query.c $(pkg-config --cflags --libs tanglefree) -o query
#include <stdio.h>
#include <tanglefree.h>

enum {
    POINTS = 5
};

// Where all vertices are at the start of the step, and at its end.  The first
// three are the corners of the triangle, which is at rest.
static const double start[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, //
                               1, 1, 1, 2, 2, 1, 3, 3, 1, 1, 2, 1, 2, 1, 1};
static const double end[] = {0, 0, 0,  4, 0, 0,  0, 4, 0, //
                             1, 1, -1, 2, 2, -1, 3, 3, -1, 1, 2, 0, 2, 1, 0.5};

int main(void)
{
    const tf_motion motion = {3, 3 + POINTS, start, end};
    const int triangle[] = {0, 1, 2};

    // A query lists its vertices: the point and the triangle.
    int vertices[4 * POINTS];
    for (int i = 0; i < POINTS; i++) {
        vertices[4 * i] = 3 + i;
        for (int k = 0; k < 3; k++)
            vertices[4 * i + 1 + k] = triangle[k];
    }

    // All verdicts at once, which is the fastest way to find out which elements
    // meet at all.
    const tf_queries queries = {TF_POINT_TRIANGLE, &motion, POINTS, vertices};
    tf_verdict verdict[POINTS];
    size_t separated = 0;
    tf_status status = tf_vectorized.decide(tf_vectorized.context, &tf_exact,
                                            &queries, verdict, &separated);

    // Few elements meet, and of those alone we ask for more.
    for (int i = 0; i < POINTS && status == TF_OK; i++) {
        tf_contact contact;
        if (verdict[i] != TF_HIT) {
            printf("point %d misses\n", i);
            continue;
        }
        status =
            tf_point_triangle(&tf_exact, &motion, 3 + i, triangle, &contact);
        if (status == TF_OK)
            printf(
                "point %d hits at t = %.3f, at %.3g of the way to corner 1\n",
                i, contact.toi_lo, contact.barycentric[1][1]);
    }
    if (status != TF_OK)
        puts(tf_status_message(status));
    return status != TF_OK;
}
