# Build and test the first chapters alone:
#
#     MAKE=make BUILD=dir COMPILE='gcc ...' chapters.sh N|all
#
# The files of the modules of chapters 1 to N are linked into a tree of their
# own, BUILD/chapter/N/tree.  Each header there must compile without the others,
# and the tests of the modules must pass.
#
# With `all`, for each N, in one tree that grows.  What chapter N adds cannot
# change what was compiled and tested before it, so only its own headers and
# tests are looked at.
set -u

chapters=$(grep -c '^[a-z]' book/chapters)

modules_of() { # M, N: of the chapters M to N
    awk -v m="$1" -v n="$2" '/^[a-z]/ && ++chapter >= m && chapter <= n {
        for (i = 2; i <= NF; i++) print $i }' book/chapters
}

plant() { # tree, modules
    tree=$1 && shift
    for module; do
        mkdir -p "$tree/$(dirname "$module")"
        for file in src/$module.[ch]; do
            [ ! -e "$file" ] || ln -s "$(pwd)/$file" "$tree/${file#src/}"
        done
    done
}

compile_headers() { # tree, modules
    tree=$1 && shift
    for module; do
        [ ! -e "$tree/$module.h" ] ||
            printf '#include "%s.h"\nint main(void) { return 0; }\n' "$module" |
            $COMPILE -I"$tree" -fsyntax-only -x c - || return 1
    done
}

tests_of() { # build, modules
    build=$1 && shift
    for module; do
        [ ! -e "tests/$module.c" ] || echo "$build/tests/$module"
    done
}

# A module that is needed too early moves to an earlier line of book/chapters.
# make would take an archive that lacks objects of old sources to be complete.
check_chapters() { # M, N, build: the chapters M to N, after those before
    build=$3
    added=$(modules_of "$1" "$2")
    rm -f "$build"/*.a
    plant "$build/tree" $added && compile_headers "$build/tree" $added &&
        $MAKE check BUILD="$build" SRC="$build/tree" CHAPTERS="$2" \
            TESTS="$(echo $(tests_of "$build" $added))" && return
    echo "The first $2 chapters have only:" $(modules_of 1 "$2")
    return 1
}

wrong=0
build=$BUILD/chapter/$1
rm -rf "$build/tree"
case $1 in
all)
    for n in $(seq "$chapters"); do
        echo "Chapter $n"
        check_chapters "$n" "$n" "$build" || wrong=1
    done ;;
*)
    seq "$chapters" | grep -qx "$1" || {
        echo "Which chapter? make chapter N=1 to N=$chapters" >&2
        exit 1
    }
    check_chapters 1 "$1" "$build" || wrong=1 ;;
esac
exit $wrong
