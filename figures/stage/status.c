#include "stage/status.h"

const char *tf_stage_message(tf_stage_status status)
{
    switch (status) {
    case TF_STAGE_OK:
        return "no error";
    case TF_STAGE_NO_MEMORY:
        return "out of memory; ask for fewer pixels";
    case TF_STAGE_BAD_SIZE:
        return "a picture is 16 to 16384 pixels wide and high";
    case TF_STAGE_NO_FONT:
        return "the family of letters is not installed; STIXGeneral comes "
               "with Debian's fonts-stix";
    case TF_STAGE_NO_CONTEXT:
        return "no OpenGL 3.3; install Mesa's OSMesa or its EGL with llvmpipe";
    case TF_STAGE_NO_SHADER:
        return "this OpenGL refuses the shaders; Mesa's llvmpipe takes them";
    case TF_STAGE_BAD_TEXT:
        return "a label is no UTF-8 or has a $ or a { that is not closed";
    case TF_STAGE_UNWRITABLE:
        return "cannot write the picture";
    case TF_STAGE_UNKNOWN_KIND:
        return "a picture's name ends in .png, .pdf or .svg";
    }
    return "no such status";
}
