#include "stage/gl.h"

#include <stddef.h>

bool tf_gl_load(tf_gl *gl)
{
    bool complete = true;
#define LOAD(type, name)                                                       \
    gl->name = (type)tf_context_function("gl" #name);                          \
    complete = complete && gl->name != NULL;
    TF_GL_FUNCTIONS(LOAD)
#undef LOAD
    return complete;
}
