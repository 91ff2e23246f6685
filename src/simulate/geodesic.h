//: Declare geodesic spheres
#pragma once

#include "simulate/body.h"

/// Adds a sphere around the origin of radius 1, of 20 n^2 triangles that are
/// nearly equilateral: an icosahedron whose sides are divided, and blown up.
void tf_geodesic_add(tf_body *body, int n);

/// The n for which the edges of a geodesic sphere with that radius are nearly as
/// long.
int tf_geodesic_division(double radius, double edge);
