#include <stdio.h>
#include <tanglefree.h>

/// A fly hovers above a plank that rises; prints where they end.
static void resolve(tf_resolver *resolver, const double inverse_mass[])
{
    const double start[] = {0, 0.125, -2, 0, 2, 0};
    double end[] = {0, 0.125, -2, 1, 2, 1};
    tf_response_options options = {.separation = -1};
    const tf_response_report *report;
    if (tf_step_resolve(resolver, 3, start, end, inverse_mass, &options,
                        &report, NULL) == TF_OK)
        printf("%zu contact; the fly ends at %g, the plank at %g and %g\n",
               report->first_contacts, end[1], end[3], end[5]);
}

int main(void)
{
    tf_mesh mesh = {2, 3, 0, NULL, 1, (int[]){1, 2}};
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    if (tf_surface_create(&mesh, &surface, NULL) != TF_OK ||
        tf_resolver_create(surface, &resolver) != TF_OK)
        return 2;
    resolve(resolver, NULL);
    resolve(resolver, (double[]){1, 0, 0});
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return 0;
}
