// A square is remeshed, and what its corners have, here a temperature, is
// carried over: each new vertex says from which point of the old surface it is.
//
//     cc remesh.c $(pkg-config --cflags --libs tanglefree) -o remesh
#include <stdio.h>
#include <tanglefree.h>

/// The temperature at a point of the old surface, that of its corners weighed.
static double temperature_at(const tf_origin *origin, const int triangle[],
                             const double temperature[])
{
    const int *corner = triangle + 3 * origin->triangle;
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += origin->barycentric[i] * temperature[corner[i]];
    return sum;
}

int main(void)
{
    // Warm at x = 0 and hot at x = 1, so that it is 20 + 60 x everywhere.
    const double position[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const double temperature[] = {20, 80, 80, 20};
    const int triangle[] = {0, 1, 2, 0, 2, 3};
    const tf_mesh mesh = {3, 4, 2, triangle, 0, NULL};

    tf_adaptive_surface *surface;
    tf_error error;
    static tf_remesh_options options; // all zero but the length of an edge
    options.edge = 0.25;
    tf_status status = tf_adaptive_create(&mesh, position, &surface, &error);
    if (status == TF_OK) {
        status = tf_adaptive_remesh(surface, &options, NULL, &error);
        if (status != TF_OK)
            tf_adaptive_free(surface);
    }
    if (status != TF_OK) {
        char sentence[200];
        tf_describe(&error, sentence, sizeof sentence);
        puts(sentence);
        return 1;
    }

    const double *x = tf_adaptive_positions(surface);
    const tf_origin *origin = tf_adaptive_origins(surface);
    const int vertices = tf_adaptive_mesh(surface)->vertices;
    double worst = 0;
    for (int v = 0; v < vertices; v++) {
        double off = temperature_at(&origin[v], triangle, temperature) -
                     (20 + 60 * x[3 * v]);
        worst = off > worst ? off : -off > worst ? -off : worst;
    }
    printf("%s vertices, temperatures %s\n", vertices > 20 ? "many" : "few",
           worst < 1e-12 ? "carried over" : "lost");
    tf_adaptive_free(surface);
    return 0;
}
