//: Include what the fields of a contact need
#include "program/contact_fields.h"

#include <string.h>

//: Arrange the numbers of a contact
enum {
    NUMBERS = 6
};

static const char *const number_names[NUMBERS] = {
    "toi_lo", "toi_hi", "nx", "ny", "nz", "normal_velocity",
};

/// The numbers in the order of their names; NULL where there is none.
static void arrange(const tf_contact *contact, int axes,
                    const double *number[NUMBERS])
{
    memset(number, 0, NUMBERS * sizeof *number);
    if (contact->verdict == TF_APART)
        return;
    number[0] = &contact->toi_lo;
    number[1] = &contact->toi_hi;
    for (int k = 0; k < axes; k++)
        number[2 + k] = &contact->normal[k];
    number[5] = &contact->normal_velocity;
}

const char *const tf_classification_names[] = {
    [TF_GENERIC] = "generic",
    [TF_TOUCHING] = "touching",
    [TF_DEGENERATE] = "degenerate",
};

//: Write the fields as CSV
void tf_contact_head_csv(FILE *stream)
{
    for (int i = 0; i < NUMBERS; i++)
        fprintf(stream, ",%s", number_names[i]);
    fputs(",case\n", stream);
}

static const char *case_of(const tf_contact *contact)
{
    return contact->verdict == TF_APART
               ? NULL
               : tf_classification_names[contact->classification];
}

void tf_contact_write_csv(FILE *stream, int axes, const tf_contact *contact)
{
    const double *number[NUMBERS];
    arrange(contact, axes, number);
    for (int i = 0; i < NUMBERS; i++)
        if (number[i])
            fprintf(stream, ",%.17g", *number[i]);
        else
            fputc(',', stream);
    const char *name = case_of(contact);
    fprintf(stream, ",%s\n", name ? name : "");
}

//: Write the fields as JSON
void tf_contact_write_json(FILE *stream, int axes, const tf_contact *contact)
{
    const double *number[NUMBERS];
    arrange(contact, axes, number);
    for (int i = 0; i < NUMBERS; i++)
        if (number[i])
            fprintf(stream, ",\"%s\":%.17g", number_names[i], *number[i]);
        else
            fprintf(stream, ",\"%s\":null", number_names[i]);
    const char *name = case_of(contact);
    if (name)
        fprintf(stream, ",\"case\":\"%s\"}", name);
    else
        fputs(",\"case\":null}", stream);
}
