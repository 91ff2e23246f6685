# Describe the binary interface of the library in one file: the names that it
# exports, their types, and all public types as they are in memory.
#
#     CC=cc describe.sh FOLDER
#
# compiles tanglefree.c in FOLDER, with tanglefree.h, to libtanglefree.so, and
# writes tanglefree.abi there.  Neither the options of the compiler nor the
# folder show in it, nor the version of gcc.
set -eu

here=$(dirname "$0")

# The compiler reads from standard input, so that no file has a path.
{
    cat "$1/tanglefree.c"
    awk -f "$here/types.awk" "$1/tanglefree.h"
} | $CC -std=c17 -O0 -g -gdwarf-4 -fPIC -fvisibility=hidden -I "$1" -x c - \
    -x none -shared -lm -o "$1/libtanglefree.so"

growing=$(awk -f "$here/growing.awk" "$1/tanglefree.h")
abidw --exported-interfaces-only --headers-dir "$1" --drop-private-types \
    --no-corpus-path --no-comp-dir-path --no-show-locs --no-elf-needed \
    --no-parameter-names --type-id-style hash "$1/libtanglefree.so" |
    sed "1a $growing" >"$1/tanglefree.abi"
