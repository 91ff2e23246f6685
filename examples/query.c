// Which of five points hit a triangle during a step, and when.
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
    // A query lists its vertices: the point, and the corners of the triangle in
    // the order that the normal of the contact is to follow.
    int vertices[4 * POINTS];
    for (int i = 0; i < POINTS; i++) {
        vertices[4 * i] = 3 + i;
        for (int corner = 0; corner < 3; corner++)
            vertices[4 * i + 1 + corner] = corner;
    }
    const tf_motion motion = {3, 3 + POINTS, start, end};
    const tf_queries queries = {TF_POINT_TRIANGLE, &motion, POINTS, vertices};

    // The answers are those of tf_point_triangle, query by query, but sooner.
    tf_contact contact[POINTS];
    tf_error error;
    if (tf_query_batch(&tf_exact, &queries, NULL, contact, &error) != TF_OK) {
        char sentence[200];
        tf_describe(&error, sentence, sizeof sentence);
        puts(sentence);
        return 1;
    }

    for (int i = 0; i < POINTS; i++) {
        const tf_contact *found = &contact[i];
        if (found->verdict != TF_HIT)
            printf("point %d misses\n", i);
        else // the lower bound of the time: until then it is certainly apart
            printf("point %d hits at t = %.3f with normal velocity %g\n", i,
                   found->toi_lo, found->normal_velocity);
    }
    return 0;
}
