//: Declare what a resolver holds
#pragma once

#include "distance/near_contacts.h"
#include "response/answer_list.h"
#include "response/failsafe.h"
#include "response/rigid.h"
#include "response/zones.h"
#include "surface/pair_cache.h"

typedef struct tf_resolver {
    tf_surface *surface;
    tf_pair_cache pairs;
    tf_thickness thickness;
    tf_buffer end, unpushed, base, ones, displacement; ///< of the vertices
    tf_zones zones;
    tf_rigid rigid;
    tf_failsafe failsafe;
    tf_answer_list answers;
    tf_buffer flags;           ///< a byte for each vertex, see tf_vertex_flag
    bool has_resolved;         ///< the last call has resolved a step
    tf_response_report report; ///< of the last step, lent
} tf_resolver;
