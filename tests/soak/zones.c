// Many random steps from tangled starts, resolved outside of zones and judged:
//
//     zones COUNT FROM [weak]
//
// resolves steps of the runs FROM, FROM + 1, ... of TF_SEED's until there are
// COUNT, and prints each fault, which TF_SEED and FROM repeat, and how often
// what happened.  With `weak`, a weaker rule is planted, by which a pair is
// left out if some triangles at its elements are in one zone: then it is an
// error if no fault is found.
#include "support/generator.h"
#include "support/zoned_steps.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char *argv[])
{
    long count = argc > 1 ? atol(argv[1]) : 10000;
    long from = argc > 2 ? atol(argv[2]) : 0;
    bool weak = argc > 3 && strcmp(argv[3], "weak") == 0;
    if (count < 1 || from < 0) {
        fprintf(stderr, "zones: COUNT from 1, FROM from 0\n");
        return EXIT_FAILURE;
    }
    zoned_counts counts = {0};
    for (long i = from; counts.steps < count; i++) {
        const char *fault = zoned_fault(i, weak, &counts);
        if (!fault || weak)
            continue;
        printf("%s\n", fault);
        fflush(stdout);
    }
    zoned_counts_print(&counts);
    printf("seed %llu, runs from %ld%s\n", (unsigned long long)seed(), from,
           weak ? ", by the weaker rule" : "");
    return (counts.faulty > 0) == weak ? EXIT_SUCCESS : EXIT_FAILURE;
}
