#define _GNU_SOURCE // mkdtemp
#include "support/picture_folder.h"

#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/tanglefree-picture-XXXXXX", picture[64];

void make_picture_folder(void)
{
    ck_assert(mkdtemp(folder));
    snprintf(picture, sizeof picture, "%s/picture.png", folder);
}

void remove_picture_folder(void)
{
    remove(picture);
    ck_assert_int_eq(rmdir(folder), 0);
}

const char *picture_path(void)
{
    return picture;
}
