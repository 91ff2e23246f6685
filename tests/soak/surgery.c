// Many random operations on adaptive surfaces, judged after each that is done:
//
//     surgery COUNT FROM [LEFT_OUT]
//
// tries COUNT operations, in runs of RUN, of the streams of random numbers FROM
// on of TF_SEED's, leaving out tests of the library (bits 1 << outcome).  Prints
// each fault, with the stream that repeats it.
#include "support/surgery_runs.h"

#include <stdio.h>
#include <stdlib.h>

enum {
    RUN = 500
};

int main(int argc, char *argv[])
{
    long count = argc > 1 ? atol(argv[1]) : 100000;
    long from = argc > 2 ? atol(argv[2]) : 0, faults = 0;
    unsigned left_out = argc > 3 ? (unsigned)atol(argv[3]) : 0;
    if (count < 1 || from < 0) {
        fprintf(stderr, "surgery: COUNT from 1, FROM from 0\n");
        return EXIT_FAILURE;
    }
    surgery_counts counts = {0};
    for (long i = from; i < from + (count + RUN - 1) / RUN; i++) {
        const char *fault = run_surgery(
            generator_new((uint64_t)i),
            (adaptive_scene_kind)(i % ADAPTIVE_SCENES), RUN, left_out, &counts);
        if (!fault)
            continue;
        faults++;
        printf("stream %ld: %s\n", i, fault);
        fflush(stdout);
    }
    surgery_counts_print(&counts);
    printf("seed %llu, streams from %ld, %ld faults\n",
           (unsigned long long)seed(), from, faults);
    return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
