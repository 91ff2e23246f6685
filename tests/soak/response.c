// Many random proposals resolved and judged, by as many processes as there are
// cores:
//
//     response COUNT FROM
//
// tries the proposals FROM to FROM + COUNT - 1 of TF_SEED's, and prints those
// with a fault, which TF_SEED and FROM repeat, and how often what happened.
// Interrupted, it prints where to go on.
#define _GNU_SOURCE // MAP_ANONYMOUS

#include "support/resolutions.h"

#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    MOST_PROCESSES = 64
};

static struct shared {
    atomic_long next; ///< the first proposal that no process has taken yet
    long end;         ///< the first that none will
    atomic_bool stop;
    atomic_long faults;
    long taken[MOST_PROCESSES]; ///< the proposal that each is at
    pid_t process[MOST_PROCESSES];
    resolution_counts count[MOST_PROCESSES];
} * all;

static void stop(int signal)
{
    (void)signal;
    all->stop = true;
}

static void work(int process)
{
    while (!all->stop) {
        long number = atomic_fetch_add(&all->next, 1);
        if (number >= all->end)
            return;
        all->taken[process] = number;
        const char *fault = numbered_fault(number, &all->count[process]);
        if (!fault)
            continue;
        all->faults++;
        fprintf(stderr, "%s\n", fault);
    }
}

/// Starts as many as there are cores; returns how many.
static int start(void)
{
    int count = 0;
    for (long cores = sysconf(_SC_NPROCESSORS_ONLN);
         count < cores && count < MOST_PROCESSES; count++) {
        pid_t child = fork();
        if (child == 0) {
            work(count);
            _exit(EXIT_SUCCESS);
        }
        if (child < 0)
            break;
        all->process[count] = child;
    }
    return count;
}

/// Returns how many ended well.
static int wait_for(int processes)
{
    int good = 0;
    for (int i = 0; i < processes; i++) {
        int status;
        if (waitpid(all->process[i], &status, 0) > 0 && status == 0)
            good++;
        else
            fprintf(stderr, "broke off at proposal %ld, signal %d\n",
                    all->taken[i], WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    }
    return good;
}

static resolution_counts total(int processes)
{
    resolution_counts sum = {0};
    for (int i = 0; i < processes; i++) {
        const resolution_counts *count = &all->count[i];
        sum.tries += count->tries;
        sum.met += count->met;
        sum.rescued += count->rescued;
        sum.held += count->held;
        sum.shortened += count->shortened;
        sum.rested += count->rested;
        sum.exact += count->exact;
        sum.rounds = count->rounds > sum.rounds ? count->rounds : sum.rounds;
    }
    return sum;
}

static void share(long from, long count)
{
    all = mmap(NULL, sizeof *all, PROT_READ | PROT_WRITE,
               MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) {
        perror("soak: mmap");
        exit(EXIT_FAILURE);
    }
    all->next = from;
    all->end = from + count;
}

int main(int argc, char *argv[])
{
    long count = argc > 1 ? atol(argv[1]) : 10000;
    long from = argc > 2 ? atol(argv[2]) : 0;
    if (count < 1 || from < 0) {
        fprintf(stderr, "soak: COUNT from 1, FROM from 0\n");
        return EXIT_FAILURE;
    }
    share(from, count);
    signal(SIGINT, stop);
    signal(SIGTERM, stop);
    int processes = start(), good = wait_for(processes);
    resolution_counts sum = total(processes);
    resolution_counts_print(&sum);
    printf("seed %llu, proposals from %ld, %d processes, %d broke off, "
           "%ld faults\n",
           (unsigned long long)seed(), from, processes, processes - good,
           (long)all->faults);
    if (all->next < all->end)
        printf("interrupted; go on with FROM=%ld COUNT=%ld\n", (long)all->next,
               all->end - all->next);
    return all->faults == 0 && good == processes && processes > 0
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
}
