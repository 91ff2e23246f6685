//: Declare the pieces of contacts
#pragma once

#include "topology/reconnector.h"

/// Divides the vertices near the edges that face each other, up to their
/// neighbors, into pieces that are connected on the surface.  Returns TF_OK,
/// TF_OUT_OF_MEMORY or TF_CANCELLED.
tf_status tf_find_pieces(tf_reconnector *reconnector);

/// The vertex that stands for the piece of another one.
int tf_piece_of(tf_reconnector *reconnector, int vertex);

/// Makes one piece of two.
void tf_unite_pieces(tf_reconnector *reconnector, int a, int b);
