//: Explain the statuses
#include "base/status.h"

#include <stdbool.h>

static const char *const messages[] = {
    [TF_OK] = "no error",
    [TF_NOT_FINITE] = "a coordinate is infinite or NaN; give finite positions",
    [TF_OUT_OF_RANGE] = "out of range: a coordinate is too large for this "
                        "function or arithmetic, or not an integer as it must "
                        "be; use exact, or a larger unit of length",
    [TF_BAD_INDEX] = "an index is bad; the vertices of an element or a query "
                     "must be distinct, and each have an index from 0 to the "
                     "number of vertices less 1",
    [TF_BAD_ENVIRONMENT] = "the floating-point environment is not the default "
                           "of IEEE 754; round to nearest and keep subnormal "
                           "numbers, and "
                           "compile without -ffast-math and its parts (which "
                           "may flush them to zero in the whole program)",
    [TF_NO_ELEMENTS] = "a surface has no elements; give it a triangle or an "
                       "edge",
    [TF_BAD_COUNT] = "a count is negative or too large, or the positions are "
                     "not those of this surface; give as many vertices as it "
                     "was created with",
    [TF_OUT_OF_MEMORY] = "not enough memory; divide the surface, or use a "
                         "machine with more",
    [TF_BAD_OPTION] = "an option, tolerance or limit is not in its range",
    [TF_BAD_MASS] = "an inverse mass is negative, infinite or NaN; use 0 for a "
                    "vertex that is scripted",
    [TF_START_NOT_CLEAR] = "two elements touch or intersect when the step "
                           "starts; start from a surface that does not "
                           "intersect itself",
    [TF_EDGE_NOT_MANIFOLD] = "an edge has no triangle, more than two, or two "
                             "that pass it in one direction; give each edge "
                             "one triangle or two, and orient them "
                             "consistently",
    [TF_VERTEX_NOT_MANIFOLD] = "the triangles at a vertex form more than one "
                               "ring or fan; give each its own vertex",
    [TF_COLLINEAR] = "the corners of a triangle are on one line; remove it, or "
                     "move a corner off",
    [TF_NOT_EMBEDDED] = "a surface intersects or touches itself; move its "
                        "parts away from each other",
    [TF_BAD_AXES] = "the number of axes must be 2 in the plane and 3 in space, "
                    "and be that of the surface or the query",
    [TF_CANCELLED] = "cancelled; nothing is changed",
    [TF_IN_USE] = "memory is in use; set the allocator before anything is "
                  "created, or after all is freed",
};

const char *tf_status_message(tf_status status)
{
    bool known = (unsigned)status < sizeof messages / sizeof *messages;
    return known ? messages[status] : "a status of a later version";
}
