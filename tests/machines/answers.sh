#!/bin/sh
# Print the answers to tests/queries of all kinds, arithmetics and formats,
# those about a surface of many contacts, found by several numbers of threads,
# and what becomes of a surface that flows:
#
#     answers.sh PROGRAM...
#
# where the words of PROGRAM start `tanglefree`, perhaps under an emulator.
for kind in point-edge point-triangle edge-edge; do
    for arithmetic in exact clamped report perturbed integer64 integer128; do
        for format in csv json summary; do
            echo "$kind $arithmetic $format"
            "$@" query --kind $kind --arithmetic $arithmetic --format $format \
                tests/queries/$kind.csv 2>&1 || echo "status $?"
        done
    done
done

# Two sheets of 8 x 8 vertices, one above the other, which are crumpled (by less
# than the second argument) and pass through each other from frame 0 to frame 2.
# The coordinates are integers of a linear congruential generator, so that every
# awk prints the same ones.
frame() {
    awk -v frame="$1" -v most="$2" -v n=8 '
        function random() { seed = (seed * 16807) % 2147483647; return seed }
        BEGIN {
            seed = 1
            for (v = 0; v < 2 * n * n; v++) {
                for (f = 0; f <= 2; f++)
                    for (k = 0; k < 3; k++) bend[f, k] = random() % most
                z = 1024 * (v < n * n ? frame : 2 - frame)
                print "v", v % n * 512 + bend[frame, 0], \
                    int(v / n) % n * 512 + bend[frame, 1], z + bend[frame, 2]
            }
            for (v = 1; v < 2 * n * n - n; v++)
                if (v % n > 0 && int((v - 1) / n) % n < n - 1) {
                    print "f", v, v + 1, v + n + 1
                    print "f", v, v + n + 1, v + n
                }
        }'
}

frames=$(mktemp -d)
trap 'rm -r "$frames"' EXIT
for i in 0 1 2; do
    frame $i 512 >"$frames/$i.obj"
    frame $i 128 >"$frames/calm$i.obj"
done
for arithmetic in exact clamped perturbed integer64; do
    for threads in 1 2 8; do
        echo "detect $arithmetic $threads"
        "$@" detect --arithmetic $arithmetic --threads $threads \
            "$frames/0.obj" "$frames/1.obj" "$frames/2.obj" 2>&1
        echo "status $?"
    done
done
for i in 0 1 2; do
    echo "check $i"
    "$@" check - <"$frames/$i.obj" 2>&1
    echo "status $?"
done

# Their reports have times, so that the meshes have to do.
for threads in 1 2; do
    echo "resolve $threads"
    "$@" resolve --threads $threads --friction 0.5 -o - \
        "$frames/calm0.obj" "$frames/calm2.obj" 2>/dev/null
    echo "status $?"
done
echo remesh
"$@" remesh --edge 300 -o - "$frames/calm0.obj" 2>/dev/null
echo "status $?"

# The star grows without functions of libm, which are not the same everywhere.
for threads in 1 2; do
    echo "simulate $threads"
    "$@" simulate star --edge 0.1 --steps 40 --threads $threads \
        -o "$frames/star$threads" >/dev/null 2>&1
    echo "status $?"
    cat "$frames/star$threads"/frame-*.ply | cksum
done
