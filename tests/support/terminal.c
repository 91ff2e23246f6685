#define _GNU_SOURCE // posix_openpt, ptsname_r

#include "support/terminal.h"

#include <check.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

terminal terminal_open(void)
{
    terminal screen = {.master = posix_openpt(O_RDWR | O_NOCTTY)};
    ck_assert_int_ge(screen.master, 0);
    ck_assert_int_eq(grantpt(screen.master), 0);
    ck_assert_int_eq(unlockpt(screen.master), 0);
    ck_assert_int_eq(ptsname_r(screen.master, screen.name, sizeof screen.name),
                     0);
    screen.slave = open(screen.name, O_RDWR | O_NOCTTY);
    ck_assert_int_ge(screen.slave, 0);
    return screen;
}

const char *terminal_close(terminal *screen)
{
    // A mark of our own, so that the end is seen even if there is nothing else.
    static const char mark = '\a';
    ck_assert_int_eq(write(screen->slave, &mark, 1), 1);

    static char text[10000];
    size_t length = 0;
    while (length == 0 || text[length - 1] != mark) {
        ssize_t more =
            read(screen->master, text + length, sizeof text - length);
        ck_assert_int_gt(more, 0);
        length += (size_t)more;
    }
    text[length - 1] = '\0';
    close(screen->slave);
    close(screen->master);
    return text;
}

void expect_progress(const char *text, const char *line)
{
    static const char erased[] = "\r\033[K";
    size_t length = strlen(text), closing = strlen(erased);
    ck_assert_msg(strncmp(text, line, strlen(line)) == 0 &&
                      length >= strlen(line) + closing &&
                      strcmp(text + length - closing, erased) == 0,
                  "'%s' is shown, not '%s'", text, line);
}
