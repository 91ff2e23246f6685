//: Include what interruptions need
#define _POSIX_C_SOURCE 200809L
#include "program/interruption.h"

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

static const int requests[] = {SIGINT, SIGTERM, SIGHUP};
enum {
    REQUESTS = sizeof requests / sizeof *requests
};

//: Hold signals back, and look for them
/// Held back, it would wait all the same.
static bool is_ignored(int request)
{
    struct sigaction present;
    return sigaction(request, NULL, &present) == 0 &&
           present.sa_handler == SIG_IGN;
}

void tf_interruption_hold(void)
{
    sigset_t held;
    sigemptyset(&held);
    for (int i = 0; i < REQUESTS; i++)
        if (!is_ignored(requests[i]))
            sigaddset(&held, requests[i]);
    sigprocmask(SIG_BLOCK, &held, NULL);
}

int tf_interruption(void)
{
    sigset_t pending;
    sigpending(&pending);
    for (int i = 0; i < REQUESTS; i++)
        if (sigismember(&pending, requests[i]) == 1)
            return requests[i];
    return 0;
}
