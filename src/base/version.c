//: State the version
#include "base/version.h"

const char *tf_version(void)
{
    return TF_VERSION;
}
