# See that all builds give the same answers to the last bit, whatever their
# options allow the compiler; that the library refuses to be compiled or to run
# where it would give others; and that it needs libc and libm alone:
#
#     MAKE=make BUILD=dir compilers.sh
set -eu

builds=$BUILD/compilers

# Options that let a compiler rewrite arithmetic.  The Makefile undoes them; who
# compiles the single file may not.
rewriting='-Ofast
-ffast-math
-funsafe-math-optimizations
-freciprocal-math
-fassociative-math -fno-signed-zeros -fno-trapping-math
-ffinite-math-only
-fno-signed-zeros'

# Balls that merge and a neck that is pinched: with one libm, their velocities
# are the same, too.
simulate() { # program, folder
    for scene in 'spheres --steps 110' 'dumbbell --steps 130'; do
        rm -rf "$2"
        "$1" simulate $scene --edge 0.08 --threads 1 -o "$2"
        cat "$2"/frame-*.ply | cksum
    done | sed '/seconds: /d'
}

answer() { # compiler, options
    build=$builds/$(echo "$1 $2" | tr ' ' '_')
    $MAKE library program BUILD="$build" CC="$1" CFLAGS="-Werror $2" </dev/null
    sh tests/machines/answers.sh "$build/tanglefree" >"$build/answers"
    simulate "$build/tanglefree" "$build/frames" >>"$build/answers"
    if grep -A 2 ' exact ' "$build/answers" | grep '^status'; then
        echo "exact signs do not answer: $1 $2" >&2
        exit 1
    fi
}

# Undone, options make the library the same to the last byte as without them, and
# the program is compiled in the same way.
same_library() { # compiler, options
    build=$builds/$1_rewriting
    $MAKE "$build/libtanglefree.a" BUILD="$build" CC="$1" CFLAGS="-Werror -O3 $2" \
        </dev/null &&
        cmp "$builds/$1_-O3/libtanglefree.a" "$build/libtanglefree.a" &&
        echo "the same library: $1 -O3 $2"
}

# All of them are undone at once; if they are not, one by one tells which.
undo() { # compiler
    options=$(printf '%s\n' "$rewriting" -fno-rounding-math)
    same_library "$1" "$(echo $options)" && return
    echo "$options" | while read -r some; do
        same_library "$1" "$some" || echo "another library: $1 -O3 $some"
    done
    return 1
}

try_compiler() { # compiler
    for level in -O0 -O2 -O3; do
        answer "$1" "$level"
    done
    undo "$1"
}

# Side by side: much of it, the answers, keeps one processor busy.
mkdir -p "$builds"
try_compiler gcc >"$builds/gcc.txt" 2>&1 & gcc=$!
try_compiler clang >"$builds/clang.txt" 2>&1 & clang=$!
wrong=0
wait $gcc || wrong=1
wait $clang || wrong=1
cat "$builds/gcc.txt" "$builds/clang.txt"
[ $wrong = 0 ] || exit 1

for cc in gcc clang; do
    for level in -O0 -O2 -O3; do
        cmp "$builds/gcc_-O0/answers" "$builds/${cc}_$level/answers"
        echo "the same answers: $cc $level"
    done
done

for cc in gcc clang; do
    echo "$rewriting" | while read -r options; do
        CC=$cc BUILD=$BUILD sh tests/package/refuse.sh $options
    done
done

echo 'int main(void) { return 0; }' | gcc -x c - -x none -o /dev/null \
    -Wl,--whole-archive "$builds/gcc_-O0/libtanglefree.a" \
    -Wl,--no-whole-archive -lm
echo 'linked: libc and libm only'
