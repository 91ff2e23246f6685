# Use what is installed: versions, header, symbols, and the examples, that of
# README.md too, by all compilers, with pkg-config and with CMake.
. tests/package/common.sh

# The versions -----------------------------------------------------------------

expect() { # wanted, got, of what
    [ "$1" = "$2" ] || fail "the version is $1, but $2 in $3"
}

check_versions() {
    for package in tanglefree tanglefree_threads; do
        expect "$VERSION" "$(installed --modversion $package)" $package.pc
    done
    for program in tanglefree tanglefree-draw; do
        expect "$program $VERSION" "$("$prefix/bin/$program" --version)" \
            "$program --version"
    done
    readelf -d "$prefix/lib/libtanglefree.so" >"$scratch/dynamic"
    expect "libtanglefree.so.${VERSION%%.*}" \
        "$(sed -n 's/.*soname: \[\(.*\)\]/\1/p' "$scratch/dynamic")" \
        "the shared library"
}

# The header and the symbols ---------------------------------------------------

check_header() {
    ! grep '^#include "' "$header" || fail "tanglefree.h needs other headers"
    for module in $(sed -n 's/^\/\/ \([a-z]*\/[a-z_]*\) -*$/\1/p' "$header"); do
        ! echo "#include <$module.h>" | gcc -I "$prefix/include" -fsyntax-only \
            -x c - 2>/dev/null || fail "$module.h can be included"
    done
    for language in 'gcc -std=c11' 'gcc -std=c17' 'clang -std=c11' \
        'clang -std=c17' 'g++ -std=c++17' 'g++ -std=c++20' \
        'clang++ -std=c++17' 'clang++ -std=c++20'; do
        ending=c
        case $language in *++*) ending=cc ;; esac
        for file in tanglefree.h tanglefree_threads.h; do
            echo "#include <$file>" >"$scratch/header.$ending"
            $language -Wall -Wextra -Wpedantic -Werror -I "$prefix/include" \
                -fsyntax-only "$scratch/header.$ending" ||
                fail "$language has warnings of $file"
        done
    done
}

# The names that a header declares with TF_API.
list_declared() { # header
    grep -v '^ *\(//\|#\)' "$prefix/include/$1" | tr '\n' ' ' | tr ';{' '\n\n' |
        sed -n 's/^.*TF_API \([^(]*\).*/\1/; t print
            d
            :print
            s/ *$//; s/.*[ *]//; p' | LC_ALL=C sort
}

expect_symbols() { # header, library, options of nm
    list_declared "$1" >"$scratch/declared"
    [ -s "$scratch/declared" ] || fail "$1 declares nothing"
    nm $3 --defined-only "$prefix/lib/$2" | sed -n 's/.* [A-Z] //p' |
        LC_ALL=C sort | diff "$scratch/declared" - ||
        fail "$2 exports other names than TF_API (<) declares"
}

check_symbols() {
    expect_symbols tanglefree.h libtanglefree.so -D
    expect_symbols tanglefree_threads.h libtanglefree_threads.a -g
}

# The programs of users --------------------------------------------------------

expect_stated() { # program
    answer=$(LD_LIBRARY_PATH="$prefix/lib" "$1")
    [ "$answer" ] && grep -qF "$answer" README.md ||
        fail "README.md does not state what its example prints: $answer"
}

try_example() { # compiler, standard, source
    program=$scratch/example
    $1 -std="$2" -Wall -Wextra -Wpedantic -Werror "$3" \
        $(installed --cflags --libs tanglefree) -o "$program"
    readelf -d "$program" | grep -q "libtanglefree.so.${VERSION%%.*}" ||
        fail "$1 links no shared library"
    expect_stated "$program"
    $1 -std="$2" -static "$3" \
        $(installed --static --cflags --libs tanglefree) -o "$program"
    expect_stated "$program"
}

check_example() {
    readme c >"$scratch/example.c"
    cp "$scratch/example.c" "$scratch/example.cc"
    for cc in gcc clang; do
        try_example $cc c17 "$scratch/example.c"
    done
    for cc in g++ clang++; do
        try_example $cc c++17 "$scratch/example.cc"
        try_example $cc c++20 "$scratch/example.cc"
    done
}

# The scenes, as they are installed: all that is built in, and the example, whose
# frames another program writes.
check_scenes() {
    tanglefree=$prefix/bin/tanglefree
    "$tanglefree" simulate list | cut -d ' ' -f 1 >"$scratch/listed"
    while read -r name; do
        rm -rf "$scratch/made"
        "$tanglefree" simulate "$prefix/share/tanglefree/scenes/$name.yaml" \
            -o "$scratch/made" --steps 1 >"$scratch/report" ||
            fail "$name.yaml cannot be simulated"
    done <"$scratch/listed"
    cp -r "$prefix/share/doc/tanglefree/examples/walk" "$scratch/walk"
    (cd "$scratch/walk" && python3 walk.py frames 21 &&
        "$tanglefree" simulate walk.yaml -o walk --steps 60 &&
        "$tanglefree" detect judge.yaml &&
        "$tanglefree" check judge.yaml) >"$scratch/report" 2>&1 ||
        fail "the example walk fails: $(cat "$scratch/report")"
}

