#define _GNU_SOURCE // memmem

#include "support/polydata.h"

#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int polydata_count(const char *text, const char *kind)
{
    char words[50];
    snprintf(words, sizeof words, " %s=\"", kind);
    const char *at = strstr(text, words);
    ck_assert_msg(at, "no%s", words);
    return atoi(at + strlen(words));
}

/// Where the data of an array begins, which is described so.
static size_t offset_of(const char *text, const char *element,
                        const char *described)
{
    char words[50];
    snprintf(words, sizeof words, "<%s>\n", element);
    const char *begin = strstr(text, words);
    ck_assert_msg(begin, "no %s", words);
    snprintf(words, sizeof words, "</%s>", element);
    const char *end = strstr(begin, words);
    ck_assert_msg(end, "no %s", words);
    const char *at =
        memmem(begin, (size_t)(end - begin), described, strlen(described));
    ck_assert_msg(at, "no %s in %s", described, element);
    return strtoul(at + strlen(described), NULL, 10);
}

static size_t bytes_of(const char *type)
{
    return (size_t)atoi(type + strcspn(type, "0123456789")) / 8;
}

/// On a machine of either byte order.
static uint64_t bits_at(const unsigned char *at, size_t bytes)
{
    uint64_t bits = 0;
    for (size_t i = 0; i < bytes; i++)
        bits |= (uint64_t)at[i] << 8 * i;
    return bits;
}

static double number_of(const char *type, uint64_t bits)
{
    double wide;
    float narrow;
    uint32_t low = (uint32_t)bits;
    memcpy(&wide, &bits, sizeof wide);
    memcpy(&narrow, &low, sizeof narrow);
    return strcmp(type, "Float64") == 0   ? wide
           : strcmp(type, "Float32") == 0 ? (double)narrow
           : strcmp(type, "Int32") == 0   ? (double)(int32_t)low
                                          : (double)bits;
}

double polydata_number(const char *text, size_t size, const char *element,
                       const char *name, const char *type, int components,
                       size_t count, size_t i)
{
    static const char mark[] = "<AppendedData encoding=\"raw\">\n_";
    char described[200];
    snprintf(described, sizeof described,
             "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" "
             "format=\"appended\" offset=\"",
             type, name, components);
    const unsigned char *data = memmem(text, size, mark, sizeof mark - 1);
    ck_assert_ptr_nonnull(data);
    data += sizeof mark - 1 + offset_of(text, element, described);
    ck_assert_uint_eq(bits_at(data, 8), count * bytes_of(type));
    ck_assert((const char *)data + 8 + count * bytes_of(type) <= text + size);
    return number_of(type,
                     bits_at(data + 8 + i * bytes_of(type), bytes_of(type)));
}
