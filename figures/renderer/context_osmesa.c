#include "renderer/gl.h"

#ifndef FIG_EGL

#include <GL/osmesa.h>
#include <stdlib.h>

struct fig_context {
    OSMesaContext mesa;
    unsigned char
        pixels[4 * 16 * 16]; ///< the renderer draws to textures, but a
                             ///< context wants a buffer
};

static OSMesaContext create_context(void)
{
    const int wanted[] = {OSMESA_FORMAT,
                          OSMESA_RGBA,
                          OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          3,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          3,
                          0};
    return OSMesaCreateContextAttribs(wanted, NULL);
}

fig_context *fig_context_open(void)
{
    fig_context *context = calloc(1, sizeof *context);
    if (context == NULL)
        return NULL;
    context->mesa = create_context();
    if (context->mesa == NULL ||
        !OSMesaMakeCurrent(context->mesa, context->pixels, GL_UNSIGNED_BYTE, 16,
                           16)) {
        fig_context_close(context);
        return NULL;
    }
    return context;
}

void fig_context_close(fig_context *context)
{
    if (context == NULL)
        return;
    if (context->mesa != NULL)
        OSMesaDestroyContext(context->mesa);
    free(context);
}

fig_gl_function fig_context_function(const char *name)
{
    return (fig_gl_function)OSMesaGetProcAddress(name);
}

#endif
