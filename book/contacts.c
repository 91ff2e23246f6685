#include <stdio.h>
#include <tanglefree.h>

int main(void)
{
    const int triangle[] = {0, 2, 1, 1, 2, 3, 2, 4, 3,
                            3, 4, 5, 4, 6, 5, 5, 6, 7};
    double x[] = {0, 0, 0, 0, 1, 0, 2,    0,   0, 2,    1,    0,
                  2, 0, 1, 2, 1, 1, .625, .25, 1, .625, .875, 1};
    double next[24];
    tf_mesh mesh = {.axes = 3, .vertices = 8, .triangles = 6, triangle};
    tf_motion motion = {.axes = 3, .vertices = 8, .start = x, .end = next};
    tf_surface *surface;
    tf_contacts found;
    if (tf_surface_create(&mesh, &surface, NULL) != TF_OK)
        return 1;
    for (int step = 0; step < 4; step++) {
        for (int i = 0; i < 24; i++) // the last two vertices sink
            next[i] = i == 20 || i == 23 ? x[i] - 0.375 : x[i];
        if (tf_surface_detect(surface, &motion, NULL, &found, NULL) != TF_OK)
            return 1;
        printf("step %d: %zu contacts\n", step, found.count);
        for (int i = 0; i < 24; i++)
            x[i] = next[i];
    }
    tf_surface_free(surface);
}