# The examples, as they are installed.
check_examples() {
    for expected in examples/*.expected; do
        name=$(basename "$expected" .expected)
        example=$prefix/share/doc/tanglefree/examples/$name.c
        cp "$example" "$scratch/$name.cc"
        for compiler in "gcc -std=c17 $example" "clang -std=c17 $example" \
            "g++ -std=c++17 $scratch/$name.cc" \
            "clang++ -std=c++17 $scratch/$name.cc"; do
            $compiler -pthread -Wall -Wextra -Wpedantic -Werror \
                $(installed --cflags --libs tanglefree) -lm -o "$scratch/$name"
            LD_LIBRARY_PATH="$prefix/lib" "$scratch/$name" |
                diff "$expected" - ||
                fail "$example prints something else"
        done
    done
}

expect_tasks() { # program
    answer=$(LD_LIBRARY_PATH="$prefix/lib" "$1")
    [ "$answer" = '1000 tasks by 3 threads' ] ||
        fail "tests/package/threads.c does not run its tasks: $answer"
}

check_threads() {
    program=$scratch/threads
    cp tests/package/threads.c "$program.cc"
    for compiler in 'gcc -std=c17 tests/package/threads.c' \
        'clang -std=c11 tests/package/threads.c' \
        "g++ -std=c++17 $program.cc" "clang++ -std=c++20 $program.cc"; do
        $compiler -Wall -Wextra -Wpedantic -Werror \
            $(installed --cflags --libs tanglefree_threads) -o "$program"
        expect_tasks "$program"
        $compiler -static $(installed --static --cflags --libs \
            tanglefree_threads) -o "$program"
        expect_tasks "$program"
    done
    # As a part of a shared library.
    gcc -shared -fPIC tests/package/threads.c -Wl,--no-undefined \
        $(installed --cflags --libs tanglefree_threads) -o "$program.so"
}

# What is installed may move.
check_cmake() {
    cp -R "$prefix" "$scratch/moved"
    cmake -S tests/package/cmake -B "$scratch/cmake" \
        -DCMAKE_PREFIX_PATH="$scratch/moved" -DEXAMPLE="$scratch/example.c" \
        -DTHREADS="$(pwd)/tests/package/threads.c" \
        -DTHREADS_IN_CXX="$scratch/threads.cc" \
        >"$scratch/cmake.txt" && cmake --build "$scratch/cmake" \
        >>"$scratch/cmake.txt" || { cat "$scratch/cmake.txt"; exit 1; }
    for program in shared static; do
        expect_stated "$scratch/cmake/$program"
    done
    for program in threads threads_in_cxx; do
        expect_tasks "$scratch/cmake/$program"
    done
    readelf -d "$scratch/cmake/shared" >"$scratch/dynamic"
    grep -q "RUNPATH.*$scratch/moved/lib" "$scratch/dynamic" &&
        grep -q 'NEEDED.*libtanglefree' "$scratch/dynamic" ||
        fail "tanglefree::tanglefree is not the shared library beside it"
    ! readelf -d "$scratch/cmake/static" | grep -q 'NEEDED.*libtanglefree' ||
        fail "tanglefree::static is shared"
}

fits() { # version asked for, of 3.4.5
    cmake -S tests/package/version -B "$scratch/version" -DVERSION="$1" \
        -DCMAKE_PREFIX_PATH="$scratch/moved" >"$scratch/version.txt" 2>&1
}

check_cmake_versions() {
    sed -i "s/\"$VERSION\"/\"3.4.5\"/" \
        "$scratch/moved/lib/cmake/tanglefree/tanglefreeConfigVersion.cmake"
    for version in '3;' '3.4;' '3.4.5;' '3.4.5;EXACT' '3.0...3.9;' \
        '3.1...3.4.5;'; do
        fits "$version" || fail "3.4.5 does not fit $version"
    done
    for version in '2;' '2.9;' '4;' '3.5;' '3.4.6;' '3.4;EXACT' '3.0...3.4;' \
        '3.0...<3.4.5;' '2.0...3.9;'; do
        ! fits "$version" || fail "3.4.5 fits $version"
    done
}

check_versions
check_header
check_symbols
check_example
check_examples
check_scenes
check_threads
check_cmake
check_cmake_versions
