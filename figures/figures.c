#include "figures.h"

#include <string.h>

const tf_figure *const tf_figures[] = {
    NULL,
};

const tf_figure *tf_figure_named(const char *name)
{
    for (int i = 0; tf_figures[i]; i++)
        if (strcmp(name, tf_figures[i]->name) == 0)
            return tf_figures[i];
    return NULL;
}
