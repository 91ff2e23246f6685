# See in what compilers make of the code that they did what its speed needs:
#
#     BUILD=dir simd.sh
#
# By their own reports, each of the four loops over lanes is made of vectors, and
# for gcc each for every processor that base/simd.h lists.  And the prefetches
# are still there.
set -eu

report=$BUILD/simd
mkdir -p "$BUILD"

fail() { # what
    echo "check-simd: $cc: $1" >&2
    exit 1
}

expect() { # loops, pattern
    found=$(grep -c "fast/lanes.c.*$2" "$report") || true
    [ "$found" -ge "$1" ] || {
        cat "$report" >&2
        fail "$found of $1 loops are vectors: $2"
    }
    echo "simd: $cc: $found loops: $2"
}

compile() { # module, options
    module=$1
    shift
    $cc -O3 -std=c17 -ffp-contract=off -Isrc "$@" -S "src/$module.c" \
        -o "$report.s" >"$report" 2>&1
    found=$(grep -cE '[[:space:]](prefetch|prfm)' "$report.s") ||
        fail "src/$module.c prefetches nothing"
    echo "simd: $cc: $found prefetches in $module.c"
}

cc=gcc
compile surface/tree
compile fast/gather
compile fast/lanes -fopt-info-vec-optimized
for bytes in $(case $(uname -m) in x86_64) echo 16 32 64 ;; *) echo 16 ;; esac)
do
    expect 4 "loop vectorized using $bytes byte vectors"
done
cc=clang
compile surface/tree
compile fast/gather
compile fast/lanes -Rpass=loop-vectorize
expect 4 "vectorized loop (vectorization width: [2-8]"
