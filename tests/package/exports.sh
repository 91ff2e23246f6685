# See that TF_API can be defined by those who compile the library: here to hide
# everything, and for Windows to make a DLL.
#
#     BUILD=dir CC=cc exports.sh
#
# `make check-single` runs this in the folder of the Makefile.
set -eu

single=$BUILD/single
scratch=$single/exports
windows=x86_64-w64-mingw32-gcc

fail() {
    echo "check-single: $*" >&2
    exit 1
}

exported() { # library
    nm -D --defined-only "$1" | sed 's/.* //' | LC_ALL=C sort
}

# No other file of the program may see the library.
check_hidden() {
    $CC -O0 -fPIC -shared -fvisibility=hidden "$single/tanglefree.c" -lm \
        -o "$scratch/marked.so"
    exported "$scratch/marked.so" >"$scratch/marked"
    grep -qx tf_version "$scratch/marked" || fail "tf_version is not exported"

    $CC -O0 -fPIC -shared '-DTF_API=__attribute__((visibility("hidden")))' \
        -fvisibility=hidden "$single/tanglefree.c" -lm -o "$scratch/hidden.so"
    [ ! "$(exported "$scratch/hidden.so")" ] ||
        fail "in spite of TF_API: $(exported "$scratch/hidden.so")"
}

# What a DLL exports is among the directives of its objects, and what a program
# takes from a DLL has a name that begins with __imp_.
check_dll() {
    $windows -O0 -DTF_BUILD_DLL -c "$single/tanglefree.c" \
        -o "$scratch/dll.o" 2>"$scratch/warnings" ||
        fail "$(cat "$scratch/warnings")"
    ! grep visibility "$scratch/warnings" || fail "a mark of other systems"
    objcopy -O binary -j .drectve "$scratch/dll.o" "$scratch/directives"
    tr -s ' ' '\n' <"$scratch/directives" |
        sed -n 's/^-export:"\([^"]*\)".*/\1/p' | LC_ALL=C sort |
        diff "$scratch/marked" - || fail "the DLL exports other names (>)"

    $windows -O0 -DTF_DLL -I "$single" -c tests/package/answers.c \
        -o "$scratch/user.o"
    expect_symbol '__imp_tf_exact'
    $windows -O0 -I "$single" -c tests/package/answers.c -o "$scratch/user.o"
    expect_symbol 'tf_exact'
}

expect_symbol() { # name
    nm "$scratch/user.o" | grep -q " U $1\$" || fail "no $1 is asked for"
}

rm -rf "$scratch"
mkdir -p "$scratch"
check_hidden
check_dll
echo 'TF_API hides everything, and marks what a DLL has.'
