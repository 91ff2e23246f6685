#include "renderer/gl.h"

#include <stddef.h>

bool fig_gl_load(fig_gl *gl)
{
    bool complete = true;
#define LOAD(type, name)                                                       \
    gl->name = (type)fig_context_function("gl" #name);                         \
    complete = complete && gl->name != NULL;
    FIG_GL_FUNCTIONS(LOAD)
#undef LOAD
    return complete;
}
