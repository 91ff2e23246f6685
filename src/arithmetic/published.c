//: Include what the published rule needs
#include "arithmetic/published.h"

#include "arithmetic/clamped.h"
#include "arithmetic/functions.h"

//: Take unknown signs for zeros
static tf_sign published_sign(const tf_differences *differences)
{
    tf_sign sign = tf_clamped.sign(differences);
    return sign == TF_UNKNOWN ? TF_ZERO : sign;
}

static tf_value published_value(const tf_differences *differences)
{
    return tf_clamped.value(differences);
}

const tf_arithmetic tf_published = {
    .name = "report", .sign = published_sign, .value = published_value};
