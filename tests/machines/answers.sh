#!/bin/sh
# Print the answers to tests/queries of all kinds, arithmetics and outputs:
#
#     answers.sh PROGRAM...
#
# where the words of PROGRAM start `tanglefree`, perhaps under an emulator.
for kind in point-edge point-triangle edge-edge; do
    for arithmetic in exact clamped report perturbed integer64 integer128; do
        for output in csv json summary; do
            echo "$kind $arithmetic $output"
            "$@" query --kind $kind --arithmetic $arithmetic --output $output \
                tests/queries/$kind.csv 2>&1 || echo "status $?"
        done
    done
done
