#include "arithmetic/clamped.h"
#include "query/point_edge.h"

#include <stdio.h>

int main(void)
{
    const double start[] = {1, 3, 0, 0, 4, 0};
    const double end[] = {2, 0, 0, 1, 4, 2};
    tf_motion motion = {.axes = 2, .vertices = 3, .start = start, .end = end};

    tf_contact contact;
    tf_status status =
        tf_point_edge(&tf_clamped, &motion, 0, (int[]){1, 2}, &contact);
    if (status != TF_OK) {
        puts(tf_status_message(status));
        return 1;
    }
    if (contact.verdict != TF_APART)
        printf("barycentric %g %g, velocity (%g, %g), normal velocity %g\n",
               contact.barycentric[1][0], contact.barycentric[1][1],
               contact.velocity[0], contact.velocity[1],
               contact.normal_velocity);
    return 0;
}
