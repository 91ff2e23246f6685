#include "measured.h"

#include "tables.h"

#include <stdio.h>
#include <string.h>

#define LENGTH(array) ((int)(sizeof(array) / sizeof *(array)))

const tf_query_time *tf_measured_queries(int *count)
{
    *count = LENGTH(query_times);
    return query_times;
}

const tf_stage_share *tf_measured_shares(int *count)
{
    *count = LENGTH(stage_shares);
    return stage_shares;
}

const tf_stage_time *tf_measured_stages(int *count)
{
    *count = LENGTH(stage_times);
    return stage_times;
}

const char *tf_kind_letters(const char *kind)
{
    return strcmp(kind, "point-triangle") == 0 ? "pt" : "ee";
}

void tf_name_workload(tf_page *page, double x, double y, const char *work,
                      const char *kind)
{
    char name[64];
    snprintf(name, sizeof name, "%s, %s", work, tf_kind_letters(kind));
    tf_page_text(page, x, y, TF_ALIGN_RIGHT, name, TF_LETTERS_SMALL,
                 TF_ROLE_INK);
}
