// A cloth falls on a slope and slides down, or not: its velocities propose
// where the vertices end, and tf_step_resolve makes of that a clear step.
#include <stdio.h>
#include <tanglefree.h>

enum {
    SIDE = 6,                   // vertices along a side of the cloth
    VERTICES = 3 + SIDE * SIDE, // those of the slope, a triangle, come first
    NUMBERS = 3 * VERTICES      // coordinates
};

static void fall(tf_resolver *resolver, double friction)
{
    const double h = 0.02; // seconds a step
    double x[NUMBERS] = {-99, -99, -33, 99, -99, 33, 0, 99, 0};
    double end[NUMBERS], v[NUMBERS] = {0}, inverse_mass[VERTICES] = {0};
    for (int i = 3; i < VERTICES; i++) {
        x[3 * i] = (i - 3) % SIDE;
        x[3 * i + 1] = (i - 3) / SIDE;
        x[3 * i + 2] = 3;
        inverse_mass[i] = 1; // that of the slope is 0: it is not to be pushed
    }
    static tf_response_options options; // all zero: the usual choices
    options.friction = friction;
    options.separation = 0.001; // a thousandth of an edge of the cloth
    tf_status status = TF_OK;
    for (int step = 0; step < 200 && status == TF_OK; step++) {
        for (int n = 0; n < NUMBERS; n++) {
            v[n] -= n >= 9 && n % 3 == 2 ? 9.8 * h : 0;
            end[n] = x[n] + h * v[n];
        }
        status = tf_step_resolve(resolver, VERTICES, x, end, inverse_mass,
                                 &options, NULL, NULL);
        const double *motion = tf_resolver_unpushed(resolver);
        for (int n = 0; n < NUMBERS && status == TF_OK; n++) {
            v[n] = (motion[n] - x[n]) / h;
            x[n] = end[n];
        }
    }
    printf("friction %g: slid down by %d, %s\n", friction, (int)-x[9],
           tf_status_message(status));
}

int main(void)
{
    const int square[] = {3, 4, SIDE + 3, 4, SIDE + 4, SIDE + 3};
    int triangles[6 * VERTICES] = {0, 1, 2}, corners = 3;
    for (int i = 0; i < SIDE * (SIDE - 1); i++)
        for (int k = 0; k < 6 && i % SIDE < SIDE - 1; k++)
            triangles[corners++] = i + square[k];
    const tf_mesh mesh = {3, VERTICES, corners / 3, triangles, 0, NULL};
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL; // keeps its memory from step to step
    if (tf_surface_create(&mesh, &surface, NULL) == TF_OK &&
        tf_resolver_create(surface, &resolver) == TF_OK)
        for (int friction = 0; friction < 2; friction++)
            fall(resolver, friction);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return 0;
}
