#include "renderer/status.h"

const char *fig_status_message(fig_status status)
{
    switch (status) {
    case FIG_OK:
        return "no error";
    case FIG_NO_MEMORY:
        return "not enough memory; try fewer pixels";
    case FIG_BAD_SIZE:
        return "a picture must be from 16 to 16384 pixels wide and high";
    case FIG_NO_FONT:
        return "the font is not installed; STIXGeneral is in Debian's "
               "package fonts-stix";
    case FIG_NO_CONTEXT:
        return "no OpenGL 3.3; install Mesa's OSMesa, or its EGL with llvmpipe";
    case FIG_NO_SHADER:
        return "the OpenGL driver rejects the shaders; Mesa's llvmpipe accepts "
               "them";
    case FIG_BAD_TEXT:
        return "a label is not valid UTF-8, or has an unclosed $ or {";
    case FIG_UNWRITABLE:
        return "cannot write the picture";
    case FIG_UNKNOWN_KIND:
        return "the name of a picture must end in .png, .pdf or .svg";
    }
    return "unknown status";
}
