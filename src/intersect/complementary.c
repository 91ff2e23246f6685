//: Include what the complementary test needs
#include "intersect/complementary.h"

#include "intersect/separation.h"
#include "intersect/time.h"

#include <string.h>

//: Describe the common point
void tf_complementary_describe(const tf_arithmetic *arithmetic,
                               const tf_pair *pair, tf_detail detail,
                               tf_intersection *found)
{
    if (detail <= found->detail)
        return;
    int smaller = tf_pair_smaller_operand(pair);
    tf_value value[TF_PAIR_EVENTS];
    const tf_value *known =
        tf_pair_values(arithmetic, pair, value) ? value : NULL;

    // Values that come at once cost less to use now than to find again.
    if (known)
        detail = TF_WITH_POINT;
    if (found->detail < TF_WITH_TIME) {
        //: Find the time from the smaller operand
        tf_coordinates coordinates;
        tf_pair_coordinates(arithmetic, pair, &found->signs, smaller, known,
                            &coordinates);
        tf_interval time = {0, 1};
        if (found->unique)
            time = tf_pair_time(pair, &coordinates);
        found->toi_lo = time.lo;
        found->toi_hi = pair->start_count == pair->count ? 0 : time.hi;
        tf_coordinates_normalize(&coordinates, pair, smaller,
                                 found->barycentric);
    }
    if (detail == TF_WITH_POINT) {
        //: Find the point from the other operand as well
        tf_coordinates coordinates;
        tf_pair_coordinates(arithmetic, pair, &found->signs, -smaller, known,
                            &coordinates);
        tf_coordinates_normalize(&coordinates, pair, -smaller,
                                 found->barycentric);
    }
    found->detail = detail;
}

//: Decide by barycentric signs
const tf_intersection tf_intersection_apart = {.verdict = TF_APART,
                                               .unique = true};

bool tf_complementary_intersect(const tf_arithmetic *arithmetic,
                                const tf_pair *pair, tf_detail detail,
                                tf_intersection *found)
{
    // Of a pair that is apart nothing else is ever read.
    found->detail = TF_ONLY_VERDICT;
    found->verdict = TF_APART;
    found->classification = TF_UNCLASSIFIED;

    // Signs that are proved at once cost less than a search for an axis.
    tf_signs signs;
    if (!tf_pair_sure_signs(arithmetic, pair, &signs)) {
        if (tf_pair_separated(pair))
            return true;
        tf_pair_other_signs(arithmetic, pair, &signs);
    }
    bool unique = signs.positive || signs.negative;
    if (signs.positive && signs.negative)
        return true;
    if (!unique && !signs.unknown)
        return false;

    found->verdict = signs.unknown ? TF_UNDECIDED : TF_HIT;
    found->classification =
        signs.zero || signs.unknown ? TF_TOUCHING : TF_GENERIC;
    found->unique = unique;
    found->signs = signs;
    found->toi_lo = found->toi_hi = 0;
    memset(found->barycentric, 0, sizeof found->barycentric);
    if (detail > TF_ONLY_VERDICT)
        tf_complementary_describe(arithmetic, pair, detail, found);
    return true;
}
