// Many random calls that remesh, reconnect or move adaptive surfaces at all
// scales, judged:
//
//     scales COUNT FROM
//
// makes COUNT calls, of the streams of random numbers FROM on of TF_SEED's.
// Prints each fault, with the stream that repeats it.
#include "support/scaled_calls.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char *argv[])
{
    long count = argc > 1 ? atol(argv[1]) : 10000;
    long from = argc > 2 ? atol(argv[2]) : 0, faults = 0;
    if (count < 1 || from < 0) {
        fprintf(stderr, "scales: COUNT from 1, FROM from 0\n");
        return EXIT_FAILURE;
    }
    scaled_counts counts = {0};
    for (long i = from; i < from + count; i++) {
        const char *fault =
            run_scaled_call(generator_new((uint64_t)i),
                            (adaptive_scene_kind)(i % MERGING_SCENES), &counts);
        if (!fault)
            continue;
        faults++;
        printf("stream %ld: %s\n", i, fault);
        fflush(stdout);
    }
    scaled_counts_print(&counts);
    printf("seed %llu, streams from %ld, %ld faults\n",
           (unsigned long long)seed(), from, faults);
    return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
