//: Include what the progress line needs
#define _GNU_SOURCE
#include "program/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

//: Write a count with commas
static void print_grouped(FILE *stream, long count)
{
    if (count < 1000) {
        fprintf(stream, "%ld", count);
        return;
    }
    print_grouped(stream, count / 1000);
    fprintf(stream, ",%03ld", count % 1000);
}

//: Read the clock
static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

//: Show, rewrite and erase the progress line
tf_progress tf_progress_begin(void)
{
    return (tf_progress){
        .wanted = isatty(STDERR_FILENO) && !isatty(STDOUT_FILENO),
        .next = seconds() + 1,
    };
}

void tf_progress_show(tf_progress *progress, long count, const char *things)
{
    if (!progress->wanted || seconds() < progress->next)
        return;
    fputc('\r', stderr);
    print_grouped(stderr, count);
    fprintf(stderr, " %s", things);
    progress->shown = true;
    progress->next = seconds() + 0.2;
}

void tf_progress_end(tf_progress *progress)
{
    if (progress->shown)
        fputs("\r\033[K", stderr);
}
