//: Declare strands
#pragma once

#include "simulate/cloth.h"

/// How long an edge is, in meters.
double tf_strand_length(const tf_body *body, int edge);

/// Gives mass and elastic elements to edges: each resists being stretched, and
/// each two at a vertex without a third resist being bent.  The strand is
/// straight at rest.
/// @param first the first of the edges, which go on to the last of the body
/// @param material per meter: in kilograms per meter, newtons, and newtons times
///     square meters
void tf_strand_stiffen(tf_body *body, int first, const tf_material *material);
