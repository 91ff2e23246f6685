#include "support/stepped.h"

#include "support/support.h"
#include "support/surface_of.h"

#include <string.h>

void stepped_begin(stepped *of, const proposal *made)
{
    memcpy(of->end, made->end, sizeof of->end);
    memcpy(of->looked, made->end, sizeof of->looked);
    of->surface = surface_of(&made->mesh);
    of->step = (tf_step){.axes = made->mesh.axes,
                         .vertices = made->mesh.vertices,
                         .start = made->start,
                         .proposed = made->end,
                         .inverse_mass = made->inverse_mass,
                         .end = of->end,
                         .looked = of->looked};
    of->rule = (tf_contact_rule){.base = made->end};
}

void stepped_free(stepped *of)
{
    tf_surface_free(of->surface);
}

tf_contacts stepped_contacts(stepped *of)
{
    tf_motion motion = {of->step.vertices, of->step.start, of->end};
    tf_contacts found;
    ck_assert_int_eq(
        tf_surface_detect(of->surface, &motion, NULL, &found, NULL), TF_OK);
    return found;
}

bool stepped_has_moved(const stepped *of, int vertex)
{
    ptrdiff_t place = (ptrdiff_t)of->step.axes * vertex;
    return memcmp(of->step.end + place, of->step.looked + place,
                  sizeof(double) * (size_t)of->step.axes) != 0;
}

int stepped_changes(const stepped *of)
{
    int changes = 0;
    for (int v = 0; v < of->step.vertices; v++)
        changes += stepped_has_moved(of, v);
    return changes;
}
