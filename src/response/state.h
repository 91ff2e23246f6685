//: Declare what a resolver holds
#pragma once

#include "response/failsafe.h"
#include "response/resolver.h"
#include "response/rigid.h"
#include "response/zones.h"

struct tf_resolver {
    tf_surface *surface;
    tf_buffer end, looked, base, ones, displacement; ///< of the vertices
    tf_zones zones;
    tf_rigid rigid;
    tf_failsafe failsafe;
};
