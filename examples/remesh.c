// A sheet gets triangles of one size, and the temperatures of its vertices go
// along: each new vertex comes from a point of one of the old triangles.
#include <stdio.h>
#include <stdlib.h>
#include <tanglefree.h>

// A square of two triangles, cold at the left and hot at the right.
static const double position[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
static const int triangles[] = {0, 1, 2, 0, 2, 3};
static const double temperature[] = {0, 10, 10, 0};

// The temperatures of the vertices of a surface that was just remeshed.
static void carry(const tf_adaptive_surface *surface, double carried[])
{
    const tf_origin *origin = tf_adaptive_origins(surface);
    for (int v = 0; v < tf_adaptive_mesh(surface)->vertices; v++) {
        const int *corner = triangles + 3 * origin[v].triangle;
        carried[v] = 0;
        for (int k = 0; k < 3; k++)
            carried[v] += origin[v].barycentric[k] * temperature[corner[k]];
    }
}

// The temperature is 10 x, before and after.
static double worst_error(const tf_adaptive_surface *surface,
                          const double carried[])
{
    const double *x = tf_adaptive_positions(surface);
    double worst = 0;
    for (int v = 0; v < tf_adaptive_mesh(surface)->vertices; v++) {
        double error = carried[v] - 10 * x[3 * v];
        worst = error > worst ? error : -error > worst ? -error : worst;
    }
    return worst;
}

int main(void)
{
    const tf_mesh square = {3, 4, 2, triangles, 0, NULL};
    static tf_remesh_options options; // all zero: the usual choices
    options.edge = 0.2;
    tf_adaptive_surface *surface = NULL;
    tf_status status = tf_adaptive_create(&square, position, &surface, NULL);
    if (status == TF_OK)
        status = tf_adaptive_remesh(surface, &options, NULL, NULL);
    if (status == TF_OK) {
        int vertices = tf_adaptive_mesh(surface)->vertices;
        double *carried = (double *)calloc((size_t)vertices, sizeof *carried);
        if (carried) {
            carry(surface, carried);
            printf("%d vertices, temperatures right to %.6f\n", vertices,
                   worst_error(surface, carried));
        }
        free(carried);
    }
    tf_adaptive_free(surface);
    return status != TF_OK;
}
