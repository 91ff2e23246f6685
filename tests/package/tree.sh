# See what `make install` puts where, and that `make uninstall` removes it:
#
#     tree.sh install|uninstall
. tests/package/common.sh

list_tree() { # folder
    (cd "$1" && find . ! -type d -printf '%P -> %l\n') |
        sed 's/ -> $//' | LC_ALL=C sort
}

expect_tree() { # folder, pattern of what is not there yet
    sed "s/VERSION/$VERSION/g; s/MAJOR/${VERSION%%.*}/" \
        tests/package/installed | grep -v "$2" >"$scratch/expected"
    list_tree "$1" | diff "$scratch/expected" - ||
        fail "$1 is not what tests/package/installed lists"
}

# Pages are to be read without an installation, too.
check_pages() {
    rm -f "$BUILD"/man/*.[1-9]
    $MAKE program drawing
    for page in $(sed -n 's|^share/man/man./||p' tests/package/installed); do
        [ -s "$BUILD/man/$page" ] || fail "make leaves out the page $page"
    done
}

check_tree() {
    $MAKE install PREFIX="$prefix" DESTDIR=
    expect_tree "$prefix" draw
    $MAKE install-draw PREFIX="$prefix" DESTDIR=
    expect_tree "$prefix" '^$'
}

# A folder with a blank, and below it a prefix that counts from here.
check_stage() {
    stage="$scratch/the stage"
    $MAKE install install-draw PREFIX=some/where DESTDIR="$stage"
    expect_tree "$stage$(pwd)/some/where" '^$'
    grep -qx "prefix=$(pwd)/some/where" \
        "$stage$(pwd)/some/where/lib/pkgconfig/tanglefree.pc" ||
        fail "tanglefree.pc does not name the prefix"
}

# What others put there stays.
check_uninstall() {
    echo kept >"$prefix/lib/pkgconfig/other.pc"
    $MAKE uninstall PREFIX="$prefix" DESTDIR=
    [ "$(list_tree "$prefix")" = lib/pkgconfig/other.pc ] ||
        fail "uninstall leaves $(list_tree "$prefix")"
    left=$(find "$prefix" -name tanglefree)
    [ ! "$left" ] || fail "uninstall leaves $left"
}

case $1 in
install)
    rm -rf "$scratch"
    mkdir -p "$scratch"
    check_pages
    check_tree
    check_stage ;;
uninstall)
    check_uninstall ;;
esac
