#include "arithmetic/clamped.h"
#include "query/point_edge.h"

#include <stdio.h>

int main(void)
{
    tf_worldline point =
        tf_worldline_between(2, (double[]){0, 2}, (double[]){1, -1});
    tf_worldline edge[2] = {
        tf_worldline_between(2, (double[]){-2, 0}, (double[]){-2, 0}),
        tf_worldline_between(2, (double[]){2, 0}, (double[]){2, 1})};

    tf_contact contact;
    tf_status status = tf_point_edge(&tf_clamped, &point, edge, &contact);
    if (status != TF_OK) {
        puts(tf_status_message(status));
        return 1;
    }
    if (contact.verdict == TF_HIT)
        printf("weights %g %g, velocity (%g, %g), speed %g\n",
               contact.weight[1][0], contact.weight[1][1], contact.velocity[0],
               contact.velocity[1], contact.speed);
    return 0;
}
