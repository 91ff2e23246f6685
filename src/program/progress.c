//: Include what the progress line needs
#define _GNU_SOURCE
#include "program/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

//: Read the clock
double tf_clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

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

//: Show, rewrite and erase the progress line
tf_progress_line tf_progress_line_begin(bool silent)
{
    return (tf_progress_line){
        .wanted = isatty(STDERR_FILENO) && (silent || !isatty(STDOUT_FILENO)),
        .next = tf_clock_seconds() + 1,
    };
}

void tf_progress_line_show(tf_progress_line *progress, long count,
                           const char *things)
{
    if (!progress->wanted || tf_clock_seconds() < progress->next)
        return;
    fputc('\r', stderr);
    print_grouped(stderr, count);
    fprintf(stderr, " %s", things);
    progress->shown = true;
    progress->next = tf_clock_seconds() + 0.2;
}

bool tf_progress_line_show_stage(void *progress, const tf_stage *stage)
{
    tf_progress_line_show(progress, (long)stage->done, stage->name);
    return true;
}

void tf_progress_line_end(tf_progress_line *progress)
{
    if (progress->shown)
        fputs("\r\033[K", stderr);
}
