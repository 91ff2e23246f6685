# Compile the one file of the library by several compilers, without any option
# that it would need, and compare the bits of all answers with those of the
# library.  Options that rewrite arithmetic must be refused: by the compiler, or
# by every query.  The threads in one file go with it, in C and C++.
#
#     BUILD=dir CC=cc single.sh
#
# `make check-single` runs this in the folder of the Makefile.
set -eu

scratch=$BUILD/single/check
queries='point-edge:point-edge point-triangle:point-triangle
    edge-edge:edge-edge point-triangle:witness'

answer() { # command
    for query in $queries; do
        "$@" "${query%:*}" <"tests/queries/${query#*:}.csv"
    done
}

try() { # name, compiler and options
    name=$1
    shift
    "$@" -Wall -Wextra -Wpedantic -Werror -I "$BUILD/single" \
        "$BUILD/single/tanglefree.c" tests/package/answers.c -lm \
        -o "$scratch/$name"
    case $name in
    *.js) answer node "$scratch/$name" ;;
    *) answer "$scratch/$name" ;;
    esac >"$scratch/answers"
    cmp "$scratch/expected" "$scratch/answers"
    echo "the same answers: $*"
}

refuse() { # compiler and options
    if "$@" -O2 -I "$BUILD/single" "$BUILD/single/tanglefree.c" \
        tests/package/answers.c -lm -o "$scratch/refused" \
        2>"$scratch/errors"; then
        answer "$scratch/refused" >"$scratch/answers"
        ! grep -v ': .*not IEEE' "$scratch/answers"
        [ -s "$scratch/answers" ]
    else
        grep -q 'error.*fast-math' "$scratch/errors"
    fi
    echo "refused: $*"
}

try_threads() { # compiler of C and options; the program's compiler, language
    for file in tanglefree tanglefree_threads; do
        $1 -Wall -Wextra -Wpedantic -Werror -c "$BUILD/single/$file.c" \
            -o "$scratch/$file.o"
    done
    $2 -Wall -Wextra -Wpedantic -Werror -I "$BUILD/single" -x "$3" \
        tests/package/threads.c -x none "$scratch/tanglefree.o" \
        "$scratch/tanglefree_threads.o" -lm -pthread -o "$scratch/threads"
    [ "$("$scratch/threads")" = '1000 tasks by 3 threads' ]
    echo "threads: $1, $2"
}

mkdir -p "$scratch"
$CC -std=c17 -I "$BUILD/include" tests/package/answers.c \
    "$BUILD/libtanglefree.a" -lm -o "$scratch/library"
answer "$scratch/library" >"$scratch/expected"
[ -s "$scratch/expected" ]

try gcc gcc
try gcc-native gcc -O3 -march=native
try clang clang -std=c11
try clang-native clang -O3 -march=native
# A program for node: all in one file, with node's own input and output.
try emcc.js emcc -O1 -s SINGLE_FILE=1 -s NODERAWFS=1
try_threads 'gcc -O1' gcc c
try_threads 'gcc -O1' g++ c++
try_threads 'clang -O1 -std=c11' clang c
try_threads 'clang -O1 -std=c11' clang++ c++
for cc in gcc clang; do
    refuse $cc -ffast-math
    refuse $cc -funsafe-math-optimizations
    refuse $cc -fassociative-math -fno-signed-zeros -fno-trapping-math
    refuse $cc -freciprocal-math
    refuse $cc -ffinite-math-only
    refuse $cc -fno-signed-zeros
done
