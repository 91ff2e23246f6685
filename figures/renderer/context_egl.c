#include "renderer/gl.h"

#ifdef FIG_EGL

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdlib.h>

struct fig_context {
    EGLDisplay display;
    EGLContext egl;
};

/// The display of the process, which all contexts use and none may close.
static EGLDisplay open_display(void)
{
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                                               EGL_DEFAULT_DISPLAY, NULL);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL) ||
        !eglBindAPI(EGL_OPENGL_API))
        return EGL_NO_DISPLAY;
    return display;
}

static EGLContext create_context(EGLDisplay display)
{
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             3,
                             EGL_CONTEXT_MINOR_VERSION,
                             3,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
}

fig_context *fig_context_open(void)
{
    fig_context *context = calloc(1, sizeof *context);
    if (context == NULL)
        return NULL;
    context->egl = EGL_NO_CONTEXT;
    context->display = open_display();
    if (context->display != EGL_NO_DISPLAY)
        context->egl = create_context(context->display);
    if (context->egl == EGL_NO_CONTEXT ||
        !eglMakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                        context->egl)) {
        fig_context_close(context);
        return NULL;
    }
    return context;
}

void fig_context_close(fig_context *context)
{
    if (context == NULL)
        return;
    if (context->egl != EGL_NO_CONTEXT) {
        eglMakeCurrent(context->display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                       EGL_NO_CONTEXT);
        eglDestroyContext(context->display, context->egl);
    }
    free(context);
}

fig_gl_function fig_context_function(const char *name)
{
    return (fig_gl_function)eglGetProcAddress(name);
}

#endif
