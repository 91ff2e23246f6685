#include "support/surface_of.h"

#include <check.h>
#include <stddef.h>

tf_surface *surface_of(const tf_mesh *mesh)
{
    tf_surface *surface = NULL;
    tf_error error;
    ck_assert_int_eq(tf_surface_create(mesh, &surface, &error), TF_OK);
    return surface;
}
