# See that the library is refused where a compiler's options rewrite arithmetic:
# when the options have a macro of their own, by the compiler, else by the first
# query, as the arithmetic does not pass for IEEE's.
#
#     CC=cc BUILD=dir refuse.sh OPTION...
#
# `make check-compilers` runs this in the folder of the Makefile.
set -eu

scratch=$BUILD/compilers/refused
mkdir -p "$scratch"
echo 'int main(void) { return tf_environment_is_ieee(); }' >"$scratch/main.c"
if $CC -std=c17 -O2 "$@" -Isrc -include base/environment.h "$scratch/main.c" \
    src/base/environment.c -lm -o "$scratch/main" 2>"$scratch/errors"; then
    "$scratch/main" || { echo "taken: $CC $*" >&2 && exit 1; }
    echo "refused when it runs: $CC $*"
else
    grep -q 'error.*fast-math' "$scratch/errors" ||
        { cat "$scratch/errors" >&2 && exit 1; }
    echo "refused: $CC $*"
fi
