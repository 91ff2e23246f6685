//: Include what choices need
#include "files/choice.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

//: Find a choice by its name
const void *tf_choice_named(const tf_choice list[], const char *name)
{
    for (; list->name; list++)
        if (strcmp(name, list->name) == 0)
            return list->value;
    return NULL;
}

//: List the names of choices
tf_choices tf_list_choices(const tf_choice list[])
{
    tf_choices names = {""};
    size_t length = 0;
    for (int i = 0; list[i].name && length < sizeof names.text; i++)
        length += (size_t)snprintf(names.text + length,
                                   sizeof names.text - length, "%s%s",
                                   i == 0              ? ""
                                   : !list[i + 1].name ? " or "
                                                       : ", ",
                                   list[i].name);
    return names;
}
