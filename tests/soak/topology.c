// Many random merges, pinches and drops on adaptive surfaces, among other
// operations, judged after each that is done:
//
//     topology COUNT FROM [LEFT_OUT]
//
// tries COUNT operations, in runs of RUN, of the streams of random numbers FROM
// on of TF_SEED's, leaving out tests of the library.  Prints each fault, with
// the stream that repeats it.
#include "support/reconnections.h"

#include <stdio.h>
#include <stdlib.h>

enum {
    RUN = 200
};

int main(int argc, char *argv[])
{
    long count = argc > 1 ? atol(argv[1]) : 100000;
    long from = argc > 2 ? atol(argv[2]) : 0, faults = 0;
    unsigned left_out = argc > 3 ? (unsigned)atol(argv[3]) : 0;
    if (count < 1 || from < 0) {
        fprintf(stderr, "topology: COUNT from 1, FROM from 0\n");
        return EXIT_FAILURE;
    }
    reconnection_counts counts = {0};
    for (long i = from; i < from + (count + RUN - 1) / RUN; i++) {
        const char *fault = run_reconnections(
            generator_new((uint64_t)i),
            (adaptive_scene_kind)(i % MERGING_SCENES), RUN, left_out, &counts);
        if (!fault)
            continue;
        faults++;
        printf("stream %ld: %s\n", i, fault);
        fflush(stdout);
    }
    reconnection_counts_print(&counts);
    printf("seed %llu, streams from %ld, %ld faults\n",
           (unsigned long long)seed(), from, faults);
    return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
