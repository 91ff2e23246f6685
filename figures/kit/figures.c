#include "kit/figures.h"

#include <string.h>

const fig_figure *const fig_figures[] = {
#define FIG_NAME(name) &fig_##name,
#include "names.h"
#undef FIG_NAME
    NULL,
};

const fig_figure *fig_figure_named(const char *name)
{
    for (int i = 0; fig_figures[i]; i++)
        if (strcmp(name, fig_figures[i]->name) == 0)
            return fig_figures[i];
    return NULL;
}
