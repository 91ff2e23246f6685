#include "support/proposal_steps.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "surface/detect.h"

#include <string.h>

void proposal_step_begin(proposal_step *s, const proposal *made)
{
    memcpy(s->end, made->end, sizeof s->end);
    memcpy(s->unpushed, made->end, sizeof s->unpushed);
    s->surface = surface_of(&made->mesh);
    s->step = (tf_step){.axes = made->mesh.axes,
                        .vertices = made->mesh.vertices,
                        .start = made->start,
                        .proposed = made->end,
                        .inverse_mass = made->inverse_mass,
                        .end = s->end,
                        .unpushed = s->unpushed,
                        .flags = memset(s->flags, 0, sizeof s->flags)};
    s->rule = (tf_contact_rule){.base = made->end};
}

void proposal_step_free(proposal_step *s)
{
    tf_surface_free(s->surface);
}

tf_contacts proposal_step_contacts(proposal_step *s)
{
    tf_motion motion = {s->step.axes, s->step.vertices, s->step.start, s->end};
    tf_contacts found;
    ck_assert_int_eq(tf_detect(s->surface, &motion, NULL, &found, NULL), TF_OK);
    return found;
}

bool proposal_step_has_moved(const proposal_step *s, int vertex)
{
    ptrdiff_t place = (ptrdiff_t)s->step.axes * vertex;
    return memcmp(s->step.end + place, s->step.proposed + place,
                  sizeof(double) * (size_t)s->step.axes) != 0;
}

int proposal_step_changes(const proposal_step *s)
{
    int changes = 0;
    for (int v = 0; v < s->step.vertices; v++)
        changes += proposal_step_has_moved(s, v);
    return changes;
}
