# See that compilers make vectors of the loops over lanes, by their own reports:
#
#     BUILD=dir vectors.sh
#
# Each of the two loops of src/fast/lanes.c, and for gcc each for every processor
# that base/vectors.h lists.
set -eu

report=$BUILD/vectors
mkdir -p "$BUILD"

count() { # pattern
    grep -c "fast/lanes.c.*$1" "$report" || true
}

expect() { # loops, pattern
    found=$(count "$2")
    [ "$found" -ge "$1" ] || {
        cat "$report" >&2
        echo "check-vectors: $cc: $found of $1 loops are vectors: $2" >&2
        exit 1
    }
    echo "vectors: $cc: $found loops: $2"
}

compile() { # compiler, options
    cc=$1
    shift
    $cc -O3 -std=c17 -ffp-contract=off -Isrc "$@" -c src/fast/lanes.c \
        -o "$report.o" >"$report" 2>&1
}

compile gcc -fopt-info-vec-optimized
for bytes in $(case $(uname -m) in x86_64) echo 16 32 64 ;; *) echo 16 ;; esac)
do
    expect 2 "loop vectorized using $bytes byte vectors"
done
compile clang -Rpass=loop-vectorize
expect 2 "vectorized loop (vectorization width: [2-8]"
