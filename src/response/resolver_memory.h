//: Declare what a resolver holds
#pragma once

#include "response/answer_list.h"
#include "response/failsafe.h"
#include "response/follow.h"
#include "response/rigid.h"
#include "response/zones.h"
#include "surface/pair_cache.h"

typedef struct tf_resolver {
    tf_surface *surface;
    tf_pair_cache pairs;
    tf_buffer end, unpushed, base, ones, displacement; ///< of the vertices
    tf_zones zones;
    tf_rigid rigid;
    tf_failsafe failsafe;
    tf_follow follow;
    tf_answer_list answers;
    tf_buffer part;  ///< of a part of the step: where vertices start, are
                     ///< proposed to end, and would be when the step ends
    tf_buffer flags; ///< a byte for each vertex, see tf_vertex_flag; and once
                     ///< more, of a part of the step
    tf_buffer
        followed;      ///< the fraction of its script that each vertex followed
    bool has_resolved; ///< the last call has resolved a step
    tf_response_report report; ///< of the last step, lent
} tf_resolver;
