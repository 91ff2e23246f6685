//: Lend where vertices come from
#include "remesh/origins.h"

#include "base/require.h"
#include "surgery/adaptive_surface.h"

const tf_origin *tf_adaptive_origins(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    return surface->lent.has_origins ? surface->lent.origin.data : NULL;
}

const tf_origin *tf_adaptive_corner_origins(const tf_adaptive_surface *surface)
{
    TF_REQUIRE(surface);
    return surface->lent.has_origins ? surface->lent.corner_origin.data : NULL;
}
