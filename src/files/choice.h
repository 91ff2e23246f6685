//: Declare choices
#pragma once

enum {
    TF_CHOICES_ROOM = 128
};

/// A name that can be chosen, and what it stands for.  A list of them ends with
/// one without a name.
typedef struct tf_choice {
    const char *name;
    const void *value;
} tf_choice;

/// What a name stands for; NULL if it is not in the list.
const void *tf_choice_named(const tf_choice list[], const char *name);

/// The names of a list in words, "a, b or c".
typedef struct tf_choices {
    char text[TF_CHOICES_ROOM];
} tf_choices;

tf_choices tf_list_choices(const tf_choice list[]);
