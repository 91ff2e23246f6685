# See that two builds of the commit at hand give the same bytes:
#
#     MAKE=make BUILD=dir FILM=bending reproducible.sh
#
# They differ in all that should not matter: the folder, the name of the build,
# the locale and the time zone.  Libraries and programs are compared as they are
# with -g, too.  Pictures and pages must not even depend on the compiler's
# flags, so those in BUILD, made from the same commit, serve as the first build.
# Films and pictures take most of the time: if FILM is set, only this film and the
# light pictures are made twice.
set -eu

scratch=$BUILD/reproducible
libraries='libtanglefree.a libtanglefree.so tanglefree tanglefree-draw include
    single'
pages='figures films book/html'

if [ -n "$(git status --porcelain)" ]; then
    echo "The files differ from HEAD: commit or stash them first." >&2
    exit 2
fi

build() { # folder, name of the build, targets
    mkdir -p "$scratch/$1"
    git archive HEAD | tar -x -C "$scratch/$1"
    echo "build   $scratch/$1"
    # One after the other: `all` starts a make of its own, and beside it a
    # second one would write the same archives.
    for targets in "$3" "single $2/libtanglefree.so"; do
        $MAKE -C "$scratch/$1" $targets BUILD="$2" CFLAGS='-O2 -g' \
            >>"$scratch/$1.txt" 2>&1 ||
            { tail -n 20 "$scratch/$1.txt"; exit 1; }
    done
}

# The second build takes all films but FILM and the dark pictures from the first.
borrow_pictures() {
    output=$scratch/another/place/output
    mkdir -p "$output/figures"
    cp -R "$BUILD/films" "$output"
    cp "$BUILD"/figures/*-dark.png "$output/figures"
    rm "$output/films/$FILM-light.png"
    echo "films=output/films/$FILM-light.png THEMES=light"
}

compare() { # first build, products
    for product in $2; do
        diff -rq "$1/$product" "$scratch/another/place/output/$product" ||
            wrong=1
    done
}

rm -rf "$scratch"
export LC_ALL=C.UTF-8 TZ=UTC
$MAKE all
build one build 'library program drawing'
export LC_ALL=C TZ=Asia/Tokyo
build another/place output "all ${FILM:+$(borrow_pictures)}"

wrong=0
compare "$scratch/one/build" "$libraries"
compare "$BUILD" "$pages"
[ $wrong = 0 ] || exit 1
echo "the same bytes:" $libraries $pages
