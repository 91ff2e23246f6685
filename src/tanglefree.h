//: Include the whole library
#ifndef TF_TANGLEFREE_H
#define TF_TANGLEFREE_H

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "arithmetic/perturbed.h"
#include "query/edge_edge.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"

#endif
