# Build and test the first chapters alone:
#
#     MAKE=make BUILD=dir COMPILE='gcc ...' chapters.sh N|all
#
# The files of the modules of chapters 1 to N are linked into a tree of their
# own, BUILD/chapter/N/tree.  Each header there must compile without the others,
# and the tests of the modules must pass.  With `all`, for each N.
set -u

chapters=$(grep -c '^[a-z]' book/chapters)

modules_of() { # N: of the first N chapters
    awk -v n="$1" '/^[a-z]/ && n-- > 0 { for (i = 2; i <= NF; i++) print $i }' \
        book/chapters
}

plant() { # N, tree
    rm -rf "$2"
    for module in $(modules_of "$1"); do
        mkdir -p "$2/$(dirname "$module")"
        for file in src/$module.[ch]; do
            [ ! -e "$file" ] || ln -s "$(pwd)/$file" "$2/${file#src/}"
        done
    done
}

compile_headers() { # tree
    for header in $(cd "$1" && find * -name '*.h' | sort); do
        printf '#include "%s"\nint main(void) { return 0; }\n' "$header" |
            $COMPILE -I"$1" -fsyntax-only -x c - || return 1
    done
}

# A module that is needed too early moves to an earlier line of book/chapters.
check_chapters() { # N
    tree=$BUILD/chapter/$1/tree
    plant "$1" "$tree" && compile_headers "$tree" &&
        $MAKE check BUILD="$BUILD/chapter/$1" SRC="$tree" CHAPTERS="$1" &&
        return
    echo "The first $1 chapters have only:" $(modules_of "$1")
    return 1
}

wrong=0
case $1 in
all)
    for n in $(seq "$chapters"); do
        echo "Chapter $n"
        check_chapters "$n" || wrong=1
    done ;;
*)
    seq "$chapters" | grep -qx "$1" || {
        echo "Which chapter? make chapter N=1 to N=$chapters" >&2
        exit 1
    }
    check_chapters "$1" || wrong=1 ;;
esac
exit $wrong
