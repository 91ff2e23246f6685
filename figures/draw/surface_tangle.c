#include "draw/surface_tangle.h"

#include "untangle/tangled_zones.h"

#include <stdlib.h>

static tf_status fail(tf_error *error)
{
    *error = (tf_error){.status = TF_OUT_OF_MEMORY};
    return error->status;
}

static bool find_touching(fig_tangled *tangled, const tf_crossings *found)
{
    tangled->touches = malloc(found->count + 1);
    for (size_t i = 0; i < found->count && tangled->touches; i++)
        tangled->touches[i] =
            found->crossing[i].kind != TF_EDGE_THROUGH_TRIANGLE;
    return tangled->touches;
}

tf_status fig_tangled_find(fig_tangled *tangled, tf_surface *surface,
                           const fig_shape *shape, const double position[],
                           const tf_check_options *options, tf_crossings *found,
                           tf_error *error)
{
    size_t facets =
        (size_t)(shape->axes == 2 ? shape->edges : shape->triangles);
    *tangled = (fig_tangled){0};
    tangled->zone = malloc((facets + 1) * sizeof *tangled->zone);
    if (!tangled->zone)
        return fail(error);
    tf_status status =
        tf_surface_zones(surface, shape->vertices, position, 1, options,
                         tangled->zone, &tangled->zones, found, error);
    if (status != TF_OK)
        return status;
    bool good =
        find_touching(tangled, found) &&
        (shape->axes == 2 ||
         fig_curve_pieces_find(&tangled->curves, shape, shape->at[0], found));
    return good ? TF_OK : fail(error);
}

void fig_tangled_free(fig_tangled *tangled)
{
    fig_curve_pieces_free(&tangled->curves);
    free(tangled->touches);
    free(tangled->zone);
    *tangled = (fig_tangled){0};
}
